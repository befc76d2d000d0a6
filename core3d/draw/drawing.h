// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core3d/draw/camera.h"
#include "core3d/lines/feature_lines.h"
#include "core3d/lines/line_finder.h"

namespace flatland {

/// A stroke of a line drawing: a polyline of one family, as a whole visible or hidden.
struct Polyline {
  LineFamily family;
  std::uint32_t level = 0;  ///< of isophotes and topographic lines
  bool visible = true;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
  std::vector<Eigen::Vector3f> points;  ///< coordinates of the mesh (TriangleMesh), 2 or more
  std::vector<Eigen::Vector2d> screen;  ///< px, of each point
  std::vector<float> strength;          ///< dimensionless, of each point
};

/// How many px of a picture count as one px of StrokeOptions: 1 if its diagonal is 1000 px long, as
/// that of 800 x 600. So a drawing has the same strokes at every size of the picture.
inline double pictureScale(double width, double height) { return std::hypot(width, height) / 1e3; }

/// How segments become strokes. Px are those of a picture with a diagonal of 1000 px, and grow and
/// shrink with it (pictureScale); those of tolerancePx are the picture's own.
struct StrokeOptions {
  bool hidden = false;  ///< hidden strokes are kept (visible = false), else removed
  /// A stroke that reaches the family's threshold somewhere is followed down to this share of it.
  double hysteresis = 0.6;
  double minLengthPx = 6.0;  ///< shorter ones are dropped, but whole outlines of parts
  /// A stroke of a family with a threshold is dropped if its length, weighed by how many times the
  /// threshold its strength is (at most 3), is less: short strokes have to be strong. So is the rim
  /// of a hole that is shorter, unless there is background behind it.
  double minWeightPx = 30.0;
  double tolerancePx = 0.2;  ///< largest deviation on the screen from simplifying
  double smallestGapPx =
      3.0;  ///< visibility that changes for less than that along a stroke is smoothed over
  /// Where ridges, valleys and suggestive lines break off and go on in the same direction within so
  /// much, they are joined. 0: never.
  double largestGapPx = 6.0;
  /// Share of the picture's pixels to be covered with ink at `inkWidthPx`: one factor on the
  /// thresholds of all families with a threshold but creases is solved for. Empty: thresholds as
  /// given.
  std::optional<double> ink = {};
  double inkWidthPx = 1.5;
  std::stop_token stop = {};
};

struct DrawingStats {
  std::size_t segments = 0;  ///< before filtering
  double vertexMs = 0.0, segmentMs = 0.0, chainMs = 0.0, visibilityMs = 0.0, strokeMs = 0.0;
  std::size_t rays = 0;          ///< cast for visibility
  double ink = 0.0;              ///< share of the pixels covered by the visible strokes
  double thresholdFactor = 1.0;  ///< found for StrokeOptions::ink
  /// False if no factor comes within 1 % of StrokeOptions::ink: the lines that have no threshold
  /// cover more, all lines together cover less, or single strokes are too long to get closer.
  bool inkReached = true;
  /// Part of the visible length that lies in strokes longer than 2 % of the picture's diagonal;
  /// the rest is crumbs. 1 for an empty drawing.
  double share = 1.0;
};

struct Drawing {
  /// By family, then by level, then by place on the mesh. If exterior silhouettes are on, what is
  /// one is not repeated among contours and boundaries.
  std::vector<Polyline> polylines;
  Projection projection;
  /// Of each family, the strength that counts as weak: the threshold that was used; if ink made it
  /// less, the geometric mean of it and the given one, at least 0.3 of that. 0 for families without
  /// a threshold.
  std::array<double, kLineFamilyCount> weak{};
  DrawingStats stats;
};

}  // namespace flatland
