// SPDX-License-Identifier: MIT
#include "flatland/curve/cubic_cuts.h"

#include <algorithm>

namespace flatland {

namespace {

constexpr int kMostHalvings = 16;

// With so many, what is left is only halved the least number of times.
constexpr std::size_t kMostStretches = 5000;

struct End {
  double t;
  Jet jet;
};

Bezier hermite(const End& low, const End& high) {
  const double third = (high.t - low.t) / 3.0;
  return {
      {low.jet.p, low.jet.p + third * low.jet.d1, high.jet.p - third * high.jet.d1, high.jet.p}};
}

void halve(const JetOnPiece& jet, int piece, const End& low, const End& high, int depth,
           int leastHalvings, double tolerance, std::vector<CubicStretch>& to) {
  const Bezier cubic = hermite(low, high);
  bool close = depth >= leastHalvings;
  if (close && depth < leastHalvings + kMostHalvings && to.size() < kMostStretches) {
    // Not evenly spread, so that a wave of the curve does not meet the cubic at all of them.
    for (const double s : {0.5, 0.23, 0.79, 0.11, 0.92}) {
      const double t = low.t + s * (high.t - low.t);
      close = close && (jet(piece, t).p - pointAt(cubic, s)).norm() <= tolerance;
      if (!close) break;
    }
  }
  if (close) {
    to.push_back({piece + low.t, piece + high.t, cubic});
    return;
  }
  const double t = 0.5 * (low.t + high.t);
  const End middle{t, jet(piece, t)};
  halve(jet, piece, low, middle, depth + 1, leastHalvings, tolerance, to);
  halve(jet, piece, middle, high, depth + 1, leastHalvings, tolerance, to);
}

}  // namespace

void appendCubics(const JetOnPiece& jet, int piece, double tLow, double tHigh, int leastHalvings,
                  double tolerance, std::vector<CubicStretch>& to) {
  halve(jet, piece, {tLow, jet(piece, tLow)}, {tHigh, jet(piece, tHigh)}, 0, leastHalvings,
        tolerance, to);
}

std::vector<double> cubicCuts(const JetOnPiece& jet, int pieceCount, int leastHalvings,
                              double tolerance) {
  std::vector<CubicStretch> stretches;
  for (int piece = 0; piece < pieceCount; ++piece) {
    appendCubics(jet, piece, 0.0, 1.0, leastHalvings, tolerance, stretches);
  }
  std::vector<double> cuts{0.0};
  for (const CubicStretch& stretch : stretches) cuts.push_back(stretch.tHigh);
  return cuts;
}

}  // namespace flatland
