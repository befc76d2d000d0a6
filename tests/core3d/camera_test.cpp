// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras set before meshes: what is fitted stays inside the margin and touches it.
#include "core3d/draw/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core3d/mesh/build_mesh.h"
#include "core3d/mesh/solids.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Rounding of some products of numbers around 1000, px.
constexpr double kRoundingPx = 1e-8;

TriangleMesh ellipsoid() {
  const SolidMesh solid =
      meshOf({SolidKind::Ellipsoid, 1.0, 0.6, 0.35}, {.cells = 8, .irregular = true});
  return buildMesh(solid.soup).mesh;
}

Vector3d direction(Random& random) {
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

struct Box {
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
  Vector2d high = -low;
};

Box boxOf(const TriangleMesh& mesh, const Projection& projection) {
  Box box;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const auto p = projection.toScreen(mesh.position(v).cast<double>());
    if (!p) {
      ADD_FAILURE() << "a vertex is behind the viewer";
      continue;
    }
    box.low = box.low.cwiseMin(*p);
    box.high = box.high.cwiseMax(*p);
  }
  return box;
}

TEST(Camera, FitsTheOutlineExactly) {
  Random random(announcedSeed("FitsTheOutlineExactly", 1));
  const TriangleMesh mesh = ellipsoid();
  for (int trial = 0; trial < 40; ++trial) {
    Camera camera;
    camera.towards = direction(random) * uniform(random, 0.1, 10.0);
    camera.up = direction(random);
    camera.width = uniform(random, 200.0, 1000.0);
    camera.height = uniform(random, 200.0, 1000.0);
    if (trial % 2 == 1) camera.perspectiveDeg = uniform(random, 5.0, 120.0);
    const Box box = boxOf(mesh, projectionOf(camera, mesh));
    // Free room left, right, above and below, less the margin.
    const double left = box.low.x() - camera.margin, above = box.low.y() - camera.margin;
    const double right = camera.width - camera.margin - box.high.x();
    const double below = camera.height - camera.margin - box.high.y();
    EXPECT_GE(std::min({left, right, above, below}), -kRoundingPx);
    // Both sides of one direction touch.
    EXPECT_LE(std::min(std::max(left, right), std::max(above, below)), kRoundingPx);
  }
}

TEST(Camera, ZoomEnlargesFromTheSamePlace) {
  const TriangleMesh mesh = ellipsoid();
  for (const bool perspective : {false, true}) {
    Camera camera;
    camera.towards = {1.0, 2.0, 3.0};
    if (perspective) camera.perspectiveDeg = 40.0;
    const Projection plain = projectionOf(camera, mesh);
    camera.zoom = 2.5;
    const Projection zoomed = projectionOf(camera, mesh);
    const Vector2d middle(camera.width / 2.0, camera.height / 2.0);
    const Vector3d p(0.3, -0.2, 0.1);
    const Vector2d expected = middle + 2.5 * (*plain.toScreen(p) - middle);
    EXPECT_LT((*zoomed.toScreen(p) - expected).norm(), kRoundingPx);
  }
}

TEST(Camera, FieldOfViewIsTheAngleOfThePicturesHeight) {
  const TriangleMesh mesh = ellipsoid();
  Camera camera;
  camera.perspectiveDeg = 50.0;
  const Projection projection = projectionOf(camera, mesh);
  const SurfaceView view = projection.view();
  const Vector3d up = projection.axes.row(1), towards = projection.axes.row(2);
  const double half = 25.0 * std::numbers::pi / 180.0;
  const Vector3d p = *view.eye + 3.0 * (std::sin(half) * up - std::cos(half) * towards);
  EXPECT_NEAR(projection.toScreen(p)->y(), 0.0, 1e-6);
}

TEST(Camera, PointsOnOneLineOfSightFallTogether) {
  const TriangleMesh mesh = ellipsoid();
  Camera camera;
  camera.towards = {-1.0, 0.4, 0.8};
  for (const bool perspective : {false, true}) {
    if (perspective) camera.perspectiveDeg = 35.0;
    const Projection projection = projectionOf(camera, mesh);
    const SurfaceView view = projection.view();
    const Vector3d p(0.2, 0.1, -0.3);
    const Vector3d q = p + 0.4 * view.towardsViewer(p);
    EXPECT_LT((*projection.toScreen(p) - *projection.toScreen(q)).norm(), kRoundingPx);
    EXPECT_FALSE(perspective && projection.toScreen(p + 1e3 * view.towardsViewer(p)));
    if (perspective) {
      const Vector3d w = view.towards;
      EXPECT_FALSE(projection.toScreen(*view.eye + 1e-9 * w));
      EXPECT_TRUE(projection.toScreen(*view.eye - 1e-9 * w));
    }
  }
}

