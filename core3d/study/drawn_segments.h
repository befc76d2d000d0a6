// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core3d/lines/feature_lines.h"
#include "core3d/mesh/slice.h"
#include "core3d/mesh/swept.h"
#include "core3d/study/bridge_lines.h"

namespace flatland {

// Lines that are no family, as segments for Draughtsman: so that a drawing removes what is hidden
// of them as exactly as of the families. Coordinates of the mesh; segments of one line share nodes,
// and lines of different `level` have none in common; the strength is 1.

/// A section in the triangles that it cuts, for a family that follows the mesh (Topographic).
/// `slice` is of this mesh.
std::vector<LineSegment> segmentsOf(const Slice& slice, const TriangleMesh& mesh);

/// A predicted line. It lies on the surface that the mesh stands for and not on its facets: each
/// piece, at most as long as an edge, names the triangle below it, for a family that is
/// interpolated (Isophotes, OccludingContours). `mesh` was built from `swept`. A pass over the
/// triangles and another over those around the line for each piece.
std::vector<LineSegment> segmentsOf(const PredictedLine& line, const SweptMesh& swept,
                                    const TriangleMesh& mesh, std::uint32_t level = 0);

}  // namespace flatland
