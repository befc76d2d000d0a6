// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core3d/diff/estimate_fields.h"

namespace flatland {

/// Unit normals of all vertices: of each corner the cross product of its edges divided by their
/// squared lengths (bibliography: max1999), which is exact where the vertices lie on a sphere; 0
/// where that sum is 0. Empty if stopped.
std::vector<Eigen::Vector3d> vertexNormals(const TriangleMesh& mesh, const FieldOptions& options);

/// The fast estimate from the triangles round each vertex (bibliography: rusinkiewicz2004).
SurfaceFields oneRingFields(const TriangleMesh& mesh, const FieldOptions& options);

}  // namespace flatland
