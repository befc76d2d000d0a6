// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor arithmetic against 50 digits (its edges: taylor_test.cpp), and typed formulas: their
// grammar, values and errors.
#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "flatland/curve/curve.h"
#include "tests/support/precise.h"
#include "tests/support/seed.h"

namespace flatland {
namespace {

using test::Precise;
using Series = Taylor<4>;

/// Derivatives 0 to 4 at t by symmetric differences with 50 digits: errors near 1e-20.
std::array<double, 5> derivatives(const std::function<Precise(const Precise&)>& f, double t) {
  const Precise h = Precise("1e-5"), x = t;
  std::array<Precise, 9> y;
  for (int i = -4; i <= 4; ++i) y[static_cast<std::size_t>(i + 4)] = f(x + i * h);
  const auto at = [&y](int i) { return y[static_cast<std::size_t>(i + 4)]; };
  const auto odd = [&](int i) { return Precise(at(i) - at(-i)); };
  const auto even = [&](int i) { return Precise(at(i) + at(-i)); };
  const Precise d1 = (672 * odd(1) - 168 * odd(2) + 32 * odd(3) - 3 * odd(4)) / (840 * h);
  const Precise d2 =
      (8064 * even(1) - 1008 * even(2) + 128 * even(3) - 9 * even(4) - 14350 * at(0)) /
      (5040 * h * h);
  const Precise d3 = (-488 * odd(1) + 338 * odd(2) - 72 * odd(3) + 7 * odd(4)) / (240 * h * h * h);
  const Precise d4 = (-1952 * even(1) + 676 * even(2) - 96 * even(3) + 7 * even(4) + 2730 * at(0)) /
                     (240 * h * h * h * h);
  return {static_cast<double>(at(0)), static_cast<double>(d1), static_cast<double>(d2),
          static_cast<double>(d3), static_cast<double>(d4)};
}

struct Case {
  const char* text;
  std::function<Precise(const Precise&)> precise;
};

const std::vector<Case>& cases() {
  using P = const Precise&;
  static const std::vector<Case> all = {
      {"sin(3*t)", [](P t) { return sin(3 * t); }},
      {"cos(t^2)", [](P t) { return cos(t * t); }},
      {"tan(t)", [](P t) { return tan(t); }},
      {"asin(t/2)", [](P t) { return asin(t / 2); }},
      {"acos(t/2)", [](P t) { return acos(t / 2); }},
      {"atan(2*t)", [](P t) { return atan(2 * t); }},
      {"sinh(t)", [](P t) { return sinh(t); }},
      {"cosh(2*t)", [](P t) { return cosh(2 * t); }},
      {"tanh(t)", [](P t) { return tanh(t); }},
      {"asinh(t)", [](P t) { return Precise(log(t + sqrt(t * t + 1))); }},
      {"acosh(t+2)", [](P t) { return Precise(log(t + 2 + sqrt((t + 2) * (t + 2) - 1))); }},
      {"atanh(t/2)", [](P t) { return Precise(log((1 + t / 2) / (1 - t / 2)) / 2); }},
      {"exp(-t*t/2)", [](P t) { return exp(-t * t / 2); }},
      {"log(1+t^2)", [](P t) { return log(1 + t * t); }},
      {"ln(3+t)-log10(5+t)",
       [](P t) { return Precise(log(3 + t) - log(5 + t) / log(Precise(10))); }},
      {"sqrt(2+t)", [](P t) { return sqrt(2 + t); }},
      {"abs(t-3)*t", [](P t) { return Precise((3 - t) * t); }},
      {"(2+t)^2.5", [](P t) { return pow(Precise(2 + t), Precise("2.5")); }},
      {"pow(t,5)-t^-2", [](P t) { return Precise(t * t * t * t * t - 1 / (t * t)); }},
      {"(2+t)^t", [](P t) { return Precise(exp(t * log(2 + t))); }},
      {"atan2(t, 1-t)", [](P t) { return Precise(atan(t / (1 - t))); }},
      {"hypot(t, 1)/(1+t)", [](P t) { return Precise(sqrt(t * t + 1) / (1 + t)); }},
      {"e^(-t)*(t-pi)",
       [](P t) { return Precise(exp(-t) * (t - boost::math::constants::pi<Precise>())); }},
  };
  return all;
}

TEST(Taylor, AgreesWithFiftyDigits) {
  for (const Case& one : cases()) {
    const Expression::Result parsed = Expression::parse(one.text, {});
    ASSERT_TRUE(parsed.expression) << one.text << ": " << parsed.error.reason;
    for (const double t : {0.125, 0.37, 0.71}) {
      const Series value = parsed.expression->at(Series::variable(t));
      const auto expected = derivatives(one.precise, t);
      for (int k = 0; k < 5; ++k) {
        const double right = expected[static_cast<std::size_t>(k)];
        // Rounding grows with the size of the terms: a few hundred units of the largest derivative.
        const double scale = std::abs(right) + std::abs(expected[0]) + 1.0;
        EXPECT_NEAR(value.derivative(k), right, 1e-13 * scale) << one.text << " order " << k;
      }
    }
  }
}

double valueOf(const std::string& text, const Expression::Constants& constants = {}) {
  const Expression::Result parsed = Expression::parse(text, constants);
  EXPECT_TRUE(parsed.expression) << text << ": " << parsed.error.reason;
  return parsed.expression ? parsed.expression->at(Taylor<0>(2.0)).value() : NAN;
}

TEST(Expression, HasTheUsualPrecedence) {
  EXPECT_EQ(valueOf("-2^2"), -4.0);
  EXPECT_EQ(valueOf("2^3^2"), 512.0);
  EXPECT_EQ(valueOf("2^-1"), 0.5);
  EXPECT_EQ(valueOf("-t^2*3"), -12.0);
  EXPECT_EQ(valueOf("1-2-3"), -4.0);
  EXPECT_EQ(valueOf("8/4/2"), 1.0);
  EXPECT_EQ(valueOf("2+3*4^2/8"), 8.0);
  EXPECT_EQ(valueOf("--3"), 3.0);
  EXPECT_EQ(valueOf("2*-3"), -6.0);
  EXPECT_EQ(valueOf(" ( 1 + t ) * 1.5e1 "), 45.0);
  EXPECT_EQ(valueOf("a*b_2", {{"a", 3.0}, {"b_2", 7.0}}), 21.0);
  EXPECT_EQ(valueOf("pi"), std::numbers::pi);
  EXPECT_EQ(valueOf("atan2(0, -1)"), std::numbers::pi);
}

TEST(Expression, SaysWhereAndWhy) {
  const auto expectError = [](const std::string& text, int column, const std::string& part) {
    const Expression::Result parsed = Expression::parse(text, {});
    ASSERT_FALSE(parsed.expression) << text;
    EXPECT_EQ(parsed.error.column, column) << text << ": " << parsed.error.reason;
    EXPECT_NE(parsed.error.reason.find(part), std::string::npos) << parsed.error.reason;
  };
  expectError("", 1, "missing");
  expectError("2*", 3, "missing");
  expectError("2 t", 3, "2*t");
  expectError("sin t", 1, "( )");
  expectError("(1+2", 5, ") is missing");
  expectError("1+2)", 4, "no (");
  expectError("foo(1)", 1, "no such function");
  expectError("1 + x", 5, "neither");
  expectError("atan2(1)", 1, "two arguments");
  expectError("sin(1,5)", 6, "point");
  expectError("1e999", 1, "out of range");
  expectError("\u03c0 + 1", 1, "\u03c0");
  expectError("t + \u00e4", 5, "\u00e4");
  expectError(std::string(3000, '('), 101, "deeply");
  expectError(std::string(3000, '-') + "1", 200, "deeply");
  expectError(std::string(5000, '1'), 4001, "longer");
  EXPECT_TRUE(Expression::whyNotAName("sin"));
  EXPECT_TRUE(Expression::whyNotAName("2a"));
  EXPECT_FALSE(Expression::whyNotAName("a2"));
}

TEST(Expression, NothingCrashesIt) {
  test::Random random(test::announcedSeed("Expression", 3));
  const std::string parts[] = {"t",      "2", "(",  ")", "+", "-", "*",    "/",  "^", "sin(",
                               "atan2(", ",", "pi", ".", "e", " ", "\xff", "1e", "a"};
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (int k = test::uniformInt(random, 0, 24); k > 0; --k) {
      text += parts[test::uniformInt(random, 0, 18)];
    }
    const Expression::Result parsed = Expression::parse(text, {{"a", 1.5}});
    if (parsed.expression) {
      (void)parsed.expression->at(Series::variable(0.3));
    } else {
      EXPECT_GE(parsed.error.column, 1);
      EXPECT_FALSE(parsed.error.reason.empty());
    }
  }
}

TEST(TypedFormula, KnowsWhetherItIsClosed) {
  EXPECT_TRUE(
      FormulaCurve::make(TypedFormula{"cos(t)", "sin(2*t)", "0", "2*pi", {}}).curve->closed());
  EXPECT_FALSE(
      FormulaCurve::make(TypedFormula{"cos(t)", "sin(2*t)", "0", "pi", {}}).curve->closed());
}

TEST(TypedFormula, SaysWhatIsWrongWithIt) {
  using Field = FormulaError::Field;
  const auto expectError = [](const TypedFormula& formula, Field field, const std::string& part) {
    const FormulaCurve::Result result = FormulaCurve::make(formula);
    ASSERT_FALSE(result.curve) << part;
    EXPECT_EQ(result.error.field, field) << result.error.reason;
    EXPECT_NE(result.error.reason.find(part), std::string::npos) << result.error.reason;
  };
  expectError({"t", "1/t", "-1", "0", {}}, Field::Y, "at t = 0");
  expectError({"sqrt(t)", "t", "-1", "1", {}}, Field::X, "no finite value at t = -1");
  expectError({"exp(1000*t)", "t", "0", "0.5", {}}, Field::X, "beyond 1e50");
  expectError({"t", "t", "0", "t", {}}, Field::To, "domain");
  expectError({"t", "t", "2", "1", {}}, Field::To, "above 2");
  expectError({"t", "t", "1/0", "1", {}}, Field::From, "finite");
  expectError({"t", "2*", "0", "1", {}}, Field::Y, "missing");
  expectError({"t", "t", "0", "1", {{"sin", 1.0}}}, Field::Constants, "taken");
}

TEST(TypedFormula, TheDerivativesAtTheEdgeOfItsDomainAreTakenInside) {
  const FormulaCurve curve = *FormulaCurve::make(TypedFormula{"t", "sqrt(t)", "0", "1", {}}).curve;
  for (const Vec2& d : curve.derivativesAt(0, 0.0)) EXPECT_TRUE(d.allFinite());
  EXPECT_EQ(curve.derivativesAt(0, 0.0)[0], Vec2(0.0, 0.0));
}

}  // namespace
}  // namespace flatland
