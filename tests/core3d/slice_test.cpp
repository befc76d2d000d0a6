// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of meshes by planes against closed forms and against a cut of every triangle by itself;
// their fits as curves.
#include "core3d/mesh/slice.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/solids.h"
#include "core3d/mesh/swept.h"
#include "flatland/curve/fit.h"
#include "flatland/features/features.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

TriangleMesh meshOfSolid(const Solid& solid, int cells) {
  return buildMesh(meshOf(solid, {.cells = cells, .irregular = true}).soup).mesh;
}

Vector3d randomDirection(Random& random) {
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

double twiceArea(const std::vector<Vec2>& points) {
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    area += cross(points[i], points[(i + 1) % points.size()]);
  }
  return area;
}

// What holds of every section: points on the plane and on their edges, pieces inside their
// triangles, the outside on the left.
void expectSound(const TriangleMesh& mesh, const CutPlane& plane, const Slice& slice) {
  for (const SliceLine& line : slice.lines) {
    const std::size_t count = line.points.size();
    ASSERT_EQ(line.triangles.size(), line.closed ? count : count - 1);
    for (std::size_t i = 0; i < count; ++i) {
      const SlicePoint& p = line.points[i];
      EXPECT_NEAR(plane.height(p.at), 0.0, 1e-12 * mesh.unit);
      EXPECT_GE(p.share, 0.0);
      EXPECT_LE(p.share, 1.0);
    }
    for (std::size_t i = 0; i < line.triangles.size(); ++i) {
      const auto& t = mesh.triangles[line.triangles[i]];
      const Vector3d a = mesh.positionInFile(t[0]), b = mesh.positionInFile(t[1]),
                     c = mesh.positionInFile(t[2]);
      const Vector3d across = (b - a).cross(c - a);
      const Vector3d way = line.points[(i + 1) % count].at - line.points[i].at;
      EXPECT_GE(plane.normal.cross(way).dot(across), -1e-9 * way.norm() * across.norm());
    }
  }
}

double totalLength(const Slice& slice) {
  double sum = 0.0;
  for (const SliceLine& line : slice.lines) sum += line.length();
  return sum;
}

// Every triangle by itself: where its sides meet the plane.
double bruteLength(const TriangleMesh& mesh, const CutPlane& plane) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    std::vector<Vector3d> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d a = mesh.positionInFile(t[k]), b = mesh.positionInFile(t[(k + 1) % 3]);
      const double ha = plane.height(a), hb = plane.height(b);
      if ((ha >= 0.0) != (hb >= 0.0)) ends.push_back(a + ha / (ha - hb) * (b - a));
    }
    if (ends.size() == 2) sum += (ends[1] - ends[0]).norm();
  }
  return sum;
}

TEST(Slice, SphereIsACircleWalkedWithItsOutsideOnTheLeft) {
  Random random(announcedSeed("circles", 71));
  constexpr int kCells = 20;
  const TriangleMesh mesh = meshOfSolid({SolidKind::Sphere, 2.0}, kCells);
  const double edge = 2.0 * 2.0 / kCells * 1.5;  // at most
  for (int i = 0; i < 20; ++i) {
    const double height = uniform(random, -1.8, 1.8);
    const Vector3d n = randomDirection(random);
    const CutPlane plane = planeAcross(height * n, n, randomDirection(random));
    EXPECT_TRUE(plane.right.cross(plane.up).isApprox(plane.normal, 1e-12));
    const Slice slice = sliceMesh(mesh, plane);
    ASSERT_EQ(slice.lines.size(), 1u);
    const SliceLine& line = slice.lines[0];
    EXPECT_TRUE(line.closed);
    for (const SlicePoint& p : line.points) {
      EXPECT_LT(p.at.norm(), 2.0 + 1e-6);
      EXPECT_GT(p.at.norm(), 2.0 - edge * edge / 8.0);
    }
    EXPECT_LT(twiceArea(inPlane(line, plane)), 0.0);
    expectSound(mesh, plane, slice);
  }
}

TEST(Slice, TorusIsTwoCirclesAndTheHoleIsOutside) {
  const TriangleMesh mesh = meshOfSolid({SolidKind::Torus, 2.0, 0.5}, 60);
  const CutPlane plane = planeAcross(Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitY());
  const Slice slice = sliceMesh(mesh, plane);
  ASSERT_EQ(slice.lines.size(), 2u);
  for (const SliceLine& line : slice.lines) {
    const bool outer = line.points[0].at.norm() > 2.0;
    for (const SlicePoint& p : line.points) EXPECT_NEAR(p.at.norm(), outer ? 2.5 : 1.5, 0.02);
    EXPECT_EQ(twiceArea(inPlane(line, plane)) < 0.0, outer);
  }
}

TEST(Slice, CylinderIsAnEllipseOrRulings) {
  const TriangleMesh mesh = meshOfSolid({SolidKind::Cylinder, 1.0, 4.0}, 60);
  const Vector3d n = Vector3d(0.3, 0.2, 1.0).normalized();
  const Slice ellipse = sliceMesh(mesh, planeAcross(Vector3d::Zero(), n, Vector3d::UnitX()));
  ASSERT_EQ(ellipse.lines.size(), 1u);
  EXPECT_TRUE(ellipse.lines[0].closed);
  for (const SlicePoint& p : ellipse.lines[0].points) {
    EXPECT_NEAR(p.at.head<2>().norm(), 1.0, 0.01);
  }
  // Along the axis: from border to border.
  const Slice rulings =
      sliceMesh(mesh, planeAcross(Vector3d(0.1, 0, 0), Vector3d::UnitX(), Vector3d::UnitZ()));
  ASSERT_EQ(rulings.lines.size(), 2u);
  for (const SliceLine& line : rulings.lines) EXPECT_FALSE(line.closed);
  EXPECT_NEAR(totalLength(rulings), 2.0 * 4.0, 0.05);
}

