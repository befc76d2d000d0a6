// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core3d/draw/camera.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/slice.h"
#include "flatland/scene/surface_setting.h"
#include "flatland/view/view.h"
#include "ui/model/loaded_surface.h"

namespace flatland::ui {

// The plane that cuts the surface: what it is of, and what a hand does to it. All in the
// coordinates of TriangleMesh and SurfaceCamera unless it is said otherwise. Pixels: x right, y
// down.

/// The plane in the unit of the mesh's file. Its coordinates depend on the plane alone and not on
/// the view: up is y as far as the plane allows, so that a section stays where it is while the
/// surface turns.
CutPlane cutPlaneOf(const SurfacePlane& plane, const TriangleMesh& mesh);

/// From where flatland has to look at a section in that plane: along the part of w within it.
/// Empty, with the reason in English, where the plane is seen head-on or the view is in
/// perspective.
struct PlaneView {
  std::optional<View> view;
  std::string whyNot;
};
PlaneView planeViewOf(const CutPlane& plane, const SurfaceView& view);

/// The plane through a point that holds the direction to the viewer and the picture's upward one.
SurfacePlane planeAlongView(const SurfaceCamera& camera, const Eigen::Vector3d& through);

/// The plane through a picked place along w and t_A (planeAlongRidge); nullopt without fields, or
/// without a t_A there.
std::optional<SurfacePlane> planeAlongRidgeAt(const LoadedSurface& surface, const SurfaceView& view,
                                              const Eigen::Vector3d& at);

/// What of the plane can be taken hold of: the middle, and four places on a circle around it.
struct PlaneHandles {
  Eigen::Vector3d centre;
  std::array<Eigen::Vector3d, 4> rim;
  double radius;
};
PlaneHandles handlesOf(const SurfacePlane& plane, double ballRadius);

/// Points of that circle, closed.
std::vector<Eigen::Vector3d> rimOf(const SurfacePlane& plane, double ballRadius);

/// Moved along its normal by a length, its point at most a ball's radius from 0.
SurfacePlane moved(const SurfacePlane& plane, double by, double ballRadius);

/// Moved along its normal as a hand pulls its middle from one pixel to another. Where the normal is
/// along the line of sight, upward is towards the viewer.
SurfacePlane pulled(const SurfacePlane& plane, const Projection& projection,
                    const Eigen::Vector2d& fromPx, const Eigen::Vector2d& toPx, double ballRadius);

/// Turned about its point so that a place of the rim, taken hold of, comes under a pixel: on the
/// side of the ball where it is, or as near as the ball comes to it.
SurfacePlane turnedTo(const SurfacePlane& plane, const Eigen::Vector3d& rimPlace,
                      const Projection& projection, const Eigen::Vector2d& px);

/// Turned about its point, about a direction of the picture (right, up): radians, counter-clockwise
/// seen against the direction.
SurfacePlane turnedAbout(const SurfacePlane& plane, const Eigen::Vector3d& axis, double angleRad);

/// The normal as two angles in degrees, for people: azimuth in (-180, 180] about y from x towards
/// -z, elevation in [-90, 90] above the plane of x and z. A normal along y, but for kSeenAlong, has
/// no azimuth: what is left of it would be rounding.
struct NormalAngles {
  std::optional<double> azimuthDeg;
  double elevationDeg;
};
NormalAngles anglesOf(const Eigen::Vector3d& normal);
/// Exactly along y where the azimuth says nothing, or is empty.
Eigen::Vector3d normalOf(const NormalAngles& angles);

}  // namespace flatland::ui
