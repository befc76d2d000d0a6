// SPDX-License-Identifier: GPL-3.0-or-later
// How far the fits of estimateFields look: over noise, and not across features, creases and edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/grid.h"
#include "tests/core3d/fields_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

// A plane of unit cells with a height for each vertex.
template <typename Height>
TriangleMesh heightField(int cells, const Height& height) {
  PolygonSoup soup;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) soup.addVertex(i, j, height(i, j));
  addGrid(soup, {.columns = cells + 1, .rows = cells + 1});
  return buildMesh(soup).mesh;
}

// Root mean square of C over the inner vertices, by edges of the grid.
double roughness(const TriangleMesh& mesh, const SurfaceFields& fields) {
  double sum = 0.0;
  int count = 0;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    if (std::max(std::abs(mesh.x[v]), std::abs(mesh.y[v])) > 0.8f) continue;
    const auto& c = fields.at(mesh, v).C.coefficients;
    sum += c[0] * c[0] + 3.0 * (c[1] * c[1] + c[2] * c[2]) + c[3] * c[3];
    ++count;
  }
  return std::sqrt(sum / count) / (mesh.unit * mesh.unit);
}

TEST(FitSizes, NoiseIsSmoothedByItselfAndByTheScale) {
  Random random(announcedSeed("NoiseIsSmoothed", 405));
  // A hundredth of an edge, as a good scan has.
  const TriangleMesh mesh =
      heightField(50, [&](int, int) { return 0.01 * uniform(random, -1.0, 1.0); });
  for (const auto estimator : kBoth) {
    const double usual = roughness(mesh, estimateFields(mesh, with(estimator)));
    const double twice = roughness(mesh, estimateFields(mesh, with(estimator, 2.0)));
    EXPECT_LT(twice, 0.5 * usual);
    EXPECT_GT(twice, 0.0);
  }
  // Without being told the fit takes wide neighbourhoods here.
  EXPECT_LT(roughness(mesh, estimateFields(mesh, with(FieldEstimator::JetFit))),
            0.1 * roughness(mesh, estimateFields(mesh, with(FieldEstimator::OneRing))));
}

// A groove one edge wide in an otherwise smooth sheet: wide fits would flatten it.
TEST(FitSizes, AGrooveOneEdgeWideStaysSharp) {
  Random random(announcedSeed("AGroove", 406));
  const TriangleMesh mesh = heightField(50, [&](int i, int j) {
    return (i == 25 ? -0.3 : 0.0) + 0.002 * uniform(random, -1.0, 1.0) * (j + 1) / 51.0;
  });
  const SurfaceFields jet = estimateFields(mesh, with(FieldEstimator::JetFit));
  const SurfaceFields ring = estimateFields(mesh, with(FieldEstimator::OneRing));
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    if (std::abs(mesh.y[v]) > 0.8f) continue;
    const double column = mesh.positionInFile(v).x();
    if (column == 25.0) {
      EXPECT_LT(jet.k2[v], 0.9f * ring.k2[v]);  // both negative: a valley
    } else if (std::abs(column - 25.0) > 6.5 && std::abs(mesh.x[v]) < 0.9f) {
      EXPECT_LT(std::abs(jet.k2[v]), 0.02 * std::abs(ring.k2[v]) + 0.02 * mesh.unit);
    }
  }
}

// Heights that go up and down from vertex to vertex beside a plane, from which the noise is known:
// no polynomial holds there, and where all vertices that choose say so the one-ring stands alone.
TEST(FitSizes, WhatNoFitResolvesIsLeftToTheOneRing) {
  Random random(announcedSeed("WhatNoFitResolves", 407));
  const TriangleMesh mesh = heightField(40, [&](int i, int j) {
    return i > 20 ? ((i + j) % 2 == 0 ? 0.15 : -0.15) + uniform(random, -0.02, 0.02) : 0.0;
  });
  const SurfaceFields jet = estimateFields(mesh, with(FieldEstimator::JetFit));
  const SurfaceFields ring = estimateFields(mesh, with(FieldEstimator::OneRing));
  int compared = 0;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    // Few points at the border may be met by chance.
    if (mesh.positionInFile(v).x() < 27.0 || std::max(mesh.x[v], std::abs(mesh.y[v])) > 0.8f)
      continue;
    ++compared;
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ((*arraysOf(jet)[i])[v], (*arraysOf(ring)[i])[v]);
  }
  EXPECT_GT(compared, 250);
}

// A bar two cells wide: the middle of each side lies between two edges and is flat all the same.
TEST(FitSizes, TheEdgesOfABarLeaveItsSidesFlat) {
  constexpr int kAround[8][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  PolygonSoup soup;
  for (int j = 0; j <= 20; ++j)
    for (const auto& [x, y] : kAround) soup.addVertex(x, y, j);
  addGrid(soup, {.columns = 8, .rows = 21, .closedColumns = true});
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const SurfaceFields fields = estimateFields(mesh);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::Vector3d p = mesh.positionInFile(v);
    const bool isMiddle = std::lround(p.x()) == 1 || std::lround(p.y()) == 1;
    if (isMiddle) {
      EXPECT_NEAR(fields.k1[v] / mesh.unit, 0.0, 1e-4);
      EXPECT_NEAR(fields.k2[v] / mesh.unit, 0.0, 1e-4);
    } else {
      EXPECT_GT(std::abs(fields.k1[v]) / mesh.unit, 0.2);
    }
  }
}

// All neighbours of the middle of a face lie on its edges.
TEST(FitSizes, TheEdgesOfASmallCubeLeaveItsFacesFlat) {
  PolygonSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      const int first = static_cast<int>(soup.vertexCount());
      for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
          Eigen::Vector3d p;
          p[axis] = side;
          p[(axis + 1) % 3] = i;
          p[(axis + 2) % 3] = j;
          soup.addVertex(p.x(), p.y(), p.z());
        }
      }
      addGrid(soup, {.first = first, .columns = 3, .rows = 3, .turned = side < 0});
    }
  }
  const TriangleMesh mesh = buildMesh(soup).mesh;
  ASSERT_EQ(mesh.vertexCount(), 26u);
  const SurfaceFields fields = estimateFields(mesh);
  for (std::uint32_t v = 0; v < 26; ++v) {
    if (mesh.position(v).cwiseAbs().sum() > 1.5f) continue;  // the mesh is in [-1, 1]
    EXPECT_NEAR(fields.k1[v], 0.0, 1e-4);
    EXPECT_NEAR(fields.k2[v], 0.0, 1e-4);
  }
}

// The faces of a block are flat up to their edges.
TEST(FitSizes, FitsDoNotReachAcrossCreases) {
  PolygonSoup soup;
  constexpr int kCells = 8;
  for (int j = 0; j <= 2 * kCells; ++j) {
    for (int i = 0; i <= kCells; ++i)
      soup.addVertex(i, std::min(j, kCells), std::max(0, j - kCells));
  }
  addGrid(soup, {.columns = kCells + 1, .rows = 2 * kCells + 1});
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const SurfaceFields fields = estimateFields(mesh);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Eigen::Vector3d p = mesh.positionInFile(v);
    if (std::abs(p.y() - kCells) + std::abs(p.z()) < 0.5) {
      EXPECT_GT(std::max(std::abs(fields.k1[v]), std::abs(fields.k2[v])) / mesh.unit, 0.2);
    } else {
      EXPECT_NEAR(fields.k1[v] / mesh.unit, 0.0, 1e-4);
      EXPECT_NEAR(fields.k2[v] / mesh.unit, 0.0, 1e-4);
    }
  }
}

}  // namespace
}  // namespace flatland::test
