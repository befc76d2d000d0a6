// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "flatland/scene/scene.h"

namespace flatland {

/// Answers whether points of the scene's curves can be seen. Curves are cut where their image on
/// the screen folds, so each part meets a line of sight at most once, and found by their place on
/// the screen and their depth: a question costs about the logarithm of their number, where few of
/// them overlap in depth. Build once per scene and view; queries are const and thread safe.
class Visibility {
 public:
  explicit Visibility(const Scene& scene);
  ~Visibility();
  Visibility(Visibility&&) noexcept;
  Visibility& operator=(Visibility&&) noexcept;

  /// True if no curve lies strictly between the point at chain parameter t of `curve` and the
  /// viewer. False at and behind a viewer in perspective. Curves that only touch the line of sight
  /// at the end of a fold count as being in its way; nearer by less than 1e-9 of the scene's size
  /// counts as the same place.
  bool isVisible(int curve, double t) const;

  /// The parameter intervals of `curve` that are visible, in order, ends accurate to about 1e-9:
  /// what the 1D drawing shows. Found for all curves at the first call and kept: what is in front
  /// between the images of neighbouring folds and ends, asked at 16 places (fewer, but at least 4,
  /// beyond 125 folds and ends), or where there are only lines at the ends. Where two curves in
  /// front cross twice between such places, both crossings may be missed.
  struct Interval {
    double tLow, tHigh;
  };
  const std::vector<Interval>& visibleIntervals(int curve) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flatland
