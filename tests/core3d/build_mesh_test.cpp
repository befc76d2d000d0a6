// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/mesh/build_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core3d/mesh/hilbert.h"
#include "core3d/mesh/solids.h"
#include "flatland/io/input_error.h"
#include "tests/core3d/mesh_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

PolygonSoup soupOf(const std::vector<std::array<double, 3>>& points,
                   const std::vector<std::vector<std::uint32_t>>& polygons) {
  PolygonSoup soup;
  for (const auto& [x, y, z] : points) soup.addVertex(x, y, z);
  for (const auto& polygon : polygons) soup.addPolygon(polygon);
  return soup;
}

PolygonSoup cube(double x, double y, double z, bool outward = true) {
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 8; ++i) points.push_back({x + (i & 1), y + (i >> 1 & 1), z + (i >> 2)});
  std::vector<std::vector<std::uint32_t>> faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  if (!outward) {
    for (auto& face : faces) std::reverse(face.begin(), face.end());
  }
  return soupOf(points, faces);
}

PolygonSoup together(const PolygonSoup& a, const PolygonSoup& b) {
  PolygonSoup both = a;
  both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
  for (std::size_t i = 0; i < b.polygonCount(); ++i) {
    std::vector<std::uint32_t> polygon(b.polygon(i).begin(), b.polygon(i).end());
    for (auto& v : polygon) v += static_cast<std::uint32_t>(a.vertexCount());
    both.addPolygon(polygon);
  }
  return both;
}

// The same surface in another order: vertices, faces, and where each face begins.
PolygonSoup shuffled(const PolygonSoup& soup, Random& random) {
  std::vector<std::uint32_t> place(soup.vertexCount()), faces(soup.polygonCount());
  std::iota(place.begin(), place.end(), 0u);
  std::iota(faces.begin(), faces.end(), 0u);
  std::shuffle(place.begin(), place.end(), random);
  std::shuffle(faces.begin(), faces.end(), random);
  PolygonSoup other;
  other.positions.resize(soup.positions.size());
  for (std::size_t v = 0; v < place.size(); ++v) {
    std::copy_n(&soup.positions[3 * v], 3, &other.positions[3 * place[v]]);
  }
  for (const std::uint32_t f : faces) {
    std::vector<std::uint32_t> polygon;
    for (const std::uint32_t v : soup.polygon(f)) polygon.push_back(place[v]);
    std::rotate(polygon.begin(),
                polygon.begin() + uniformInt(random, 0, static_cast<int>(polygon.size()) - 1),
                polygon.end());
    other.addPolygon(polygon);
  }
  return other;
}

PolygonSoup moved(const PolygonSoup& soup, double scale, const Eigen::Vector3d& shift) {
  PolygonSoup other = soup;
  for (std::size_t i = 0; i < other.positions.size(); ++i) {
    other.positions[i] = scale * other.positions[i] + shift[static_cast<int>(i % 3)];
  }
  return other;
}

TEST(Hilbert, VisitsEveryCellOnceAndStepsToNeighboursOnly) {
  constexpr int kBits = 4, kSide = 1 << kBits;
  std::vector<Eigen::Vector3i> cells(kSide * kSide * kSide, Eigen::Vector3i::Constant(-1));
  for (int x = 0; x < kSide; ++x) {
    for (int y = 0; y < kSide; ++y) {
      for (int z = 0; z < kSide; ++z) {
        const std::uint64_t key =
            hilbertKey(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                       static_cast<std::uint32_t>(z), kBits);
        ASSERT_LT(key, cells.size());
        ASSERT_EQ(cells[key].x(), -1) << "visited twice";
        cells[key] = {x, y, z};
      }
    }
  }
  for (std::size_t i = 1; i < cells.size(); ++i) {
    ASSERT_EQ((cells[i] - cells[i - 1]).cwiseAbs().sum(), 1) << i;
  }
}

TEST(BuildMesh, ACubeIsClosedAndFacesOutward) {
  const auto [mesh, report] = buildMesh(cube(10, 20, 30));
  expectSound(mesh);
  EXPECT_EQ(mesh.vertexCount(), 8u);
  EXPECT_EQ(mesh.triangleCount(), 12u);
  EXPECT_EQ(report.edges, 18u);
  EXPECT_EQ(report.borderEdges, 0u);
  EXPECT_EQ(report.pieces, 1u);
  EXPECT_TRUE(report.sentences().empty());
  EXPECT_DOUBLE_EQ(sixfoldVolume(mesh), 6.0 * 8.0);
  EXPECT_EQ(mesh.origin, Eigen::Vector3d(10.5, 20.5, 30.5));
  EXPECT_EQ(mesh.unit, 0.5);
  std::set<std::uint32_t> polygons(mesh.filePolygon.begin(), mesh.filePolygon.end());
  EXPECT_EQ(polygons.size(), 6u);
}

