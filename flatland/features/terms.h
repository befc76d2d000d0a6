// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flatland/curve/jet.h"
#include "flatland/view/view.h"

namespace flatland {

/// The flatland form of the apparent-ridge equation at one point (docs/math/features.md):
///   feature + offset + perspective = (n.w)^3 / 2 d(lambda)/du,
/// with feature = (n.w) k k', offset = -k^3 (t.w), perspective = -(n.w) k^2 (t.w) / rho, rho the
/// distance to the viewer (0 when orthographic). The thesis prints the sum with other signs (3.13).
struct Terms {
  double nw;                            ///< n.w, foreshortening; 0 at a silhouette
  double tw;                            ///< t.w
  double k, kPrime;                     ///< curvature and its derivative by arc length
  double feature, offset, perspective;  ///< 1/length^3
  std::optional<double> lambda;         ///< k^2 / nw^2; empty where nw = 0

  double sum() const { return feature + offset + perspective; }
};

/// Terms at a jet; `side` is that of normalSide(). At the viewer itself nw, tw and the terms are 0
/// and lambda is empty. Precondition: jet.d1 is not zero, and sizes lie between 1e-50 and 1e50.
Terms termsAt(const Jet& jet, const ViewFrame& frame, int side);

/// How far a mark's defining quantity is from zero, without dimension: its absolute value over the
/// sum of the absolute values of the products it is computed from, plus the quantity's natural size
/// on a curve of length `length`. Of the order of 1e-16 at a root known to its last bits.
/// Precondition: jet.d1 is not zero, length > 0.
struct Residuals {
  double silhouette;     ///< n.w
  double inflection;     ///< k
  double extremum;       ///< k'
  double apparentRidge;  ///< feature + offset + perspective
};
Residuals residualsAt(const Jet& jet, const ViewFrame& frame, double length);

}  // namespace flatland
