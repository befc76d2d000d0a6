// SPDX-License-Identifier: MIT
#pragma once

#include "core3d/mesh/mesh_report.h"
#include "core3d/mesh/polygon_soup.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// First part of buildMesh: takes the vertices that mesh.triangles (numbered as in the soup) use,
/// normalises, welds and orders them, and numbers the triangles anew. Fills x, y, z, fileVertex,
/// meshVertex, origin and unit. False, and nothing done, if all used vertices are at one place.
bool orderVertices(const PolygonSoup& soup, TriangleMesh& mesh, MeshReport& report);

}  // namespace flatland