TEST(BuildMesh, TheMapsLeadBackToTheFile) {
  Random random(announcedSeed("maps", 5));
  PolygonSoup soup =
      meshOf({SolidKind::BumpySphere, 1.0, 0.1, 5.0}, {.cells = 8, .irregular = true}).soup;
  soup.addVertex(7, 7, 7);
  soup = shuffled(soup, random);
  const auto [mesh, report] = buildMesh(soup);
  expectSound(mesh);
  EXPECT_EQ(report.isolatedVertices, 1u);
  std::size_t none = 0;
  for (std::size_t f = 0; f < soup.vertexCount(); ++f) {
    const Eigen::Vector3d p(&soup.positions[3 * f]);
    if (mesh.meshVertex[f] == TriangleMesh::kNone) {
      ++none;
      EXPECT_EQ(p.x(), 7.0);
      continue;
    }
    // Half a unit in the last place of a float of size 1.
    EXPECT_LT((mesh.positionInFile(mesh.meshVertex[f]) - p).cwiseAbs().maxCoeff(),
              mesh.unit * 0x1p-24);
  }
  EXPECT_EQ(none, 1u);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    EXPECT_EQ(mesh.meshVertex[mesh.fileVertex[v]], v);
  }
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto polygon = soup.polygon(mesh.filePolygon[t]);
    for (const std::uint32_t v : mesh.triangles[t]) {
      EXPECT_TRUE(std::any_of(polygon.begin(), polygon.end(),
                              [&](std::uint32_t f) { return mesh.meshVertex[f] == v; }));
    }
  }
}

TEST(BuildMesh, TheOrderOfTheFileDoesNotMatter) {
  Random random(announcedSeed("order", 3));
  std::vector<PolygonSoup> soups;
  for (const Solid& solid : standardSolids())
    soups.push_back(meshOf(solid, {.cells = 9, .irregular = true}).soup);
  // Squares, whose diagonals are equally good, and a sheet that is there twice, wound both ways.
  soups.push_back(cube(0, 0, 0));
  PolygonSoup doubled;
  for (int i = 0; i < 49; ++i) doubled.addVertex(i % 7, i / 7, 0.1 * (i % 3));
  for (const bool down : {false, true}) {
    for (std::uint32_t i = 0; i < 42; ++i) {
      if (i % 7 == 6) continue;
      std::array<std::uint32_t, 4> square = {i, i + 1, i + 8, i + 7};
      if (down) std::reverse(square.begin(), square.end());
      doubled.addPolygon(square);
    }
  }
  soups.push_back(doubled);
  for (const PolygonSoup& soup : soups) {
    SCOPED_TRACE(&soup - soups.data());
    const TriangleMesh first = buildMesh(soup).mesh;
    for (int i = 0; i < 3; ++i) {
      const TriangleMesh other = buildMesh(shuffled(soup, random)).mesh;
      EXPECT_EQ(other.x, first.x);
      EXPECT_EQ(other.y, first.y);
      EXPECT_EQ(other.z, first.z);
      EXPECT_EQ(other.triangles, first.triangles);
      EXPECT_EQ(other.opposite, first.opposite);
      EXPECT_EQ(other.cornerStart, first.cornerStart);
      EXPECT_EQ(other.cornersAt, first.cornersAt);
    }
  }
}

