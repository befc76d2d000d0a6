// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

// The fields of a mesh, and what a view makes of them, one row for a vertex in the order of the
// mesh. Lengths are those of the file. Columns:
//
//   x y z, nx ny nz          place and unit normal
//   k1 k2                    principal curvatures, k1 >= k2, 1/length
//   e1x e1y e1z, e2x e2y e2z their unit directions
//   c111 c112 c122 c222      derivative of curvature in that frame, 1/length^2
//   nw                       foreshortening, n.w
//   lambda                   largest squared view-dependent curvature, 1/length^2
//   feature offset perspective   the terms of 1/2 D_tA lambda, 1/length^3 (apparent_curvature.h)
//   file_vertex              the vertex of the file
//
// lambda and the terms do not exist where nw = 0 or the normal is unknown.

/// Why these numbers cannot be written for this mesh, for a person; empty if they can. Its longest
/// side has to lie between 1e-75 and 1e75: the terms go with the third power of its inverse, and
/// doubles end at 1e-308 and 1e308.
std::optional<std::string> whyNoFieldsFile(const TriangleMesh& mesh);

// Precondition of both: !whyNoFieldsFile(mesh).

/// Binary little-endian PLY with the triangles. Values in double, "not a number" where they do not
/// exist.
std::string fieldsToPly(const TriangleMesh& mesh, const SurfaceFields& fields,
                        const SurfaceView& view);

/// CSV (RFC 4180), an empty field for what does not exist.
std::string fieldsToCsv(const TriangleMesh& mesh, const SurfaceFields& fields,
                        const SurfaceView& view);

}  // namespace flatland
