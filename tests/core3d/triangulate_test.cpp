// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Points = std::vector<Eigen::Vector3d>;

PolygonSoup soupOf(const Points& points) {
  PolygonSoup soup;
  std::vector<std::uint32_t> polygon;
  for (const auto& p : points) {
    polygon.push_back(static_cast<std::uint32_t>(soup.vertexCount()));
    soup.addVertex(p.x(), p.y(), p.z());
  }
  soup.addPolygon(polygon);
  return soup;
}

// Of a polygon, by Newell.
Eigen::Vector3d areaVector(const Points& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += 0.5 * (points[i] - points[0]).cross(points[(i + 1) % points.size()] - points[0]);
  }
  return sum;
}

// The triangles cover the polygon once: all of them face its way and their areas add up to its own.
void expectCovered(const Points& points) {
  const Triangulation result = triangulate(soupOf(points));
  ASSERT_EQ(result.triangles.size(), points.size() - 2);
  EXPECT_EQ(result.folded, 0u);
  EXPECT_EQ(result.huge, 0u);
  const Eigen::Vector3d whole = areaVector(points);
  double sum = 0.0;
  for (const auto& [a, b, c] : result.triangles) {
    const double part =
        0.5 * (points[b] - points[a]).cross(points[c] - points[a]).dot(whole.normalized());
    EXPECT_GT(part, 0.0);
    sum += part;
  }
  EXPECT_NEAR(sum, whole.norm(), 1e-12 * whole.norm());
}

TEST(Triangulate, CoversRandomStarsInAnyPlane) {
  Random random(announcedSeed("stars", 11));
  for (int i = 0; i < 300; ++i) {
    const int corners = uniformInt(random, 4, 60);
    Eigen::Matrix3d turn =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized()
            .toRotationMatrix();
    const double scale = std::pow(10.0, uniform(random, -30.0, 30.0));
    Points points;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / corners;
      const double radius = uniform(random, 0.1, 1.0);
      points.push_back(scale * (turn * Eigen::Vector3d(radius * std::cos(angle),
                                                       radius * std::sin(angle), 3.0)));
    }
    expectCovered(points);
  }
}

TEST(Triangulate, CoversCombsWithManyReflexCorners) {
  Points comb;
  for (int i = 0; i < 400; ++i) comb.emplace_back(i, i % 2 == 0 ? 0.0 : 5.0, 0.0);
  comb.emplace_back(399.0, -1.0, 0.0);
  comb.emplace_back(0.0, -1.0, 0.0);
  std::reverse(comb.begin(), comb.end());
  expectCovered(comb);
}

TEST(Triangulate, CornersInALineMakeNoFlatTriangle) {
  expectCovered(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {3, 2, 0}, {0, 2, 0}, {0, 1, 0}});
  expectCovered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 3, 0}});
}

TEST(Triangulate, QuadrilateralsAreCutInside) {
  // An arrowhead, beginning at each of its corners.
  Points arrow = {{0, 0, 0}, {4, -4, 0}, {1, 0, 0}, {4, 4, 0}};
  for (int i = 0; i < 4; ++i) {
    std::rotate(arrow.begin(), arrow.begin() + 1, arrow.end());
    expectCovered(arrow);
  }
  // The shorter diagonal of a kite.
  const Triangulation kite = triangulate(soupOf({{-5, 0, 0}, {0, -1, 0}, {5, 0, 0}, {0, 1, 0}}));
  for (const auto& [a, b, c] : kite.triangles) {
    EXPECT_TRUE((a == 1 || b == 1 || c == 1) && (a == 3 || b == 3 || c == 3));
  }
}

TEST(Triangulate, BridgesToHolesAreFollowed) {
  // A square with a square hole, cut open along a bridge that is walked twice.
  expectCovered({{0, 0, 0},
                 {6, 0, 0},
                 {6, 6, 0},
                 {0, 6, 0},
                 {0, 0, 0},
                 {2, 2, 0},
                 {2, 4, 0},
                 {4, 4, 0},
                 {4, 2, 0},
                 {2, 2, 0}});
}

TEST(Triangulate, WhatCrossesItselfIsToldAndEnds) {
  const Triangulation star =
      triangulate(soupOf({{0, 3, 0}, {-2, -3, 0}, {3, 1, 0}, {-3, 1, 0}, {2, -3, 0}}));
  EXPECT_EQ(star.triangles.size(), 3u);
  EXPECT_EQ(star.folded, 1u);
  const Triangulation line =
      triangulate(soupOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}}));
  EXPECT_EQ(line.triangles.size(), 3u);
}

TEST(Triangulate, EnormousPolygonsEndSoon) {
  // Half of its corners are reflex, so that proper cutting takes their number squared.
  Points comb;
  for (int i = 0; i < 200000; ++i) comb.emplace_back(-i, i % 2 == 0 ? 0.0 : 5.0, 0.0);
  comb.emplace_back(-200000.0, -1.0, 0.0);
  comb.emplace_back(0.0, -1.0, 0.0);
  const Triangulation result = triangulate(soupOf(comb));
  EXPECT_EQ(result.triangles.size(), comb.size() - 2);
  EXPECT_EQ(result.huge, 1u);
}

}  // namespace
}  // namespace flatland::test