TEST(BuildMesh, SizeAndPlaceDoNotMatter) {
  const PolygonSoup soup = meshOf({SolidKind::Ellipsoid, 1.0, 0.8, 0.6}, {.cells = 10}).soup;
  const TriangleMesh first = buildMesh(soup).mesh;
  // Powers of two change no digit; other sizes and places the last one of a float.
  for (const double scale : {0x1p-900, 0x1p-60, 0x1p60, 0x1p1000, 1e-300, 1e-20, 1e30, 1e300}) {
    SCOPED_TRACE(scale);
    const TriangleMesh other = buildMesh(moved(soup, scale, Eigen::Vector3d::Zero())).mesh;
    expectSound(other);
    EXPECT_NEAR(other.unit / scale, first.unit, 1e-15);
    ASSERT_EQ(other.vertexCount(), first.vertexCount());
    EXPECT_EQ(other.triangleCount(), first.triangleCount());
    EXPECT_NEAR(sixfoldVolume(other), sixfoldVolume(first), 1e-5);
  }
  EXPECT_EQ(buildMesh(moved(soup, 0x1p60, Eigen::Vector3d::Zero())).mesh.triangles,
            first.triangles);
  const BuiltMesh far = buildMesh(moved(soup, 1.0, {1e6, -1e6, 1e6}));
  expectSound(far.mesh);
  EXPECT_EQ(far.mesh.vertexCount(), first.vertexCount());
  EXPECT_NEAR(sixfoldVolume(far.mesh), sixfoldVolume(first), 1e-5);
}

TEST(BuildMesh, WhatHasTheExtentOfAllDoublesIsNormalised) {
  constexpr double kLargest = 1.7976931348623157e308;
  const auto [mesh, report] =
      buildMesh(soupOf({{-kLargest, 0, 0}, {kLargest, 0, 0}, {0, kLargest, 0}, {0, 0, 4.9e-324}},
                       {{0, 1, 2}, {1, 0, 3}}));
  expectSound(mesh);
  // The smallest number has no half.
  EXPECT_THROW(buildMesh(soupOf({{0, 0, 0}, {4.9e-324, 0, 0}, {0, 4.9e-324, 0}}, {{0, 1, 2}})),
               InputError);
}

TEST(BuildMesh, WindingIsMadeToAgree) {
  Random random(announcedSeed("winding", 7));
  PolygonSoup soup = meshOf({SolidKind::Torus, 1.0, 0.4}, {.cells = 12}).soup;
  const TriangleMesh right = buildMesh(soup).mesh;
  EXPECT_GT(sixfoldVolume(right), 0.0);
  std::size_t turned = 0;
  for (std::size_t i = 0; i < soup.corners.size(); i += 3) {
    if (uniform(random, 0, 1) < 0.4) {
      std::swap(soup.corners[i], soup.corners[i + 1]);
      ++turned;
    }
  }
  const auto [mesh, report] = buildMesh(soup);
  EXPECT_EQ(mesh.triangles, right.triangles);
  EXPECT_EQ(mesh.opposite, right.opposite);
  EXPECT_EQ(report.turnedTriangles, turned);
  // All of them inside out: one piece is turned, no single triangle is.
  for (std::size_t i = 0; i < soup.corners.size(); i += 3) {
    std::swap(soup.corners[i], soup.corners[i + 1]);
  }
  const BuiltMesh inverted = buildMesh(soup);
  EXPECT_EQ(inverted.mesh.triangles, right.triangles);
  EXPECT_EQ(inverted.report.invertedPieces, 1u);
}

TEST(BuildMesh, ASurfaceWithABorderKeepsTheSideOfItsMajority) {
  PolygonSoup soup = meshOf({SolidKind::Saddle, 1.0, 1.0}, {.cells = 6}).soup;
  for (const bool down : {false, true}) {
    if (down) {
      for (std::size_t i = 0; i < soup.corners.size(); i += 3) {
        std::swap(soup.corners[i], soup.corners[i + 1]);
      }
    }
    PolygonSoup some = soup;
    for (std::size_t i = 0; i < 30; i += 3) std::swap(some.corners[i], some.corners[i + 1]);
    const auto [mesh, report] = buildMesh(some);
    EXPECT_EQ(report.turnedTriangles, 10u);
    EXPECT_EQ(report.borderEdges, 24u);
    for (const auto& [a, b, c] : mesh.triangles) {
      const Eigen::Vector3f p = mesh.position(a);
      EXPECT_EQ((mesh.position(b) - p).cross(mesh.position(c) - p).z() > 0.0f, !down);
    }
  }
}

