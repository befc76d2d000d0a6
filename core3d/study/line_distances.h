// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core3d/lines/feature_lines.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// Mean length of the sides of the mesh's triangles, in the unit of the file.
double meanEdge(const TriangleMesh& mesh);

/// A piece of a line that was found, in the coordinates of the file, and how far it is from where a
/// line should be.
struct MeasuredPiece {
  Eigen::Vector3d middle;
  double length, distance;
};

/// The piece without its distance, which is 0.
MeasuredPiece pieceOf(const TriangleMesh& mesh, const LineSegment& segment);

/// The distance that `share` of all length lies at or below; not a number without any. Sorts the
/// pieces by distance.
double distancePercentile(std::vector<MeasuredPiece>& pieces, double share);

}  // namespace flatland
