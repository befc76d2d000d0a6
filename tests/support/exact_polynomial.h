// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

namespace flatland::test {

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

/// A polynomial with integer coefficients, constant term first, without leading zeros; empty is 0.
/// Everything is exact.
class ExactPolynomial {
 public:
  ExactPolynomial() = default;
  explicit ExactPolynomial(std::vector<Integer> coefficients);

  /// 2^shift times the polynomial whose Bernstein coefficients on [0, 1] are the doubles, exactly;
  /// `shift` chosen as the smallest that makes all integer, or given (then large enough).
  static ExactPolynomial fromBernstein(const std::vector<double>& coefficients);
  static ExactPolynomial fromBernstein(const std::vector<double>& coefficients, int shift);
  /// The smallest shift that makes all the doubles integer (0 for an empty list).
  static int shiftFor(const std::vector<double>& values);

  bool isZero() const { return a_.empty(); }
  int degree() const { return static_cast<int>(a_.size()) - 1; }
  const Integer& operator[](int i) const { return a_[static_cast<std::size_t>(i)]; }
  const std::vector<Integer>& coefficients() const { return a_; }

  /// Sign at the double t, and just above and below it.
  int signAt(double t) const;
  int signAbove(double t) const;
  int signBelow(double t) const;

  /// log2 |p(t)|, to within 1; -infinity at a root.
  double log2AbsAt(double t) const;

  ExactPolynomial derivative() const;
  friend ExactPolynomial operator+(const ExactPolynomial& p, const ExactPolynomial& q);
  friend ExactPolynomial operator-(const ExactPolynomial& p, const ExactPolynomial& q);
  friend ExactPolynomial operator*(const ExactPolynomial& p, const ExactPolynomial& q);
  friend ExactPolynomial operator*(const Integer& factor, const ExactPolynomial& p);

 private:
  Integer scaledAt(double t, int& exponent) const;  // p(t) = result 2^-exponent
  void trim();

  std::vector<Integer> a_;
};

}  // namespace flatland::test
