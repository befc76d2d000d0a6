// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core3d/lines/feature_lines.h"

namespace flatland {

/// Where two sets of lines on one surface agree and where they do not. A piece agrees if its middle
/// lies within the tolerance of some piece of the other set, on the surface's own scale: in space,
/// hidden or not, whatever the picture.
struct LineDifference {
  std::vector<LineSegment> common;   ///< pieces of `lines` that have one of `reference` near
  std::vector<LineSegment> added;    ///< pieces of `lines` that have none
  std::vector<LineSegment> missing;  ///< pieces of `reference` that have none of `lines` near

  // Lengths, coordinates of the mesh.
  double linesLength = 0.0, referenceLength = 0.0;
  double addedLength = 0.0, missingLength = 0.0;

  /// Of the length of `lines`, in [0, 1]; 0 if there are none.
  double addedShare() const { return linesLength > 0.0 ? addedLength / linesLength : 0.0; }
  /// Of the length of `reference`, likewise.
  double missingShare() const {
    return referenceLength > 0.0 ? missingLength / referenceLength : 0.0;
  }
};

/// Compares `lines` with `reference`. Tolerance: coordinates of the mesh, >= 0. Cost: the number of
/// pieces, times how many of them lie within a cell of the size of the tolerance or of a mean
/// piece, whichever is larger.
LineDifference differenceOf(std::span<const LineSegment> lines,
                            std::span<const LineSegment> reference, double tolerance);

}  // namespace flatland
