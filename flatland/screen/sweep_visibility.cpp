// SPDX-License-Identifier: MIT
#include "flatland/screen/sweep_visibility.h"

#include <cmath>

#include "flatland/screen/sight_rays.h"

namespace flatland {

namespace {

constexpr int kDegrees = 360;

// The whole degrees stand a hair off the axes: exactly along an axis a scene of round numbers has
// its sights through joints and ends, where a touch counts as hiding.
constexpr double kOffAxisDeg = 1e-3;

}  // namespace

bool SweepVisibility::lineAt(std::size_t line, double angleDeg) const {
  const int degree = static_cast<int>(std::lround(angleDeg)) + kDegrees / 2;
  const int wrapped = ((degree % kDegrees) + kDegrees) % kDegrees;
  return lines[line][static_cast<std::size_t>(wrapped)];
}

std::size_t SweepVisibility::raysFor(const Sweep& sweep) {
  std::size_t rays = kDegrees * sweep.lines.size();
  for (const SweepBranch& branch : sweep.branches) rays += 2 * branch.points.size();
  return rays;
}

SweepVisibility visibilityOf(const Sweep& sweep, const Scene& scene,
                             const std::function<bool()>& goOn) {
  SweepVisibility result;
  result.marked = SweepVisibility::raysFor(sweep) <= SweepVisibility::kMostRays;
  if (!result.marked) {
    for (const SweepBranch& branch : sweep.branches) {
      result.branches.emplace_back(branch.points.size(), std::uint8_t{3});
    }
    result.lines.assign(sweep.lines.size(), std::vector<bool>(kDegrees, true));
    return result;
  }
  const SightRays rays(scene);
  for (const SweepBranch& branch : sweep.branches) {
    std::vector<std::uint8_t>& seen = result.branches.emplace_back();
    for (const SweepPoint& point : branch.points) {
      if (goOn && !goOn()) return {};
      std::uint8_t bits = 0;
      const double angleDeg = normalizedDeg(point.angleDeg);
      if (rays.isVisible(branch.curve, point.t, angleDeg)) bits |= 1;
      if (rays.isVisible(branch.curve, point.t, normalizedDeg(angleDeg + 180.0))) bits |= 2;
      seen.push_back(bits);
    }
  }
  for (const SweepLine& line : sweep.lines) {
    if (goOn && !goOn()) return {};
    std::vector<bool>& seen = result.lines.emplace_back();
    for (int degree = 0; degree < kDegrees; ++degree) {
      seen.push_back(rays.isVisible(line.curve, line.t, degree - kDegrees / 2 + kOffAxisDeg));
    }
  }
  return result;
}

}  // namespace flatland
