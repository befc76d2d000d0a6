// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/orbit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core3d/draw/drawing.h"

namespace flatland::ui {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Of the viewer's distance, where nothing is drawn: keeps depths apart.
constexpr double kNearestShare = 1e-3;

/// The axes of the picture: rows right, up, towards the viewer.
Eigen::Matrix3d axesOf(const SurfaceCamera& camera) {
  Eigen::Matrix3d axes;
  axes.row(2) = camera.towards.normalized();
  axes.row(0) = camera.up.cross(camera.towards).normalized();
  axes.row(1) = Vector3d(axes.row(2)).cross(Vector3d(axes.row(0)));
  return axes;
}

/// Turned about an axis through the centre of the ball; what the hand turned stays exactly
/// orthonormal, however long it turns.
SurfaceCamera turned(SurfaceCamera camera, const Vector3d& axis, double angleRad) {
  const Eigen::AngleAxisd turn(angleRad, axis);
  const Vector3d up = axesOf(camera).row(1);
  camera.towards = (turn * camera.towards).normalized();
  camera.up = turn * up;
  camera.up = (camera.up - camera.towards * camera.towards.dot(camera.up)).normalized();
  return camera;
}

}  // namespace

Camera drawingCamera(const SurfaceCamera& camera, double width, double height) {
  Camera drawing;
  drawing.towards = camera.towards;
  drawing.up = camera.up;
  drawing.perspectiveDeg = camera.perspectiveDeg;
  drawing.zoom = camera.zoom;
  drawing.centre = camera.centre;
  drawing.width = width;
  drawing.height = height;
  drawing.margin *= pictureScale(width, height);
  return drawing;
}

Projection orbitProjection(const SurfaceCamera& camera, double ballRadius, double width,
                           double height) {
  return projectionOfBall(drawingCamera(camera, width, height),
                          ballRadius > 0.0 ? ballRadius : 1.0);
}

SurfaceView orbitView(const SurfaceCamera& camera, double ballRadius) {
  constexpr double kAnySize = 100.0;
  return orbitProjection(camera, ballRadius, kAnySize, kAnySize).view();
}

Eigen::Matrix4d clipMatrix(const Projection& projection, double ballRadius) {
  const double reach = std::max(ballRadius, 1e-6) + projection.centre.norm();
  const Eigen::Matrix3d& axes = projection.axes;
  Eigen::Matrix4d seen = Eigen::Matrix4d::Identity();  // right, up, towards the viewer
  seen.topLeftCorner<3, 3>() = axes;
  seen.topRightCorner<3, 1>() = -axes * projection.centre;
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 2.0 * projection.pxPerUnit / projection.width;
  clip(1, 1) = 2.0 * projection.pxPerUnit / projection.height;
  if (projection.distance) {
    const double d = *projection.distance;
    const double near = std::max(d - reach, kNearestShare * d), far = d + reach;
    // With D = d - z the depth before the viewer: w = D / d, z = (a D + b) / d.
    const double a = (far + near) / (far - near), b = -2.0 * far * near / (far - near);
    clip(2, 2) = -a / d;
    clip(2, 3) = (a * d + b) / d;
    clip(3, 2) = -1.0 / d;
    clip(3, 3) = 1.0;
  } else {
    clip(2, 2) = -1.0 / reach;
    clip(3, 3) = 1.0;
  }
  return clip * seen;
}

Sight sightThrough(const Projection& projection, const Vector2d& px) {
  const double x = (px.x() - 0.5 * projection.width) / projection.pxPerUnit;
  const double y = (0.5 * projection.height - px.y()) / projection.pxPerUnit;
  const Vector3d right = projection.axes.row(0), up = projection.axes.row(1),
                 towards = projection.axes.row(2);
  const Vector3d at = projection.centre + x * right + y * up;
  if (!projection.distance) return {at, -towards};
  const Vector3d eye = projection.centre + *projection.distance * towards;
  return {eye, (at - eye).normalized()};
}

SurfaceCamera orbited(const SurfaceCamera& camera, const Vector2d& dragPx, double heightPx) {
  const double length = dragPx.norm();
  if (!(length > 0.0)) return camera;
  const Eigen::Matrix3d axes = axesOf(camera);
  // The front follows the hand, so the viewer goes round the other way.
  const Vector3d axis = -(dragPx.y() * Vector3d(axes.row(0)) + dragPx.x() * Vector3d(axes.row(1)));
  return turned(camera, axis / length, length / heightPx * std::numbers::pi);
}

SurfaceCamera rolled(const SurfaceCamera& camera, double angleRad) {
  return turned(camera, camera.towards.normalized(), -angleRad);
}

SurfaceCamera spun(const SurfaceCamera& camera, double angleRad) {
  return turned(camera, axesOf(camera).row(1), angleRad);
}

SurfaceCamera panned(const SurfaceCamera& camera, const Projection& projection,
                     const Vector2d& dragPx) {
  SurfaceCamera moved = camera;
  moved.centre -= (dragPx.x() * Vector3d(projection.axes.row(0)) -
                   dragPx.y() * Vector3d(projection.axes.row(1))) /
                  projection.pxPerUnit;
  return moved;
}

SurfaceCamera zoomedAt(const SurfaceCamera& camera, const Projection& projection,
                       const Vector2d& px, double factor) {
  const double zoom = std::clamp(camera.zoom * factor, kLeastZoom, kMostZoom);
  const double share = zoom / camera.zoom;
  // The place under the pointer moves away from the middle by the factor; the centre follows.
  const Vector2d away = px - Vector2d(0.5 * projection.width, 0.5 * projection.height);
  SurfaceCamera moved = panned(camera, projection, (1.0 / share - 1.0) * away);
  moved.zoom = zoom;
  return moved;
}

Eigen::Matrix3d uprightTurn(const Vector3d& up) {
  if (up == -Vector3d::UnitY()) return Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), up);
  // Between axes all entries are 0 or 1; standard views are exact.
  return turn.toRotationMatrix().array().round();
}

SurfaceCamera homeCamera(const Vector3d& up) {
  SurfaceCamera camera;
  const Eigen::Matrix3d turn = uprightTurn(up);
  camera.towards = turn * camera.towards;
  camera.up = turn * camera.up;
  return camera;
}

SurfaceCamera seenFrom(const SurfaceCamera& camera, StandardView view, const Vector3d& up) {
  SurfaceCamera moved = camera;
  moved.centre.setZero();
  moved.up = Vector3d::UnitY();
  switch (view) {
    case StandardView::Front:
      moved.towards = Vector3d::UnitZ();
      break;
    case StandardView::Back:
      moved.towards = -Vector3d::UnitZ();
      break;
    case StandardView::Right:
      moved.towards = Vector3d::UnitX();
      break;
    case StandardView::Left:
      moved.towards = -Vector3d::UnitX();
      break;
    case StandardView::Top:
      moved.towards = Vector3d::UnitY();
      moved.up = -Vector3d::UnitZ();
      break;
    case StandardView::Bottom:
      moved.towards = -Vector3d::UnitY();
      moved.up = Vector3d::UnitZ();
      break;
  }
  const Eigen::Matrix3d turn = uprightTurn(up);
  moved.towards = turn * moved.towards;
  moved.up = turn * moved.up;
  return moved;
}

SurfaceCamera withPerspectiveToggled(const SurfaceCamera& camera) {
  SurfaceCamera other = camera;
  if (other.perspectiveDeg) {
    other.perspectiveDeg.reset();
  } else {
    other.perspectiveDeg = kUsualPerspectiveDeg;
  }
  return other;
}

}  // namespace flatland::ui
