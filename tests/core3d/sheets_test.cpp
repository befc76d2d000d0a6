// SPDX-License-Identifier: GPL-3.0-or-later
// On which side the normal of a surface is must not matter: pieces with an outside are turned that
// way, and sheets are looked at from both sides.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "core3d/diff/estimate_fields.h"
#include "core3d/draw/draughtsman.h"
#include "core3d/io/read_mesh.h"
#include "core3d/mesh/pieces.h"
#include "tests/core3d/example_meshes.h"
#include "tests/core3d/lines_check.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

PolygonSoup reversed(const PolygonSoup& soup) {
  PolygonSoup other;
  other.positions = soup.positions;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    std::vector<std::uint32_t> polygon(soup.polygon(i).begin(), soup.polygon(i).end());
    std::reverse(polygon.begin(), polygon.end());
    other.addPolygon(polygon);
  }
  return other;
}

// A unit sphere as far as z <= top.
PolygonSoup openSphere(double top) {
  const PolygonSoup whole = meshOf({SolidKind::Sphere, 1.0}, {.cells = 60}).soup;
  PolygonSoup open;
  open.positions = whole.positions;
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) {
    double z = 0.0;
    for (const std::uint32_t v : whole.polygon(i)) z += whole.positions[3 * v + 2] / 3.0;
    if (z > top) continue;
    open.addPolygon(std::vector<std::uint32_t>(whole.polygon(i).begin(), whole.polygon(i).end()));
  }
  return open;
}

PieceShape shapeOfAll(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangleCount());
  std::iota(all.begin(), all.end(), 0u);
  return shapeOf(mesh, all, {});
}

TEST(Sheets, ShapeOfASphereWithAHole) {
  for (const double top : {2.0, 0.9, 0.5, 0.0}) {
    SCOPED_TRACE(top);
    const TriangleMesh mesh = buildMesh(openSphere(top)).mesh;
    const PieceShape shape = shapeOfAll(mesh);
    // The sphere as far as `cap`, and the disc that closes it.
    const double cap = std::min(top, 1.0);
    const double area = 2.0 * kPi * (1.0 + cap), hole = kPi * (1.0 - cap * cap);
    const double volume = kPi * (2.0 / 3.0 + cap - cap * cap * cap / 3.0);
    const double u = mesh.unit;
    EXPECT_NEAR(shape.area * u * u, area, 0.03 * area);
    EXPECT_NEAR(shape.holes * u * u, hole, 0.1 * hole + 0.01);
    EXPECT_NEAR(shape.volume * u * u * u, volume, 0.03 * volume);
    EXPECT_EQ(shape.isSheet(), top == 0.5 || top == 0.0);
    EXPECT_EQ(shape.hasOutside(), top != 0.0);
  }
}

TEST(Sheets, PiecesWithAnOutsideAreTurnedThatWay) {
  const PolygonSoup bust = openSphere(0.9);
  const BuiltMesh built = buildMesh(reversed(bust));
  EXPECT_EQ(built.report.invertedPieces, 1u);
  EXPECT_EQ(built.mesh.triangles, buildMesh(bust).mesh.triangles);
  // A hemisphere may be a bowl.
  EXPECT_EQ(buildMesh(reversed(openSphere(0.0))).report.invertedPieces, 0u);
  // A tube has its outside although its border is as large as it likes.
  const PolygonSoup tube = meshOf({SolidKind::Cylinder, 1.0, 6.0}, {.cells = 20}).soup;
  EXPECT_EQ(buildMesh(reversed(tube)).report.invertedPieces, 1u);
  EXPECT_TRUE(shapeOfAll(buildMesh(tube).mesh).isSheet());
}

// The two sides of a cut through a closed surface are no hole: a sphere with a fin along most of
// its equator, where three triangles meet at each edge.
TEST(Sheets, SlitsAreNoHoles) {
  PolygonSoup soup = meshOf({SolidKind::Sphere, 1.0}, {.cells = 24}).soup;
  const TriangleMesh whole = buildMesh(soup).mesh;
  const auto at = [&soup](std::uint32_t v) {
    return Eigen::Vector3d(soup.positions[3 * v], soup.positions[3 * v + 1],
                           soup.positions[3 * v + 2]);
  };
  const std::size_t count = soup.polygonCount();
  std::map<std::uint32_t, std::uint32_t> raised;
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<std::uint32_t> p(soup.polygon(i).begin(), soup.polygon(i).end());
    for (std::size_t k = 0; k < p.size(); ++k) {
      const std::uint32_t a = p[k], b = p[(k + 1) % p.size()];
      const Eigen::Vector3d pa = at(a), pb = at(b);
      if (a > b || std::abs(pa.z()) > 1e-9 || std::abs(pb.z()) > 1e-9 ||
          std::min(pa.x(), pb.x()) < -0.7)
        continue;
      for (const std::uint32_t v : {a, b}) {
        if (raised.contains(v)) continue;
        const Eigen::Vector3d out = 1.1 * at(v);
        raised[v] = static_cast<std::uint32_t>(soup.vertexCount());
        soup.addVertex(out.x(), out.y(), out.z());
      }
      soup.addPolygon(std::vector<std::uint32_t>{a, b, raised[b], raised[a]});
    }
  }
  ASSERT_GT(raised.size(), 20u);
  const BuiltMesh built = buildMesh(reversed(soup));
  EXPECT_GT(built.report.nonManifoldEdges, 20u);
  EXPECT_EQ(built.report.invertedPieces, 1u);
  // The sphere is no sheet, the fin is one.
  const Sheets sheets(built.mesh);
  std::size_t onSheets = 0;
  for (std::uint32_t t = 0; t < built.mesh.triangleCount(); ++t) onSheets += sheets.has(t) ? 1 : 0;
  EXPECT_EQ(onSheets, built.mesh.triangleCount() - whole.triangleCount());
}

