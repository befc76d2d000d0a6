// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/exact_polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatland::test {

namespace {

// value = mantissa 2^-exponent with an odd mantissa (0 has exponent 0).
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};

Dyadic dyadic(double value) {
  if (value == 0.0) return {0, 0};
  int power = 0;
  const double fraction = std::frexp(value, &power);
  auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  int exponent = 53 - power;
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    --exponent;
  }
  return {mantissa, exponent};
}

}  // namespace

ExactPolynomial::ExactPolynomial(std::vector<Integer> coefficients) : a_(std::move(coefficients)) {
  trim();
}

void ExactPolynomial::trim() {
  while (!a_.empty() && a_.back().is_zero()) a_.pop_back();
}

int ExactPolynomial::shiftFor(const std::vector<double>& values) {
  int shift = std::numeric_limits<int>::min();
  for (const double v : values) {
    if (v != 0.0) shift = std::max(shift, dyadic(v).exponent);
  }
  return shift == std::numeric_limits<int>::min() ? 0 : shift;
}

ExactPolynomial ExactPolynomial::fromBernstein(const std::vector<double>& coefficients) {
  return fromBernstein(coefficients, shiftFor(coefficients));
}

ExactPolynomial ExactPolynomial::fromBernstein(const std::vector<double>& coefficients, int shift) {
  // Differences of order k times binom(n, k) are the power coefficients.
  std::vector<Integer> difference;
  for (const double c : coefficients) {
    const Dyadic d = dyadic(c);
    Integer value(d.mantissa);
    if (!value.is_zero()) value <<= shift - d.exponent;
    difference.push_back(value);
  }
  const std::size_t n = coefficients.size() - 1;
  std::vector<Integer> powers;
  Integer binomial = 1;
  for (std::size_t k = 0; k <= n; ++k) {
    powers.push_back(binomial * difference[0]);
    for (std::size_t i = 0; i + k < n; ++i) difference[i] = difference[i + 1] - difference[i];
    binomial = binomial * static_cast<long>(n - k) / static_cast<long>(k + 1);
  }
  return ExactPolynomial(std::move(powers));
}

Integer ExactPolynomial::scaledAt(double t, int& exponent) const {
  exponent = 0;
  if (a_.empty()) return 0;
  Dyadic d = dyadic(t);
  if (d.exponent < 0) {  // an even integer t
    d.mantissa <<= -d.exponent;
    d.exponent = 0;
  }
  Integer sum = a_.back();
  for (std::size_t i = a_.size() - 1; i-- > 0;) {
    exponent += d.exponent;
    sum = sum * d.mantissa + (a_[i] << exponent);
  }
  return sum;
}

int ExactPolynomial::signAt(double t) const {
  int exponent = 0;
  return scaledAt(t, exponent).sign();
}

int ExactPolynomial::signAbove(double t) const {
  for (ExactPolynomial p = *this; !p.isZero(); p = p.derivative()) {
    if (const int sign = p.signAt(t)) return sign;
  }
  return 0;
}

int ExactPolynomial::signBelow(double t) const {
  int flip = 1;
  for (ExactPolynomial p = *this; !p.isZero(); p = p.derivative(), flip = -flip) {
    if (const int sign = p.signAt(t)) return flip * sign;
  }
  return 0;
}

double ExactPolynomial::log2AbsAt(double t) const {
  int exponent = 0;
  const Integer value = abs(scaledAt(t, exponent));
  if (value.is_zero()) return -std::numeric_limits<double>::infinity();
  return static_cast<double>(msb(value)) - exponent;
}

ExactPolynomial ExactPolynomial::derivative() const {
  std::vector<Integer> d;
  for (std::size_t i = 1; i < a_.size(); ++i) d.push_back(a_[i] * static_cast<long>(i));
  return ExactPolynomial(std::move(d));
}

ExactPolynomial operator+(const ExactPolynomial& p, const ExactPolynomial& q) {
  std::vector<Integer> sum(std::max(p.a_.size(), q.a_.size()));
  for (std::size_t i = 0; i < p.a_.size(); ++i) sum[i] += p.a_[i];
  for (std::size_t i = 0; i < q.a_.size(); ++i) sum[i] += q.a_[i];
  return ExactPolynomial(std::move(sum));
}

ExactPolynomial operator-(const ExactPolynomial& p, const ExactPolynomial& q) {
  return p + Integer(-1) * q;
}

ExactPolynomial operator*(const ExactPolynomial& p, const ExactPolynomial& q) {
  if (p.isZero() || q.isZero()) return {};
  std::vector<Integer> product(p.a_.size() + q.a_.size() - 1);
  for (std::size_t i = 0; i < p.a_.size(); ++i) {
    for (std::size_t j = 0; j < q.a_.size(); ++j) product[i + j] += p.a_[i] * q.a_[j];
  }
  return ExactPolynomial(std::move(product));
}

ExactPolynomial operator*(const Integer& factor, const ExactPolynomial& p) {
  std::vector<Integer> a = p.a_;
  for (Integer& c : a) c *= factor;
  return ExactPolynomial(std::move(a));
}

}  // namespace flatland::test
