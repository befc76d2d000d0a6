// SPDX-License-Identifier: GPL-3.0-or-later
// What hides what: against every triangle tried in double, and against closed forms.
#include "core3d/draw/sight.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core3d/diff/estimate_fields.h"
#include "core3d/diff/exact_fields.h"
#include "core3d/draw/compose.h"
#include "core3d/draw/screen_chain.h"
#include "core3d/lines/line_finder.h"
#include "core3d/mesh/build_mesh.h"
#include "tests/core3d/contours.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

void addBox(PolygonSoup& soup, const Vector3d& low, const Vector3d& high) {
  const auto first = static_cast<std::uint32_t>(soup.vertexCount());
  for (int i = 0; i < 8; ++i) {
    soup.addVertex(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                   i & 4 ? high.z() : low.z());
  }
  constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    soup.addTriangle(first + f[0], first + f[1], first + f[2]);
    soup.addTriangle(first + f[0], first + f[2], first + f[3]);
  }
}

// Moeller and Trumbore's test in double, without any rule of which hits count.
std::optional<double> hit(const TriangleMesh& mesh, std::uint32_t t, const Vector3d& origin,
                          const Vector3d& direction) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Vector3d p = mesh.position(a).cast<double>();
  const Vector3d e = mesh.position(b).cast<double>() - p, f = mesh.position(c).cast<double>() - p;
  const Vector3d q = direction.cross(f);
  const double det = e.dot(q);
  if (std::abs(det) < 1e-12) return std::nullopt;
  const Vector3d s = origin - p;
  const double u = s.dot(q) / det;
  const Vector3d r = s.cross(e);
  const double v = direction.dot(r) / det;
  const double distance = f.dot(r) / det;
  if (u < 0.0 || v < 0.0 || u + v > 1.0) return std::nullopt;
  return distance;
}

bool hiddenByTryingAll(const TriangleMesh& mesh, const SightPoint& point, const SurfaceView& view) {
  const Vector3d w = view.towardsViewer(point.at);
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto distance = hit(mesh, t, point.at, w);
    if (t != point.triangle && distance && *distance > 1e-3 &&
        *distance < view.distanceTo(point.at).value_or(1e9)) {
      return true;
    }
  }
  return false;
}

