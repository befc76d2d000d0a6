// SPDX-License-Identifier: GPL-3.0-or-later
// Where surfaces pass through themselves: closed forms, all pairs of triangles as the slow
// reference, and thousands of triangles about one vertex.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>

#include "tests/core3d/lines_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<LineSegment> selfIntersectionsOf(const TriangleMesh& mesh) {
  SurfaceFields fields;
  fields.resize(mesh.vertexCount());
  return LineFinder(mesh, fields)
      .find({}, only({LineFamily::SelfIntersections}))
      .of(LineFamily::SelfIntersections);
}

std::vector<LineSegment> selfIntersectionsOf(const PolygonSoup& soup) {
  return selfIntersectionsOf(buildMesh(soup).mesh);
}

TEST(SelfIntersections, TwoSpheresCrossInACircle) {
  SolidMesh two = meshOf({SolidKind::Sphere, 1.0}, {.cells = 24});
  const SolidMesh other = meshOf({SolidKind::Sphere, 1.0}, {.cells = 23});
  const auto first = static_cast<std::uint32_t>(two.soup.vertexCount());
  for (std::size_t v = 0; v < other.soup.vertexCount(); ++v) {
    const double* p = &other.soup.positions[3 * v];
    two.soup.addVertex(p[0] + 1.0, p[1], p[2]);
  }
  for (std::size_t i = 0; i < other.soup.corners.size(); i += 3) {
    const std::uint32_t* c = &other.soup.corners[i];
    two.soup.addTriangle(c[0] + first, c[1] + first, c[2] + first);
  }
  const TriangleMesh mesh = buildMesh(two.soup).mesh;
  const std::vector<LineSegment> found = selfIntersectionsOf(mesh);
  EXPECT_NEAR(totalLength(mesh, found), 2 * kPi * std::sqrt(0.75), 0.02);
  std::map<LineNode, int> degree;
  for (const LineSegment& s : found) {
    EXPECT_LT(std::abs(middleInFile(mesh, s).x() - 0.5), 5e-3);
    ++degree[s.a.node];
    ++degree[s.b.node];
  }
  for (const auto& [node, count] : degree) EXPECT_EQ(count, 2) << "the circle is not closed";
}

TEST(SelfIntersections, WhatLiesInOnePlaneOrTouchesDoesNotPassThroughItself) {
  for (const Solid& solid : standardSolids()) {
    for (const int cells : {20, 57}) {
      EXPECT_TRUE(selfIntersectionsOf(meshOf(solid, {.cells = cells}).soup).empty())
          << solid.name() << ", " << cells;
    }
  }
  // Planes in general position, whose float coordinates are not quite in one plane.
  for (const double slope : {0.0, 0.3, 17.0}) {
    constexpr std::uint32_t kCells = 40;
    PolygonSoup plane;
    for (std::uint32_t j = 0; j <= kCells; ++j) {
      for (std::uint32_t i = 0; i <= kCells; ++i)
        plane.addVertex(0.1 * i, 0.1 * j, slope * (0.1 * i + 0.057 * j));
    }
    for (std::uint32_t j = 0; j < kCells; ++j) {
      for (std::uint32_t i = 0; i < kCells; ++i) {
        const std::uint32_t a = j * (kCells + 1) + i, b = a + kCells + 1;
        plane.addTriangle(a, a + 1, b + 1);
        plane.addTriangle(a, b + 1, b);
      }
    }
    EXPECT_TRUE(selfIntersectionsOf(plane).empty()) << slope;
  }
  // A triangle across another's plane, its tip `depth` past its inside; then just touching its rim.
  const auto pierced = [](double depth, double aside) {
    PolygonSoup two;
    two.addVertex(-1, -1, 0);
    two.addVertex(1, -1, 0);
    two.addVertex(0, 1, 0);
    two.addVertex(aside, -0.2, -depth);
    two.addVertex(aside, -0.3, 1);
    two.addVertex(aside, 0.3, 1);
    two.addTriangle(0, 1, 2);
    two.addTriangle(3, 4, 5);
    return selfIntersectionsOf(two).size();
  };
  EXPECT_EQ(pierced(0.1, 0.1), 1u);
  EXPECT_EQ(pierced(1e-4, 0.1), 1u);
  EXPECT_EQ(pierced(1e-9, 0.1), 0u);
  EXPECT_EQ(pierced(-1e-4, 0.1), 0u);
  EXPECT_EQ(pierced(0.1, 0.9), 0u);
}

