// SPDX-License-Identifier: MIT
#pragma once

#include "core3d/mesh/mesh_report.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// Part of buildMesh: makes the triangles of each piece agree on their winding, cuts where they
/// cannot, turns pieces that have an outside (pieces.h) outward, leaves out pieces without area.
/// Expects triangles and `opposite` (half-edges paired whichever way they run); both agree
/// afterwards. May leave no triangle.
void agreeOnWinding(TriangleMesh& mesh, MeshReport& report);

}  // namespace flatland
