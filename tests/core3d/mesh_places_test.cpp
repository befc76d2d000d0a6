// SPDX-License-Identifier: GPL-3.0-or-later
// Places of a mesh: against every triangle tried in double, and against closed forms.
#include "core3d/draw/mesh_places.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/solids.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

/// Positions of a mesh are floats.
constexpr double kFloat = 1e-6;
/// A ray is one of floats, of lengths up to 4.
constexpr double kFloatRay = 1e-5;

/// The slow reference of MeshPlaces::firstHit.
std::optional<SurfaceHit> firstHit(const TriangleMesh& mesh, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& along, bool wholeLine) {
  std::optional<SurfaceHit> hit;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& corners = mesh.triangles[t];
    const Eigen::Vector3d a = mesh.position(corners[0]).cast<double>();
    const Eigen::Vector3d ab = mesh.position(corners[1]).cast<double>() - a;
    const Eigen::Vector3d ac = mesh.position(corners[2]).cast<double>() - a;
    // from + s along = a + u ab + v ac, by Cramer's rule.
    const Eigen::Vector3d across = along.cross(ac);
    const double volume = ab.dot(across);
    if (volume == 0.0) continue;
    const Eigen::Vector3d away = from - a;
    const double u = away.dot(across) / volume;
    if (!(u >= 0.0 && u <= 1.0)) continue;
    const Eigen::Vector3d turned = away.cross(ab);
    const double v = along.dot(turned) / volume;
    if (!(v >= 0.0 && u + v <= 1.0)) continue;
    const double s = ac.dot(turned) / volume;
    if (s >= nearest || (!wholeLine && s <= 0.0)) continue;
    nearest = s;
    hit = SurfaceHit{t, {1.0 - u - v, u, v}, from + s * along};
  }
  return hit;
}

/// That of MeshPlaces::nearest.
std::optional<SurfaceHit> nearestPlace(const TriangleMesh& mesh, const Vector3d& p) {
  std::optional<SurfaceHit> nearest;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const SurfaceHit place = nearestInTriangle(mesh, t, p);
    if (!nearest || (place.at - p).squaredNorm() < (nearest->at - p).squaredNorm()) nearest = place;
  }
  return nearest;
}

/// The square with corners (+-1, +-1, 0) as two triangles.
TriangleMesh square() {
  PolygonSoup soup;
  soup.positions = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
  soup.corners = {0, 1, 2, 0, 2, 3};
  return buildMesh(soup).mesh;
}

TEST(MeshPlaces, OnASquareCoordinatesAreClamped) {
  const TriangleMesh mesh = square();
  const MeshPlaces places(mesh);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> range(-3.0, 3.0);
  for (int i = 0; i < 500; ++i) {
    const Vector3d p(range(random), range(random), range(random));
    const auto place = places.nearest(p);
    ASSERT_TRUE(place);
    const Vector3d known(std::clamp(p.x(), -1.0, 1.0), std::clamp(p.y(), -1.0, 1.0), 0.0);
    EXPECT_LT((place->at - known).norm(), kFloat) << p.transpose();
    double sum = 0.0;
    Vector3d byWeights = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GE(place->weights[k], 0.0);
      sum += place->weights[k];
      byWeights +=
          place->weights[k] * mesh.position(mesh.triangles[place->triangle][k]).cast<double>();
    }
    EXPECT_NEAR(sum, 1.0, kFloat);
    EXPECT_LT((byWeights - known).norm(), kFloat);
  }
}

TEST(MeshPlaces, NoSampleOfATorusIsNearer) {
  const TriangleMesh mesh =
      buildMesh(meshOf({SolidKind::Torus, 1.0, 0.4}, {.cells = 12}).soup).mesh;
  const MeshPlaces places(mesh);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> range(-1.2, 1.2);
  constexpr int kSteps = 12;
  for (int i = 0; i < 20; ++i) {
    const Vector3d p(range(random), range(random), range(random));
    const auto place = places.nearest(p);
    ASSERT_TRUE(place);
    const double distance = (place->at - p).norm();
    double least = 1e9;
    for (const auto& corners : mesh.triangles) {
      for (int u = 0; u <= kSteps; ++u) {
        for (int v = 0; u + v <= kSteps; ++v) {
          const double a = 1.0 * u / kSteps, b = 1.0 * v / kSteps;
          const Vector3d q = a * mesh.position(corners[0]).cast<double>() +
                             b * mesh.position(corners[1]).cast<double>() +
                             (1.0 - a - b) * mesh.position(corners[2]).cast<double>();
          least = std::min(least, (q - p).norm());
        }
      }
    }
    EXPECT_LE(distance, least + kFloat);
    EXPECT_GT(distance, least - 0.1);  // the samples' step
  }
}

TEST(MeshPlaces, OfNoMeshThereIsNone) {
  const TriangleMesh mesh;
  const MeshPlaces places(mesh);
  EXPECT_FALSE(places.nearest(Vector3d::Zero()));
  EXPECT_FALSE(places.firstHit(Vector3d::Zero(), Vector3d::UnitX(), true));
}