/// True if the segment from p to q goes through the triangle.
bool pierces(const Eigen::Vector3d& p, const Eigen::Vector3d& q,
             const std::array<Eigen::Vector3d, 3>& triangle) {
  Eigen::Matrix3d sides;
  sides << triangle[1] - triangle[0], triangle[2] - triangle[0], p - q;
  const Eigen::Vector3d at = sides.inverse() * (p - triangle[0]);
  return at.x() > 0.0 && at.y() > 0.0 && at.x() + at.y() < 1.0 && at.z() > 0.0 && at.z() < 1.0;
}

// Fans of needles about vertices in general position, and single triangles: some are numbered one
// after the other, others far apart, and a vertex of a fan may also be one of another at the same
// place.
TEST(SelfIntersections, AreThoseOfAllPairsThatShareNoPlace) {
  Random random(announcedSeed("self-intersections", 17));
  for (int trial = 0; trial < 6; ++trial) {
    PolygonSoup soup;
    const auto addRandom = [&] {
      soup.addVertex(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
      return static_cast<std::uint32_t>(soup.vertexCount() - 1);
    };
    for (int fan = 0; fan < 8; ++fan) {
      const std::uint32_t apex = addRandom();
      std::uint32_t last = addRandom();
      for (int i = 0; i < (fan % 2 ? 25 : 2); ++i) {
        const std::uint32_t next = addRandom();
        soup.addTriangle(apex, last, next);
        last = next;
      }
    }
    const TriangleMesh mesh = buildMesh(soup).mesh;
    std::vector<std::array<Eigen::Vector3d, 3>> corners(mesh.triangleCount());
    for (std::size_t t = 0; t < corners.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        corners[t][k] = mesh.position(mesh.triangles[t][k]).cast<double>();
    }
    std::vector<std::uint32_t> expected, found;  // the first triangle of each pair
    for (std::uint32_t t = 0; t < corners.size(); ++t) {
      for (std::uint32_t u = t + 1; u < corners.size(); ++u) {
        int ends = 0;
        bool shared = false;
        for (std::size_t k = 0; k < 3; ++k) {
          for (const Eigen::Vector3d& other : corners[u]) shared = shared || corners[t][k] == other;
          ends += pierces(corners[t][k], corners[t][(k + 1) % 3], corners[u]);
          ends += pierces(corners[u][k], corners[u][(k + 1) % 3], corners[t]);
        }
        if (!shared && ends == 2) expected.push_back(t);
      }
    }
    for (const LineSegment& segment : selfIntersectionsOf(mesh)) found.push_back(segment.triangle);
    std::sort(found.begin(), found.end());
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(found, expected);
  }
}

// The boxes of all needles meet at the apex: pair by pair this would take minutes (the time limit
// of this program is one).
TEST(SelfIntersections, ThousandsOfNeedlesAboutAVertexAreNotComparedPairByPair) {
  constexpr std::uint32_t kNeedles = 100000;
  PolygonSoup soup;
  soup.addVertex(0, 0, 1);
  std::size_t crossing = 0;
  for (std::uint32_t i = 0; i < kNeedles; ++i) {
    const auto x = [](std::uint32_t k) { return std::cos(2.0 * kPi * (k + 0.5) / kNeedles); };
    soup.addVertex(x(i), std::sin(2.0 * kPi * (i + 0.5) / kNeedles), 0);
    soup.addTriangle(0, 1 + i, 1 + (i + 1) % kNeedles);
    crossing += std::max(x(i), x(i + 1)) > 0.6;
  }
  // Across those that reach beyond x = 0.6.
  soup.addVertex(0.6, -9, -9);
  soup.addVertex(0.6, 9, -9);
  soup.addVertex(0.6, 0, 9);
  soup.addTriangle(kNeedles + 1, kNeedles + 2, kNeedles + 3);
  const TriangleMesh mesh = buildMesh(soup).mesh;
  EXPECT_EQ(selfIntersectionsOf(mesh).size(), crossing);
}

}  // namespace
}  // namespace flatland::test
