// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/lines/vertex_terms.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core3d/diff/exact_fields.h"
#include "core3d/mesh/build_mesh.h"

namespace flatland::test {
namespace {

struct Case {
  TriangleMesh mesh;
  SurfaceFields fields;
};

Case caseOf(const Solid& solid, int cells) {
  const SolidMesh made = meshOf(solid, {.cells = cells});
  Case c{buildMesh(made.soup).mesh, {}};
  c.fields = exactFields(solid, made.places, c.mesh);
  c.fields.size = surfaceSize(c.mesh);
  return c;
}

/// Fields are rounded to float; near a contour their error grows by 1 / (n.w)^2.
constexpr double kFloat = 1e-5;

TEST(VertexTerms, OnASphereLambdaIsOneOverTheCosineSquared) {
  const Case c = caseOf({SolidKind::Sphere, 3.0}, 12);
  SurfaceView view;
  view.towards = Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  int seen = 0;
  for (std::uint32_t v = 0; v < c.mesh.vertexCount(); ++v) {
    const auto terms = termsAt(c.mesh, c.fields, view, v);
    ASSERT_TRUE(terms);
    if (std::abs(terms->nw) < 0.1) continue;
    ++seen;
    // Dimensionless: the radius is the size of a sphere, up to the mesh's coarseness.
    const double k = c.fields.k1[v] * c.fields.size;
    EXPECT_NEAR(terms->k1, k, kFloat);
    EXPECT_NEAR(terms->nw, c.mesh.position(v).cast<double>().normalized().dot(view.towards), 1e-4);
    EXPECT_NEAR(*terms->lambda, k * k / (terms->nw * terms->nw),
                kFloat / (terms->nw * terms->nw) * 10.0);
    // K and C of a sphere: nothing but the offset is left, and it grows towards the contour.
    EXPECT_NEAR(terms->feature, 0.0, 1e-3);
    EXPECT_EQ(terms->perspective, 0.0);
  }
  EXPECT_GT(seen, 100);
}

TEST(VertexTerms, TheSumIsHalfTheDerivativeOfLambdaAlongR) {
  // The neighbours of the vertices of a fine mesh know lambda too: its difference along r, fitted
  // over the one-ring, has to agree. Coarse, but a wrong sign or factor is far off.
  const Case c = caseOf({SolidKind::Torus, 1.0, 0.4}, 200);
  SurfaceView view;
  view.towards = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
  int compared = 0;
  for (std::uint32_t v = 0; v < c.mesh.vertexCount(); v += 37) {
    const auto terms = termsAt(c.mesh, c.fields, view, v);
    ASSERT_TRUE(terms && terms->lambda);
    if (std::abs(terms->nw) < 0.4) continue;
    // Lambda must be smooth here: the two directions are well apart.
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    Eigen::Vector2d products = Eigen::Vector2d::Zero();
    const Eigen::Vector3d e1 = c.fields.e1(v).cast<double>(), e2 = c.fields.e2(v).cast<double>();
    for (std::uint32_t i = c.mesh.cornerStart[v]; i < c.mesh.cornerStart[v + 1]; ++i) {
      const std::uint32_t other = c.mesh.vertexOf(TriangleMesh::nextCorner(c.mesh.cornersAt[i]));
      const Eigen::Vector3d away = (c.mesh.position(other) - c.mesh.position(v)).cast<double>();
      const Eigen::Vector2d at(away.dot(e1), away.dot(e2));
      const auto there = termsAt(c.mesh, c.fields, view, other);
      squares += at * at.transpose();
      products += at * (*there->lambda - *terms->lambda);
    }
    const Eigen::Vector2d gradient = squares.ldlt().solve(products);
    const Eigen::Vector2d r(terms->r.dot(e1), terms->r.dot(e2));
    const double measured = 0.5 * gradient.dot(r) * c.fields.size;
    const double sum = terms->feature + terms->offset;
    if (std::abs(sum) < 1.0) continue;
    ++compared;
    EXPECT_NEAR(measured / sum, 1.0, 0.1) << v;
    ASSERT_TRUE(terms->offsetShare());
    EXPECT_DOUBLE_EQ(*terms->offsetShare(), std::abs(terms->offset / terms->feature));
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace flatland::test
