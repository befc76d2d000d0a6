// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of a closed mesh is a closed line: against the picture of the mesh, filled pixel by
// pixel.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "core3d/diff/estimate_fields.h"
#include "core3d/draw/draughtsman.h"
#include "core3d/io/read_mesh.h"
#include "core3d/mesh/build_mesh.h"
#include "tests/core3d/example_meshes.h"
#include "tests/core3d/prism.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Of a rim of 1000 px or more: some pixels are a little farther than 2.5 px from a line without a
// gap. The gaps that there were, of 3 px and more, had shares of 0.004 to 0.09.
constexpr double kBare = 0.003;

// Which pixels of a picture have their middle behind a triangle.
class Shadow {
 public:
  Shadow(const TriangleMesh& mesh, const Projection& projection)
      : columns_(static_cast<int>(projection.width)),
        rows_(static_cast<int>(projection.height)),
        dark_(static_cast<std::size_t>(columns_ * rows_), false) {
    for (const auto& corners : mesh.triangles) {
      Vector2d p[3];
      for (int k = 0; k < 3; ++k)
        p[k] = *projection.toScreen(mesh.position(corners[k]).cast<double>());
      fill(p);
    }
  }
  bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < columns_ && y < rows_ &&
           dark_[static_cast<std::size_t>(y * columns_ + x)];
  }
  // Middles of the pixels on its rim.
  std::vector<Vector2d> rim() const {
    std::vector<Vector2d> found;
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        if (at(x, y) && !(at(x - 1, y) && at(x + 1, y) && at(x, y - 1) && at(x, y + 1)))
          found.emplace_back(x + 0.5, y + 0.5);
      }
    }
    return found;
  }

 private:
  static double side(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  }
  void fill(const Vector2d (&p)[3]) {
    const auto [left, right] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [above, below] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for (int y = static_cast<int>(above); y <= static_cast<int>(below); ++y) {
      for (int x = static_cast<int>(left); x <= static_cast<int>(right); ++x) {
        const Vector2d middle(x + 0.5, y + 0.5);
        const double a = side(p[0], p[1], middle), b = side(p[1], p[2], middle),
                     c = side(p[2], p[0], middle);
        if (std::min({a, b, c}) >= 0.0 || std::max({a, b, c}) <= 0.0)
          dark_[static_cast<std::size_t>(y * columns_ + x)] = true;
      }
    }
  }

  int columns_, rows_;
  std::vector<bool> dark_;
};

double distanceTo(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const double sq = (b - a).squaredNorm();
  const double share = sq > 0.0 ? std::clamp((p - a).dot(b - a) / sq, 0.0, 1.0) : 0.0;
  return (a + share * (b - a) - p).norm();
}

// The share of a shadow's rim from which no visible stroke is within so many px.
double bareShare(const Drawing& drawing, const std::vector<Vector2d>& rim, double px) {
  std::size_t bare = 0;
  for (const Vector2d& p : rim) {
    const bool drawn =
        std::any_of(drawing.polylines.begin(), drawing.polylines.end(), [&](const Polyline& line) {
          const std::size_t n = line.screen.size();
          for (std::size_t i = 0; line.visible && i + (line.closed ? 0 : 1) < n; ++i) {
            if (distanceTo(p, line.screen[i], line.screen[(i + 1) % n]) <= px) return true;
          }
          return false;
        });
    if (!drawn) ++bare;
  }
  return static_cast<double>(bare) / static_cast<double>(rim.size());
}

// The share of what is drawn that is so many px from every pixel of the rim.
double strayShare(const Drawing& drawing, const std::vector<Vector2d>& rim, double px) {
  double stray = 0.0, all = 0.0;
  for (const Polyline& line : drawing.polylines) {
    const std::size_t n = line.screen.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
      const Vector2d from = line.screen[i], way = line.screen[(i + 1) % n] - from;
      const int steps = std::max(1, static_cast<int>(way.norm()));
      for (int k = 0; k < steps; ++k) {
        const Vector2d p = from + (k + 0.5) / steps * way;
        const double length = way.norm() / steps;
        all += length;
        if (std::none_of(rim.begin(), rim.end(),
                         [&](const Vector2d& r) { return (r - p).norm() < px; }))
          stray += length;
      }
    }
  }
  return all > 0.0 ? stray / all : 1.0;
}

