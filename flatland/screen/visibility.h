// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "flatland/scene/scene.h"

namespace flatland {

/// Answers whether points of the scene's curves can be seen. Curves are cut where their image on
/// the screen folds, so each part meets a line of sight at most once.
/// Build once per scene and view; queries are const and thread safe.
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
  /// what the 1D drawing shows. Found at the first call and kept. Where curves cross each other
  /// twice within 1/16 of the stretch between two folds, both crossings may be missed.
  struct Interval {
    double tLow, tHigh;
  };
  const std::vector<Interval>& visibleIntervals(int curve) const;

 private:
  std::vector<Interval> findVisibleIntervals(int curve) const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace flatland
