// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/new_curves.h"

#include <QCoreApplication>
#include <cmath>

#include "ui/model/core_words.h"

namespace flatland::ui {

namespace {

struct NewCurvesWords {
  Q_DECLARE_TR_FUNCTIONS(NewCurves)
};

/// The unit shape put in place, its coordinates rounded to short numbers.
std::vector<Vec2> placed(const std::vector<Vec2>& unit, const Vec2& centre, double radius) {
  const double grid = std::pow(10.0, std::floor(std::log10(radius)) - 2.0);
  std::vector<Vec2> points;
  for (const Vec2& p : unit) {
    points.push_back(((centre + radius * p) / grid).array().round().matrix() * grid);
  }
  return points;
}

}  // namespace

std::vector<NewCurve> newCurves() {
  std::vector<NewCurve> kinds{{"bezier", NewCurvesWords::tr("&Bezier")},
                              {"bspline", NewCurvesWords::tr("B-&spline, closed")},
                              {"rational", NewCurvesWords::tr("&Rational Bezier: a circle")}};
  for (const Family& family : families()) {
    kinds.push_back({QString::fromStdString(family.name), coreWords(family.title)});
  }
  kinds.push_back({"formula", NewCurvesWords::tr("&Typed Formula")});
  return kinds;
}

Curve newCurve(const QString& id, const Vec2& centre, double radius) {
  if (id == "bspline") {
    const auto points =
        placed({{0.8, -0.4}, {0.7, 0.5}, {0.1, 0.2}, {-0.6, 0.7}, {-0.8, -0.3}, {0, -0.8}}, centre,
               radius);
    return BSpline(3, true, points, BSpline::uniformKnots(3, true, points.size()));
  }
  if (id == "rational") {
    const auto points =
        placed({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}, centre,
               0.7 * radius);
    const double w = std::sqrt(0.5);
    return RationalBezier(2, true, points, {1, w, 1, w, 1, w, 1, w});
  }
  if (const Family* family = familyNamed(id.toStdString())) {
    return *FormulaCurve::make(initialCurve(*family), centre).curve;
  }
  if (id == "formula") {
    const TypedFormula rose{
        "cos(t) * (1 + a*cos(3*t))", "sin(t) * (1 + a*cos(3*t))", "0", "2*pi", {{"a", 0.3}}};
    return *FormulaCurve::make(rose, centre).curve;
  }
  return BezierChain(Bezier{placed(
      {{0.07, -0.42}, {-0.42, -0.21}, {0.35, 0}, {-0.42, 0.21}, {0.07, 0.42}}, centre, radius)});
}

}  // namespace flatland::ui
