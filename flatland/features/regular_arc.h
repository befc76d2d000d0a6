// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "flatland/curve/bezier.h"
#include "flatland/roots/bernstein.h"
#include "flatland/view/view.h"

namespace flatland {

/// A stretch of a Bezier piece on which the curve has a tangent everywhere: the derivative by the
/// local parameter s in [0, 1] is s^zerosAtStart (1 - s)^zerosAtEnd (dx, dy), with (dx, dy)
/// without common zeros. Pieces are cut at interior cusps, so a cusp is always an end.
/// Coordinates are scaled by a power of two (exactly) to keep products in range; signs and roots do
/// not depend on it.
struct RegularArc {
  double tLow, tHigh;  ///< the stretch in the piece's parameter
  Bernstein x, y;      ///< position
  Bernstein dx, dy;    ///< direction of the derivative, see above
  int zerosAtStart, zerosAtEnd;
  bool straight;  ///< on a line to within rounding of its control points (kStraightUlps)

  /// Unit tangent at s = 0 and s = 1, one-sided.
  Vec2 startDirection() const;
  Vec2 endDirection() const;
};

/// The regular arcs of a piece, in order; empty if all control points coincide. A point where the
/// derivative's zero cannot be told from a double (within 8 units in the last place) is a cusp.
/// A straight piece that turns back is cut where it does. `scale` multiplies all coordinates (a
/// power of two).
std::vector<RegularArc> regularArcs(const Bezier& piece, double scale);

/// The polynomials whose roots are the marks of an arc (docs/math/features.md), in s, and whose
/// signs are those of the quantity up to the factor given.
struct ArcPolynomials {
  Bernstein silhouette;      ///< sign of n.w for the left normal
  Bernstein curvature;       ///< sign of -k for the left normal
  Bernstein curvaturePrime;  ///< sign of -dk/du for the left normal
  Bernstein lambdaPrime;     ///< sign of dlambda/du * curvature * silhouette

  /// -k for the left normal at s = 0 and s = 1, one-sided, in scaled units; infinite at most cusps,
  /// empty where the sign of the infinity is undecided.
  std::optional<double> startCurvature, endCurvature;
};

/// `scale` is that of regularArcs(). A straight arc has silhouette only; the other
/// polynomials are zero.
ArcPolynomials polynomialsOf(const RegularArc& arc, const ViewFrame& frame, double scale);

/// Vanishes where an apparent ridge and a minimum of lambda meet in some orthographic view: sign of
/// k^4 + k k'' - k'^2, derivatives by arc length (docs/math/sweep.md). Where it is negative the
/// point is an apparent ridge, seen from its one stationary direction; where positive, a minimum.
/// Precondition: the arc is not straight.
Bernstein foldPolynomial(const RegularArc& arc);

/// Vanishes where (3.13) does as the thesis prints it, but for its factor k: sign of
/// -((n.w) k' + k^2 (t.w)) for the left normal, w from the point to the viewer. Precondition: the
/// arc is not straight.
Bernstein printedPolynomial(const RegularArc& arc, const ViewFrame& frame, double scale);

/// Screen slope polynomial only: what visibility needs.
Bernstein silhouettePolynomial(const Bezier& piece, const ViewFrame& frame, double scale);

/// Largest power of two that brings a length to at most 1; 1 for length 0.
double unitScale(double length);

}  // namespace flatland
