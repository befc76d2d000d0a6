// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/label_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace flatland::ui {

std::vector<double> spreadApart(const std::vector<double>& wanted, double gap) {
  // Without its place in the row (i gap), "at least gap apart" is "not descending": isotonic
  // regression, by pooling neighbours that are out of order into blocks at their mean.
  struct Block {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Block block{wanted[i] - gap * static_cast<double>(i), 1};
    while (!blocks.empty() && blocks.back().mean() >= block.mean()) {
      block.sum += blocks.back().sum;
      block.count += blocks.back().count;
      blocks.pop_back();
    }
    blocks.push_back(block);
  }
  std::vector<double> placed;
  placed.reserve(wanted.size());
  for (const Block& block : blocks) {
    for (std::size_t i = 0; i < block.count; ++i) {
      placed.push_back(block.mean() + gap * static_cast<double>(placed.size()));
    }
  }
  return placed;
}

std::pair<int, int> LabelPlacer::cellOf(const Vec2& point) {
  static constexpr double kCellPx = 32.0;
  static constexpr double kFar = 1e6;  // cells beyond are one: an int holds it
  const auto index = [](double x) {
    return static_cast<int>(std::floor(std::clamp(x / kCellPx, -kFar, kFar)));
  };
  return {index(point.x()), index(point.y())};
}

void LabelPlacer::block(const Vec2& centre, const Vec2& half) {
  cells_[cellOf(centre)].boxes.push_back({centre, half});
  largestHalf_ = largestHalf_.cwiseMax(half);
}

bool LabelPlacer::isFree(const Vec2& centre, const Vec2& half) const {
  const Vec2 reach = half + largestHalf_;
  const auto low = cellOf(centre - reach), high = cellOf(centre + reach);
  for (int column = low.first; column <= high.first; ++column) {
    auto at = cells_.lower_bound({column, low.second});
    for (; at != cells_.end() && at->first <= std::pair(column, high.second); ++at) {
      for (const Box& box : at->second.boxes) {
        if (((half + box.half) - (centre - box.centre).cwiseAbs()).minCoeff() > 0.0) return false;
      }
    }
  }
  return true;
}

void LabelPlacer::discourage(const Vec2& point) { cells_[cellOf(point)].points.push_back(point); }

Vec2 LabelPlacer::place(const Vec2& anchor, const Vec2& half, const Vec2& preferred) {
  const Best best = bestFor(anchor, half, preferred);
  block(best.centre, half);
  return best.centre;
}

std::optional<Vec2> LabelPlacer::placeFree(const Vec2& anchor, const Vec2& half,
                                           const Vec2& preferred) {
  const Best best = bestFor(anchor, half, preferred);
  if (!best.free) return std::nullopt;
  block(best.centre, half);
  return best.centre;
}

LabelPlacer::Best LabelPlacer::bestFor(const Vec2& anchor, const Vec2& half,
                                       const Vec2& preferred) const {
  constexpr std::array<double, 3> kRingsPx{14.0, 20.0, 27.0};
  constexpr int kDirections = 16;
  // Costs in px^2 of covered label: another label is worst, then the curve, then a long way off.
  constexpr double kPointCost = 4.0;
  constexpr double kRingCost = 12.0;
  constexpr double kTurnCost = 3.0;
  constexpr std::size_t kCrowd = 2000;  // things nearby; then every place is as bad as the others

  // Only what is near can be covered.
  const double reach = kRingsPx.back() + half.norm();
  const Vec2 boxReach = Vec2::Constant(kRingsPx.back()) + half + largestHalf_;
  const Vec2 searched = boxReach.cwiseMax(Vec2::Constant(reach));
  const auto low = cellOf(anchor - searched), high = cellOf(anchor + searched);
  std::vector<Box> nearBoxes;
  std::vector<Vec2> nearPoints;
  for (int column = low.first; column <= high.first; ++column) {
    auto at = cells_.lower_bound({column, low.second});
    for (; at != cells_.end() && at->first <= std::pair(column, high.second); ++at) {
      std::copy_if(at->second.boxes.begin(), at->second.boxes.end(), std::back_inserter(nearBoxes),
                   [&](const Box& box) {
                     return ((box.centre - anchor).cwiseAbs() - boxReach).maxCoeff() < 0.0;
                   });
      std::copy_if(at->second.points.begin(), at->second.points.end(),
                   std::back_inserter(nearPoints),
                   [&](const Vec2& p) { return (p - anchor).squaredNorm() < reach * reach; });
    }
    if (nearBoxes.size() + nearPoints.size() > kCrowd) {
      return {anchor + kRingsPx.front() * preferred, false};
    }
  }

  Best best{anchor + kRingsPx.front() * preferred, false};
  double bestCost = std::numeric_limits<double>::infinity();
  for (std::size_t ring = 0; ring < kRingsPx.size(); ++ring) {
    for (int direction = 0; direction < kDirections; ++direction) {
      // 0, 1, -1, 2, -2, ... steps from the preferred direction.
      const int steps = (direction + 1) / 2 * (direction % 2 == 0 ? -1 : 1);
      const double angle = 2.0 * std::numbers::pi * steps / kDirections;
      const Vec2 unit = std::cos(angle) * preferred + std::sin(angle) * rotateCcw(preferred);
      const Vec2 centre = anchor + kRingsPx[ring] * unit;
      double cost = kRingCost * static_cast<double>(ring) + kTurnCost * std::abs(angle);
      bool free = true;
      for (const Box& box : nearBoxes) {
        const Vec2 overlap = (half + box.half) - (centre - box.centre).cwiseAbs();
        if (!(overlap.minCoeff() > 0.0)) continue;
        cost += 10.0 + overlap.prod();
        free = false;
      }
      for (const Vec2& p : nearPoints) {
        if (((p - centre).cwiseAbs() - half).maxCoeff() < 0.0) cost += kPointCost;
      }
      if (cost < bestCost) {
        bestCost = cost;
        best = {centre, free};
      }
    }
  }
  return best;
}

}  // namespace flatland::ui
