// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/lines/vertex_terms.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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

// The direction of largest lambda has no sign of its own, so terms taken with any sign jump between
// neighbours. Turned to where lambda grows, they may jump only where it stops growing: where the
// sum of the terms passes through 0.
TEST(VertexTerms, TowardsGrowthTheTermsJumpOnlyWhereTheirSumIsZero) {
  const Case c = caseOf({SolidKind::Torus, 1.0, 0.4}, 200);
  SurfaceView view;
  view.towards = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
  std::vector<std::optional<SurfaceTerms>> as, growing;
  for (std::uint32_t v = 0; v < c.mesh.vertexCount(); ++v) {
    as.push_back(termsAt(c.mesh, c.fields, view, v));
    growing.push_back(as.back() ? std::optional(as.back()->towardsGrowth()) : std::nullopt);
  }
  const auto sum = [](const SurfaceTerms& t) { return t.feature + t.offset + t.perspective; };
  // Neighbours that look alike but for the sign of the offset term, far from a ridge.
  const auto jumps = [&](const std::vector<std::optional<SurfaceTerms>>& terms) {
    int count = 0;
    for (const auto& t : c.mesh.triangles) {
      const auto &a = terms[t[0]], &b = terms[t[1]];
      if (!a || !b || std::min(std::abs(a->nw), std::abs(b->nw)) < 0.4) continue;
      const double least = std::min(std::abs(sum(*a)), std::abs(sum(*b)));
      const double between = std::abs(std::abs(sum(*a)) - std::abs(sum(*b)));
      const bool nearRidge = least < 4.0 * between + 1e-3;
      const bool turned = std::abs(a->offset + b->offset) < std::abs(a->offset - b->offset) / 4.0;
      if (!nearRidge && turned && std::abs(a->offset) > 0.1) ++count;
    }
    return count;
  };
  EXPECT_EQ(jumps(growing), 0);
  EXPECT_GT(jumps(as), 10) << "or this test sees nothing";
  for (std::size_t v = 0; v < as.size(); ++v) {
    if (!as[v]) continue;
    const SurfaceTerms &was = *as[v], &is = *growing[v];
    EXPECT_GE(sum(is), 0.0);
    EXPECT_EQ(is.offsetShare(), was.offsetShare());
    EXPECT_EQ(is.feature, is.r.dot(was.r) < 0.0 ? -was.feature : was.feature);
  }
}

}  // namespace
}  // namespace flatland::test
