// SPDX-License-Identifier: GPL-3.0-or-later
// The proxies against functions with known roots, against the eigenvalues of the colleague matrix
// (another way from coefficients to roots) and against the exact isolation of polynomials.
#include "flatland/roots/chebyshev.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "flatland/curve/roots_along.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

// Adjacent doubles around the root, and the rounding of the functions here.
constexpr double kLastBits = 4e-16;

MeasuredFunction measured(std::function<double(double)> f, double size) {
  return [f = std::move(f), size](double s) { return Measured{f(s), size}; };
}

// Where the last coefficient stands just above rounding: a smaller one would drown the matrix.
constexpr int kColleagueDegree = 24;

// Rows and columns of like size, by powers of two (Parlett and Reinsch 1969): without it a small
// last coefficient drowns the eigenvalues.
template <class Matrix>
void balance(Matrix& m) {
  for (int sweep = 0; sweep < 40; ++sweep) {
    for (Eigen::Index i = 0; i < m.rows(); ++i) {
      const double row = m.row(i).norm(), column = m.col(i).norm();
      if (!(row > 0.0 && column > 0.0)) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      m.row(i) /= factor;
      m.col(i) *= factor;
    }
  }
}

// Real roots in [-1, 1] as eigenvalues of the colleague matrix (Good 1961).
std::vector<double> colleagueRoots(const std::vector<double>& c) {
  using Colleague = Eigen::Matrix<double, kColleagueDegree, kColleagueDegree>;
  constexpr Eigen::Index n = kColleagueDegree;
  Colleague m = Colleague::Zero();
  m(0, 1) = 1.0;
  for (Eigen::Index i = 1; i < n; ++i) {
    m(i, i - 1) = 0.5;
    if (i + 1 < n) m(i, i + 1) = 0.5;
  }
  const double last = c.back() != 0.0 ? c.back() : 1e-17;
  for (Eigen::Index j = 0; j < n; ++j) {
    m(n - 1, j) -= 0.5 * c[static_cast<std::size_t>(j)] / last;
  }
  balance(m);
  std::vector<double> roots;
  for (const std::complex<double>& z : Eigen::EigenSolver<Colleague>(m, false).eigenvalues()) {
    if (std::abs(z.imag()) < 1e-7 && std::abs(z.real()) <= 1.0) roots.push_back(z.real());
  }
  std::sort(roots.begin(), roots.end());
  return roots;
}

TEST(Chebyshev, CoefficientsOfAChebyshevPolynomialAreAUnitVector) {
  for (const int j : {0, 1, 5, 16}) {
    const auto c =
        chebyshevCoefficients([j](double x) { return std::cos(j * std::acos(x)); }, -1.0, 1.0, 16);
    for (int i = 0; i <= 16; ++i) {
      EXPECT_NEAR(c[static_cast<std::size_t>(i)], i == j ? 1.0 : 0.0, 1e-14) << i << " of T_" << j;
    }
  }
}

TEST(Chebyshev, BernsteinFormIsTheSamePolynomial) {
  Random random(announcedSeed("BernsteinForm", 41));
  for (const int degree : {1, 3, 8, 20, 32}) {
    std::vector<double> c;
    for (int j = 0; j <= degree; ++j) c.push_back(normal(random));
    const Bernstein p = bernsteinOf(c, 1e-9);
    for (int i = 0; i <= 40; ++i) {
      const double s = i / 40.0;
      double value = 0.0;
      for (int j = 0; j <= degree; ++j) {
        value += c[static_cast<std::size_t>(j)] * std::cos(j * std::acos(2 * s - 1));
      }
      const Bounded at = p.at(s);
      EXPECT_NEAR(at.value(), value, 1e-12) << degree;
      EXPECT_NEAR(at.error, 1e-9, 1e-11) << degree;
    }
  }
}

