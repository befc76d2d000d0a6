// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/lines/nearest_place.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/solids.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;

/// Positions of a mesh are floats.
constexpr double kFloat = 1e-6;

/// The square with corners (+-1, +-1, 0) as two triangles.
TriangleMesh square() {
  PolygonSoup soup;
  soup.positions = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
  soup.corners = {0, 1, 2, 0, 2, 3};
  return buildMesh(soup).mesh;
}

TEST(NearestPlace, OnASquareCoordinatesAreClamped) {
  const TriangleMesh mesh = square();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> places(-3.0, 3.0);
  for (int i = 0; i < 500; ++i) {
    const Vector3d p(places(random), places(random), places(random));
    const auto place = nearestPlace(mesh, p);
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

TEST(NearestPlace, NoSampleOfATorusIsNearer) {
  const TriangleMesh mesh =
      buildMesh(meshOf({SolidKind::Torus, 1.0, 0.4}, {.cells = 12}).soup).mesh;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> places(-1.2, 1.2);
  constexpr int kSteps = 12;
  for (int i = 0; i < 20; ++i) {
    const Vector3d p(places(random), places(random), places(random));
    const auto place = nearestPlace(mesh, p);
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

TEST(NearestPlace, OfNoMeshIsNone) { EXPECT_FALSE(nearestPlace(TriangleMesh(), Vector3d::Zero())); }

}  // namespace
}  // namespace flatland::test
