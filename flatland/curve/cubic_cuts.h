// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "flatland/curve/bezier.h"

namespace flatland {

/// A jet on a piece, t in [0, 1].
using JetOnPiece = std::function<Jet(int piece, double t)>;

/// A stretch of a curve as a cubic that meets it and its derivative at both ends, walked at nearly
/// the same pace.
struct CubicStretch {
  double tLow, tHigh;  ///< curve parameters, piece index plus local parameter
  Bezier cubic;
};

/// Cubics over [tLow, tHigh] of one piece (local parameters), each within `tolerance` of the curve
/// where compared: at five places of matching parameter. Halved at least `leastHalvings` times, and
/// at most 16 times more, which the fourth order of the error makes plenty.
void appendCubics(const JetOnPiece& jet, int piece, double tLow, double tHigh, int leastHalvings,
                  double tolerance, std::vector<CubicStretch>& to);

/// The ends of such stretches over the whole curve, from 0 to pieceCount.
std::vector<double> cubicCuts(const JetOnPiece& jet, int pieceCount, int leastHalvings,
                              double tolerance);

}  // namespace flatland
