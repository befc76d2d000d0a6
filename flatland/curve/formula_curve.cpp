// SPDX-License-Identifier: MIT
#include "flatland/curve/formula_curve.h"

#include <algorithm>
#include <cmath>

#include "flatland/curve/cubic_cuts.h"
#include "flatland/io/number_text.h"

namespace flatland {

namespace {

using Field = FormulaError::Field;

std::string shortText(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

/// An end of the domain, or why it is none.
std::optional<FormulaError> readEnd(const std::string& text, const Expression::Constants& constants,
                                    Field field, double& value) {
  const Expression::Result result = Expression::parse(text, constants, false);
  if (!result.expression) return FormulaError{field, result.error.column, result.error.reason};
  value = result.expression->at(Taylor<0>(0.0)).value();
  constexpr double kLargestParameter = 1e15;
  if (!std::isfinite(value)) return FormulaError{field, 0, "this is not a finite number"};
  if (std::abs(value) > kLargestParameter) return FormulaError{field, 0, "this is beyond 1e15"};
  return std::nullopt;
}

/// Where a function that changes its sign between two places does so through infinity. A crossing
/// through zero has small values on at least one side of it; a jump keeps its values.
template <class Value>
std::optional<double> poleBetween(const Value& value, double low, double high) {
  constexpr double kGrowth = 1e6;
  double before = value(low), after = value(high);
  if (!(before * after < 0.0)) return std::nullopt;
  const double largest = std::max(std::abs(before), std::abs(after));
  const double smallest = std::min(std::abs(before), std::abs(after));
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) break;
    const double here = value(middle);
    if (!std::isfinite(here)) return middle;
    // Towards a zero the values fall.
    if (std::abs(here) < smallest) return std::nullopt;
    ((here < 0.0) == (before < 0.0) ? low : high) = middle;
    if (std::abs(here) > kGrowth * largest) return middle;
  }
  return std::nullopt;
}

// The infinity of a function that keeps its sign between two places, as 1/t^2 does: where it is
// largest it goes on growing however near one comes, by a power of the distance of 0.1 or more.
template <class Value>
std::optional<double> evenPoleIn(const Value& value, double low, double high, double least) {
  const auto size = [&](double t) { return std::abs(value(t)); };
  const double golden = 0.5 * (3.0 - std::sqrt(5.0));
  double a = low + golden * (high - low), b = high - golden * (high - low);
  double fa = size(a), fb = size(b);
  constexpr int kSteps = 80, kHope = 20;
  for (int i = 0; i < kSteps && low < a && a < b && b < high; ++i) {
    if (!std::isfinite(fa) || !std::isfinite(fb)) return std::isfinite(fa) ? b : a;
    if (i == kHope && std::max(fa, fb) < 1.5 * least) return std::nullopt;  // a plain maximum
    if (fa > fb) {
      high = b, b = a, fb = fa;
      a = low + golden * (high - low), fa = size(a);
    } else {
      low = a, a = b, fa = fb;
      b = high - golden * (high - low), fb = size(b);
    }
  }
  const double top = fa > fb ? a : b;
  constexpr double kGrowth = 1.5;  // over a factor 64 of the distance
  double before = 0.0;
  for (const double apart : {0x1p-24, 0x1p-30, 0x1p-36, 0x1p-42}) {
    const double here = std::min(size(top - apart), size(top + apart));
    if (!(here > kGrowth * before)) return std::nullopt;
    before = here;
  }
  return top;
}

thread_local std::uint64_t evaluationCount = 0;

}  // namespace

std::uint64_t FormulaCurve::evaluations() { return evaluationCount; }

template <int N>
void FormulaCurve::Compiled::evaluate(int piece, double t, Taylor<N>& px, Taylor<N>& py) const {
  ++evaluationCount;
  if (const auto* family = std::get_if<FamilyCurve>(&source)) {
    flatland::evaluate(*family, piece, Taylor<N>::variable(t), px, py);
    return;
  }
  const double at = t >= 1.0 ? to : from + t * (to - from);
  const auto parameter = Taylor<N>::variable(at, to - from);
  px = x.at(parameter);
  py = y.at(parameter);
}

Vec2 FormulaCurve::pointAt(int piece, double t) const {
  Taylor<0> x, y;
  shared_->evaluate(piece, t, x, y);
  return at_ + Vec2(x.value(), y.value());
}

std::array<Vec2, 5> FormulaCurve::derivativesAt(int piece, double t) const {
  Taylor<4> x, y;
  shared_->evaluate(piece, t, x, y);
  std::array<Vec2, 5> result;
  result[0] = at_ + Vec2(x.value(), y.value());
  if (!x.isFinite() || !y.isFinite()) {
    constexpr double kInside = 0x1p-40;
    shared_->evaluate(piece, t > 0.5 ? t - kInside : t + kInside, x, y);
  }
  for (int k = 1; k < 5; ++k) {
    result[static_cast<std::size_t>(k)] = Vec2(x.derivative(k), y.derivative(k));
  }
  return result;
}

FormulaCurve FormulaCurve::movedTo(const Vec2& at) const { return FormulaCurve(shared_, at); }

