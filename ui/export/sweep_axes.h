// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "flatland/curve/vec2.h"

namespace flatland::ui {

/// The part of a sweep's diagram that is shown: angles in degrees, and the stacked arc length, in
/// which each curve starts where the one before ends.
struct SweepWindow {
  double angleLow = -180.0, angleHigh = 180.0;
  double uLow = 0.0, uHigh = 1.0;

  bool operator==(const SweepWindow&) const = default;
};

/// From view angle and arc length to the px of a diagram and back. Angles run to the right, arc
/// length upwards, the curves of a scene above each other.
class SweepAxes {
 public:
  /// The rectangle of the plot in the figure, px.
  struct Box {
    double left, top, right, bottom;
  };

  /// `window`: none for the whole diagram. Lengths of the curves in their order; all zero counts as
  /// 1 in all.
  SweepAxes(const std::vector<double>& lengths, const Box& box,
            const std::optional<SweepWindow>& window);

  const Box& box() const { return box_; }
  const SweepWindow& window() const { return window_; }
  double total() const { return total_; }
  int curveCount() const { return static_cast<int>(starts_.size()); }
  double start(int curve) const { return starts_[static_cast<std::size_t>(curve)]; }
  double length(int curve) const { return lengths_[static_cast<std::size_t>(curve)]; }

  double x(double angleDeg) const;
  double yOf(double stackedU) const;
  double y(int curve, double u) const { return yOf(start(curve) + u); }

  /// A place of the diagram.
  struct Place {
    double angleDeg;
    int curve;
    double u;
  };
  /// What is at a position; a position beside the plot counts as its edge. nullopt without curves.
  std::optional<Place> placeAt(const Vec2& px) const;
  double angleAt(double x) const;
  double stackedUAt(double y) const;

  /// The part of the segment a-b, given as (angle, stacked u), that lies in the window: the two
  /// ends as shares of the segment.
  struct Clip {
    double from, to;
  };
  std::optional<Clip> clipped(const Vec2& a, const Vec2& b) const;

 private:
  std::vector<double> lengths_, starts_;
  double total_ = 0.0;
  Box box_;
  SweepWindow window_;
};

}  // namespace flatland::ui
