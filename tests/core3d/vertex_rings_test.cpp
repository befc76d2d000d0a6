// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/diff/vertex_rings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/grid.h"
#include "core3d/mesh/solids.h"

namespace flatland::test {
namespace {

// Distances in edges from a vertex, by relaxing every triangle until nothing changes.
std::vector<int> distancesFrom(const TriangleMesh& mesh, std::uint32_t v) {
  std::vector<int> distance(mesh.vertexCount(), 1000);
  distance[v] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t a : t) {
        for (const std::uint32_t b : t) {
          if (distance[a] + 1 >= distance[b]) continue;
          distance[b] = distance[a] + 1;
          changed = true;
        }
      }
    }
  }
  return distance;
}

TEST(VertexRings, AreTheVerticesAtEqualDistance) {
  const TriangleMesh mesh = buildMesh(meshOf({SolidKind::Saddle, 0.3, 1.0}, {9, true}).soup).mesh;
  const VertexNeighbours neighbours(mesh);
  VertexRings rings(neighbours);
  // A second round with the same buffers must not remember the first.
  for (const std::uint32_t v : {7u, 50u, 0u}) {
    const std::vector<int> distance = distancesFrom(mesh, v);
    rings.startAt(v);
    for (int k = 0; k <= 10; ++k) {
      if (k > 0) rings.grow();
      ASSERT_EQ(rings.rings(), k);
      std::vector<std::uint32_t> expected, found(rings.ring(k).begin(), rings.ring(k).end());
      for (std::uint32_t q = 0; q < distance.size(); ++q)
        if (distance[q] == k) expected.push_back(q);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << "ring " << k << " of " << v;
    }
  }
}

// Two squares that meet at a right angle along x = 0.
TriangleMesh bentSheet(double angleRad) {
  PolygonSoup soup;
  for (int j = 0; j <= 8; ++j) {
    for (int i = -4; i <= 4; ++i) {
      const double along = i > 0 ? std::cos(angleRad) : 1.0, up = i > 0 ? std::sin(angleRad) : 0.0;
      soup.addVertex(along * i, j, up * i);
    }
  }
  addGrid(soup, {.columns = 9, .rows = 9});
  return buildMesh(soup).mesh;
}

TEST(VertexRings, StopAtCreases) {
  const TriangleMesh mesh = bentSheet(0.5 * std::numbers::pi);
  const VertexNeighbours neighbours(mesh);
  VertexRings rings(neighbours);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const auto column = [&](std::uint32_t q) {
      return std::lround(mesh.positionInFile(q).x() + mesh.positionInFile(q).z());
    };
    EXPECT_EQ(neighbours.onCrease[v] != 0, column(v) == 0);
    rings.startAt(v);
    for (int k = 1; k <= 12; ++k) {
      rings.grow();
      for (const std::uint32_t q : rings.ring(k)) {
        // On its own side, or on the crease; from the crease to both sides.
        EXPECT_GE(column(v) * column(q), 0);
      }
    }
    if (column(v) != 0) continue;
    rings.startAt(v);
    rings.grow();
    bool left = false, right = false;
    for (const std::uint32_t q : rings.ring(1)) {
      left = left || column(q) < 0;
      right = right || column(q) > 0;
    }
    EXPECT_TRUE(left && right);
  }
}

TEST(VertexRings, AMildBendIsNoCrease) {
  const TriangleMesh mesh = bentSheet(0.25 * std::numbers::pi);
  const VertexNeighbours neighbours(mesh);
  EXPECT_EQ(std::count(neighbours.onCrease.begin(), neighbours.onCrease.end(), 1), 0);
}

TEST(VertexRings, TakeSomeOfTheManyNeighboursOfATip) {
  constexpr std::uint32_t kSides = 5000;
  PolygonSoup soup;
  soup.addVertex(0.0, 0.0, 1.0);
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    soup.addVertex(std::cos(angle), std::sin(angle), 0.0);
    soup.addTriangle(0, 1 + i, 1 + (i + 1) % kSides);
  }
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const VertexNeighbours neighbours(mesh);
  VertexRings rings(neighbours);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); v += 97) {
    rings.startAt(v);
    for (int k = 1; k <= 3; ++k) {
      rings.grow();
      EXPECT_LE(rings.ring(k).size(), 200u);
    }
    EXPECT_GE(rings.ring(1).size() + rings.ring(2).size(), 40u);
  }
}

}  // namespace
}  // namespace flatland::test
