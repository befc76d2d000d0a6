// SPDX-License-Identifier: MIT
#include "flatland/study/bifurcation.h"

#include <cmath>

namespace flatland {

std::optional<Bifurcation> bifurcationOf(const FamilyCurve& curve) {
  if (curve.family != Family::Id::Ellipse) return std::nullopt;
  // With s = sin t, c = cos t: lambda = b^2 / ((a^2 s^2 + b^2 c^2)^2 s^2), so at the tip, where
  // c = 0, log lambda = constant + (1 - 2 (b^2 - a^2) / a^2) c^2 + ..., a maximum if 2 b^2 > 3 a^2.
  constexpr std::size_t kAcross = 0, kAlong = 1;
  return Bifurcation{kAlong, curve.parameters[kAcross] * std::sqrt(1.5)};
}

}  // namespace flatland