std::vector<TriangleMesh> meshes() {
  std::vector<TriangleMesh> meshes;
  for (const Solid& solid :
       {Solid{SolidKind::Torus, 1.0, 0.4}, Solid{SolidKind::BumpySphere, 1.0, 0.1},
        Solid{SolidKind::RoundedCube, 1.0, 0.2}}) {
    meshes.push_back(buildMesh(meshOf(solid, {.cells = 30}).soup).mesh);
  }
  return meshes;
}

TEST(MeshPlaces, FirstHitsAreThoseOfTryingAll) {
  Random random(announcedSeed("first hits", 17));
  std::uniform_real_distribution<double> places(-1.2, 1.2);
  int hits = 0, misses = 0, same = 0;
  for (const TriangleMesh& mesh : meshes()) {
    const MeshPlaces fast(mesh);
    for (int i = 0; i < 1000; ++i) {
      const bool wholeLine = i % 2 == 0;
      const double far = i % 3 == 0 ? 100.0 : 1.0;  // a viewer far off, or close
      const Vector3d at(places(random), places(random), places(random));
      const Vector3d from = far * Vector3d(places(random), places(random), places(random));
      const Vector3d along = (at - from).normalized();
      const auto known = firstHit(mesh, from, along, wholeLine);
      const auto hit = fast.firstHit(from, along, wholeLine);
      ASSERT_EQ(hit.has_value(), known.has_value()) << i;
      ++(hit ? hits : misses);
      if (!hit) continue;
      // Along a grazing line places lie far apart: across it they must agree.
      const Vector3d apart = hit->at - known->at;
      EXPECT_LT(apart.cross(along).norm(), kFloatRay) << i;
      if (hit->triangle == known->triangle) {
        ++same;
        EXPECT_LT(apart.norm(), 1e-9) << i;
      }
      EXPECT_LT(std::abs(apart.dot(along)), 1e-3) << i;
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(misses, 300);
  EXPECT_GT(same, hits - hits / 100);
}

TEST(MeshPlaces, NearestAreThoseOfTryingAll) {
  Random random(announcedSeed("nearest places", 19));
  std::uniform_real_distribution<double> places(-1.5, 1.5);
  for (const TriangleMesh& mesh : meshes()) {
    const MeshPlaces fast(mesh);
    for (int i = 0; i < 300; ++i) {
      const double far = i % 10 == 0 ? 30.0 : 1.0;
      const Vector3d p = far * Vector3d(places(random), places(random), places(random));
      const auto known = nearestPlace(mesh, p);
      const auto place = fast.nearest(p);
      ASSERT_TRUE(place) << i;
      EXPECT_DOUBLE_EQ((place->at - p).norm(), (known->at - p).norm()) << i;
      EXPECT_EQ(place->triangle, known->triangle) << i;
    }
    // A vertex is as near in all of its triangles.
    for (std::uint32_t v = 0; v < 200; ++v) {
      const Vector3d p = mesh.position(v).cast<double>();
      const auto place = fast.nearest(p);
      ASSERT_TRUE(place);
      EXPECT_EQ(place->triangle, nearestPlace(mesh, p)->triangle) << v;
      EXPECT_EQ(place->nearestVertex(mesh), v);
    }
  }
}

TEST(MeshPlaces, TheFirstOfASphereIsItsNearSide) {
  const TriangleMesh mesh = buildMesh(meshOf({SolidKind::Sphere, 1.0}, {.cells = 24}).soup).mesh;
  const MeshPlaces places(mesh);
  for (int i = 0; i < 50; ++i) {
    const double angle = 0.7 * i, tilt = std::sin(1.3 * i);
    const Vector3d w = Vector3d(std::cos(angle), std::sin(angle), tilt).normalized();
    const Vector3d side = w.unitOrthogonal() * (0.017 * i);  // up to 0.83 of the radius
    const auto hit = places.firstHit(side, -w, true);
    ASSERT_TRUE(hit) << i;
    EXPECT_NEAR(hit->at.norm(), 1.0, 0.02);
    EXPECT_NEAR(hit->at.dot(w), std::sqrt(1.0 - side.squaredNorm()), 0.02);
    EXPECT_NEAR(hit->weights[0] + hit->weights[1] + hit->weights[2], 1.0, 1e-12);
    EXPECT_LT((mesh.position(hit->nearestVertex(mesh)).cast<double>() - hit->at).norm(), 0.1);
    // From the middle on only what lies ahead counts: the far side.
    const auto ahead = places.firstHit(side, -w, false);
    ASSERT_TRUE(ahead);
    EXPECT_NEAR(ahead->at.dot(w), -std::sqrt(1.0 - side.squaredNorm()), 0.02);
    EXPECT_FALSE(places.firstHit(1.1 * w.unitOrthogonal(), -w, true));
  }
}

}  // namespace
}  // namespace flatland::test