TEST(Camera, UpIsUpRightIsRight) {
  const TriangleMesh mesh = ellipsoid();
  Camera camera;
  camera.towards = {0.0, 0.0, 2.0};
  const Projection projection = projectionOf(camera, mesh);
  const Vector2d origin = *projection.toScreen(Vector3d::Zero());
  EXPECT_GT((*projection.toScreen(Vector3d::UnitX()) - origin).x(), 1.0);
  EXPECT_LT((*projection.toScreen(Vector3d::UnitY()) - origin).y(), -1.0);  // px run down
  EXPECT_NEAR(projection.axes.determinant(), 1.0, 1e-12);
}

TEST(Camera, TakesAnotherUpWhereUpIsTheLineOfSight) {
  const TriangleMesh mesh = ellipsoid();
  for (const double sign : {1.0, -1.0}) {
    for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1),
                                 Vector3d(0.6, 0.0, 0.8), Vector3d(0.0, 0.0, 0.0)}) {
      Camera camera;
      camera.towards = axis.norm() > 0.0 ? Vector3d(sign * axis) : Vector3d(sign, 2.0, 3.0);
      camera.up = axis;
      const Projection projection = projectionOf(camera, mesh);
      ASSERT_TRUE(projection.axes.allFinite());
      EXPECT_LT(
          (projection.axes * projection.axes.transpose() - Eigen::Matrix3d::Identity()).norm(),
          1e-12);
      EXPECT_NEAR(projection.axes.determinant(), 1.0, 1e-12);
    }
  }
  // Seen from above, x stays on the right.
  Camera camera;
  camera.towards = Vector3d::UnitY();
  EXPECT_NEAR(projectionOf(camera, mesh).axes(0, 0), 1.0, 1e-12);
}

TEST(Camera, BallKeepsSizeAndPlaceWhenTurned) {
  Random random(announcedSeed("BallKeepsSizeAndPlaceWhenTurned", 2));
  const TriangleMesh mesh = ellipsoid();
  for (const bool perspective : {false, true}) {
    Camera camera;
    if (perspective) camera.perspectiveDeg = 60.0;
    const Projection first = projectionOf(camera, mesh, true);
    double nearest = std::numeric_limits<double>::infinity();
    for (int trial = 0; trial < 20; ++trial) {
      camera.towards = direction(random);
      const Projection turned = projectionOf(camera, mesh, true);
      EXPECT_DOUBLE_EQ(turned.pxPerUnit, first.pxPerUnit);
      EXPECT_EQ(turned.centre, first.centre);
      const Box box = boxOf(mesh, turned);
      EXPECT_GE(box.low.minCoeff(), camera.margin - kRoundingPx);
      EXPECT_LE(box.high.x(), camera.width - camera.margin + kRoundingPx);
      EXPECT_LE(box.high.y(), camera.height - camera.margin + kRoundingPx);
      nearest = std::min(nearest, box.low.y() - camera.margin);
    }
    // Not smaller than needed: from some side the longest half axis nearly touches.
    EXPECT_LT(nearest, 0.1 * camera.height);
  }
}

TEST(Camera, OutlineOfABallTouchesTheMargin) {
  for (const std::optional<double> angle :
       {std::optional<double>(), std::optional(20.0), std::optional(90.0)}) {
    Camera camera;
    camera.perspectiveDeg = angle;
    const Projection projection = projectionOfBall(camera, 0.7);
    double farthest = 0.0;
    for (int i = 0; i <= 2000; ++i) {  // from the pole that is nearest to the viewer to the other
      const double turn = 3.14159265 * i / 2000.0;
      const auto p = projection.toScreen({0.7 * std::sin(turn), 0.0, 0.7 * std::cos(turn)});
      ASSERT_TRUE(p);
      farthest = std::max(farthest, p->x() - camera.width / 2.0);
    }
    EXPECT_NEAR(farthest, camera.height / 2.0 - camera.margin, 0.01);
  }
}

TEST(Camera, MarginThatLeavesNothingIsReduced) {
  const TriangleMesh mesh = ellipsoid();
  Camera camera;
  camera.width = camera.height = 30.0;
  const Projection projection = projectionOf(camera, mesh);
  EXPECT_GT(projection.pxPerUnit, 0.0);
  const Box box = boxOf(mesh, projection);
  EXPECT_GE(box.low.minCoeff(), 0.0);
  EXPECT_LE(box.high.maxCoeff(), 30.0);
}

}  // namespace
}  // namespace flatland::test
