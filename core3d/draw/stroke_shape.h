// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core3d/draw/drawing.h"

namespace flatland {

/// How wide and how dark strokes are.
struct StrokeStyle {
  double widthPx = 1.5;  ///< of the strongest
  /// Width of a stroke at its weakest, as a share of widthPx, in (0, 1]. 1: all equally wide.
  double leastWidth = 1.0;
  /// Open ends run out to a point over this length or a third of the stroke, whichever is less.
  /// Stroke ends where the line goes on hidden are tapered like others. 0: blunt.
  double taperPx = 0.0;
  /// Darkness at the weakest, in [0, 1]. 1: all equally dark.
  double leastDarkness = 1.0;
};

/// A stroke ready for drawing.
struct StrokeShape {
  std::vector<Eigen::Vector2d> centre;  ///< px; a closed stroke does not repeat its first point
  std::vector<double> widthPx;          ///< of each point of the centre line
  std::vector<double> darkness;         ///< of each, in [0, 1]
  bool closed = false;
  bool uniform = true;  ///< one width and darkness everywhere: a plain line will do
};

/// Maps strength to width and darkness. Between two strengths of a family, `weak` (usually its
/// threshold) and `strong`, both grow with the square root of the strength; strength is first
/// averaged over some pixels along the stroke. A family without strength (weak >= strong) is drawn
/// at full width. Points are added so that tapers are curved and width is linear enough between
/// points.
StrokeShape shapeOf(const Polyline& line, const StrokeStyle& style, double weak, double strong);

/// The area of a shape as a closed polygon, px, to be filled by the nonzero rule: out along the
/// left side and back along the right one, with mitres at mild bends and cut corners at sharp ones.
/// A closed stroke gives two polygons, the outer side and the inner one turned round.
std::vector<std::vector<Eigen::Vector2d>> outlineOf(const StrokeShape& shape);

}  // namespace flatland
