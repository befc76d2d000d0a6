// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "flatland/curve/bezier_chain.h"

namespace flatland {

struct FitOptions {
  double tolerance = 0.0;  ///< how far a point may lie from the chain, length > 0
  double cornerDeg =
      40.0;        ///< a turn above it is a corner: pieces meet there with their own tangents
  int degree = 5;  ///< of the pieces, 3 to 9; 5 keeps curvature calmer than 3
};

/// A chain through a row of points.
struct FittedChain {
  BezierChain chain;
  double maxDeviation;  ///< largest distance from a point given to the piece fitted to it
  std::size_t corners;  ///< joints where the tangent jumps
};

/// Fits Bezier pieces by least squares, and cuts in two what the tolerance does not allow. Pieces
/// start and end at points that were given and share a tangent (G1) but at corners; in the worst
/// case they are the straight lines between the points, so maxDeviation is at most the tolerance.
/// Between neighbouring points the chain stays within the tolerance and a quarter of their
/// distance.
///
/// Curvature jumps a little at the joints: with a tolerance below the noise of the points it
/// follows the noise. nullopt without two points that differ. Points in a row at one place count
/// once; a closed row does not repeat its first point. Cost: about 1 ms for 1000 points.
std::optional<FittedChain> fitBezierChain(const std::vector<Vec2>& points, bool closed,
                                          const FitOptions& options);

}  // namespace flatland