// Lines of the view on a sheet with its normals up, and on the same one with them down.
TEST(Sheets, NormalsUpOrDownShowTheSameLines) {
  LineOptions options;
  for (const LineFamily family : allLineFamilies()) options[family] = dependsOnView(family);
  options.threshold.fill(0.5);
  double far = 0.0;
  for (const Solid solid :
       {Solid{SolidKind::SineSheet, 1.0, 1.0}, Solid{SolidKind::GaussianBump, 1.0, 0.5},
        Solid{SolidKind::Saddle, 1.0, 1.0}}) {
    const SolidMesh made = meshOf(solid, {.cells = 60, .irregular = true});
    SolidModel up{buildMesh(made.soup).mesh, {}}, down{buildMesh(reversed(made.soup)).mesh, {}};
    up.fields = exactFields(solid, made.places, up.mesh);
    down.fields = exactFields(solid, made.places, down.mesh);
    LineFinder finder(up.mesh, up.fields), other(down.mesh, down.fields);
    for (const double height : {1.0, 0.3, -0.3, -1.0}) {
      for (const bool perspective : {false, true}) {
        SCOPED_TRACE(height);
        SurfaceView view{.towards = Eigen::Vector3d(0.7, 0.5, height).normalized(), .eye = {}};
        if (perspective) view.eye = 4.0 * view.towards;
        const FeatureLines expected = finder.find(view, options), found = other.find(view, options);
        for (const LineFamily family : allLineFamilies()) {
          if (!dependsOnView(family)) continue;
          SCOPED_TRACE(nameOf(family));
          const double length = totalLength(up.mesh, expected.of(family));
          // Whether a line that hardly stands out is kept is asked at its first piece, at
          // either end of it.
          const double share = family == LineFamily::ApparentRidges ? 0.05 : 1e-3;
          EXPECT_NEAR(totalLength(down.mesh, found.of(family)), length, share * length + 2e-2);
          if (height == -1.0) far += length;
        }
      }
    }
  }
  EXPECT_GT(far, 1.0);
}

// Length on the screen by family of what is visible.
std::array<double, kLineFamilyCount> drawn(const TriangleMesh& mesh, const SurfaceFields& fields,
                                           const Camera& camera) {
  LineOptions options;
  for (const LineFamily family : allLineFamilies()) options[family] = dependsOnView(family);
  options[LineFamily::Isophotes] = false;
  Draughtsman draughtsman(mesh, fields);
  std::array<double, kLineFamilyCount> lengths{};
  for (const Polyline& line :
       draughtsman.draw(projectionOf(camera, mesh), options, StrokeOptions{}).polylines) {
    for (std::size_t i = 1; i < line.screen.size(); ++i)
      lengths[static_cast<std::size_t>(line.family)] +=
          (line.screen[i] - line.screen[i - 1]).norm();
  }
  return lengths;
}

void expectSameDrawing(const std::array<double, kLineFamilyCount>& a,
                       const std::array<double, kLineFamilyCount>& b, double share) {
  for (const LineFamily family : allLineFamilies()) {
    SCOPED_TRACE(nameOf(family));
    const auto i = static_cast<std::size_t>(family);
    EXPECT_NEAR(a[i], b[i], share * a[i] + 1.0);
  }
}

// A contour that is seen from behind is as visible as one that is seen from the front.
TEST(Sheets, AContourIsSeenOnEitherSide) {
  for (const SolidKind kind : {SolidKind::SineSheet, SolidKind::GaussianBump}) {
    const Solid solid =
        kind == SolidKind::SineSheet ? Solid{kind, 0.4, 3.0, 4.0} : Solid{kind, 2.0, 3.0};
    const SolidMesh made = meshOf(solid, {.cells = 80, .irregular = true});
    SolidModel up{buildMesh(made.soup).mesh, {}}, down{buildMesh(reversed(made.soup)).mesh, {}};
    up.fields = exactFields(solid, made.places, up.mesh);
    down.fields = exactFields(solid, made.places, down.mesh);
    for (const double height : {0.5, 0.2, -0.2, -0.5}) {
      SCOPED_TRACE(height);
      Camera camera;
      camera.towards = {0.9, 0.3, height};
      camera.up = Eigen::Vector3d::UnitZ();
      const auto a = drawn(up.mesh, up.fields, camera), b = drawn(down.mesh, down.fields, camera);
      expectSameDrawing(a, b, 0.01);
      if (std::abs(height) < 0.3) {
        EXPECT_GT(a[static_cast<std::size_t>(LineFamily::OccludingContours)], 60.0);
      }
    }
  }
}

class SheetsData : public ExampleMeshes {};

TEST_F(SheetsData, ABustAndAReliefInsideOutAreDrawnAlike) {
  for (const char* name : {"demosthenes_bust.obj", "mountain.obj"}) {
    SCOPED_TRACE(name);
    const PolygonSoup soup = readPolygons(dataFolder() / "meshes" / name);
    const TriangleMesh mesh = buildMesh(soup).mesh, turned = buildMesh(reversed(soup)).mesh;
    Camera camera;
    camera.towards = {0.4, 0.5, 0.8};
    const auto a = drawn(mesh, estimateFields(mesh, {}), camera);
    const auto b = drawn(turned, estimateFields(turned, {}), camera);
    EXPECT_GT(a[static_cast<std::size_t>(LineFamily::ApparentRidges)], 500.0);
    expectSameDrawing(a, b, 0.05);
  }
}

}  // namespace
}  // namespace flatland::test
