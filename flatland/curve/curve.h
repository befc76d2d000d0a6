// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "flatland/curve/arc_length.h"
#include "flatland/curve/bezier_chain.h"
#include "flatland/curve/bspline.h"
#include "flatland/curve/cubic_cuts.h"
#include "flatland/curve/formula_curve.h"
#include "flatland/curve/rational_bezier.h"

namespace flatland {

/// A curve of any kind the program knows. What every kind offers are the functions below; what only
/// one kind offers is asked of that kind (std::get_if).
///
/// Parameter: t in [0, pieceCount]; between whole numbers a curve is smooth, at them (the joints)
/// its derivatives may jump.
using Curve = std::variant<BezierChain, BSpline, RationalBezier, FormulaCurve>;

int pieceCount(const Curve& curve);

/// True if the end of the last piece is the start of the first.
bool isClosed(const Curve& curve);

/// Piece and local parameter of t, clamped to the domain; a joint belongs to the piece it starts.
ChainParameter locate(const Curve& curve, double t);

/// The curve as polynomial Bezier pieces with the very same parameter, exact up to rounding: a
/// chain itself, or the form of a B-spline. nullptr for the other kinds. Lives as long as `curve`.
const BezierChain* bezierForm(const Curve& curve);

/// Position and derivatives by t to order 4 on one piece, t in [0, 1]: at its ends the one-sided
/// derivatives. Exact up to rounding. Precondition: 0 <= piece < pieceCount.
std::array<Vec2, 5> derivativesAt(const Curve& curve, int piece, double t);

/// Point and derivatives by t. A joint belongs to the piece it starts; t is clamped to the domain.
Jet jetAt(const Curve& curve, double t);

/// The same on one piece, as in derivativesAt.
Jet jetAt(const Curve& curve, int piece, double t);

Vec2 pointAt(const Curve& curve, double t);

/// See arc_length.h.
ArcLength arcLength(const Curve& curve, double t0, double t1, double accuracy);

/// The points a person can drag, in order; empty for a curve that is given by formulas.
const std::vector<Vec2>& controlPoints(const Curve& curve);

/// The degree of the pieces; 0 for a curve that is given by formulas.
int degreeOf(const Curve& curve);

/// True if both are of one kind with as many pieces and control points, so that what was known by
/// piece, parameter or index of a point still has a meaning.
bool sameTopology(const Curve& a, const Curve& b);

/// The curve moved as a whole.
Curve translated(const Curve& curve, const Vec2& delta);

/// Axis-aligned box.
struct Bounds {
  Vec2 low, high;
  Vec2 centre() const { return 0.5 * (low + high); }
  double diagonal() const { return (high - low).norm(); }
};

/// Box around the control points, or around a curve given by formulas (to 1/1000 of its size);
/// holds the curve.
Bounds boundsOf(const Curve& curve);

/// A length to judge others by: that of the control polygon, or of a curve given by formulas
/// roughly its own. 0 if the curve is a single point.
double lengthScale(const Curve& curve);

/// Twice the signed area enclosed, the open end closed by its chord: positive when walked
/// counter-clockwise. With a bezierForm exact up to rounding, else to about 1e-9 of the squared
/// size.
double twiceSignedArea(const Curve& curve);

/// Cubic pieces over [tLow, tHigh] (clamped) for drawing: each stays within `tolerance` (length)
/// of the curve, exactly the curve up to degree 3, else where compared (see cubic_cuts.h).
std::vector<CubicStretch> cubicsWithin(const Curve& curve, double tLow, double tHigh,
                                       double tolerance);

/// The whole curve as a cubic chain within `tolerance`; closed if the curve is.
BezierChain drawnAs(const Curve& curve, double tolerance);

/// Points along the curve in order, dense enough to see its extent: `perPiece` steps on each piece,
/// or an eighth of that between the cuts of a curve given by formulas.
std::vector<Vec2> sampledPoints(const Curve& curve, int perPiece);

/// See Nearest in bezier_chain.h. Certified with a bezierForm. Else a foot of the perpendicular
/// that is exact to rounding, but perhaps not the nearest: its distance is at most that to any of
/// the places sampled, which are 32 steps to a rational piece and 4 to each stretch between the
/// cuts of a formula (FormulaCurve::cuts). What is nearer by less than the curve strays from the
/// nearest sample can be missed.
Nearest nearestPoint(const Curve& curve, const Vec2& p);

/// For people: "Bezier chain", "B-spline", "rational Bezier", "ellipse", "formula".
std::string kindName(const Curve& curve);

}  // namespace flatland
