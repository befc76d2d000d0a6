// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor arithmetic where functions end, turn or have no derivative. Inside their domains it is
// held against 50 digits in formulas_test.cpp.
#include "flatland/curve/taylor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace flatland {
namespace {

using Series = Taylor<4>;
constexpr double kPi = std::numbers::pi;

void expectSeries(const Series& found, std::array<double, 5> derivatives, double tolerance = 0.0) {
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(found.derivative(k), derivatives[static_cast<std::size_t>(k)], tolerance) << k;
  }
}

TEST(Taylor, CoefficientsAreDerivativesOverFactorials) {
  Series t = Series::variable(3.0, 2.0);
  expectSeries(t, {3.0, 2.0, 0.0, 0.0, 0.0});
  expectSeries(t * t * t, {27.0, 54.0, 72.0, 48.0, 0.0});  // (3 + 2 x)^3
  expectSeries(t - 2.0 * t, {-3.0, -2.0, 0.0, 0.0, 0.0});
  EXPECT_FALSE(t.isConstant());
  t.c = {3.0, 0.0, 0.0, 0.0, 1.0};
  EXPECT_FALSE(t.isConstant());
  EXPECT_TRUE(Series(3.0).isConstant());
  t.c[4] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(t.isFinite());
}

TEST(Taylor, ConstantsAtTheEdgeOfADomainAreConstants) {
  for (const Series& edge : {sqrt(Series(0.0)), asin(Series(1.0)), acos(Series(-1.0)),
                             acosh(Series(1.0)), pow(Series(0.0), 0.5), pow(Series(0.0), 0.0)}) {
    EXPECT_TRUE(edge.isFinite() && edge.isConstant());
  }
  EXPECT_EQ(acos(Series(-1.0)).value(), kPi);
  EXPECT_EQ(pow(Series(0.0), 0.0).value(), 1.0);
}

TEST(Taylor, OutsideADomainNothingIsFinite) {
  EXPECT_FALSE(std::isfinite(sqrt(Series(-1.0)).value()));
  EXPECT_FALSE(std::isfinite(log(Series(0.0)).value()));
  EXPECT_FALSE(std::isfinite(pow(Series(-2.0), 0.5).value()));
  EXPECT_FALSE(sqrt(Series::variable(0.0)).isFinite());
  EXPECT_FALSE(atan2(Series::variable(0.0), Series(0.0)).isFinite());
}

TEST(Taylor, PowersAtZeroAndBelow) {
  expectSeries(pow(Series::variable(0.0), 3.0), {0.0, 0.0, 0.0, 6.0, 0.0});
  expectSeries(pow(Series::variable(-2.0), 2.0), {4.0, -4.0, 2.0, 0.0, 0.0});
  expectSeries(pow(Series::variable(-2.0), -1.0), {-0.5, -0.25, -0.25, -0.375, -0.75}, 1e-15);
  // Below the exponent the derivatives are 0, above there are none.
  const Series root = pow(Series::variable(0.0), 2.5);
  for (int k = 0; k <= 2; ++k) EXPECT_EQ(root.derivative(k), 0.0) << k;
  for (int k = 3; k <= 4; ++k) EXPECT_EQ(root.derivative(k), HUGE_VAL) << k;
  // A whole exponent beyond squaring: (1 + x)^2000 = 1 + 2000 x + 1999000 x^2 + ...
  const Series large = pow(Series::variable(1.0), 2000.0);
  EXPECT_EQ(large.c[1], 2000.0);
  EXPECT_NEAR(large.c[2], 1999000.0, 1e-6);
  // The value is that of the library, which squaring misses.
  EXPECT_EQ(pow(Series(1.1), 37.0).value(), std::pow(1.1, 37.0));
}

TEST(Taylor, AbsoluteValueTurnsToTheRight) {
  EXPECT_EQ(abs(Series::variable(0.0)).derivative(1), 1.0);
  EXPECT_EQ(abs(-Series::variable(0.0)).derivative(1), 1.0);
  const Series t = Series::variable(0.0);
  EXPECT_EQ(abs(-(t * t)).derivative(2), 2.0);
  EXPECT_EQ(abs(Series::variable(-2.0)).derivative(1), -1.0);
  EXPECT_EQ(abs(Series(0.0)).value(), 0.0);
}

TEST(Taylor, TurnsAreExactAtQuarters) {
  // d/dt of sin(2 pi t) and cos(2 pi t) at multiples of a quarter, from two turns below.
  for (int quarter = -8; quarter <= 8; ++quarter) {
    Series s, c;
    sinCosOfTurns(Series::variable(0.25 * quarter), s, c);
    const int at = ((quarter % 4) + 4) % 4;
    const double sine = at == 1 ? 1.0 : at == 3 ? -1.0 : 0.0;
    const double cosine = at == 0 ? 1.0 : at == 2 ? -1.0 : 0.0;
    EXPECT_EQ(s.value(), sine) << quarter;
    EXPECT_EQ(c.value(), cosine) << quarter;
    EXPECT_EQ(s.derivative(1), 2.0 * kPi * cosine) << quarter;
    EXPECT_EQ(c.derivative(1), -2.0 * kPi * sine) << quarter;
    EXPECT_NEAR(s.derivative(2), -4.0 * kPi * kPi * sine, 1e-13) << quarter;
  }
  for (const double turns : {-1.9, -0.6, -0.37, 0.1, 0.13, 0.4, 0.62, 0.874, 0.876, 3.2}) {
    Series s, c;
    sinCosOfTurns(Series::variable(turns), s, c);
    EXPECT_NEAR(s.value(), std::sin(2.0 * kPi * turns), 1e-14) << turns;
    EXPECT_NEAR(c.value(), std::cos(2.0 * kPi * turns), 1e-14) << turns;
    EXPECT_NEAR(c.derivative(1), -2.0 * kPi * s.value(), 1e-13) << turns;
  }
}

// The angle grows by 1 a unit all the way around, and jumps nowhere in its derivatives.
TEST(Taylor, AnglesInEveryQuadrant) {
  for (const double angle : {-3.0, -2.0, -1.0, -0.1, 0.0, 0.7, 1.6, 2.5, 3.1}) {
    const Series t = Series::variable(angle);
    expectSeries(atan2(3.0 * sin(t), 3.0 * cos(t)), {angle, 1.0, 0.0, 0.0, 0.0}, 1e-13);
  }
}

// Far from 0 1 - tanh^2 has no digits left.
TEST(Taylor, TheSlopeOfTanhDoesNotCancel) {
  const double x = 25.0, slope = 4.0 * std::exp(-2.0 * x);
  EXPECT_NEAR(tanh(Series::variable(x)).derivative(1) / slope, 1.0, 1e-14);
}

}  // namespace
}  // namespace flatland