TEST(BuildMesh, SurfacesThatTouchAreCutApart) {
  // Two cubes with one edge in common: four faces on it.
  const auto [edge, edgeReport] = buildMesh(together(cube(0, 0, 0), cube(1, 1, 0, false)));
  expectSound(edge);
  EXPECT_EQ(edgeReport.weldedVertices, 2u);
  EXPECT_EQ(edgeReport.nonManifoldEdges, 1u);
  EXPECT_EQ(edgeReport.pieces, 2u);
  EXPECT_EQ(edgeReport.nonManifoldVertices, 2u);
  EXPECT_EQ(edge.vertexCount(), 16u);
  EXPECT_EQ(edgeReport.invertedPieces, 1u);
  EXPECT_EQ(std::count(edge.opposite.begin(), edge.opposite.end(), TriangleMesh::kCut), 4);
  // The volume is about the middle of both, so each counts alone.
  EXPECT_DOUBLE_EQ(sixfoldVolume(edge), 2.0 * 6.0);
  // With one corner in common.
  const auto [corner, cornerReport] = buildMesh(together(cube(0, 0, 0), cube(1, 1, 1)));
  expectSound(corner);
  EXPECT_EQ(cornerReport.nonManifoldVertices, 1u);
  EXPECT_EQ(cornerReport.nonManifoldEdges, 0u);
  EXPECT_EQ(corner.vertexCount(), 16u);
}

TEST(BuildMesh, AMoebiusStripIsCutOnceAcross) {
  PolygonSoup soup;
  constexpr int kCells = 24;
  for (int i = 0; i < kCells; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / kCells;
    for (const double across : {-0.3, 0.0, 0.3}) {
      const double r = 1.0 + across * std::cos(angle / 2);
      soup.addVertex(r * std::cos(angle), r * std::sin(angle), across * std::sin(angle / 2));
    }
  }
  for (std::uint32_t i = 0; i < kCells; ++i) {
    for (std::uint32_t k = 0; k < 2; ++k) {
      const bool last = i + 1 == kCells;
      const std::uint32_t a = 3 * i + k, b = a + 1;
      const std::uint32_t c = last ? 2 - k : a + 3, d = last ? 1 - k : a + 4;
      soup.addPolygon(std::vector<std::uint32_t>{a, c, d, b});
    }
  }
  const auto [mesh, report] = buildMesh(soup);
  expectSound(mesh);
  EXPECT_EQ(report.pieces, 1u);
  EXPECT_EQ(report.borderEdges, 2u * kCells);
  EXPECT_GT(report.unorientableEdges, 0u);
  EXPECT_EQ(mesh.triangleCount(), 4u * kCells);
}

TEST(BuildMesh, FaultsAreCounted) {
  const auto [mesh, report] = buildMesh(soupOf(
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {5, 5, 5}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}},
      {{0, 1, 2}, {2, 1, 0}, {1, 2, 3}, {0, 3, 1}, {5, 6, 7}}));
  expectSound(mesh);
  EXPECT_EQ(mesh.triangleCount(), 1u);
  EXPECT_EQ(report.weldedVertices, 1u);
  EXPECT_EQ(report.duplicateTriangles, 2u);
  EXPECT_EQ(report.collapsedTriangles, 1u);
  EXPECT_EQ(report.strayTriangles, 1u);
  EXPECT_EQ(report.isolatedVertices, 1u);
  EXPECT_EQ(mesh.meshVertex[5], TriangleMesh::kNone);
  EXPECT_EQ(report.sentences().size(), 5u);
  EXPECT_EQ(report.sentences()[0], "1 vertex without a face left out");
  EXPECT_EQ(report.sentences()[3], "2 triangles that repeat another left out");
}

TEST(BuildMesh, AFlatTriangleInASurfaceStays) {
  // Three corners in a line between two others: without it the surface would have a slit.
  const auto [mesh, report] =
      buildMesh(soupOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}},
                       {{0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 4, 2}}));
  expectSound(mesh);
  EXPECT_EQ(mesh.triangleCount(), 4u);
  EXPECT_EQ(report.flatTriangles, 1u);
  EXPECT_EQ(report.borderEdges, 4u);
  EXPECT_EQ(report.turnedTriangles, 0u);
}

TEST(BuildMesh, NothingToSeeIsAnError) {
  EXPECT_THROW(buildMesh(PolygonSoup{}), InputError);
  EXPECT_THROW(buildMesh(soupOf({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}})), InputError);
  EXPECT_THROW(buildMesh(soupOf({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}})), InputError);
  EXPECT_THROW(buildMesh(soupOf({{0, 0, 0}, {1, 1, 1}, {2, 0, 2}}, {{0, 1, 1}})), InputError);
}

}  // namespace
}  // namespace flatland::test
