// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace flatland {

/// A picture in which strokes count the pixels that they cover: those whose middle lies within half
/// the pen's width of a stroke. Pixels that several strokes cover count once.
class InkRaster {
 public:
  /// Sizes in px, rounded up; at least one pixel.
  InkRaster(double width, double height);

  /// A stroke with round ends; what lies outside the picture is cut off. Cost: its area.
  void add(std::span<const Eigen::Vector2d> screen, bool closed, double widthPx);

  /// Of the pixel that a place lies in; false outside the picture.
  bool isCovered(const Eigen::Vector2d& place) const;
  /// True inside the picture.
  bool holds(const Eigen::Vector2d& place) const;
  std::size_t covered() const { return covered_; }
  /// Share of the pixels covered, in [0, 1].
  double share() const;
  void clear();

 private:
  void addPiece(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius);

  std::ptrdiff_t columns_, rows_;
  std::vector<bool> ink_;
  std::size_t covered_ = 0;
};

}  // namespace flatland
