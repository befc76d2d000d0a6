// SPDX-License-Identifier: MIT
#include "core3d/draw/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace flatland {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Sine of the angle below which `up` counts as along the line of sight: far above rounding, far
// below anything a person would mean.
constexpr double kAlong = 1e-9;
// A mesh that is a point or a line along the view is given this size, so that its scale is finite.
constexpr double kSmallestExtent = 1e-6;

// The axis least along t; seen from above, away from the viewer is up.
Vector3d otherUp(const Vector3d& t, const Vector3d& up) {
  Eigen::Index axis = 2;
  for (const Eigen::Index k : {1, 0}) {
    if (std::abs(t[k]) < std::abs(t[axis])) axis = k;
  }
  return Vector3d::Unit(axis) * (t.dot(up) > 0.0 ? -1.0 : 1.0);
}

Eigen::Matrix3d axesOf(const Camera& camera) {
  const Vector3d t = camera.towards.stableNormalized();
  const Vector3d up = camera.up.stableNormalized();
  Vector3d right = up.cross(t);
  if (!(right.norm() > kAlong)) right = otherUp(t, up).cross(t);
  right.normalize();
  Eigen::Matrix3d axes;
  axes.row(0) = right;
  axes.row(1) = t.cross(right);
  axes.row(2) = t;
  return axes;
}

// Half the room for the outline, px.
Vector2d halfRoom(const Camera& camera) {
  double margin = std::max(camera.margin, 0.0);
  while (2.0 * margin > 0.75 * std::min(camera.width, camera.height)) margin /= 2.0;
  return {camera.width / 2.0 - margin, camera.height / 2.0 - margin};
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double middle() const { return (low + high) / 2.0; }
  double size() const { return std::max(high - low, kSmallestExtent); }
};

struct Ball {
  Vector3d centre;
  double radius;
};

Ball ballAround(const TriangleMesh& mesh) {
  Extent x, y, z;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    x.add(mesh.x[v]);
    y.add(mesh.y[v]);
    z.add(mesh.z[v]);
  }
  Ball ball{{x.middle(), y.middle(), z.middle()}, kSmallestExtent};
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    ball.radius = std::max(ball.radius, (mesh.position(v).cast<double>() - ball.centre).norm());
  }
  return ball;
}

void fitOrthographic(const Camera& camera, const TriangleMesh& mesh, Projection& to) {
  Extent x, y, z;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vector3d q = to.axes * mesh.position(v).cast<double>();
    x.add(q.x());
    y.add(q.y());
    z.add(q.z());
  }
  const Vector2d room = 2.0 * halfRoom(camera);
  to.centre = to.axes.transpose() * Vector3d(x.middle(), y.middle(), z.middle());
  to.pxPerUnit = std::min(room.x() / x.size(), room.y() / y.size());
}

// A vertex q is inside the picture of a viewer at e, in the axes of the picture, if
// |q.x - e.x| <= slope.x (e.z - q.z), and y likewise: four half-spaces for e, whose nearest common
// place is found from the extremes of q.x + slope.x q.z and its three fellows.
void fitPerspective(const Camera& camera, double tangent, const TriangleMesh& mesh,
                    Projection& to) {
  const Vector2d slope = halfRoom(camera) * (tangent / (camera.height / 2.0));
  Extent right, left, above, below, depth;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    const Vector3d q = to.axes * mesh.position(v).cast<double>();
    right.add(q.x() + slope.x() * q.z());
    left.add(-q.x() + slope.x() * q.z());
    above.add(q.y() + slope.y() * q.z());
    below.add(-q.y() + slope.y() * q.z());
    depth.add(q.z());
  }
  const double nearest =
      std::max({(right.high + left.high) / (2.0 * slope.x()),
                (above.high + below.high) / (2.0 * slope.y()), depth.high + kSmallestExtent});
  const Vector3d centre((right.high - left.high) / 2.0, (above.high - below.high) / 2.0,
                        depth.middle());
  to.centre = to.axes.transpose() * centre;
  to.distance = nearest - depth.middle();
}

}  // namespace

bool looksAlongUp(const Camera& camera) {
  return !(camera.up.stableNormalized().cross(camera.towards.stableNormalized()).norm() > kAlong);
}

SurfaceView Projection::view() const {
  SurfaceView view;
  view.towards = axes.row(2);
  if (distance) view.eye = centre + *distance * view.towards;
  return view;
}

std::optional<Vector2d> Projection::toScreen(const Vector3d& p) const {
  const Vector3d q = axes * (p - centre);
  double scale = pxPerUnit;
  if (distance) {
    const double depth = *distance - q.z();
    if (!(depth > 0.0)) return std::nullopt;
    scale *= *distance / depth;
  }
  return Vector2d(width / 2.0 + scale * q.x(), height / 2.0 - scale * q.y());
}

Projection projectionOfBall(const Camera& camera, double ballRadius) {
  Projection to;
  to.axes = axesOf(camera);
  to.width = camera.width;
  to.height = camera.height;
  to.centre = camera.centre.value_or(Vector3d::Zero());
  const double radius = std::max(ballRadius, kSmallestExtent);
  double fitted = halfRoom(camera).minCoeff() / radius;
  if (camera.perspectiveDeg) {
    const double halfAngle = *camera.perspectiveDeg * std::numbers::pi / 360.0;
    to.distance = radius / std::sin(halfAngle);
    // The outline of the ball is seen larger than its radius by 1 / cos of half the angle.
    fitted *= std::cos(halfAngle);
  }
  to.pxPerUnit = camera.zoom * fitted;
  return to;
}

double ballRadiusOf(const TriangleMesh& mesh) {
  float farthest = 0.0f;
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    farthest = std::max(farthest, mesh.position(v).norm());
  }
  return farthest;
}

Projection projectionOf(const Camera& camera, const TriangleMesh& mesh, bool fitBall) {
  if (camera.centre) return projectionOfBall(camera, ballRadiusOf(mesh));
  Projection to;
  to.axes = axesOf(camera);
  to.width = camera.width;
  to.height = camera.height;
  const double tangent =
      camera.perspectiveDeg ? std::tan(*camera.perspectiveDeg * std::numbers::pi / 360.0) : 0.0;
  if (fitBall) {
    const Ball ball = ballAround(mesh);
    const double room = halfRoom(camera).minCoeff();
    to.centre = ball.centre;
    to.pxPerUnit = room / ball.radius;
    if (camera.perspectiveDeg) {
      const double slope = tangent * room / (camera.height / 2.0);
      to.distance = ball.radius * std::sqrt(1.0 + 1.0 / (slope * slope));
    }
  } else if (camera.perspectiveDeg) {
    fitPerspective(camera, tangent, mesh, to);
  } else {
    fitOrthographic(camera, mesh, to);
  }
  if (to.distance) to.pxPerUnit = camera.height / 2.0 / (tangent * *to.distance);
  to.pxPerUnit *= camera.zoom;
  return to;
}

}  // namespace flatland
