// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flatland/roots/bernstein.h"

namespace flatland {

/// A root in [0, 1]: at low = high, or else in the open interval (low, high), whose ends may be
/// other, exact roots. For a crossing low and high are adjacent doubles, equal, or as near as the
/// coefficients' error allows.
struct Root {
  double t;          ///< best double
  double low, high;  ///< certified bracket
  int signBefore;    ///< sign of p just below the root: +1, -1; 0 for a root at t = 0
  int signAfter;     ///< sign of p just above; 0 for a root at t = 1
  /// Exact multiplicity; 1 for a simple root certified by Descartes' rule. 0: a cluster, certified
  /// to change sign (an odd number of roots, at least one) but too tight to count.
  int multiplicity;

  bool isCrossing() const { return signBefore != signAfter && signBefore * signAfter != 0; }
};

/// An interval whose roots could not be counted: either none or an even number (a double root, two
/// very near ones, or a near miss); at an end of [0, 1] whose value cannot be told from 0, any
/// number.
struct RootInterval {
  double low, high;
};

/// All roots of a polynomial in [0, 1].
struct Roots {
  bool identicallyZero = false;          ///< p cannot be told from 0; the lists are then empty
  std::vector<Root> roots;               ///< ascending, disjoint brackets
  std::vector<RootInterval> unresolved;  ///< ascending, disjoint from the roots

  bool resolved() const { return unresolved.empty() && !identicallyZero; }
};

/// Isolates by sign variations of the Bernstein coefficients (Descartes' rule) under subdivision
/// and refines to adjacent doubles. Every sign used is certain: exceeds the error bound. So for any
/// polynomial within the bounds: each root listed with multiplicity > 0 exists and is the only
/// one in its bracket, and every root in [0, 1] is listed or lies in an unresolved interval.
///
/// Stated answers. A root at 0 or 1 is listed if the end coefficient is exactly zero, with its
/// multiplicity. An interior multiple root is listed exactly if it falls on a bisection point and
/// the arithmetic there is exact (symmetric curves), else as a cluster (odd) or an unresolved
/// interval (even). Widths: 2^-48, or about 2^(-100/m) for a root of multiplicity m. Terminates on
/// any input. Cost: a few subdivisions, O(degree^2) each, per root.
Roots isolateRoots(const Bernstein& p);

}  // namespace flatland
