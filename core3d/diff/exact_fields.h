// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/mesh/solids.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// The fields of a solid's mesh from its formula: the truth that estimates and lines are held
/// against. `mesh` is built from the soup of meshOf(), `places` are those that came with it. In the
/// coordinates of the mesh: curvatures grow by mesh.unit, C by its square. Normals point to the
/// side that the triangles of each vertex face, so a flipped mesh has K and C of the other sign.
/// Exact up to the rounding of the fields to float; the mesh's own positions are rounded too.
SurfaceFields exactFields(const Solid& solid, const std::vector<Eigen::Vector3d>& places,
                          const TriangleMesh& mesh);

}  // namespace flatland
