// SPDX-License-Identifier: GPL-3.0-or-later
// The bridges from curves to surfaces: what is known of a curve holds for what it sweeps.
#include "core3d/mesh/swept.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core3d/mesh/build_mesh.h"
#include "flatland/features/terms.h"
#include "flatland/view/view.h"
#include "tests/core3d/mesh_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

Curve randomCurve(Random& random) {
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i) points.emplace_back(uniform(random, 1, 3), uniform(random, -1, 1));
  return BezierChain(4, false, points);
}

// A closed chain of four cubics near a circle about (3, 0).
Curve ring(bool clockwise) {
  std::vector<Vec2> points;
  for (int i = 0; i < 12; ++i) {
    const double angle = (clockwise ? -1 : 1) * kPi / 6 * i, radius = i % 3 == 0 ? 1.0 : 1.14;
    points.emplace_back(3 + radius * std::cos(angle), radius * std::sin(angle));
  }
  return BezierChain(3, true, points);
}

TEST(Extrude, SeesTheCurvesLambdaFromAnyDirection) {
  Random random(announcedSeed("extrude", 31));
  for (int i = 0; i < 300; ++i) {
    const Curve curve = randomCurve(random);
    const double t = uniform(random, 0, 1);
    const SurfacePoint point = extrudedPoint(curve, t, 0.3);
    Eigen::Vector3d w(normal(random), normal(random), normal(random));
    w.normalize();
    const auto seen = apparentCurvature(seenFrom(point, w));
    ASSERT_TRUE(seen);
    const Vec2 flat = w.head<2>();
    const View view{.angleDeg = std::atan2(flat.y(), flat.x()) * 180 / kPi, .distance = {}};
    const Terms terms = termsAt(jetAt(curve, t), frameOf(view), 1);
    EXPECT_NEAR(seen->lambda, *terms.lambda, 1e-11 * *terms.lambda / std::abs(terms.nw));
    // 1/2 D lambda along r: its part along the curve times the curve's own derivative.
    const Vec2 tangent = frameOf(jetAt(curve, t)).tangent;
    const double along = (point.frame * seen->r).head<2>().dot(tangent);
    const double derivative = terms.sum() / std::pow(terms.nw, 3);
    const double size =
        (std::abs(terms.feature) + std::abs(terms.offset)) / std::pow(std::abs(terms.nw), 3);
    EXPECT_NEAR(seen->sum(), along * derivative,
                1e-10 * size * std::abs(along) / std::abs(terms.nw));
  }
}

TEST(Revolve, SeesTheProfilesTermsFromItsAxis) {
  Random random(announcedSeed("revolve", 32));
  int meridians = 0;
  for (int i = 0; i < 300; ++i) {
    const Curve curve = randomCurve(random);
    const double t = uniform(random, 0, 1), angle = uniform(random, -kPi, kPi);
    const SurfacePoint point = revolvedPoint(curve, 0.0, t, angle);
    const Terms terms = termsAt(jetAt(curve, t), frameOf(View{.angleDeg = 90, .distance = {}}), 1);
    const auto seen = apparentCurvature(seenFrom(point, Eigen::Vector3d::UnitY()));
    ASSERT_TRUE(seen);
    // The other eigenvalue belongs to the parallel: n turns by n_radial / radius per length.
    const double parallel =
        point.n.dot(Eigen::Vector3d(std::cos(angle), 0, std::sin(angle))) / pointAt(curve, t).x();
    const double other = parallel * parallel;
    EXPECT_NEAR(seen->lambda, std::max(*terms.lambda, other),
                1e-9 * seen->lambda / std::abs(terms.nw));
    if (*terms.lambda < 1.01 * other) continue;
    ++meridians;
    const double scale = std::pow(terms.nw, 3);
    const Vec2 tangent = frameOf(jetAt(curve, t)).tangent;
    const Eigen::Vector3d meridian(tangent.x() * std::cos(angle), tangent.y(),
                                   tangent.x() * std::sin(angle));
    const double along = (point.frame * seen->r).dot(meridian);
    const double size = (std::abs(terms.feature) + std::abs(terms.offset)) / std::abs(scale);
    EXPECT_NEAR(seen->sum(), along * terms.sum() / scale,
                1e-8 * size * std::abs(along) / std::abs(terms.nw));
  }
  EXPECT_GT(meridians, 100);
}