TEST(Sight, AgreesWithTryingAllTriangles) {
  Random random(announcedSeed("AgreesWithTryingAllTriangles", 5));
  PolygonSoup soup;
  for (int i = 0; i < 12; ++i) {
    const Vector3d low(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    addBox(soup, low, low + Vector3d(uniform(random, 0.1, 0.8), uniform(random, 0.1, 0.8), 0.3));
  }
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const SurfaceFields none;
  const Sight sight(mesh, none);
  const FlushDenormals flush;
  int hidden = 0, differ = 0;
  constexpr int kRays = 20000;
  for (int i = 0; i < kRays; ++i) {
    SurfaceView view;
    view.towards = Vector3d(normal(random), normal(random), normal(random)).normalized();
    if (i % 2 == 1) view.eye = 4.0 * view.towards;
    const auto t = static_cast<std::uint32_t>(
        uniformInt(random, 0, static_cast<int>(mesh.triangleCount()) - 1));
    double a = uniform(random, 0, 1), b = uniform(random, 0, 1);
    if (a + b > 1.0) a = 1.0 - a, b = 1.0 - b;
    const auto& corners = mesh.triangles[t];
    const Vector3d p = mesh.position(corners[0]).cast<double>();
    const Vector3d at = p + a * (mesh.position(corners[1]).cast<double>() - p) +
                        b * (mesh.position(corners[2]).cast<double>() - p);
    const SightPoint point{at, t, false};
    const bool expected = hiddenByTryingAll(mesh, point, view);
    hidden += expected;
    differ += sight.hidden(point, view, 1e-5) != expected;
  }
  EXPECT_GT(hidden, kRays / 4);
  EXPECT_LT(hidden, kRays * 9 / 10);
  // What is left are rays within a thousandth of an edge.
  EXPECT_LE(differ, kRays / 500);
}

TEST(Sight, ViewerStandsBeforeWhatIsBehindHim) {
  PolygonSoup soup;
  addBox(soup, {-1, -1, -1}, {1, 1, -0.8});
  addBox(soup, {-1, -1, 0.8}, {1, 1, 1});
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const SurfaceFields none;
  const Sight sight(mesh, none);
  std::uint32_t top = 0;  // of the lower box
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    bool all = true;
    for (const std::uint32_t v : mesh.triangles[t]) all &= std::abs(mesh.z[v] + 0.8f) < 1e-6f;
    if (all) top = t;
  }
  const auto& [a, b, c] = mesh.triangles[top];
  const Vector3d at =
      ((mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3.0f).cast<double>();
  SurfaceView view;
  EXPECT_TRUE(sight.hidden({at, top, false}, view, 1e-5));
  view.eye = Vector3d(0.1, 0.0, 0.5);  // between the boxes
  EXPECT_FALSE(sight.hidden({at, top, false}, view, 1e-5));
  view.eye = Vector3d(0.1, 0.0, 1.5);
  EXPECT_TRUE(sight.hidden({at, top, false}, view, 1e-5));
}

Drawing contoursOf(const Solid& solid, const Meshing& meshing, const Camera& camera,
                   StrokeOptions strokes = {}, LineOptions lines = {}) {
  const SolidMesh made = meshOf(solid, meshing);
  const TriangleMesh mesh = buildMesh(made.soup).mesh;
  const SurfaceFields fields = exactFields(solid, made.places, mesh);
  const Projection projection = projectionOf(camera, mesh);
  FeatureLines found;
  found.of(LineFamily::OccludingContours) = interpolatedContours(mesh, fields, projection.view());
  if (!lines[LineFamily::ExteriorSilhouette]) lines[LineFamily::OccludingContours] = true;
  return composeDrawing(found, Sight(mesh, fields), projection, lines, strokes);
}

double lengthOf(const Drawing& drawing, bool visible) {
  double length = 0.0;
  for (const Polyline& line : drawing.polylines) {
    if (line.visible != visible) continue;
    for (std::size_t i = 0; i + 1 < line.screen.size(); ++i) {
      length += (line.screen[i + 1] - line.screen[i]).norm();
    }
    if (line.closed) length += (line.screen.front() - line.screen.back()).norm();
  }
  return length;
}

TEST(Sight, ConvexSolidsHideNoneOfTheirContour) {
  Random random(announcedSeed("ConvexSolidsHideNoneOfTheirContour", 6));
  for (const Solid& solid :
       {Solid{SolidKind::Sphere, 1.0}, Solid{SolidKind::Ellipsoid, 1, 0.5, 0.3},
        Solid{SolidKind::RoundedCube, 1.0}}) {
    for (int trial = 0; trial < 12; ++trial) {
      Camera camera;
      camera.towards = {normal(random), normal(random), normal(random)};
      if (trial % 2 == 1) camera.perspectiveDeg = 30.0;
      const Meshing meshing{.cells = trial < 4 ? 4 : 24,
                            .irregular = true,
                            .seed = static_cast<std::uint64_t>(trial)};
      const Drawing drawing = contoursOf(solid, meshing, camera, {.hidden = true});
      EXPECT_GT(lengthOf(drawing, true), 500.0);
      EXPECT_EQ(lengthOf(drawing, false), 0.0) << solid.name() << ", trial " << trial;
      ASSERT_EQ(drawing.polylines.size(), 1u) << solid.name() << ", trial " << trial;
      EXPECT_TRUE(drawing.polylines.front().closed);
    }
  }
}

// A torus about z, radii 1 and b, seen from the angle above its plane. Its contour points have
// normals across the view: for each direction about the axis two angles round the tube.
struct TorusContour {
  double visible = 0.0, hidden = 0.0;  // lengths, in units of the solid
};

// By a fine walk; the torus that may hide a point is met by solving along the line of sight in
// small steps of its implicit function.
TorusContour torusContour(double b, double elevation) {
  const Vector3d w(std::cos(elevation), 0.0, std::sin(elevation));
  const auto inside = [b](const Vector3d& p) {
    const double ring = std::hypot(p.x(), p.y()) - 1.0;
    return ring * ring + p.z() * p.z() < b * b;
  };
  const Vector3d right(0.0, 1.0, 0.0), up = w.cross(right);
  TorusContour result;
  constexpr int kSteps = 2000;
  for (const int branch : {0, 1}) {
    std::optional<Vector2d> before;
    for (int i = 0; i <= kSteps; ++i) {
      const double u = 2.0 * std::numbers::pi * i / kSteps;
      // n = (cos u cos v, sin u cos v, sin v); n.w = 0.
      const double v = std::atan2(-std::cos(u) * w.x(), w.z()) + branch * std::numbers::pi;
      const double ring = 1.0 + b * std::cos(v);
      const Vector3d p(ring * std::cos(u), ring * std::sin(u), b * std::sin(v));
      const Vector3d n(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
      bool hidden = false;
      for (int k = 1; k < 1500 && !hidden; ++k) hidden = inside(p + 1e-5 * n + 0.002 * k * w);
      const Vector2d now(right.dot(p), up.dot(p));
      if (before) (hidden ? result.hidden : result.visible) += (now - *before).norm();
      before = now;
    }
  }
  return result;
}

TEST(Sight, TorusHidesTheKnownPartOfItsContour) {
  for (const double elevation : {0.25, 0.5, 0.9}) {
    const TorusContour expected = torusContour(0.4, elevation);
    Camera camera;
    camera.towards = {std::cos(elevation), 0.0, std::sin(elevation)};
    camera.up = Vector3d::UnitZ();
    const Drawing drawing = contoursOf({SolidKind::Torus, 1.0, 0.4},
                                       {.cells = 120, .irregular = true}, camera, {.hidden = true});
    const double scale = drawing.projection.pxPerUnit / 1.4;  // the mesh is 2 long, the torus 2.8
    // Where a contour ends in a cusp it is hidden at the same place; what the mesh moves that end
    // by is a few edges, of 120 around.
    const double room = 0.02 * scale * (expected.visible + expected.hidden);
    EXPECT_NEAR(lengthOf(drawing, true), scale * expected.visible, room) << elevation;
    EXPECT_NEAR(lengthOf(drawing, false), scale * expected.hidden, room) << elevation;
    if (elevation < 0.6) {
      EXPECT_GT(expected.hidden, 0.1);
    }
  }
}

// One line on a plane, of which another plane before it hides the part with x in [-0.25, 0.35].
TEST(Sight, HiddenPartEndsWhereTheUpperPlaneEnds) {
  PolygonSoup soup;
  const auto square = [&soup](double x0, double x1, double y, double z) {
    const auto first = static_cast<std::uint32_t>(soup.vertexCount());
    soup.addVertex(x0, -y, z);
    soup.addVertex(x1, -y, z);
    soup.addVertex(x1, y, z);
    soup.addVertex(x0, y, z);
    soup.addTriangle(first, first + 1, first + 2);
    soup.addTriangle(first, first + 2, first + 3);
  };
  square(-1.0, 1.0, 0.5, 0.0);
  square(-0.25, 0.35, 0.2, 0.7);
  const TriangleMesh mesh = buildMesh(soup).mesh;
  std::uint32_t below = 0;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (mesh.z[mesh.triangles[t][0]] < 0.0f) below = t;
  }
  const auto z = static_cast<float>(mesh.position(mesh.triangles[below][0]).z());
  FeatureLines found;
  found.of(LineFamily::Ridges) = {{{Eigen::Vector3f(-0.9f, -0.1f, z), 9.0f, freeNode(0)},
                                   {Eigen::Vector3f(0.9f, 0.1f, z), 9.0f, freeNode(1)},
                                   below}};
  const SurfaceFields none;
  for (const bool perspective : {false, true}) {
    Camera camera;
    if (perspective) camera.perspectiveDeg = 40.0;
    const Projection projection = projectionOf(camera, mesh);
    LineOptions lines;
    lines[LineFamily::Ridges] = true;
    const Drawing drawing =
        composeDrawing(found, Sight(mesh, none), projection, lines, {.hidden = true});
    ASSERT_EQ(drawing.polylines.size(), 3u);
    EXPECT_GT(drawing.stats.rays, 100u);
    const Vector2d from = *projection.toScreen({-0.25, 0.0, static_cast<double>(z) + 0.7});
    const Vector2d to = *projection.toScreen({0.35, 0.0, static_cast<double>(z) + 0.7});
    EXPECT_TRUE(drawing.polylines[0].visible);
    EXPECT_FALSE(drawing.polylines[1].visible);
    EXPECT_TRUE(drawing.polylines[2].visible);
    EXPECT_NEAR(drawing.polylines[0].screen.back().x(), from.x(), 1.0);
    EXPECT_NEAR(drawing.polylines[1].screen.front().x(), from.x(), 1.0);
    EXPECT_NEAR(drawing.polylines[1].screen.back().x(), to.x(), 1.0);
    EXPECT_NEAR(drawing.polylines[2].screen.front().x(), to.x(), 1.0);
    // Without hidden lines the middle is not there.
    EXPECT_EQ(composeDrawing(found, Sight(mesh, none), projection, lines, {}).polylines.size(), 2u);
  }
}

TEST(Sight, SphereBeforeASphereHidesPartOfItsContour) {
  // Unit spheres seen along z, the nearer one displaced by d: it hides the arc of the other's
  // circle that lies within its own, 2 acos(d / 2).
  constexpr double d = 1.2;
  const SolidMesh one = meshOf({SolidKind::Sphere, 1.0}, {.cells = 40, .irregular = true});
  PolygonSoup soup = one.soup;
  const auto n = static_cast<std::uint32_t>(soup.vertexCount());
  for (std::uint32_t v = 0; v < n; ++v) {
    const double* p = one.soup.positions.data() + 3 * v;
    soup.addVertex(p[0] + d, p[1], p[2] + 3.0);
  }
  for (std::size_t i = 0; i + 2 < one.soup.corners.size(); i += 3) {
    soup.addTriangle(one.soup.corners[i] + n, one.soup.corners[i + 1] + n,
                     one.soup.corners[i + 2] + n);
  }
  const TriangleMesh mesh = buildMesh(soup).mesh;
  SurfaceFields fields;  // exact: normals towards the nearer centre's outside
  fields.resize(mesh.vertexCount());
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vector3d p = mesh.positionInFile(v);
    const Vector3d centre = p.z() > 1.5 ? Vector3d(d, 0.0, 3.0) : Vector3d::Zero();
    const Eigen::Vector3f normal = (p - centre).normalized().cast<float>();
    fields.nx[v] = normal.x();
    fields.ny[v] = normal.y();
    fields.nz[v] = normal.z();
  }
  const Projection projection = projectionOf(Camera(), mesh);
  FeatureLines found;
  found.of(LineFamily::OccludingContours) = interpolatedContours(mesh, fields, projection.view());
  LineOptions lines;
  lines[LineFamily::OccludingContours] = true;
  const Drawing drawing =
      composeDrawing(found, Sight(mesh, fields), projection, lines, {.hidden = true});
  const double radius = projection.pxPerUnit / mesh.unit;
  const double hidden = 2.0 * std::acos(d / 2.0) * radius;
  EXPECT_NEAR(lengthOf(drawing, false), hidden, 3.0);
  EXPECT_NEAR(lengthOf(drawing, true), 4.0 * std::numbers::pi * radius - hidden, 3.0);
  EXPECT_EQ(drawing.polylines.size(), 3u);

  // The outline is what neither hides nor has a sphere behind it: both arcs outside the other.
  LineOptions outline;
  outline[LineFamily::ExteriorSilhouette] = true;
  const Drawing outer = composeDrawing(found, Sight(mesh, fields), projection, outline, {});
  EXPECT_NEAR(lengthOf(outer, true), 4.0 * std::numbers::pi * radius - 2.0 * hidden, 6.0);
  for (const Polyline& line : outer.polylines) {
    EXPECT_EQ(line.family, LineFamily::ExteriorSilhouette);
    for (const Vector2d& p : line.screen) {
      const auto distance = [&](const Vector3d& centre) {
        return (p - *projection.toScreen((centre - mesh.origin) / mesh.unit)).norm();
      };
      EXPECT_GT(std::min(distance({d, 0.0, 3.0}), distance({0.0, 0.0, 0.0})), radius - 1.0);
    }
  }
  // With contours on as well nothing is drawn twice.
  outline[LineFamily::OccludingContours] = true;
  const Drawing both = composeDrawing(found, Sight(mesh, fields), projection, outline, {});
  EXPECT_NEAR(lengthOf(both, true), lengthOf(drawing, true), 0.5);
}