struct Outline {
  double bare;   // share of the rim
  double times;  // px drawn for each pixel of the rim
  double stray;  // share of what is drawn
};

Outline outlineOf(const TriangleMesh& mesh, const Camera& camera, LineFamily family) {
  const SurfaceFields fields = estimateFields(mesh);
  const Projection projection = projectionOf(camera, mesh);
  LineOptions lines;
  lines[family] = true;
  const Drawing drawing = Draughtsman(mesh, fields).draw(projection, lines, StrokeOptions());
  const std::vector<Vector2d> rim = Shadow(mesh, projection).rim();
  double length = 0.0;
  for (const Polyline& line : drawing.polylines) {
    for (std::size_t i = 0; i + 1 < line.screen.size(); ++i)
      length += (line.screen[i + 1] - line.screen[i]).norm();
  }
  return {bareShare(drawing, rim, 2.5), length / static_cast<double>(rim.size()),
          strayShare(drawing, rim, 3.0)};
}

// A blown-up cube of cells x cells quadrilaterals a face, its vertices moved in and out at random.
TriangleMesh roughSphere(int cells, double roughness, Random& random) {
  PolygonSoup soup;
  std::map<std::array<int, 3>, std::uint32_t> made;
  const auto vertex = [&](const std::array<int, 3>& place) {
    const auto [at, isNew] =
        made.try_emplace(place, static_cast<std::uint32_t>(soup.vertexCount()));
    if (isNew) {
      Vector3d p;
      for (std::size_t k = 0; k < 3; ++k)
        p[static_cast<Eigen::Index>(k)] =
            std::tan(std::numbers::pi / 4.0 * (2.0 * place[k] / cells - 1.0));
      p = (1.0 + roughness * normal(random)) * p.normalized();
      soup.addVertex(p.x(), p.y(), p.z());
    }
    return at->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, cells}) {
      for (int i = 0; i < cells; ++i) {
        for (int k = 0; k < cells; ++k) {
          const auto corner = [&](int di, int dk) {
            std::array<int, 3> place{};
            place[axis] = side;
            place[(axis + 1) % 3] = side > 0 ? i + di : k + dk;
            place[(axis + 2) % 3] = side > 0 ? k + dk : i + di;
            return vertex(place);
          };
          const std::uint32_t face[] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
          soup.addPolygon(face);
        }
      }
    }
  }
  return buildMesh(soup).mesh;
}

// A flat can about z with few sides, with lids.
TriangleMesh can(std::uint32_t sides) {
  std::vector<Vector2d> round;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / sides;
    round.emplace_back(std::cos(turn), std::sin(turn));
  }
  return prism(round, -0.2, 0.2);
}

TEST(Outline, OfARoughSphereIsClosed) {
  Random random(announcedSeed("OfARoughSphereIsClosed", 21));
  for (const LineFamily family : {LineFamily::ExteriorSilhouette, LineFamily::OccludingContours}) {
    for (int trial = 0; trial < 3; ++trial) {
      const TriangleMesh mesh = roughSphere(40, 0.003, random);
      Camera camera;
      camera.towards = {normal(random), normal(random), normal(random)};
      if (trial == 2) camera.perspectiveDeg = 40.0;
      const Outline outline = outlineOf(mesh, camera, family);
      EXPECT_LT(outline.bare, kBare);
      EXPECT_LT(outline.times, 1.2);  // a circle drawn once has pi / sqrt(8) = 1.11
    }
  }
}

TEST(Outline, OfACanIsClosed) {
  Random random(announcedSeed("OfACanIsClosed", 22));
  for (const std::uint32_t sides : {17u, 24u, 48u}) {
    const TriangleMesh mesh = can(sides);
    for (int trial = 0; trial < 5; ++trial) {
      Camera camera;
      camera.towards = {normal(random), normal(random), normal(random)};
      const Outline outline = outlineOf(mesh, camera, LineFamily::ExteriorSilhouette);
      EXPECT_LT(outline.bare, kBare) << sides;
      EXPECT_LT(outline.times, 1.2) << sides;
    }
  }
}

