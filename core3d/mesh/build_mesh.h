// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core3d/mesh/mesh_report.h"
#include "core3d/mesh/polygon_soup.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// A mesh, and what was found and mended on the way to it.
struct BuiltMesh {
  TriangleMesh mesh;
  MeshReport report;
};

/// Checks, mends and lays out what a file says. In this order:
///
/// 1. Polygons become triangles (triangulate.h). Vertices that no face uses are left out, so that
///    they do not count for the bounding box; positions are normalised and rounded to float.
/// 2. Vertices at the same place after that are welded. Triangles that then use a vertex twice, or
///    have the same three vertices as another one, are left out.
/// 3. An edge of more than two triangles is cut: none of them has a neighbour there.
/// 4. Triangles are turned to agree with their neighbours, as the majority of their piece is
///    wound. Where that is impossible (a Moebius strip), edges are cut. A piece that has an
///    outside (pieces.h) is turned outward; a relief or a mask stays as the file has it.
/// 5. Pieces without any area are left out. Other triangles whose corners lie in one line stay,
///    for without them the surface would have a slit.
/// 6. A vertex with several fans of triangles becomes one vertex for each fan.
///
/// Equal surfaces give equal meshes, whatever the order of vertices and faces in the file.
///
/// Throws InputError, with `source` as the file, if no triangle with an area is left. About 0.3
/// microseconds a triangle; a soup of n corners needs memory for about 30 n bytes beside its own.
BuiltMesh buildMesh(const PolygonSoup& soup, const std::string& source = "");

}  // namespace flatland
