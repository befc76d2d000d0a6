// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

namespace flatland {

/// From where a surface is seen, in the coordinates of its TriangleMesh.
struct SurfaceView {
  Eigen::Vector3d towards =
      Eigen::Vector3d::UnitZ();        ///< unit vector from the surface to the viewer
  std::optional<Eigen::Vector3d> eye;  ///< place of the viewer; empty when orthographic

  /// Unit vector from p towards the viewer; 0 at the viewer itself.
  Eigen::Vector3d towardsViewer(const Eigen::Vector3d& p) const {
    if (!eye) return towards;
    const Eigen::Vector3d w = *eye - p;
    const double length = w.norm();
    return length > 0.0 ? Eigen::Vector3d(w / length) : Eigen::Vector3d::Zero();
  }
  /// Distance from p to the viewer; empty when orthographic.
  std::optional<double> distanceTo(const Eigen::Vector3d& p) const {
    if (!eye) return std::nullopt;
    return (*eye - p).norm();
  }
};

}  // namespace flatland
