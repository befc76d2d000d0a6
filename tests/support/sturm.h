// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "tests/support/exact_polynomial.h"

namespace flatland::test {

/// Counts the real roots of a polynomial in intervals with double end points by Sturm's theorem, in
/// exact integers by subresultant remainders (bibliography: brown1971): no tolerance anywhere. The
/// polynomial must not be zero.
class Sturm {
 public:
  explicit Sturm(const ExactPolynomial& p);

  /// Distinct roots in (low, high], and in [low, high].
  int distinctHalfOpen(double low, double high) const;
  int distinct(double low, double high) const;

  /// Roots in [low, high], each as often as its multiplicity.
  int withMultiplicity(double low, double high) const;

 private:
  int variations(double t) const;

  std::vector<ExactPolynomial> chain_;  // of the square-free part
  std::unique_ptr<Sturm> repeated_;     // of gcd(p, p'), if it is not constant
};

}  // namespace flatland::test