FormulaCurve::Result FormulaCurve::make(const FamilyCurve& curve, const Vec2& at) {
  if (const auto why = whyInvalid(curve)) return {std::nullopt, {Field::Family, 0, *why}};
  auto compiled = std::make_shared<Compiled>();
  compiled->source = curve;
  compiled->pieceCount = flatland::pieceCount(curve);
  compiled->closed = familyOf(curve).closed;
  return finished(std::move(compiled), at);
}

FormulaCurve::Result FormulaCurve::make(const TypedFormula& formula, const Vec2& at) {
  auto compiled = std::make_shared<Compiled>();
  compiled->source = formula;
  for (const auto& [name, value] : formula.constants) {
    if (const auto why = Expression::whyNotAName(name)) {
      return {std::nullopt, {Field::Constants, 0, "\"" + name + "\": " + *why}};
    }
    if (!std::isfinite(value)) {
      return {std::nullopt, {Field::Constants, 0, name + " is not a finite number"}};
    }
  }
  for (const Field field : {Field::X, Field::Y}) {
    const std::string& text = field == Field::X ? formula.x : formula.y;
    Expression::Result result = Expression::parse(text, formula.constants);
    if (!result.expression) {
      return {std::nullopt, {field, result.error.column, result.error.reason}};
    }
    (field == Field::X ? compiled->x : compiled->y) = std::move(*result.expression);
  }
  if (auto error = readEnd(formula.from, formula.constants, Field::From, compiled->from)) {
    return {std::nullopt, *error};
  }
  if (auto error = readEnd(formula.to, formula.constants, Field::To, compiled->to)) {
    return {std::nullopt, *error};
  }
  // Below this, neighbouring parameters are the same number.
  constexpr double kShortestDomain = 0x1p-40;
  const double length = compiled->to - compiled->from;
  if (!(length > kShortestDomain * std::max(std::abs(compiled->from), std::abs(compiled->to)))) {
    return {std::nullopt, {Field::To, 0, "the domain must end above " + shortText(compiled->from)}};
  }
  return finished(std::move(compiled), at);
}

FormulaCurve::Result FormulaCurve::finished(std::shared_ptr<Compiled> compiled, const Vec2& at) {
  const bool typed = std::holds_alternative<TypedFormula>(compiled->source);
  const FormulaCurve curve(compiled, Vec2::Zero());
  // A prime number of steps, so that a swing does not hide between them.
  const int steps = typed ? 2003 : 211;
  // A value must stand out so far from its neighbours for a pole to be looked for.
  constexpr double kPeak = 1.05;
  Vec2 low = Vec2::Constant(HUGE_VAL), high = -low;
  const auto noValue = [&](Field field, double t, const char* what) {
    const std::string name = field == Field::X ? "x" : "y";
    const double parameter = compiled->from + t * (compiled->to - compiled->from);
    return Result{
        std::nullopt,
        {typed ? field : Field::Family, 0, name + what + " at t = " + shortText(parameter)}};
  };
  for (int piece = 0; piece < compiled->pieceCount; ++piece) {
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const Vec2 p = curve.pointAt(piece, t);
      for (const Field field : {Field::X, Field::Y}) {
        const double value = field == Field::X ? p.x() : p.y();
        if (std::abs(value) <= kLargestCoordinate) continue;
        return noValue(field, t, std::isfinite(value) ? " is beyond 1e50" : " has no finite value");
      }
      if (typed && i > 0) {
        for (const Field field : {Field::X, Field::Y}) {
          const int k = field == Field::X ? 0 : 1;
          const auto value = [&](double s) { return curve.pointAt(piece, s)[k]; };
          const auto pole = poleBetween(value, static_cast<double>(i - 1) / steps, t);
          if (pole) return noValue(field, *pole, " grows beyond all bounds");
          if (i < 2) continue;
          const double step = 1.0 / steps, before = std::abs(value(t - 2.0 * step));
          const double middle = std::abs(value(t - step)), here = std::abs(value(t));
          if (!(middle > 0.0) || middle < before || middle < here ||
              middle < kPeak * std::min(before, here))
            continue;
          const auto even = evenPoleIn(value, t - 2.0 * step, t, middle);
          if (even) return noValue(field, *even, " grows beyond all bounds");
        }
      }
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  const double size = (high - low).norm();
  if (typed) {
    const Vec2 gap = curve.pointAt(0, 1.0) - curve.pointAt(0, 0.0);
    constexpr double kEndsMeet = 1e-12;
    compiled->closed = size > 0.0 && gap.norm() <= kEndsMeet * size;
  }
  constexpr double kNearlyCubic = 1e-3;
  const auto jet = [&curve](int piece, double t) {
    const std::array<Vec2, 5> d = curve.derivativesAt(piece, t);
    return Jet{d[0], d[1], d[2], d[3]};
  };
  std::vector<double> cuts =
      cubicCuts(jet, compiled->pieceCount, typed ? 5 : 3, kNearlyCubic * size);
  constexpr std::size_t kMostCuts = 5000;
  if (cuts.size() > kMostCuts) {
    return {std::nullopt,
            {typed ? Field::To : Field::Family, 0, "the curve turns too often for its domain"}};
  }
  compiled->cuts = std::move(cuts);
  return {FormulaCurve(std::move(compiled), at), {}};
}

}  // namespace flatland
