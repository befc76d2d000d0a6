// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/cutting_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core3d/study/bridge_lines.h"
#include "core3d/study/section.h"
#include "ui/model/orbit.h"

namespace flatland::ui {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kDeg = 180.0 / std::numbers::pi;
constexpr double kRimShare = 0.8;  ///< of the ball around the surface: the handles stay in sight
constexpr int kRimPoints = 96;
/// Below this sine between normal and line of sight a pull along the normal would run away.
constexpr double kAlongSight = 0.15;

/// The two directions of the rim's handles.
std::array<Vector3d, 2> axesOf(const SurfacePlane& plane) {
  const CutPlane cut = planeAcross(plane.point, plane.normal, Vector3d::UnitY());
  return {cut.right, cut.up};
}

}  // namespace

CutPlane cutPlaneOf(const SurfacePlane& plane, const TriangleMesh& mesh) {
  return planeAcross(mesh.origin + mesh.unit * plane.point, plane.normal, Vector3d::UnitY());
}

PlaneView planeViewOf(const CutPlane& plane, const SurfaceView& view) {
  if (view.eye) return {{}, std::string(kNoFlatPerspective)};
  const Vec2 w(plane.right.dot(view.towards), plane.up.dot(view.towards));
  if (w.norm() < kSeenAlong) {
    return {{}, "the plane is seen head-on: no direction within it leads to the viewer"};
  }
  return {View{.angleDeg = std::atan2(w.y(), w.x()) * kDeg, .distance = {}}, {}};
}

SurfacePlane planeAlongView(const SurfaceCamera& camera, const Vector3d& through) {
  return {through, camera.up.cross(camera.towards).normalized()};
}

std::optional<SurfacePlane> planeAlongRidgeAt(const LoadedSurface& surface, const SurfaceView& view,
                                              const Vector3d& at) {
  if (!surface.fields) return std::nullopt;
  const TriangleMesh& mesh = *surface.mesh;
  const auto cut = planeAlongRidge(mesh, *surface.fields, view, mesh.origin + mesh.unit * at);
  if (!cut) return std::nullopt;
  return SurfacePlane{(cut->origin - mesh.origin) / mesh.unit, cut->normal};
}

PlaneHandles handlesOf(const SurfacePlane& plane, double ballRadius) {
  const double radius = kRimShare * ballRadius;
  const auto [right, up] = axesOf(plane);
  return {plane.point,
          {plane.point + radius * right, plane.point + radius * up, plane.point - radius * right,
           plane.point - radius * up},
          radius};
}

std::vector<Vector3d> rimOf(const SurfacePlane& plane, double ballRadius) {
  const double radius = kRimShare * ballRadius;
  const auto [right, up] = axesOf(plane);
  std::vector<Vector3d> points;
  for (int i = 0; i < kRimPoints; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRimPoints;
    points.push_back(plane.point + radius * (std::cos(angle) * right + std::sin(angle) * up));
  }
  return points;
}

SurfacePlane moved(const SurfacePlane& plane, double by, double ballRadius) {
  SurfacePlane result = plane;
  const double height = plane.point.dot(plane.normal);
  const double target = std::clamp(height + by, -ballRadius, ballRadius);
  result.point += (target - height) * plane.normal;
  return result;
}

SurfacePlane pulled(const SurfacePlane& plane, const Projection& projection, const Vector2d& fromPx,
                    const Vector2d& toPx, double ballRadius) {
  // The place of the normal's line nearest to the line of sight through a pixel.
  const auto heightAt = [&](const Vector2d& px) {
    const Sight sight = sightThrough(projection, px);
    const double cosine = plane.normal.dot(sight.along);
    const Vector3d from = sight.from - plane.point;
    return (from.dot(plane.normal) - cosine * from.dot(sight.along)) / (1.0 - cosine * cosine);
  };
  const Vector3d along = sightThrough(projection, fromPx).along;
  if (plane.normal.cross(along).norm() < kAlongSight) {
    const double towards = plane.normal.dot(along) < 0.0 ? 1.0 : -1.0;
    return moved(plane, towards * (fromPx.y() - toPx.y()) / projection.pxPerUnit, ballRadius);
  }
  return moved(plane, heightAt(toPx) - heightAt(fromPx), ballRadius);
}

SurfacePlane turnedTo(const SurfacePlane& plane, const Vector3d& rimPlace,
                      const Projection& projection, const Vector2d& px) {
  const Vector3d arm = rimPlace - plane.point;
  const double radius = arm.norm();
  const Sight sight = sightThrough(projection, px);
  // Where the line of sight meets the ball of the handles, on the side where the handle is.
  const Vector3d foot =
      sight.from + sight.along * sight.along.dot(plane.point - sight.from) - plane.point;
  const double square = radius * radius - foot.squaredNorm();
  const double side = arm.dot(sight.along) < 0.0 ? -1.0 : 1.0;
  const Vector3d to = square > 0.0 ? Vector3d(foot + side * std::sqrt(square) * sight.along) : foot;
  if (!(to.norm() > 0.0)) return plane;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(arm, to);
  SurfacePlane result = plane;
  result.normal = (turn * plane.normal).normalized();
  return result;
}

SurfacePlane turnedAbout(const SurfacePlane& plane, const Vector3d& axis, double angleRad) {
  SurfacePlane result = plane;
  result.normal = (Eigen::AngleAxisd(angleRad, axis.normalized()) * plane.normal).normalized();
  return result;
}

NormalAngles anglesOf(const Vector3d& normal) {
  const double flat = std::hypot(normal.x(), normal.z());
  NormalAngles angles{{}, std::atan2(normal.y(), flat) * kDeg};
  if (flat > kSeenAlong) angles.azimuthDeg = std::atan2(-normal.z(), normal.x()) * kDeg;
  return angles;
}

Vector3d normalOf(const NormalAngles& angles) {
  const double elevation = angles.elevationDeg / kDeg, flat = std::cos(elevation);
  if (!angles.azimuthDeg || flat <= kSeenAlong) {
    return std::copysign(1.0, elevation) * Vector3d::UnitY();
  }
  const double azimuth = *angles.azimuthDeg / kDeg;
  return {flat * std::cos(azimuth), std::sin(elevation), -flat * std::sin(azimuth)};
}

}  // namespace flatland::ui
