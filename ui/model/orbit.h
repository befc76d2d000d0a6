// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core3d/draw/camera.h"
#include "flatland/scene/surface_setting.h"

namespace flatland::ui {

// How a hand moves the camera of a surface. Pixels: x right, y down, origin at the top left.

/// Standard views: from the front (+z), the right (+x), above (+y) and their opposites, where y
/// points upward; of another axis that does, see uprightTurn().
enum class StandardView { Front, Back, Right, Left, Top, Bottom };

inline constexpr double kUsualPerspectiveDeg = 35;  ///< of the key that turns perspective on
inline constexpr double kLeastZoom = 0.05;

/// The same camera for drawings, in a picture of this size with the margin that `flatland lines`
/// leaves: a list of such cameras gives the pictures of the window.
Camera drawingCamera(const SurfaceCamera& camera, double width, double height);

/// The camera set before a ball about 0 that is fitted at zoom 1 (projectionOfBall). Zoom magnifies
/// the picture and moves nobody.
Projection orbitProjection(const SurfaceCamera& camera, double ballRadius, double width,
                           double height);

/// From where such a camera looks, which the size of the picture has no part in.
SurfaceView orbitView(const SurfaceCamera& camera, double ballRadius);

/// A 4 x 4 matrix from points of the mesh to clip coordinates of OpenGL (-1 to 1 after division, z
/// nearest first): the same picture as the projection. Everything within `ballRadius` of 0 in front
/// of the viewer is kept.
Eigen::Matrix4d clipMatrix(const Projection& projection, double ballRadius);

/// The line of sight through a pixel: a point on it and the unit direction away from the viewer.
struct Sight {
  Eigen::Vector3d from, along;
};
Sight sightThrough(const Projection& projection, const Eigen::Vector2d& px);

/// Turned as if the hand held the front of the ball: a drag over the height of the picture is half
/// a turn.
SurfaceCamera orbited(const SurfaceCamera& camera, const Eigen::Vector2d& dragPx, double heightPx);

/// Turned about the line of sight, counter-clockwise as seen.
SurfaceCamera rolled(const SurfaceCamera& camera, double angleRad);

/// Turned about the upward axis of the picture.
SurfaceCamera spun(const SurfaceCamera& camera, double angleRad);

/// Moved so that the centre follows the hand.
SurfaceCamera panned(const SurfaceCamera& camera, const Projection& projection,
                     const Eigen::Vector2d& dragPx);

/// Magnified by `factor` (> 0), in the limits, about a pixel: what is seen there at the depth of
/// the centre stays there.
SurfaceCamera zoomedAt(const SurfaceCamera& camera, const Projection& projection,
                       const Eigen::Vector2d& px, double factor);

/// The rotation that takes y to the axis `up` (one of the three or its opposite) the shortest way;
/// -y about z. So the front of what has z upward is seen from -y.
Eigen::Matrix3d uprightTurn(const Eigen::Vector3d& up);

/// The same camera looking along an axis, the ball in the middle; zoom and perspective stay.
SurfaceCamera seenFrom(const SurfaceCamera& camera, StandardView view,
                       const Eigen::Vector3d& up = Eigen::Vector3d::UnitY());

/// From where a surface is seen when it is opened.
SurfaceCamera homeCamera(const Eigen::Vector3d& up);

SurfaceCamera withPerspectiveToggled(const SurfaceCamera& camera);

}  // namespace flatland::ui
