// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/diff/exact_fields.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core3d/mesh/build_mesh.h"

namespace flatland::test {
namespace {

struct Case {
  std::vector<Eigen::Vector3d> places;
  TriangleMesh mesh;
};

Case caseOf(const Solid& solid, bool flipped = false) {
  SolidMesh made = meshOf(solid, {12, true});
  if (flipped) {
    for (std::size_t i = 0; i < made.soup.corners.size(); i += 3)
      std::swap(made.soup.corners[i + 1], made.soup.corners[i + 2]);
  }
  return {made.places, buildMesh(made.soup).mesh};
}

TEST(ExactFields, SphereInTheMeshsCoordinates) {
  const Solid sphere{SolidKind::Sphere, 3.0};
  Case c = caseOf(sphere);
  const SurfaceFields fields = exactFields(sphere, c.places, c.mesh);
  ASSERT_EQ(fields.vertexCount(), c.mesh.vertexCount());
  // Longest side 2 there: the radius is 3 / unit.
  const double curvature = c.mesh.unit / 3.0;
  EXPECT_NEAR(curvature, 1.0, 0.02);
  for (std::uint32_t v = 0; v < fields.vertexCount(); ++v) {
    EXPECT_NEAR(fields.k1[v], curvature, 1e-6);
    EXPECT_NEAR(fields.k2[v], curvature, 1e-6);
    EXPECT_NEAR(fields.c111[v], 0.0, 1e-6);
    const Eigen::Vector3d outward = c.mesh.positionInFile(v).normalized();
    EXPECT_NEAR(fields.normal(v).cast<double>().dot(outward), 1.0, 1e-6);
  }
}

TEST(ExactFields, CIsTheDerivativeOfTheCurvaturesAlongTheCrest) {
  // On the torus k2 = cos(y) / (a + b cos(y)) is the curvature along the circles about z (smaller
  // than 1/b), and its derivative by the length b y along the tube is C(e2, e2, e1).
  const Solid torus{SolidKind::Torus, 1.0, 0.4};
  Case c = caseOf(torus);
  const TriangleMesh& mesh = c.mesh;
  const SurfaceFields fields = exactFields(torus, c.places, mesh);
  for (std::uint32_t v = 0; v < fields.vertexCount(); ++v) {
    const Eigen::Vector3d place = c.places[mesh.fileVertex[v]];
    const double cosine = std::cos(place.y()), sine = std::sin(place.y());
    const double radius = 1.0 + 0.4 * cosine;
    EXPECT_NEAR(fields.k1[v], mesh.unit / 0.4, 1e-5);
    EXPECT_NEAR(fields.k2[v], mesh.unit * cosine / radius, 1e-5);
    // The direction in which the angle about the tube grows.
    const Eigen::Vector3d along(-sine * std::cos(place.x()), -sine * std::sin(place.x()), cosine);
    const double sign = fields.e1(v).cast<double>().dot(along);
    EXPECT_NEAR(std::abs(sign), 1.0, 1e-6);
    const double derivative = -sine / (radius * radius) / 0.4;
    EXPECT_NEAR(fields.c122[v] * sign, mesh.unit * mesh.unit * derivative, 1e-4);
  }
}

TEST(ExactFields, FollowTheWindingOfASheet) {
  const Solid bump{SolidKind::GaussianBump, 2.0, 4.0};
  Case up = caseOf(bump), down = caseOf(bump, true);
  const SurfaceFields a = exactFields(bump, up.places, up.mesh);
  const SurfaceFields b = exactFields(bump, down.places, down.mesh);
  ASSERT_EQ(a.vertexCount(), b.vertexCount());
  for (std::uint32_t v = 0; v < a.vertexCount(); ++v) {
    ASSERT_EQ(up.mesh.fileVertex[v], down.mesh.fileVertex[v]);
    EXPECT_GT(a.nz[v], 0.0f);
    EXPECT_FLOAT_EQ(b.nz[v], -a.nz[v]);
    EXPECT_NEAR(b.k1[v], -a.k2[v], 1e-5);
    EXPECT_NEAR(b.k2[v], -a.k1[v], 1e-5);
    // The same tangent in both frames.
    const SurfacePoint p = a.at(up.mesh, v), q = b.at(down.mesh, v);
    const Eigen::Vector3d t = p.frame * Eigen::Vector2d(0.6, 0.8);
    const Eigen::Vector2d inA = p.frame.transpose() * t, inB = q.frame.transpose() * t;
    EXPECT_NEAR(p.C(inA, inA, inA), -q.C(inB, inB, inB), 1e-3);
  }
}

}  // namespace
}  // namespace flatland::test
