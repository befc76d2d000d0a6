// SPDX-License-Identifier: MIT
#include "flatland/features/terms.h"

#include <cmath>

namespace flatland {

Terms termsAt(const Jet& jet, const ViewFrame& frame, int side) {
  const Frame f = frameOf(jet, side);
  const Vec2 w = towardsViewer(frame, jet.p);
  Terms terms{};
  terms.nw = f.normal.dot(w);
  terms.tw = f.tangent.dot(w);
  terms.k = f.k;
  terms.kPrime = f.kPrime;
  terms.feature = terms.nw * f.k * f.kPrime;
  terms.offset = -f.k * f.k * f.k * terms.tw;
  terms.perspective = 0.0;
  if (frame.distance) {
    const double rho = (frame.eye() - jet.p).norm();
    // At the viewer itself there is no line of sight: all terms are 0, as nw and tw are.
    if (rho > 0.0) terms.perspective = -terms.nw * f.k * f.k * terms.tw / rho;
  }
  if (terms.nw != 0.0) terms.lambda = (f.k * f.k) / (terms.nw * terms.nw);
  return terms;
}

Residuals residualsAt(const Jet& jet, const ViewFrame& frame, double length) {
  const Terms terms = termsAt(jet, frame, 1);
  const double s2 = jet.d1.squaredNorm();
  const auto crossSize = [](const Vec2& a, const Vec2& b) {
    return std::abs(a.x() * b.y()) + std::abs(a.y() * b.x());
  };
  const auto dotSize = [](const Vec2& a, const Vec2& b) { return a.cwiseAbs().dot(b.cwiseAbs()); };
  const double kSize = crossSize(jet.d1, jet.d2) / (s2 * std::sqrt(s2)) + 1.0 / length;
  const double kPrimeSize =
      (crossSize(jet.d1, jet.d3) * s2 + 3.0 * crossSize(jet.d1, jet.d2) * dotSize(jet.d1, jet.d2)) /
          (s2 * s2 * s2) +
      1.0 / (length * length);
  const double sumSize =
      std::abs(terms.nw) * kSize * kPrimeSize + kSize * kSize * kSize + std::abs(terms.perspective);
  return {.silhouette = std::abs(terms.nw),
          .inflection = std::abs(terms.k) / kSize,
          .extremum = std::abs(terms.kPrime) / kPrimeSize,
          .apparentRidge = std::abs(terms.sum()) / sumSize};
}

}  // namespace flatland
