// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// The largest zoom that is taken from people: at it the rounding of a mesh's single-precision
/// coordinates is still far below a pixel.
inline constexpr double kMostZoom = 1000.0;

/// From where a drawing of a mesh is made, before it is known how large the mesh is.
struct Camera {
  Eigen::Vector3d towards =
      Eigen::Vector3d::UnitZ();  ///< from the mesh to the viewer, any length > 0
  Eigen::Vector3d up =
      Eigen::Vector3d::UnitY();  ///< appears upward; if along `towards`, another axis is taken
  /// Vertical field of view within the limits of flatland/view/perspective.h; empty: orthographic.
  std::optional<double> perspectiveDeg;
  double zoom = 1.0;  ///< > 1: larger than fitted, as by a longer lens from the same place
  /// Seen in the middle of the picture, coordinates of the mesh. Then not the mesh is fitted but
  /// the ball about 0 that holds it (projectionOfBall). Empty: the middle of what is fitted.
  std::optional<Eigen::Vector3d> centre = {};
  double width = 800.0, height = 600.0;  ///< px, > 0
  double margin = 20.0;                  ///< px kept free when fitting
};

/// True if `up` is along the line of sight, so that it says nothing.
bool looksAlongUp(const Camera& camera);

/// A camera set before a mesh: from points of the mesh to px of the picture (x right, y down).
struct Projection {
  Eigen::Matrix3d
      axes;  ///< rows: right, up on the picture, towards the viewer; orthonormal, right-handed
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< seen in the middle of the picture
  double pxPerUnit = 1.0;                            ///< at the centre
  std::optional<double> distance;    ///< of the viewer from the centre; empty: orthographic
  double width = 0.0, height = 0.0;  ///< px

  SurfaceView view() const;
  /// nullopt at or behind the viewer.
  std::optional<Eigen::Vector2d> toScreen(const Eigen::Vector3d& p) const;
};

/// The mesh fitted into the picture less its margin (a margin that leaves nothing is halved until
/// it leaves a quarter). With `fitBall` the ball around the middle of the mesh is fitted and not
/// its outline, so that size and place stay the same when the mesh is turned. The outline is fitted
/// exactly, in perspective too: the viewer stands as near as the field of view allows, and two
/// sides of the outline touch the margin. One pass over the vertices.
Projection projectionOf(const Camera& camera, const TriangleMesh& mesh, bool fitBall = false);

/// A ball about 0 fitted into the picture less its margin, and moved so that the camera's centre (0
/// if it has none) is in the middle. With perspective the ball fills the field of view, and the
/// viewer goes along with the centre: he stands where he does whatever the size of the picture.
Projection projectionOfBall(const Camera& camera, double ballRadius);

/// Of the ball about 0 that holds the mesh.
double ballRadiusOf(const TriangleMesh& mesh);

}  // namespace flatland
