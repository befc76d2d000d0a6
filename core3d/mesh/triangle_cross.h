// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// The vector across a triangle, on the side its normal points to, as long as twice its area. 0, or
/// a rounding of it, for a triangle without area.
inline Eigen::Vector3d crossOf(const TriangleMesh& mesh, std::uint32_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Eigen::Vector3d p = mesh.position(a).cast<double>();
  return (mesh.position(b).cast<double>() - p).cross(mesh.position(c).cast<double>() - p);
}

}  // namespace flatland