// Each edge belongs to one triangle, which may face away although the edge is seen.
TEST(Sight, OnlyTheThreeFarthestCreasesOfABoxAreHidden) {
  PolygonSoup soup;
  addBox(soup, {0, 0, 0}, {1, 1, 1});
  const TriangleMesh mesh = buildMesh(soup).mesh;
  const SurfaceFields fields = estimateFields(mesh);
  LineOptions lines;
  lines[LineFamily::Creases] = true;
  for (const Vector3d& towards :
       {Vector3d(1, 0.8, 2), Vector3d(-1, 0.8, 2), Vector3d(1, -0.8, -2), Vector3d(-2, -1, 0.7)}) {
    Camera camera;
    camera.towards = towards;
    const Projection projection = projectionOf(camera, mesh);
    const StrokeOptions strokes{.hidden = true};
    const FeatureLines found =
        LineFinder(mesh, fields).find(projection.view(), linesToFind(lines, strokes));
    const Drawing drawing = composeDrawing(found, Sight(mesh, fields), projection, lines, strokes);
    const Vector3d w = towards.normalized();
    double three = 0.0;
    for (int k = 0; k < 3; ++k)
      three += projection.pxPerUnit / mesh.unit * std::sqrt(1.0 - w[k] * w[k]);
    EXPECT_NEAR(lengthOf(drawing, false), three, 3.0);
    EXPECT_NEAR(lengthOf(drawing, true), 3.0 * three, 3.0);
  }
}

