// SPDX-License-Identifier: MIT
#pragma once

#include "flatland/curve/bezier_chain.h"

namespace flatland {

/// An approximate length and what is known of it.
struct ArcLength {
  double value;          ///< length
  double errorEstimate;  ///< estimated absolute error, length
  bool converged;        ///< errorEstimate <= the accuracy asked for
};

/// Arc length of the curve over [t0, t1] (negative if t1 < t0) to the absolute `accuracy`
/// (length > 0). Adaptive Gauss-Kronrod quadrature, panels halved until they agree with their
/// halves; cusps cost more panels but converge. An accuracy below about 1e-14 of the control
/// polygon cannot be reached and is reported so.
ArcLength arcLength(const Bezier& curve, double t0, double t1, double accuracy);
ArcLength arcLength(const BezierChain& chain, double t0, double t1, double accuracy);

}  // namespace flatland
