// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen where very many triangles meet in a vertex, or very many lines lie on a picture.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core3d/diff/estimate_fields.h"
#include "core3d/draw/draughtsman.h"
#include "core3d/draw/sight.h"
#include "core3d/mesh/build_mesh.h"
#include "tests/core3d/lines_check.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Drawing drawn(const TriangleMesh& mesh, const Camera& camera,
              std::initializer_list<LineFamily> families) {
  const SurfaceFields fields = estimateFields(mesh);
  return Draughtsman(mesh, fields)
      .draw(projectionOf(camera, mesh), only(families), {.hidden = true});
}

// Near the apex of a shallow dish the side opposite is a fold with a point if it is bent by less
// than 70 degrees, or what lies between is against both.
TEST(SightFans, AFoldIsOneWhateverTheNumberOfItsTriangles) {
  for (const std::uint32_t around : {24u, 48u, 96u, 400u}) {
    for (const double slopeDeg : {20.0, 48.0, 56.0}) {
      const double slope = std::tan(slopeDeg * kPi / 180.0);
      PolygonSoup soup;
      soup.addVertex(0, 0, 0);
      for (std::uint32_t k = 0; k < around; ++k) {
        const double turn = 2.0 * kPi * (k + 0.5) / around;
        soup.addVertex(std::cos(turn), std::sin(turn), slope);
      }
      for (std::uint32_t k = 0; k < around; ++k) soup.addTriangle(0, k + 1, (k + 1) % around + 1);
      const TriangleMesh mesh = buildMesh(soup).mesh;
      const SurfaceFields none;
      const Sight sight(mesh, none);
      const FlushDenormals flush;
      // Where the side away from the viewer has x = -0.05 in the unit of the soup.
      const Vector3d at = (Vector3d(-0.05, 0.0, 0.05 * slope) - mesh.origin) / mesh.unit;
      std::uint32_t own = 0;
      for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Eigen::Vector3f rim = mesh.position(a) + mesh.position(b) + mesh.position(c);
        if (rim.x() < -1.5f && std::abs(rim.y()) < 2.0 / around) own = t;
      }
      SurfaceView view;
      view.towards = Vector3d(std::cos(0.1), 0.0, std::sin(0.1));
      EXPECT_TRUE(sight.hidden({at, own, false}, view, 1e-4)) << around << ", " << slopeDeg;
      EXPECT_EQ(sight.hidden({at, own, true}, view, 1e-4), slopeDeg > 50.0)
          << around << ", " << slopeDeg;
    }
  }
}

// Needles round one vertex, up and down at random: every ray beside it passes hundreds of them. The
// time limit of this program is what is tested: when each of them was asked for its fold by trying
// all pairs, it took minutes.
TEST(SightFans, ThousandsOfNeedlesTakeNoMinutes) {
  constexpr std::uint32_t kNeedles = 10000;
  Random random(announcedSeed("ThousandsOfNeedlesTakeNoMinutes", 42));
  PolygonSoup soup;
  soup.addVertex(0, 0, 0);
  for (std::uint32_t i = 0; i < kNeedles; ++i) {
    const double turn = 2.0 * kPi * i / kNeedles;
    soup.addVertex(std::cos(turn), std::sin(turn), uniform(random, -0.5, 0.5));
  }
  for (std::uint32_t i = 0; i < kNeedles; ++i) soup.addTriangle(0, i + 1, (i + 1) % kNeedles + 1);
  Camera camera;
  camera.towards = {0.3, 0.5, 1.0};
  const Drawing drawing =
      drawn(buildMesh(soup).mesh, camera, {LineFamily::OccludingContours, LineFamily::Boundaries});
  EXPECT_GT(drawing.polylines.size(), 10u);
}

// Loose needles, whose rims are millions of px long together.
TEST(SightFans, NoMoreRaysAreCastThanAPictureHasRoomFor) {
  constexpr std::uint32_t kNeedles = 3000;
  Random random(announcedSeed("NoMoreRaysAreCastThanAPictureHasRoomFor", 43));
  PolygonSoup soup;
  soup.addVertex(0, 0, 0);
  for (std::uint32_t i = 0; i < kNeedles; ++i) {
    const Vector3d tip(1.0, 0.1 * normal(random), 0.1 * normal(random));
    soup.addVertex(tip.x(), tip.y(), tip.z());
    soup.addVertex(tip.x(), tip.y() + 0.01, tip.z() + 0.01 * normal(random));
    soup.addTriangle(0, 2 * i + 1, 2 * i + 2);
  }
  const Drawing drawing = drawn(buildMesh(soup).mesh, Camera(),
                                {LineFamily::Boundaries, LineFamily::ExteriorSilhouette});
  EXPECT_GT(drawing.polylines.size(), kNeedles);
  EXPECT_GT(drawing.stats.rays, 300'000u);
  // Three for each place that is asked about, and the search for where the answers change.
  EXPECT_LT(drawing.stats.rays, 2'000'000u);
}

}  // namespace
}  // namespace flatland::test