TEST(Sight, TheOutlineIsDrawnOnceAndNeverHidden) {
  const Solid torus{SolidKind::Torus, 1.0, 0.4};
  const SolidMesh made = meshOf(torus, {.cells = 60});
  const TriangleMesh mesh = buildMesh(made.soup).mesh;
  const SurfaceFields fields = exactFields(torus, made.places, mesh);
  Camera camera;
  camera.towards = {std::cos(0.5), 0.0, std::sin(0.5)};
  camera.up = Vector3d::UnitZ();
  const Projection projection = projectionOf(camera, mesh);
  const auto draw = [&](std::initializer_list<LineFamily> families) {
    LineOptions lines;
    for (const LineFamily family : families) lines[family] = true;
    const StrokeOptions strokes{.hidden = true};
    const FeatureLines found =
        LineFinder(mesh, fields).find(projection.view(), linesToFind(lines, strokes));
    return composeDrawing(found, Sight(mesh, fields), projection, lines, strokes);
  };
  const Drawing contours = draw({LineFamily::OccludingContours});
  const Drawing outline = draw({LineFamily::ExteriorSilhouette});
  const Drawing both = draw({LineFamily::ExteriorSilhouette, LineFamily::OccludingContours});
  EXPECT_GT(lengthOf(outline, true), 500.0);
  EXPECT_EQ(lengthOf(outline, false), 0.0);
  // The far rim of the hole is seen before the tube's own inside.
  EXPECT_LT(lengthOf(outline, true), lengthOf(contours, true) - 20.0);
  EXPECT_NEAR(lengthOf(both, true), lengthOf(contours, true), 1.0);
  double asOutline = 0.0;
  for (const Polyline& line : both.polylines) {
    Drawing one;
    one.polylines = {line};
    if (line.family == LineFamily::ExteriorSilhouette) asOutline += lengthOf(one, true);
  }
  EXPECT_NEAR(asOutline, lengthOf(outline, true), 1.0);
}

