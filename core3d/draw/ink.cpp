// SPDX-License-Identifier: MIT
#include "core3d/draw/ink.h"

#include <algorithm>
#include <cmath>

namespace flatland {
namespace {

using Eigen::Vector2d;

std::ptrdiff_t pixels(double size) {
  return std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(std::ceil(size)));
}

// Cuts [low, high] to where |m x + c| <= r.
void cut(double m, double c, double r, double& low, double& high) {
  if (m == 0.0) {
    if (std::abs(c) > r) high = low - 1.0;
    return;
  }
  const double a = (-r - c) / m, b = (r - c) / m;
  low = std::max(low, std::min(a, b));
  high = std::min(high, std::max(a, b));
}

}  // namespace

InkRaster::InkRaster(double width, double height)
    : columns_(pixels(width)),
      rows_(pixels(height)),
      ink_(static_cast<std::size_t>(columns_ * rows_)) {}

double InkRaster::share() const {
  return static_cast<double>(covered_) / static_cast<double>(columns_ * rows_);
}

bool InkRaster::holds(const Vector2d& place) const {
  return place.x() >= 0.0 && place.x() < static_cast<double>(columns_) && place.y() >= 0.0 &&
         place.y() < static_cast<double>(rows_);
}

bool InkRaster::isCovered(const Vector2d& place) const {
  if (!holds(place)) return false;
  const auto column = static_cast<std::ptrdiff_t>(place.x());
  return ink_[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place.y()) * columns_ + column)];
}

void InkRaster::clear() {
  std::fill(ink_.begin(), ink_.end(), false);
  covered_ = 0;
}

void InkRaster::add(std::span<const Vector2d> screen, bool closed, double widthPx) {
  for (std::size_t i = 0; i + 1 < screen.size(); ++i) {
    addPiece(screen[i], screen[i + 1], widthPx / 2.0);
  }
  if (closed && screen.size() > 1) addPiece(screen.back(), screen.front(), widthPx / 2.0);
}

// Row by row: the middles within the radius of the piece form one interval, the hull of those in
// the two discs and of those in the band between.
void InkRaster::addPiece(const Vector2d& a, const Vector2d& b, double radius) {
  const Vector2d d = b - a;
  const double length = d.norm();
  const auto row = [this](double y) {
    return std::clamp<double>(y, 0.0, static_cast<double>(rows_));
  };
  const auto first = static_cast<std::ptrdiff_t>(row(std::floor(std::min(a.y(), b.y()) - radius)));
  const auto end = static_cast<std::ptrdiff_t>(row(std::ceil(std::max(a.y(), b.y()) + radius)));
  for (std::ptrdiff_t r = first; r < end; ++r) {
    const double y = static_cast<double>(r) + 0.5;
    double low = 1e300, high = -1e300;
    for (const Vector2d& end_ : {a, b}) {
      const double sq = radius * radius - (y - end_.y()) * (y - end_.y());
      if (sq < 0.0) continue;
      low = std::min(low, end_.x() - std::sqrt(sq));
      high = std::max(high, end_.x() + std::sqrt(sq));
    }
    if (length > 0.0) {
      const Vector2d t = d / length;
      double bandLow = std::min(a.x(), b.x()) - radius, bandHigh = std::max(a.x(), b.x()) + radius;
      // Across: |t x (p - a)| <= radius; along: |t . (p - middle)| <= length / 2.
      cut(-t.y(), t.x() * (y - a.y()) + t.y() * a.x(), radius, bandLow, bandHigh);
      const Vector2d m = (a + b) / 2.0;
      cut(t.x(), t.y() * (y - m.y()) - t.x() * m.x(), length / 2.0, bandLow, bandHigh);
      if (bandLow <= bandHigh) {
        low = std::min(low, bandLow);
        high = std::max(high, bandHigh);
      }
    }
    if (!(low <= high)) continue;
    const double last = static_cast<double>(columns_ - 1);
    const double from = std::max(std::ceil(low - 0.5), 0.0);
    const double to = std::min(std::floor(high - 0.5), last);
    for (double column = from; column <= to; column += 1.0) {
      const auto i = static_cast<std::size_t>(r * columns_ + static_cast<std::ptrdiff_t>(column));
      if (!ink_[i]) {
        ink_[i] = true;
        ++covered_;
      }
    }
  }
}

}  // namespace flatland
