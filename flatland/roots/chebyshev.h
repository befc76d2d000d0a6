// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "flatland/roots/isolate.h"

namespace flatland {

/// A value with the size of what it was computed from (the sum of the absolute values of its terms,
/// of any operands known only to their own rounding too): |value| <= size, and the rounding error
/// of value is a few 1e-16 of size.
struct Measured {
  double value;
  double size;
};

/// A function on [0, 1]. A value that is not finite counts as a place where the function is
/// unknown.
using MeasuredFunction = std::function<Measured(double)>;

/// One polynomial that stands for the function on [low, high].
struct ProxyPiece {
  double low, high;
  int degree;
  /// Estimated bound of |function - polynomial| over the largest size on the piece: the tail of the
  /// Chebyshev coefficients, at least rounding. An estimate, not a proof: a feature narrower than
  /// the sampling can escape it.
  double error;
};

/// Roots in [0, 1] found by polynomial proxies.
struct ProxyRoots {
  /// As of isolateRoots(), with "certain" meaning: beyond the error of the pieces.
  /// `identicallyZero` where no sampled value exceeds 1e-13 of its size.
  Roots roots;
  std::vector<ProxyPiece> pieces;  ///< ascending; they cover [0, 1]
  int evaluations = 0;             ///< of the function, all told

  /// The largest error of the pieces that decided anything (those inside unresolved intervals are
  /// left out: there the answer is "unknown").
  double errorBound() const;
};

/// What is known of the function's ends beforehand.
struct KnownEnds {
  bool zeroAtStart = false;  ///< vanishes at 0 by construction, to any order; rounding may hide it
  bool zeroAtFinish = false;
};

/// How much may be spent on one function (docs/decisions/0022-budgets.md).
struct ProxyBudget {
  /// Places spread over [0, 1] at which the proxies must agree with the function, whatever their
  /// pieces: what is narrower than the nodes of a piece but not than these is seen. A prime number.
  int probes = 503;
  /// Once the function has been asked so often, no piece is halved any more: what is open then is
  /// listed as unresolved. The pieces already begun are finished, so at most three times as many
  /// spent. A sine of 300 waves needs about half.
  int evaluations = 20000;
};

/// Roots of a function that is smooth but no polynomial: Chebyshev interpolants of degree up to 32
/// on pieces that are halved until the tail of their coefficients is at rounding (Boyd 2014;
/// bibliography: boyd2014), each read as a Bernstein polynomial with that error bound, whose roots
/// isolateRoots() counts; then closed in on with the function itself, to adjacent doubles where
/// rounding allows.
///
/// Completeness: any function within the errors of the pieces has the signs listed, and every root
/// lies in the bracket of a listed root or in an unresolved interval. Unresolved are places where
/// the function comes nearer to 0 than the error without crossing (double roots and near misses)
/// and what is left around a jump, a pole or a kink when pieces become narrower than 2^-40. An end
/// at which the value is within 1e-13 of its size of zero is a root at that end, with a
/// multiplicity counted in the same sense. What is left when the budget is spent is unresolved too;
/// the widest piece is halved first, so that it goes to no single place. Cost: the probes once, and
/// about 60 evaluations and 0.05 ms a piece; one piece for a function as calm as one wave.
/// Terminates on any input.
ProxyRoots proxyRoots(const MeasuredFunction& f, KnownEnds ends = {},
                      const ProxyBudget& budget = {});

/// The Chebyshev coefficients of the interpolant of f on [low, high] in the degree + 1 points of
/// the first kind, lowest first: p(x) = sum_j c_j T_j((2 x - low - high) / (high - low)).
std::vector<double> chebyshevCoefficients(const std::function<double(double)>& f, double low,
                                          double high, int degree);

/// The same polynomial in Bernstein form on [0, 1], every coefficient within `error`. Exact but for
/// that. Precondition: at least one coefficient, degree at most 32.
Bernstein bernsteinOf(const std::vector<double>& chebyshev, double error);

}  // namespace flatland