// C(m, p, p) is the derivative along the meridian of the parallel's curvature, whichever way the
// curve is walked.
TEST(Revolve, ThirdDerivativesAcrossTheMeridian) {
  Random random(announcedSeed("across", 34));
  for (const bool closed : {false, true}) {
    for (int i = 0; i < 20; ++i) {
      const Curve curve = closed ? ring(i % 2 == 0) : randomCurve(random);
      const double t = uniform(random, 0.2, 0.8), angle = uniform(random, -kPi, kPi);
      const Eigen::Vector3d parallel(-std::sin(angle), 0, std::cos(angle));
      const auto curvatureAt = [&](double at) {
        const SurfacePoint point = revolvedPoint(curve, 0.3, at, angle);
        const Eigen::Vector2d p = point.frame.transpose() * parallel;
        return p.dot(point.K * p);
      };
      constexpr double kStep = 1e-5;
      const Jet jet = jetAt(curve, t);
      const double expected =
          (curvatureAt(t + kStep) - curvatureAt(t - kStep)) / (2 * kStep * jet.d1.norm());
      const Vec2 tangent = jet.d1.normalized();
      const SurfacePoint point = revolvedPoint(curve, 0.3, t, angle);
      const Eigen::Vector2d p = point.frame.transpose() * parallel,
                            m = point.frame.transpose() *
                                Eigen::Vector3d(tangent.x() * std::cos(angle), tangent.y(),
                                                tangent.x() * std::sin(angle));
      EXPECT_NEAR(point.C(m, p, p), expected, 1e-6 * (1.0 + std::abs(expected)));
    }
  }
}

TEST(Swept, MeshesLieOnTheSurfaceAndFaceOutward) {
  constexpr double kAxis = 0.4;
  Random random(announcedSeed("meshes", 33));
  for (const Curve& curve : {ring(false), ring(true), randomCurve(random)}) {
    const bool closed = isClosed(curve);
    const Sweeping sweeping{.samplesPerPiece = 10, .layers = 24};
    const SweptMesh prism = extrude(curve, 2.0, sweeping), vase = revolve(curve, kAxis, sweeping);
    const std::size_t samples = closed ? 40 : 11;
    EXPECT_EQ(prism.soup.vertexCount(), samples * 25);
    EXPECT_EQ(vase.soup.vertexCount(), samples * 24);
    for (const auto* swept : {&prism, &vase}) {
      const auto [mesh, report] = buildMesh(swept->soup);
      expectSound(mesh);
      EXPECT_EQ(report.pieces, 1u);
      EXPECT_EQ(report.turnedTriangles, 0u);
      EXPECT_EQ(report.invertedPieces, 0u) << "made inside out";
      const bool whole = closed && swept == &vase;
      const std::size_t rim = swept == &prism ? 2 * (closed ? 40 : 10 + 24) : closed ? 0 : 2 * 24;
      EXPECT_EQ(report.borderEdges, rim);
      if (whole) {
        // Pappus: 2 pi times the distance of the middle times the area of the profile; chords lose.
        const double cells = std::pow(mesh.unit, 3) * sixfoldVolume(mesh) / 6;
        EXPECT_NEAR(cells, 2 * kPi * (3 - kAxis) * 3.1, 0.06 * 58);
      }
      for (const auto& [a, b, c] : mesh.triangles) {
        const Eigen::Vector3d p = mesh.positionInFile(a);
        const Eigen::Vector3d n = (mesh.positionInFile(b) - p).cross(mesh.positionInFile(c) - p);
        const double t = swept->parameters[mesh.fileVertex[a]];
        const SurfacePoint point =
            swept == &prism ? extrudedPoint(curve, t, p.z())
                            : revolvedPoint(curve, kAxis, t, std::atan2(p.z(), p.x() - kAxis));
        EXPECT_LT((point.p - p).norm(), 1e-6);
        EXPECT_GT(n.normalized().dot(point.n), closed ? 0.9 : -1.0);
      }
    }
  }
  // Above an open curve that runs to the right.
  const Curve line = BezierChain(1, false, {{0, 0}, {1, 0}});
  EXPECT_EQ(extrudedPoint(line, 0.5, 0).n, Eigen::Vector3d::UnitY());
}

TEST(Revolve, ACurveThatMeetsTheAxisHasPoles) {
  // Half a circle, roughly: from the axis to the axis.
  const Curve half = BezierChain(3, false, {{0, -1}, {1.33, -1}, {1.33, 1}, {0, 1}});
  const auto [mesh, report] =
      buildMesh(revolve(half, 0.0, {.samplesPerPiece = 16, .layers = 20}).soup);
  expectSound(mesh);
  EXPECT_EQ(report.borderEdges, 0u);
  EXPECT_EQ(report.collapsedTriangles, 2u * 20u);
  EXPECT_EQ(report.pieces, 1u);
}

}  // namespace
}  // namespace flatland::test
