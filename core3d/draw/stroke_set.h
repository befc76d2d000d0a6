// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core3d/draw/drawing.h"
#include "core3d/draw/sight.h"
#include "core3d/draw/strokes.h"

namespace flatland {

/// The same picture with a diagonal of 1000 px, which the px of StrokeOptions are of.
Projection usualSize(Projection projection);

/// All that strokes may be made of: the lines of one view in chains, how they are seen, and what of
/// them is kept at a factor on the thresholds. composeDrawing and strokeLines make the same strokes
/// of it.
class StrokeSet {
 public:
  /// Chains the lines and joins what is torn. `found` is what linesToFind asks for, `projection` of
  /// the usual size. `lines` and `options` must outlive the set. No chains if stopped.
  StrokeSet(const FeatureLines& found, const Projection& projection, const LineOptions& lines,
            const StrokeOptions& options);

  /// Asks what is seen of each chain; how many rays that took.
  std::size_t look(const Sight& sight);
  /// Takes all of each chain for visible; contours for outlines if exterior silhouettes are on.
  void lookThrough();

  /// What is kept, for a factor on the thresholds of families that move with ink. After looking.
  std::vector<StrokePart> parts(double factor) const;

  const std::vector<SeenChain>& chains() const { return chains_; }
  std::size_t segmentCount() const { return segments_; }
  double threshold(LineFamily family) const;            ///< 0 if unfiltered
  double weak(LineFamily family, double factor) const;  ///< see Drawing::weak

  /// The family that a part is drawn as.
  static LineFamily familyOf(LineFamily family, Seen seen) {
    return seen == Seen::Outline ? LineFamily::ExteriorSilhouette : family;
  }

 private:
  double strokeThreshold(LineFamily family, double factor) const;
  bool isDrawn(LineFamily family, Seen seen) const;

  Projection projection_;
  const LineOptions& lines_;
  const StrokeOptions& options_;
  std::vector<SeenChain> chains_;
  std::size_t segments_ = 0;
};

}  // namespace flatland
