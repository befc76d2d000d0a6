// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core3d/draw/drawing.h"
#include "core3d/draw/screen_chain.h"

namespace flatland {

/// A chain and how it is seen.
struct SeenChain {
  ScreenChain line;
  std::vector<Stretch> stretches;  ///< as stretchesOf gives them
  /// Of a contour's loop shorter than StrokeOptions::minLengthPx: with background all round.
  bool outlineOfPart = false;
};

/// A part of a chain that is drawn as one stroke.
struct StrokePart {
  std::size_t chain;  ///< index
  double from, to;    ///< places
  Seen seen;
  bool closed;  ///< the whole of a closed chain
};

/// What a family is filtered with.
struct StrokeFilter {
  double threshold = 0.0;  ///< of strength; 0 keeps every strength
  double minLengthPx = 0.0;
  double minWeightPx = 0.0;  ///< see StrokeOptions::minWeightPx; 0: strokes are not weighed
  /// A closed boundary that is shorter, with no background behind it, is dropped: a pinhole.
  double minHolePx = 0.0;
  /// That weighs 1 px a px. The lower it is, the more every stroke weighs; with 0 every strength
  /// above 0 weighs as much as can be.
  double unitStrength = 0.0;
};

/// The stretches of a chain whose strength stays at or above `hysteresis * threshold` and reaches
/// the threshold somewhere, as (from, to). On a closed chain `to` may exceed the length. Strength
/// is linear between the points.
std::vector<std::pair<double, double>> strongStretches(const ScreenChain& chain, double threshold,
                                                       double hysteresis);

/// The strokes of chain number `index`: its strong stretches, cut where visibility changes.
/// Stretches and cut strokes shorter than the filter's length are dropped; a closed contour
/// that is the whole outline of a part stays whatever its length. Raising the threshold never adds
/// a stroke or lengthens one.
std::vector<StrokePart> strokeParts(const SeenChain& chain, std::size_t index,
                                    const StrokeFilter& filter, double hysteresis);

/// The picture of a stroke, px, not simplified; the first point of a closed one is not repeated.
std::vector<Eigen::Vector2d> screenOf(const ScreenChain& line, const StrokePart& part);

/// A stroke as a polyline, simplified on the screen so that no point is farther than the tolerance
/// from it. Places become points of the mesh.
Polyline polylineOf(const SeenChain& chain, const StrokePart& part, const Projection& projection,
                    double tolerancePx);

/// Appends the pieces of a stroke, with nodes from `node` on, which is counted up.
void appendSegments(const ScreenChain& line, const StrokePart& part, std::uint64_t& node,
                    std::vector<LineSegment>& segments);

/// Indices of the points that Douglas and Peucker's simplification keeps, the first and the last
/// among them. On a closed line the first point and the one farthest from it are kept.
std::vector<std::size_t> simplified(std::span<const Eigen::Vector2d> screen, bool closed,
                                    double tolerancePx);

}  // namespace flatland
