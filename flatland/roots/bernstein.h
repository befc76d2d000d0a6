// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "flatland/roots/double_double.h"

namespace flatland {

/// A polynomial on [0, 1] in Bernstein form: p(t) = sum_i c_i binom(n, i) t^i (1 - t)^(n - i),
/// c in order of i, n the degree. Each coefficient carries a bound on its error, so the object
/// stands for every polynomial within the bounds: what it says of signs holds for the exact one.
/// Products have the exact degree; rounding is about 2^-100 relative to the terms summed, and none
/// while the numbers fit in 106 bits.
///
/// Kept in scaled form, s_i = c_i binom(n, i), in which products are convolutions and nothing is
/// ever divided (Farouki and Rajan 1988; bibliography: farouki1988). A plain value; an empty one is
/// not a polynomial.
class Bernstein {
 public:
  Bernstein() = default;
  explicit Bernstein(const std::vector<Bounded>& coefficients);
  static Bernstein fromScaled(std::vector<Bounded> scaled);

  /// Coefficients taken as exact.
  static Bernstein fromDoubles(const std::vector<double>& coefficients);

  int degree() const { return static_cast<int>(s_.size()) - 1; }

  /// c_i binom(n, i). The first and last are the values p(0) and p(1).
  const std::vector<Bounded>& scaled() const { return s_; }
  const Bounded& first() const { return s_.front(); }
  const Bounded& last() const { return s_.back(); }

  /// The c_i; divided, so good to 2^-100 only.
  std::vector<Bounded> coefficients() const;

  /// The c_i times one positive integer that makes the division exact (up to degree 41; beyond,
  /// they are divided): same signs and roots as p, and exact if p is.
  std::vector<Bounded> proportionalCoefficients() const;

  /// True if every coefficient is within its error of zero: the polynomial cannot be told from 0.
  bool isZero() const;

  /// p(t), t in [0, 1] taken as exact. Horner-like, O(degree).
  Bounded at(double t) const;

  /// The polynomials s -> p(t s) and s -> p(t + (1 - t) s), by de Casteljau, O(degree^2).
  std::pair<Bernstein, Bernstein> split(double t) const;

  /// s -> p(1 - s)
  Bernstein reversed() const;

  /// p(t) / t^m and p(t) / (1 - t)^m, exactly. Precondition: the first (last) m coefficients are
  /// zero; they are dropped whatever their value.
  Bernstein dividedByT(int m) const;
  Bernstein dividedByOneMinusT(int m) const;

 private:
  std::vector<Bounded> s_;
};

/// De Casteljau on plain coefficients c_i: those of the two parts at t. The last of the first
/// equals the first of the second. No rounding at t = 1/2 while the numbers fit.
std::pair<std::vector<Bounded>, std::vector<Bounded>> splitCoefficients(
    const std::vector<Bounded>& coefficients, double t);

/// p and q of any degrees; the lower one is elevated.
Bernstein operator+(const Bernstein& p, const Bernstein& q);
Bernstein operator-(const Bernstein& p, const Bernstein& q);
Bernstein operator-(const Bernstein& p);
/// Degree p + degree q.
Bernstein operator*(const Bernstein& p, const Bernstein& q);
Bernstein operator*(const Bounded& factor, const Bernstein& p);

/// dp/dt, of one degree less; the zero polynomial of degree 0 for a constant.
Bernstein derivative(const Bernstein& p);

/// n (p' q - p q') for p and q of one degree n, of the exact degree 2 n - 2 (the zero polynomial
/// for n = 0). The factor n keeps it free of division.
Bernstein degreeTimesWronskian(const Bernstein& p, const Bernstein& q);

/// Precondition: degree >= p.degree().
Bernstein elevatedTo(const Bernstein& p, int degree);

}  // namespace flatland