// The error of the interpolant of 1 / (1 + 4 x^2) falls like rho^-n, rho = (1 + sqrt 5) / 2 from
// the poles at +-i/2.
TEST(Chebyshev, InterpolantConvergesAtTheRateOfTheNearestPole) {
  const auto f = [](double x) { return 1.0 / (1.0 + 4.0 * x * x); };
  const auto worst = [&](int degree) {
    const Bernstein p = bernsteinOf(chebyshevCoefficients(f, -1.0, 1.0, degree), 0.0);
    double most = 0.0;
    for (int i = 0; i <= 1000; ++i) {
      most = std::max(most, std::abs(p.at(i / 1000.0).value() - f(2 * (i / 1000.0) - 1)));
    }
    return most;
  };
  const double rate = std::pow(worst(8) / worst(32), 1.0 / 24.0);
  EXPECT_NEAR(rate, 0.5 * (1.0 + std::sqrt(5.0)), 0.02);
}

TEST(Chebyshev, RootsOfAWaveAreAllFoundToTheLastBits) {
  const ProxyRoots found =
      proxyRoots(measured([](double s) { return std::sin(20 * kPi * s - 1.0); }, 1.0));
  EXPECT_TRUE(found.roots.resolved());
  ASSERT_EQ(found.roots.roots.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    const Root& root = found.roots.roots[i];
    EXPECT_NEAR(root.t, (static_cast<double>(i) * kPi + 1.0) / (20 * kPi), kLastBits);
    EXPECT_EQ(root.signBefore, i % 2 == 0 ? -1 : 1);
    EXPECT_EQ(root.signAfter, -root.signBefore);
    EXPECT_EQ(root.multiplicity, 1);
    EXPECT_LE(root.high - root.low, 2e-16);
  }
  EXPECT_LT(found.errorBound(), 1e-13);
  double to = 0.0;
  for (const ProxyPiece& piece : found.pieces) {  // they cover [0, 1]
    EXPECT_EQ(piece.low, to);
    EXPECT_LE(piece.degree, 32);
    to = piece.high;
  }
  EXPECT_EQ(to, 1.0);
}

TEST(Chebyshev, RootsAtTheEndsAreCountedWithTheirMultiplicity) {
  const ProxyRoots found = proxyRoots(measured(
      [](double s) { return std::pow(s, 3) * std::pow(1 - s, 2) * std::cos(2.5 * s); }, 1.0));
  ASSERT_EQ(found.roots.roots.size(), 3u);
  EXPECT_TRUE(found.roots.resolved());
  EXPECT_EQ(found.roots.roots[0].t, 0.0);
  EXPECT_EQ(found.roots.roots[0].multiplicity, 3);
  EXPECT_EQ(found.roots.roots[0].signAfter, 1);
  EXPECT_NEAR(found.roots.roots[1].t, kPi / 5, kLastBits);
  EXPECT_EQ(found.roots.roots[2].t, 1.0);
  EXPECT_EQ(found.roots.roots[2].multiplicity, 2);
  EXPECT_EQ(found.roots.roots[2].signBefore, -1);
}

TEST(Chebyshev, RoundedZeroAtAnEndIsARoot) {
  // sin(pi) is 1.2e-16 in double.
  const ProxyRoots found = proxyRoots(measured([](double s) { return std::sin(kPi * s); }, 1.0));
  ASSERT_EQ(found.roots.roots.size(), 2u);
  EXPECT_EQ(found.roots.roots[0].t, 0.0);
  EXPECT_EQ(found.roots.roots[1].t, 1.0);
  EXPECT_TRUE(found.roots.resolved());
}

TEST(Chebyshev, SmallRootsBesideLargeValuesAreFound) {
  // exp(-x^2 / 2) sin x on [-9, 9]: 1e-18 of the middle at the ends. The size shrinks with it.
  const auto f = [](double s) {
    const double x = 18 * s - 9, g = std::exp(-x * x / 2);
    return Measured{g * std::sin(x), g};
  };
  const ProxyRoots found = proxyRoots(f);
  EXPECT_TRUE(found.roots.resolved());
  ASSERT_EQ(found.roots.roots.size(), 5u);
  for (int i = -2; i <= 2; ++i) {
    EXPECT_NEAR(18 * found.roots.roots[static_cast<std::size_t>(i + 2)].t - 9, i * kPi, 4e-15);
  }
}