TEST(Sight, BackEdgesOfABoxAreHidden) {
  PolygonSoup soup;
  addBox(soup, {-1, -0.7, -0.5}, {1, 0.7, 0.5});
  const TriangleMesh mesh = buildMesh(soup).mesh;
  FeatureLines found;
  for (std::uint32_t h = 0; h < 3 * mesh.triangleCount(); ++h) {
    const std::uint32_t a = mesh.vertexOf(h), b = mesh.vertexOf(TriangleMesh::nextCorner(h));
    const Eigen::Vector3f step = mesh.position(b) - mesh.position(a);
    if ((step.array() != 0.0f).count() != 1) continue;  // a diagonal
    found.of(LineFamily::Creases)
        .push_back({{mesh.position(a), 90.0f, vertexNode(a)},
                    {mesh.position(b), 90.0f, vertexNode(b)},
                    h / 3,
                    0,
                    true,
                    mesh.opposite[h] / 3});
  }
  Random random(announcedSeed("BackEdgesOfABoxAreHidden", 7));
  const SurfaceFields none;
  const Sight sight(mesh, none);
  for (int trial = 0; trial < 20; ++trial) {
    Camera camera;
    camera.towards = {normal(random), normal(random), normal(random)};
    const Vector3d w = camera.towards.normalized();
    if (w.cwiseAbs().minCoeff() < 0.05) continue;  // nearly along a face
    LineOptions lines;
    lines[LineFamily::Creases] = true;
    const Projection projection = projectionOf(camera, mesh);
    const Drawing drawing = composeDrawing(found, sight, projection, lines, {.hidden = true});
    // The three edges at the corner farthest from the viewer.
    double hidden = 0.0;
    const Vector3d sizes(2.0, 1.4, 1.0);
    for (int k = 0; k < 3; ++k) {
      const Vector3d edge = sizes[k] * Vector3d::Unit(k);
      hidden += projection.pxPerUnit * (edge - edge.dot(w) * w).norm();
    }
    EXPECT_NEAR(lengthOf(drawing, false), hidden, 9.0);
    EXPECT_NEAR(lengthOf(drawing, true), 3.0 * hidden, 9.0);
  }
}

}  // namespace
}  // namespace flatland::test