TEST(Slice, CubeThroughItsVerticesEdgesAndFaces) {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) soup.addVertex(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  for (const std::array<std::uint32_t, 4>& q : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                                                {4, 5, 7, 6},
                                                {0, 1, 5, 4},
                                                {2, 6, 7, 3},
                                                {0, 4, 6, 2},
                                                {1, 3, 7, 5}}) {
    soup.addPolygon(q);
  }
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const auto cut = [&](const Vector3d& through, const Vector3d& n) {
    const CutPlane plane = planeAcross(through, n, Vector3d(0.3, 0.4, 0.5));
    const Slice slice = sliceMesh(mesh, plane);
    expectSound(mesh, plane, slice);
    for (const SliceLine& line : slice.lines) EXPECT_TRUE(line.closed);
    return slice;
  };
  // Through four vertices and two edges.
  EXPECT_NEAR(totalLength(cut(Vector3d::Zero(), {1, -1, 0})), 2.0 + 2.0 * std::sqrt(2.0), 1e-6);
  // In a face: its outline from one side, nothing from the other.
  EXPECT_NEAR(totalLength(cut(Vector3d::Ones(), {0, 0, 1})), 4.0, 1e-6);
  EXPECT_EQ(cut(Vector3d::Zero(), {0, 0, 1}).lines.size(), 0u);
  // Touched at a corner: a point is no line.
  const Slice corner = cut(Vector3d::Ones(), {1, 1, 1});
  EXPECT_EQ(corner.lines.size(), 0u);
  EXPECT_EQ(corner.touched, 1u);
  // Through three vertices.
  EXPECT_NEAR(totalLength(cut({1, 0, 0}, {1, 1, 1})), 3.0 * std::sqrt(2.0), 1e-6);
}

TEST(Slice, AgreesWithACutOfEveryTriangleOnMessyMeshes) {
  Random random(announcedSeed("messy", 72));
  for (int i = 0; i < 30; ++i) {
    PolygonSoup soup;
    // Vertices on a coarse lattice: planes through many of them, non-manifold edges, flat
    // triangles.
    const int vertices = uniformInt(random, 5, 40);
    for (int v = 0; v < vertices; ++v) {
      soup.addVertex(uniformInt(random, 0, 3), uniformInt(random, 0, 3), uniformInt(random, 0, 3));
    }
    for (int t = 0; t < 60; ++t) {
      const auto any = [&] {
        return static_cast<std::uint32_t>(uniformInt(random, 0, vertices - 1));
      };
      soup.addTriangle(any(), any(), any());
    }
    const TriangleMesh mesh = buildMesh(soup).mesh;
    for (int k = 0; k < 20; ++k) {
      const bool straight = k % 2 == 0;
      const Vector3d n =
          straight ? Vector3d(Vector3d::Unit(uniformInt(random, 0, 2))) : randomDirection(random);
      const Vector3d through(uniformInt(random, 0, 3), uniformInt(random, 0, 3), 1.0);
      const CutPlane plane = planeAcross(through, n, randomDirection(random));
      const Slice slice = sliceMesh(mesh, plane);
      EXPECT_NEAR(totalLength(slice), bruteLength(mesh, plane), 1e-6);
      expectSound(mesh, plane, slice);
    }
  }
}

TEST(Slice, TheFittedSectionOfAnExtrusionHasTheCurvesMarks) {
  const Curve curve = BezierChain(4, false, {{-2, 0}, {-1, 0.4}, {0, 2}, {1, -0.3}, {2, 0.5}});
  const TriangleMesh mesh =
      buildMesh(extrude(curve, 1.0, {.samplesPerPiece = 120, .layers = 8}).soup).mesh;
  const CutPlane plane = planeAcross({0, 0, 0.07}, Vector3d::UnitZ(), Vector3d::UnitY());
  const Slice slice = sliceMesh(mesh, plane);
  ASSERT_EQ(slice.lines.size(), 1u);
  const auto fit = fitBezierChain(inPlane(slice.lines[0], plane), false, {.tolerance = 1e-3});
  ASSERT_TRUE(fit);
  EXPECT_LE(fit->maxDeviation, 1e-3);
  EXPECT_EQ(fit->corners, 0u);
  const View up{.angleDeg = 90.0, .distance = {}};
  const auto marksOf = [&](const Curve& shape, MarkKind kind) {
    std::vector<Vec2> places;
    for (const Mark& mark : findFeatures(Scene{{SceneCurve{shape}}, up}).marks) {
      if (mark.kind == kind) places.push_back(mark.point);
    }
    return places;
  };
  for (const MarkKind kind :
       {MarkKind::Silhouette, MarkKind::Inflection, MarkKind::ApparentRidge}) {
    const std::vector<Vec2> known = marksOf(curve, kind), found = marksOf(fit->chain, kind);
    for (const Vec2& mark : known) {
      double nearest = 1e9;
      for (const Vec2& place : found) {
        nearest = std::min(nearest, (plane.inSpace(place).head<2>() - mark).norm());
      }
      EXPECT_LT(nearest, 0.05) << nameOf(kind);
    }
  }
}

}  // namespace
}  // namespace flatland::test