TEST(Chebyshev, PairOfRootsIsResolvedUntilItIsAnOpenQuestion) {
  const auto pair = [](double gap) {
    return proxyRoots(measured([gap](double s) { return std::cosh(s - 0.37) - 1.0 - gap; }, 1.0));
  };
  EXPECT_EQ(pair(1e-10).roots.roots.size(), 2u);
  EXPECT_TRUE(pair(1e-10).roots.resolved());
  for (const double gap : {0.0, 1e-17}) {
    const ProxyRoots touching = pair(gap);
    EXPECT_TRUE(touching.roots.roots.empty());
    ASSERT_EQ(touching.roots.unresolved.size(), 1u);
    EXPECT_LT(touching.roots.unresolved[0].low, 0.37);
    EXPECT_GT(touching.roots.unresolved[0].high, 0.37);
    EXPECT_LT(touching.roots.unresolved[0].high - touching.roots.unresolved[0].low, 1e-5);
  }
  EXPECT_TRUE(pair(-1e-10).roots.roots.empty());
  EXPECT_TRUE(pair(-1e-10).roots.resolved());
}

TEST(Chebyshev, DoubleRootInTheMiddleIsOneOpenQuestion) {
  const ProxyRoots found =
      proxyRoots(measured([](double s) { return 1.0 - std::sin(kPi * s); }, 1.0));
  EXPECT_TRUE(found.roots.roots.empty());
  ASSERT_EQ(found.roots.unresolved.size(), 1u);
  EXPECT_LT(std::abs(found.roots.unresolved[0].low - 0.5), 1e-5);
}

TEST(Chebyshev, KinksJumpsAndPolesAreConfinedOrSaid) {
  // A kink away from zero costs pieces, no answer.
  const ProxyRoots kink =
      proxyRoots(measured([](double s) { return std::abs(s - 0.3) + 0.2 - 0.5 * s; }, 1.0));
  EXPECT_TRUE(kink.roots.resolved());
  EXPECT_TRUE(kink.roots.roots.empty());
  // A jump across zero is a place that cannot be decided, or a change of sign at the jump.
  const ProxyRoots jump = proxyRoots(measured([](double s) { return s < 0.3 ? -1.0 : 1.0; }, 1.0));
  ASSERT_EQ(jump.roots.unresolved.size() + jump.roots.roots.size(), 1u);
  const double at = jump.roots.roots.empty() ? jump.roots.unresolved[0].low : jump.roots.roots[0].t;
  EXPECT_NEAR(at, 0.3, 1e-9);
  // Unknown beyond 0.6, and an exact root before.
  const ProxyRoots unknown = proxyRoots(measured(
      [](double s) {
        return s < 0.6 ? std::exp(s) - 1.5 : std::numeric_limits<double>::quiet_NaN();
      },
      2.0));
  ASSERT_EQ(unknown.roots.roots.size(), 1u);
  EXPECT_NEAR(unknown.roots.roots[0].t, std::log(1.5), kLastBits);
  ASSERT_FALSE(unknown.roots.unresolved.empty());
  // How near it comes to the border of what is unknown is a matter of the budget: half of the
  // evaluations go into the unknown side, where no halving helps.
  EXPECT_LE(unknown.roots.unresolved.front().low, 0.6);
  EXPECT_GT(unknown.roots.unresolved.front().low, 0.599);
  EXPECT_EQ(unknown.roots.unresolved.back().high, 1.0);
}

