// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of lines in which two sheets meet: sharp edges and self-intersections, against
// closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "core3d/diff/estimate_fields.h"
#include "core3d/draw/draughtsman.h"
#include "core3d/draw/sight.h"
#include "core3d/mesh/build_mesh.h"
#include "tests/core3d/lines_check.h"
#include "tests/core3d/prism.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

struct Lengths {
  double visible = 0.0, hidden = 0.0;
};

Lengths lengthsOf(const TriangleMesh& mesh, const SurfaceFields& fields, const Camera& camera,
                  std::initializer_list<LineFamily> families) {
  Lengths lengths;
  const Drawing drawing =
      Draughtsman(mesh, fields).draw(projectionOf(camera, mesh), only(families), {.hidden = true});
  for (const Polyline& line : drawing.polylines) {
    double& length = line.visible ? lengths.visible : lengths.hidden;
    const std::size_t n = line.screen.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i)
      length += (line.screen[(i + 1) % n] - line.screen[i]).norm();
  }
  return lengths;
}

// Of the cube that fills [-1, 1]: an edge is seen if one of its faces is turned to the viewer.
Lengths edgesOfCube(const Projection& projection) {
  Lengths lengths;
  for (int along = 0; along < 3; ++along) {
    const int i = (along + 1) % 3, k = (along + 2) % 3;
    for (const double x : {-1.0, 1.0}) {
      for (const double y : {-1.0, 1.0}) {
        Vector3d from;
        from[along] = -1.0;
        from[i] = x;
        from[k] = y;
        const Vector3d to = from + 2.0 * Vector3d::Unit(along);
        const Vector3d w = projection.view().towardsViewer(from);
        (x * w[i] > 0.0 || y * w[k] > 0.0 ? lengths.visible : lengths.hidden) +=
            (*projection.toScreen(to) - *projection.toScreen(from)).norm();
      }
    }
  }
  return lengths;
}

// An edge has one triangle on each side, of which one may face away although the edge is seen.
TEST(SightSheets, SharpEdgesAreSeenAlikeWhateverTheyAreDrawnAs) {
  Random random(announcedSeed("SharpEdgesAreSeenAlikeWhateverTheyAreDrawnAs", 31));
  const TriangleMesh cube = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const TriangleMesh angle = prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  for (const TriangleMesh* mesh : {&cube, &angle}) {
    const SurfaceFields fields = estimateFields(*mesh);
    for (int trial = 0; trial < 16; ++trial) {
      Camera camera;
      camera.towards = {normal(random), normal(random), normal(random)};
      if (camera.towards.normalized().cwiseAbs().minCoeff() < 0.05) continue;
      if (trial % 2 == 1) camera.perspectiveDeg = 40.0;
      const Lengths creases = lengthsOf(*mesh, fields, camera, {LineFamily::Creases});
      const Lengths both =
          lengthsOf(*mesh, fields, camera, {LineFamily::Ridges, LineFamily::Valleys});
      // Crumbs of up to 6 px are left out, here or there, where edges pass behind others.
      EXPECT_NEAR(both.visible, creases.visible, 2.0) << "trial " << trial;
      EXPECT_NEAR(both.hidden, creases.hidden, 12.0) << "trial " << trial;
      if (mesh != &cube) continue;
      const Lengths known = edgesOfCube(projectionOf(camera, cube));
      EXPECT_NEAR(both.visible, known.visible, 3.0) << "trial " << trial;
      EXPECT_NEAR(both.hidden, known.hidden, 3.0) << "trial " << trial;
    }
  }
}

// Adds a unit sphere.
void addSphere(PolygonSoup& soup, const Vector3d& centre, int cells) {
  const SolidMesh one = meshOf({SolidKind::Sphere, 1.0}, {.cells = cells, .irregular = true});
  const auto first = static_cast<std::uint32_t>(soup.vertexCount());
  for (std::size_t v = 0; v < one.soup.vertexCount(); ++v) {
    const double* p = &one.soup.positions[3 * v];
    soup.addVertex(centre.x() + p[0], centre.y() + p[1], centre.z() + p[2]);
  }
  for (std::size_t i = 0; i + 2 < one.soup.corners.size(); i += 3) {
    const std::uint32_t* c = &one.soup.corners[i];
    soup.addTriangle(c[0] + first, c[1] + first, c[2] + first);
  }
}

// A point of the circle in which two spheres cross is seen exactly if it is on the front of both: a
// ball that it is on the back of lies before it.
TEST(SightSheets, TwoSpheresShowTheKnownPartOfTheirCircle) {
  constexpr double kSlack = 0.07;  // of n.w: an edge of the mesh is about as long
  for (const double half : {0.15, 0.5, 0.7, 0.9, 0.98}) {
    PolygonSoup soup;
    const Vector3d centre(half, 0.0, 0.0);
    addSphere(soup, centre, 30);
    addSphere(soup, -centre, 29);
    const TriangleMesh mesh = buildMesh(soup).mesh;
    const SurfaceFields fields = estimateFields(mesh);
    const std::vector<LineSegment> circle = LineFinder(mesh, fields)
                                                .find({}, only({LineFamily::SelfIntersections}))
                                                .of(LineFamily::SelfIntersections);
    const double radius = std::sqrt(1.0 - half * half);
    ASSERT_NEAR(totalLength(mesh, circle), 2.0 * std::numbers::pi * radius, 0.1 * radius);
    const Sight sight(mesh, fields);
    const FlushDenormals flush;
    for (const double aside : {0.0, 0.1, 0.4, 0.8}) {
      for (const bool perspective : {false, true}) {
        SurfaceView view;
        view.towards = {std::sin(aside), 0.6 * std::cos(aside), 0.8 * std::cos(aside)};
        if (perspective) view.eye = 4.0 * view.towards;
        int seen = 0, asked = 0, wrong = 0;
        for (const LineSegment& s : circle) {
          for (const float share : {0.1f, 0.5f, 0.9f}) {
            const Vector3d at = (s.a.at + share * (s.b.at - s.a.at)).cast<double>();
            const Vector3d p = mesh.origin + mesh.unit * at, w = view.towardsViewer(at);
            const double facing = std::min((p - centre).dot(w), (p + centre).dot(w));
            if (std::abs(facing) < kSlack) continue;
            ++asked;
            seen += facing > 0.0;
            for (const double offset : {1e-5, 2e-3}) {
              wrong +=
                  sight.hidden({at, s.triangle, false, s.other}, view, offset) != (facing < 0.0);
            }
          }
        }
        EXPECT_EQ(wrong, 0) << half << ", " << aside << ", " << perspective << ": of " << asked
                            << " asked, " << seen << " seen";
        EXPECT_GT(asked, 20);
        if (aside < 0.05) {
          EXPECT_GT(seen, asked / 3);
        }
      }
    }
  }
}

}  // namespace
}  // namespace flatland::test
