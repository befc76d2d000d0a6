// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "flatland/curve/vec2.h"

namespace flatland::ui {

/// The positions nearest to `wanted` (least squares) that keep its order and are at least `gap`
/// apart. Precondition: wanted ascends, gap >= 0. Cost: linear.
std::vector<double> spreadApart(const std::vector<double>& wanted, double gap);

/// Finds room for small labels beside the things they name. Lengths in px, boxes by half their
/// sides.
class LabelPlacer {
 public:
  /// A box that a label must not cover: another label or a symbol.
  void block(const Vec2& centre, const Vec2& half);

  /// True if a label there would cover no box.
  bool isFree(const Vec2& centre, const Vec2& half) const;

  /// Something a label had better not cover, as a dense row of points; less is better.
  void discourage(const Vec2& point);

  /// The centre for a label of half size `half` that names `anchor`: the best of three rings of
  /// directions around it, those near the unit vector `preferred` first. The place is blocked then.
  /// Where there is no free one, the least bad is returned; in a crowd of thousands around it, the
  /// preferred one. Cost: what is near, not how much there is.
  Vec2 place(const Vec2& anchor, const Vec2& half, const Vec2& preferred);

  /// The same, but nullopt, and nothing blocked, where the label would cover a box however it is
  /// put.
  std::optional<Vec2> placeFree(const Vec2& anchor, const Vec2& half, const Vec2& preferred);

 private:
  struct Box {
    Vec2 centre, half;
  };
  struct Best {
    Vec2 centre;
    bool free;  ///< covers no box
  };
  Best bestFor(const Vec2& anchor, const Vec2& half, const Vec2& preferred) const;

  /// What has its centre in one square of the figure.
  struct Cell {
    std::vector<Box> boxes;
    std::vector<Vec2> points;
  };
  static std::pair<int, int> cellOf(const Vec2& point);

  std::map<std::pair<int, int>, Cell> cells_;
  Vec2 largestHalf_ = Vec2::Zero();  // of the boxes
};

}  // namespace flatland::ui
