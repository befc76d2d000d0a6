// SPDX-License-Identifier: GPL-3.0-or-later
// Every operation on Bernstein polynomials against exact rationals: the truth is always within the
// stated error, and the error is always small.
#include "flatland/roots/bernstein.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Rational = boost::multiprecision::number<boost::multiprecision::cpp_rational::backend_type,
                                               boost::multiprecision::et_off>;
using RationalPolynomial = std::vector<Rational>;  // Bernstein coefficients

Rational choose(int n, int k) {
  Rational c = 1;
  for (int i = 0; i < k; ++i) c = c * (n - i) / (i + 1);
  return c;
}

RationalPolynomial exact(const std::vector<double>& c) { return {c.begin(), c.end()}; }

RationalPolynomial elevatedTo(RationalPolynomial p, int degree) {
  while (static_cast<int>(p.size()) - 1 < degree) {
    const int n = static_cast<int>(p.size());
    RationalPolynomial q(p.size() + 1);
    for (int i = 0; i <= n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (i > 0) q[at] += Rational(i) / n * p[at - 1];
      if (i < n) q[at] += Rational(n - i) / n * p[at];
    }
    p = q;
  }
  return p;
}

RationalPolynomial product(const RationalPolynomial& p, const RationalPolynomial& q) {
  const int m = static_cast<int>(p.size()) - 1, n = static_cast<int>(q.size()) - 1;
  RationalPolynomial r(p.size() + q.size() - 1);
  for (int i = 0; i <= m; ++i) {
    for (int j = 0; j <= n; ++j) {
      r[static_cast<std::size_t>(i + j)] += choose(m, i) * choose(n, j) / choose(m + n, i + j) *
                                            p[static_cast<std::size_t>(i)] *
                                            q[static_cast<std::size_t>(j)];
    }
  }
  return r;
}

RationalPolynomial sum(RationalPolynomial p, RationalPolynomial q, int sign) {
  const int degree = static_cast<int>(std::max(p.size(), q.size())) - 1;
  p = elevatedTo(p, degree), q = elevatedTo(q, degree);
  for (std::size_t i = 0; i < p.size(); ++i) p[i] += sign * q[i];
  return p;
}

RationalPolynomial derivative(const RationalPolynomial& p) {
  if (p.size() == 1) return {Rational(0)};
  RationalPolynomial d;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    d.push_back((p[i + 1] - p[i]) * static_cast<int>(p.size() - 1));
  return d;
}

