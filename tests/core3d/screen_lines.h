// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core3d/draw/strokes.h"

namespace flatland::test {

// 1 unit is 1 px, the origin at the picture's middle.
inline Projection flatProjection() {
  Projection projection;
  projection.axes = Eigen::Matrix3d::Identity();
  projection.width = 800.0;
  projection.height = 600.0;
  return projection;
}

// A straight chain along x from 0, or the outline of a square of that side.
inline ScreenChain straight(std::vector<float> strength, double step = 1.0) {
  LineChain chain;
  chain.family = LineFamily::ApparentRidges;
  for (std::size_t i = 0; i < strength.size(); ++i) {
    chain.points.emplace_back(static_cast<float>(step * static_cast<double>(i)), 0.0f, 0.0f);
  }
  chain.triangles.assign(strength.size() - 1, 0);
  chain.strength = std::move(strength);
  return onScreen(chain, flatProjection()).front();
}

inline ScreenChain ring(std::vector<float> strength, double radius = 50.0) {
  LineChain chain;
  chain.family = LineFamily::ApparentRidges;
  chain.closed = true;
  const std::size_t n = strength.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    chain.points.push_back((radius * Eigen::Vector3d(std::cos(a), std::sin(a), 0.0)).cast<float>());
  }
  chain.triangles.assign(n, 0);
  chain.strength = std::move(strength);
  return onScreen(chain, flatProjection()).front();
}

// Visible but between the given places.
inline std::vector<Stretch> seenBut(const ScreenChain& chain,
                                    std::vector<std::pair<double, double>> gaps,
                                    double smallestGapPx) {
  return stretchesOf(chain, smallestGapPx, [&](const ScreenChain::Point& p) {
    const double x = p.at.x();
    for (const auto& [from, to] : gaps) {
      if (x >= from && x < to) return Seen::Hidden;
    }
    return Seen::Visible;
  });
}

// From a polygon with these corners.
inline double distanceTo(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& line,
                         bool closed) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    const Eigen::Vector2d a = line[i], d = line[(i + 1) % line.size()] - a;
    const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-30), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * d).norm());
  }
  return nearest;
}

}  // namespace flatland::test
