// SPDX-License-Identifier: MIT
#include "flatland/screen/sweep_visibility.h"

#include <cmath>

#include "flatland/screen/visibility.h"

namespace flatland {

namespace {

constexpr int kDegrees = 360;

// The whole degrees stand a hair off the axes: exactly along an axis a scene of round
// numbers has its sights through joints and ends, where a touch counts as hiding.
constexpr double kOffAxisDeg = 1e-3;

}  // namespace

bool SweepVisibility::lineAt(std::size_t line, double angleDeg) const {
  const int degree = static_cast<int>(std::lround(angleDeg)) + kDegrees / 2;
  const int wrapped = ((degree % kDegrees) + kDegrees) % kDegrees;
  return lines[line][static_cast<std::size_t>(wrapped)];
}

SweepVisibility visibilityOf(const Sweep& sweep, Scene scene, const std::function<bool()>& goOn) {
  SweepVisibility result;
  const auto at = [&scene](double angleDeg) {
    scene.view = {normalizedDeg(angleDeg), std::nullopt};
    return Visibility(scene);
  };
  for (const SweepBranch& branch : sweep.branches) {
    std::vector<std::uint8_t>& seen = result.branches.emplace_back();
    for (const SweepPoint& point : branch.points) {
      if (goOn && !goOn()) return {};
      std::uint8_t bits = 0;
      if (at(point.angleDeg).isVisible(branch.curve, point.t)) bits |= 1;
      if (at(point.angleDeg + 180.0).isVisible(branch.curve, point.t)) bits |= 2;
      seen.push_back(bits);
    }
  }
  result.lines.assign(sweep.lines.size(), std::vector<bool>(kDegrees));
  if (sweep.lines.empty()) return result;
  for (int degree = 0; degree < kDegrees; ++degree) {
    if (goOn && !goOn()) return {};
    const Visibility visibility = at(degree - kDegrees / 2 + kOffAxisDeg);
    for (std::size_t i = 0; i < sweep.lines.size(); ++i) {
      result.lines[i][static_cast<std::size_t>(degree)] =
          visibility.isVisible(sweep.lines[i].curve, sweep.lines[i].t);
    }
  }
  return result;
}

}  // namespace flatland