TEST(Chebyshev, RoundingNoiseIsTheZeroFunction) {
  Random random(7);
  EXPECT_TRUE(proxyRoots(measured([&](double) { return 1e-15 * normal(random); }, 1.0))
                  .roots.identicallyZero);
  EXPECT_FALSE(proxyRoots(measured([](double) { return 1e-9; }, 1.0)).roots.identicallyZero);
}

TEST(Chebyshev, NoisyFunctionIsResolvedToItsNoise) {
  Random random(8);
  const ProxyRoots found =
      proxyRoots(measured([&](double s) { return std::cos(7 * s) + 1e-12 * normal(random); }, 1.0));
  EXPECT_TRUE(found.roots.resolved());
  ASSERT_EQ(found.roots.roots.size(), 2u);
  EXPECT_NEAR(found.roots.roots[0].t, kPi / 14, 1e-11);
  EXPECT_NEAR(found.roots.roots[1].t, 3 * kPi / 14, 1e-11);
  EXPECT_GT(found.errorBound(), 1e-13);  // and says so
  EXPECT_LT(found.pieces.size(), 40u);
}

TEST(Chebyshev, AgreesWithTheColleagueMatrix) {
  Random random(announcedSeed("Colleague", 42));
  int compared = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<double> a;
    for (int i = 0; i < 5; ++i) a.push_back(uniform(random, 1.0, 5.0));
    const double shift = uniform(random, -1.0, 1.0);
    const auto f = [&](double x) {
      return std::sin(a[0] * x + a[1]) + std::cos(a[2] * x) * std::exp(0.1 * a[3] * x) + shift;
    };
    const auto eigen = colleagueRoots(chebyshevCoefficients(f, -1.0, 1.0, kColleagueDegree));
    const ProxyRoots found = proxyRoots(measured([&](double s) { return f(2 * s - 1); }, 4.0));
    if (!found.roots.resolved()) continue;
    ++compared;
    ASSERT_EQ(found.roots.roots.size(), eigen.size()) << round;
    for (std::size_t i = 0; i < eigen.size(); ++i) {
      EXPECT_NEAR(2 * found.roots.roots[i].t - 1, eigen[i], 1e-8) << round;
    }
  }
  EXPECT_GE(compared, 299);
}

TEST(RootsAlong, AnyFunctionOfTheDerivatives) {
  // Where the unit circle's tangent has slope 1: at 135 and 315 degrees.
  const Curve circle = *FormulaCurve::make(FamilyCurve{Family::Id::Circle, {1.0}}).curve;
  const auto found = rootsAlong(circle, [](const std::array<Vec2, 5>& d) {
    return Measured{d[1].x() - d[1].y(), d[1].norm()};
  });
  ASSERT_EQ(found.size(), 1u);
  ASSERT_EQ(found[0].roots.roots.size(), 2u);
  EXPECT_NEAR(found[0].roots.roots[0].t, 0.375, kLastBits);
  EXPECT_NEAR(found[0].roots.roots[1].t, 0.875, kLastBits);
}

TEST(Chebyshev, AgreesWithExactIsolationOfPolynomials) {
  Random random(announcedSeed("Polynomials", 43));
  for (int round = 0; round < 300; ++round) {
    std::vector<double> c;
    const int degree = uniformInt(random, 1, 12);
    for (int i = 0; i <= degree; ++i) c.push_back(normal(random));
    const Bernstein p = Bernstein::fromDoubles(c);
    const Roots exact = isolateRoots(p);
    const ProxyRoots found = proxyRoots([&](double s) { return Measured{p.at(s).value(), 3.0}; });
    ASSERT_TRUE(found.roots.resolved()) << round;
    ASSERT_EQ(found.roots.roots.size(), exact.roots.size()) << round;
    for (std::size_t i = 0; i < exact.roots.size(); ++i) {
      EXPECT_NEAR(found.roots.roots[i].t, exact.roots[i].t, 1e-15) << round;
      EXPECT_EQ(found.roots.roots[i].signBefore, exact.roots[i].signBefore);
    }
  }
}

}  // namespace
}  // namespace flatland::test
