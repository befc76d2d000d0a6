// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace flatland {

/// A real number known as an unevaluated sum hi + lo (about 106 bits) and a bound on what is
/// missing: |true value - (hi + lo)| <= error. Sums and products of numbers with error 0 whose
/// results fit in 106 bits keep error 0, so exact zeros stay recognisable.
///
/// Error-free transformations after Dekker 1971 and Knuth (bibliography: dekker1971); needs
/// round-to-nearest and no contraction of a * b + c (cmake/FlatlandTarget.cmake switches it off).
struct Bounded {
  double hi = 0.0;
  double lo = 0.0;
  double error = 0.0;

  constexpr Bounded() = default;
  constexpr Bounded(double value) : hi(value) {}  // NOLINT: a double is an exact number
  constexpr Bounded(double h, double l, double e) : hi(h), lo(l), error(e) {}

  double value() const { return hi + lo; }
  bool isExactZero() const { return hi == 0.0 && lo == 0.0 && error == 0.0; }

  /// +1 or -1 where the sign of the true value is certain, else 0 (also for an exact zero).
  int certainSign() const {
    if (std::abs(hi) * kSafe > error) return hi > 0.0 ? 1 : -1;
    return 0;
  }

 private:
  // |lo| <= 2^-53 |hi|, so the true value keeps the sign of hi if error < (1 - 2^-52) |hi|.
  static constexpr double kSafe = 1.0 - 0x1p-50;
};

namespace detail {

struct Pair {
  double high, low;
};

/// a + b exactly: high = fl(a + b), low the rounding error.
inline Pair twoSum(double a, double b) {
  const double s = a + b;
  const double bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// As twoSum, for |a| >= |b| or a = 0.
inline Pair quickTwoSum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a * b exactly, barring underflow.
inline Pair twoProduct(double a, double b) {
  const double p = a * b;
  return {p, std::fma(a, b, -p)};
}

// Bounds are computed in rounded arithmetic; one factor per operation covers their own rounding.
inline constexpr double kBoundSlack = 1.0 + 0x1p-48;
// Products below this may lose bits to underflow; the loss is below kUnderflow.
inline constexpr double kUnderflowRisk = 0x1p-960;
inline constexpr double kUnderflow = 0x1p-1000;

}  // namespace detail

inline Bounded operator-(const Bounded& a) { return {-a.hi, -a.lo, a.error}; }

inline Bounded operator+(const Bounded& a, const Bounded& b) {
  using namespace detail;
  const Pair s = twoSum(a.hi, b.hi);
  const Pair t = twoSum(a.lo, b.lo);
  const Pair u = twoSum(s.low, t.high);
  const Pair r = quickTwoSum(s.high, u.high);
  const Pair v = twoSum(r.low, u.low);
  const Pair w = twoSum(v.high, t.low);
  const Pair q = quickTwoSum(r.high, w.high);
  // What did not fit: the tails of the last two sums, known exactly.
  const double lost = std::abs(v.low) + std::abs(w.low);
  return {q.high, q.low, (a.error + b.error + lost) * kBoundSlack};
}

inline Bounded operator-(const Bounded& a, const Bounded& b) { return a + (-b); }

/// a * d, with error 0 if a has none and the result fits.
inline Bounded times(const Bounded& a, double d) {
  using namespace detail;
  if (a.isExactZero() || d == 0.0) return {};
  const Pair p = twoProduct(a.hi, d);
  double lost = a.error * std::abs(d);
  if (std::abs(p.high) < kUnderflowRisk) lost += kUnderflow;
  if (a.lo == 0.0) return {p.high, p.low, lost * kBoundSlack};
  const Pair q = twoProduct(a.lo, d);
  if (std::abs(q.high) < kUnderflowRisk) lost += kUnderflow;
  // |p.low| and |q.high| are below 2^-52 |p.high|; the sum keeps account of what does not fit.
  const Bounded sum = Bounded(p.high, p.low, lost) + Bounded(q.high, q.low, 0.0);
  return {sum.hi, sum.lo, sum.error * kBoundSlack};
}

inline Bounded operator*(const Bounded& a, const Bounded& b) {
  using namespace detail;
  if (b.lo == 0.0 && b.error == 0.0) return times(a, b.hi);
  if (a.lo == 0.0 && a.error == 0.0) return times(b, a.hi);
  if (a.isExactZero() || b.isExactZero()) return {};
  const Pair p = twoProduct(a.hi, b.hi);
  const double crossTerms = a.hi * b.lo + a.lo * b.hi;
  const Pair r = quickTwoSum(p.high, p.low + (crossTerms + a.lo * b.lo));
  // Rounding of the five small operations: each below 2^-53 times a term below 2^-52 |p|.
  double lost = a.error * (std::abs(b.hi) + b.error) * (1.0 + 0x1p-50) +
                b.error * std::abs(a.hi) * (1.0 + 0x1p-50) + std::abs(p.high) * 0x1p-102;
  if (std::abs(p.high) < kUnderflowRisk) lost += kUnderflow;
  return {r.high, r.low, lost * kBoundSlack};
}

/// Exact, barring underflow.
inline Bounded halved(const Bounded& a) { return {0.5 * a.hi, 0.5 * a.lo, 0.5 * a.error}; }

/// a / n for an integer n > 0 below 2^53.
inline Bounded dividedBy(const Bounded& a, double n) {
  using namespace detail;
  if (a.isExactZero()) return {};
  const double q1 = a.hi / n;
  const Pair p = twoProduct(q1, n);
  // Nothing is lost where the division comes out even.
  if (a.lo == 0.0 && p.high == a.hi && p.low == 0.0) return {q1, 0.0, a.error / n * kBoundSlack};
  const double rest = ((a.hi - p.high) - p.low) + a.lo;
  const double q2 = rest / n;
  const Pair r = quickTwoSum(q1, q2);
  // rest and q2 are rounded once each: below 2^-52 times a number below 2^-51 |q1|.
  double lost = a.error / n + std::abs(q1) * 0x1p-101;
  if (std::abs(q1) < kUnderflowRisk) lost += kUnderflow;
  return {r.high, r.low, lost * kBoundSlack};
}

}  // namespace flatland