// [left, right] of the de Casteljau triangle.
std::pair<RationalPolynomial, RationalPolynomial> split(RationalPolynomial p, const Rational& t) {
  RationalPolynomial left, right;
  while (!p.empty()) {
    left.push_back(p.front());
    right.insert(right.begin(), p.back());
    for (std::size_t i = 0; i + 1 < p.size(); ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
    p.pop_back();
  }
  return {left, right};
}

// Relative to the terms summed, the error of a whole chain of operations of degree up to about 40.
constexpr double kSmall = 0x1p-90;
// Products of numbers near the end of the range of double may lose this much, absolutely.
constexpr double kUnderflowFloor = 0x1p-990;

void expectWithin(const Bounded& got, const Rational& truth, double size, const char* what) {
  const Rational value = Rational(got.hi) + Rational(got.lo);
  EXPECT_LE(abs(truth - value), Rational(got.error))
      << what << ": " << got.hi << " + " << got.lo << " +- " << got.error << ", truth "
      << truth.convert_to<double>();
  EXPECT_LE(got.error, kSmall * size + kUnderflowFloor) << what;
  if (const int sign = got.certainSign()) {
    EXPECT_EQ(sign, truth.sign()) << what;
  }
}

void expectWithin(const Bernstein& got, const RationalPolynomial& truth, double size,
                  const char* what) {
  ASSERT_EQ(got.degree() + 1, static_cast<int>(truth.size())) << what;
  const std::vector<Bounded> plain = got.coefficients();
  for (int i = 0; i <= got.degree(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    expectWithin(plain[at], truth[at], size, what);
    // In the scaled form nothing has been divided.
    const Rational scale = choose(got.degree(), i);
    expectWithin(got.scaled()[at], scale * truth[at], scale.convert_to<double>() * size, what);
  }
  // The proportional ones are the same up to one positive factor.
  const std::vector<Bounded> multiple = got.proportionalCoefficients();
  ASSERT_EQ(multiple.size(), plain.size());
  Rational factor = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    if (multiple[i].error == 0.0 && !truth[i].is_zero()) {
      const Rational ratio = (Rational(multiple[i].hi) + Rational(multiple[i].lo)) / truth[i];
      if (!factor.is_zero()) {
        EXPECT_EQ(ratio, factor) << what;
      }
      factor = ratio;
      EXPECT_GT(ratio, 0) << what;
    }
    if (const int sign = multiple[i].certainSign()) {
      EXPECT_EQ(sign, truth[i].sign()) << what;
    }
  }
}

double largest(const std::vector<double>& c) {
  double m = 0.0;
  for (const double x : c) m = std::max(m, std::abs(x));
  return m;
}

std::vector<double> randomCoefficients(Random& random, int degree, double scale) {
  std::vector<double> c(static_cast<std::size_t>(degree) + 1);
  const int kind = uniformInt(random, 0, 3);
  for (double& x : c) {
    x = kind == 0   ? uniformInt(random, -3, 3)
        : kind == 1 ? normal(random) * std::pow(10.0, uniform(random, -12, 12))
                    : normal(random);
    x *= scale;
  }
  return c;
}

TEST(Bernstein, EveryOperationHoldsTheExactResult) {
  Random random(announcedSeed("bernstein", 1912));
  for (int i = 0; i < 1200; ++i) {
    const double scale = i % 5 == 0 ? std::pow(10.0, uniform(random, -150, 100)) : 1.0;
    const int m = uniformInt(random, 0, 9), n = uniformInt(random, 0, 9);
    const std::vector<double> a = randomCoefficients(random, m, scale),
                              b = randomCoefficients(random, n, 1.0);
    const Bernstein p = Bernstein::fromDoubles(a), q = Bernstein::fromDoubles(b);
    const RationalPolynomial P = exact(a), Q = exact(b);
    const double A = largest(a), B = largest(b);
    expectWithin(p + q, sum(P, Q, 1), A + B, "sum");
    expectWithin(p - q, sum(P, Q, -1), A + B, "difference");
    expectWithin(-p, sum({Rational(0)}, P, -1), A, "negative");
    expectWithin(p * q, product(P, Q), A * B, "product");
    expectWithin(Bounded(b[0]) * p, product(P, {Rational(b[0])}), A * B, "multiple");
    expectWithin(derivative(p), derivative(P), 2 * std::max(m, 1) * A, "derivative");
    expectWithin(elevatedTo(p, m + 3), elevatedTo(P, m + 3), A, "elevation");
    const double t = i % 3 ? uniform(random, 0, 1) : uniformInt(random, 0, 16) / 16.0;
    const auto [left, right] = p.split(t);
    const auto [L, R] = split(P, Rational(t));
    expectWithin(left, L, A, "left half");
    expectWithin(right, R, A, "right half");
    expectWithin(p.at(t), L.back(), A, "value");
    RationalPolynomial backwards(P.rbegin(), P.rend());
    expectWithin(p.reversed(), backwards, A, "reversed");

    std::vector<double> c = randomCoefficients(random, m, 1.0);
    const double C = largest(c);
    const RationalPolynomial exactC = exact(c);
    const Bernstein w = degreeTimesWronskian(p, Bernstein::fromDoubles(c));
    // p' q - p q' with its two top power coefficients cancelled: compare after raising the degree.
    const RationalPolynomial truth = product(
        {Rational(m)}, sum(product(derivative(P), exactC), product(P, derivative(exactC)), -1));
    EXPECT_EQ(w.degree(), std::max(0, 2 * m - 2));
    RationalPolynomial wValue, wError;
    for (const Bounded& x : w.coefficients()) {
      wValue.push_back(Rational(x.hi) + Rational(x.lo));
      wError.push_back(Rational(x.error));
      EXPECT_LE(x.error, kSmall * 2 * m * m * m * A * C + kUnderflowFloor);
    }
    const int top = std::max<int>(w.degree(), static_cast<int>(truth.size()) - 1);
    wValue = elevatedTo(wValue, top), wError = elevatedTo(wError, top);
    const RationalPolynomial raised = elevatedTo(truth, top);
    for (std::size_t k = 0; k < raised.size(); ++k) {
      EXPECT_LE(abs(raised[k] - wValue[k]), wError[k]) << "wronskian";
    }

    // A chain of operations as in the apparent-ridge polynomial, with its accumulated error.
    if (m >= 1 && n >= 1) {
      // Small integers fit throughout, so no error at all may creep in.
      const Bernstein chain = derivative(p * q) * p - (p * q) * derivative(p);
      const RationalPolynomial PQ = product(P, Q);
      const RationalPolynomial exactChain =
          sum(product(derivative(PQ), P), product(PQ, derivative(P)), -1);
      expectWithin(chain, exactChain, 8.0 * (m + n) * A * A * B, "chain");
      const auto small = [](const std::vector<double>& x) {
        return std::all_of(x.begin(), x.end(),
                           [](double v) { return std::abs(v) < 4 && v == std::round(v); });
      };
      if (small(a) && small(b)) {
        for (const Bounded& x : chain.scaled()) EXPECT_EQ(x.error, 0.0);
      }
    }
  }
}

TEST(Bernstein, DivisionByPowersOfTIsThatOfThePolynomial) {
  Random random(announcedSeed("division", 2024));
  for (int i = 0; i < 300; ++i) {
    const int n = uniformInt(random, 1, 8), m = uniformInt(random, 0, std::min(n, 4));
    const std::vector<double> c = randomCoefficients(random, n, 1.0);
    RationalPolynomial tm{Rational(1)}, um{Rational(1)};
    for (int k = 0; k < m; ++k) {
      tm = product(tm, {Rational(0), Rational(1)});
      um = product(um, {Rational(1), Rational(0)});
    }
    std::vector<double> low = c, high = c;
    for (int k = 0; k < m; ++k) {
      low[static_cast<std::size_t>(k)] = 0.0;
      high[static_cast<std::size_t>(n - k)] = 0.0;
    }
    if (m > n) continue;
    const auto back = [&](const Bernstein& quotient, const RationalPolynomial& power,
                          const std::vector<double>& truth) {
      ASSERT_EQ(quotient.degree(), n - m);
      RationalPolynomial value, error;
      for (const Bounded& x : quotient.coefficients()) {
        value.push_back(Rational(x.hi) + Rational(x.lo));
        error.push_back(Rational(x.error));
        EXPECT_LE(x.error, kSmall * 100.0 * largest(truth) + kUnderflowFloor);
      }
      value = product(value, power), error = product(error, power);
      for (std::size_t k = 0; k < truth.size(); ++k) {
        EXPECT_LE(abs(value[k] - Rational(truth[k])), error[k]) << "m = " << m << ", n = " << n;
      }
    };
    back(Bernstein::fromDoubles(low).dividedByT(m), tm, low);
    back(Bernstein::fromDoubles(high).dividedByOneMinusT(m), um, high);
  }
}

TEST(Bernstein, ExactZerosStayExact) {
  const Bernstein p = Bernstein::fromDoubles({0, 3, -1}), zero = Bernstein::fromDoubles({0, 0});
  EXPECT_TRUE((p * zero).isZero());
  for (const Bounded& c : (p * zero).coefficients()) EXPECT_TRUE(c.isExactZero());
  for (const Bounded& c : (p - p).coefficients()) EXPECT_TRUE(c.isExactZero());
  for (const Bounded& c : degreeTimesWronskian(p, p).coefficients()) EXPECT_TRUE(c.isExactZero());
  EXPECT_TRUE((p * p).scaled()[0].isExactZero());
  EXPECT_TRUE((p * p).scaled()[1].isExactZero());
  EXPECT_FALSE((p * p).scaled()[2].isExactZero());
  // 0.1 + 0.2 - 0.3 is not zero in double, but is known exactly in two.
  const Bounded rest = Bounded(0.1) + Bounded(0.2) - Bounded(0.3);
  EXPECT_EQ(rest.error, 0.0);
  EXPECT_NE(rest.value(), 0.0);
  EXPECT_TRUE((rest - rest).isExactZero());
  EXPECT_FALSE(p.isZero());
  EXPECT_TRUE(zero.isZero());
  EXPECT_EQ(derivative(Bernstein::fromDoubles({5})).degree(), 0);
  EXPECT_TRUE(derivative(Bernstein::fromDoubles({5})).first().isExactZero());
}

TEST(Bounded, SignsAreClaimedOnlyWhenCertain) {
  EXPECT_EQ(Bounded(1.0, 0.0, 0.5).certainSign(), 1);
  EXPECT_EQ(Bounded(-1.0, 0.0, 0.5).certainSign(), -1);
  EXPECT_EQ(Bounded(1.0, 0.0, 1.0).certainSign(), 0);
  EXPECT_EQ(Bounded(1.0, -0x1p-53, 1.0 - 0x1p-53).certainSign(), 0);
  EXPECT_EQ(Bounded().certainSign(), 0);
}

}  // namespace
}  // namespace flatland::test