// Adds a sphere, 6 x 12 cells and poles.
void addBall(PolygonSoup& soup, const Vector3d& centre, double radius) {
  constexpr std::uint32_t kAround = 12, kUp = 6;
  const auto first = static_cast<std::uint32_t>(soup.vertexCount());
  for (std::uint32_t i = 0; i <= kUp; ++i) {
    const double rise = std::numbers::pi * i / kUp;
    for (std::uint32_t k = 0; k < (i % kUp == 0 ? 1 : kAround); ++k) {
      const double turn = 2.0 * std::numbers::pi * k / kAround;
      const Vector3d p =
          centre + radius * Vector3d(std::sin(rise) * std::cos(turn),
                                     std::sin(rise) * std::sin(turn), std::cos(rise));
      soup.addVertex(p.x(), p.y(), p.z());
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t k) {
    if (i == 0) return first;
    return first + 1 + (i - 1) * kAround + (i == kUp ? 0 : k % kAround);
  };
  for (std::uint32_t i = 0; i < kUp; ++i) {
    for (std::uint32_t k = 0; k < kAround; ++k) {
      if (i > 0) soup.addTriangle(at(i, k), at(i + 1, k), at(i, k + 1));
      if (i + 1 < kUp) soup.addTriangle(at(i, k + 1), at(i + 1, k), at(i + 1, k + 1));
    }
  }
}

TEST(Outline, OfASpeckIsDrawnBesideAPartAndNotOnIt) {
  // 1 px is 1 / 280 of the large ball's radius, about; the specks' outlines are 4 px long.
  const auto strokes = [](const Vector3d& speck) {
    PolygonSoup soup;
    addBall(soup, Vector3d::Zero(), 1.0);
    addBall(soup, speck, 0.0025);
    const TriangleMesh mesh = buildMesh(soup).mesh;
    const SurfaceFields fields = estimateFields(mesh);
    LineOptions lines;
    lines[LineFamily::OccludingContours] = true;
    const Projection projection = projectionOf(Camera(), mesh);
    return Draughtsman(mesh, fields).draw(projection, lines, StrokeOptions()).polylines.size();
  };
  EXPECT_EQ(strokes({1.2, 0.1, 0.0}), 2u);
  EXPECT_EQ(strokes({0.3, 0.1, 1.5}), 1u);
}

TEST(Outline, OfASheetIsItsBorder) {
  PolygonSoup soup;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0}) soup.addVertex(x, y, 0.0);
  }
  soup.addTriangle(0, 1, 3);
  soup.addTriangle(0, 3, 2);
  const TriangleMesh mesh = buildMesh(soup).mesh;
  for (const double side : {1.0, -1.0}) {
    Camera camera;
    camera.towards = {0.2, 0.1, side};
    EXPECT_EQ(outlineOf(mesh, camera, LineFamily::ExteriorSilhouette).bare, 0.0) << side;
  }
}

using OutlineData = ExampleMeshes;

TEST_F(OutlineData, OfScansAndMachinePartsIsClosed) {
  struct View {
    const char* name;
    Vector3d towards, up;
  };
  const Vector3d y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  for (const View& view :
       {View{"nefertiti_bust.obj", {0.6, -1, 0.2}, z}, View{"nefertiti_bust.obj", {1, 0.2, 0.1}, y},
        View{"cycloidal_drive.ply", {0.4, -1, 0.5}, z}, View{"goblet_vase.stl", {0, -1, 0}, z},
        View{"goblet_vase.stl", {1, 0, 0}, y}, View{"boot.obj", {0, 0, 1}, y},
        View{"boot.obj", {0, -1, 0}, z}, View{"hand.obj", {0.6, -1, 0.3}, y}}) {
    const TriangleMesh mesh = loadMesh(dataFolder() / "meshes" / view.name).mesh;
    Camera camera;
    camera.towards = view.towards;
    camera.up = view.up;
    const Outline outline = outlineOf(mesh, camera, LineFamily::ExteriorSilhouette);
    EXPECT_LT(outline.bare, kBare) << view.name;
    EXPECT_LT(outline.stray, 0.005) << view.name;
  }
}

}  // namespace
}  // namespace flatland::test
