// SPDX-License-Identifier: GPL-3.0-or-later
// What every kind of curve offers, against independent answers.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flatland/curve/curve.h"
#include "flatland/curve/curve_editing.h"
#include "tests/support/seed.h"

namespace flatland {
namespace {

constexpr double kPi = std::numbers::pi;

Curve familyCurve(const std::string& name, const std::vector<double>& parameters) {
  const Family* family = familyNamed(name);
  FormulaCurve::Result result = FormulaCurve::make(FamilyCurve{family->id, parameters});
  EXPECT_TRUE(result.curve) << result.error.reason;
  return *result.curve;
}

double curvatureAt(const Curve& curve, double t, int side) {
  return frameOf(jetAt(curve, t), side).k;
}

/// de Boor's recursion for the basis functions, straight from the definition.
double basis(const std::vector<double>& knots, std::size_t i, int degree, double u) {
  if (degree == 0) return knots[i] <= u && u < knots[i + 1] ? 1.0 : 0.0;
  const auto d = static_cast<std::size_t>(degree);
  double value = 0.0;
  if (knots[i + d] > knots[i]) {
    value += (u - knots[i]) / (knots[i + d] - knots[i]) * basis(knots, i, degree - 1, u);
  }
  if (knots[i + d + 1] > knots[i + 1]) {
    value += (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) *
             basis(knots, i + 1, degree - 1, u);
  }
  return value;
}

/// The spline by its basis functions at knot value u; a closed one unrolled.
Vec2 byBasis(const BSpline& spline, double u) {
  const auto n = spline.points().size(), d = static_cast<std::size_t>(spline.degree());
  std::vector<double> knots = spline.knots();
  std::vector<Vec2> points = spline.points();
  if (spline.closed()) {
    const double period = knots.back() - knots.front();
    for (std::size_t i = 0; i < 2 * d; ++i) knots.push_back(knots[i + 1] + period);
    for (std::size_t i = 0; i < d; ++i) {
      // The knot before the first is the last but one, a period earlier.
      knots.insert(knots.begin(), knots[n - 1] - period);
    }
    knots.resize(n + 2 * d + 1);
    for (std::size_t i = 0; i < d; ++i) points.push_back(points[i]);
  }
  Vec2 p = Vec2::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    p += basis(knots, i, spline.degree(), u) * points[i];
  }
  return p;
}

std::vector<BSpline> randomSplines(test::Random& random) {
  std::vector<BSpline> splines;
  for (int degree = 1; degree <= 5; ++degree) {
    for (const bool closed : {false, true}) {
      for (int shape = 0; shape < 3; ++shape) {
        const auto n = static_cast<std::size_t>(degree + 3 + shape);
        std::vector<Vec2> points;
        for (std::size_t i = 0; i < n; ++i)
          points.emplace_back(test::uniform(random, -1.0, 1.0), test::uniform(random, -1.0, 1.0));
        std::vector<double> knots = BSpline::uniformKnots(degree, closed, n);
        if (shape > 0) {  // uneven; open ones not clamped
          knots[0] = -1.0;
          for (std::size_t i = 1; i < knots.size(); ++i)
            knots[i] = knots[i - 1] + test::uniform(random, 0.2, 2.0);
        }
        if (shape == 2 && degree > 1) knots[n / 2 + 1] = knots[n / 2];  // a double knot
        splines.emplace_back(degree, closed, points, knots);
      }
    }
  }
  return splines;
}

TEST(BSpline, AgreesWithItsBasisFunctions) {
  test::Random random(test::announcedSeed("BSpline", 1));
  for (const BSpline& spline : randomSplines(random)) {
    for (int piece = 0; piece < spline.pieceCount(); ++piece) {
      for (const double s : {0.0, 0.3, 0.75, 0.999}) {
        const double low = spline.knotAt(piece), high = spline.knotAt(piece + 1);
        const Vec2 expected = byBasis(spline, low + s * (high - low));
        EXPECT_LT((pointAt(Curve(spline), piece + s) - expected).norm(), 1e-13)
            << "degree " << spline.degree() << " closed " << spline.closed() << " t " << piece + s;
      }
    }
  }
}

TEST(BSpline, AKnotMoreChangesNothing) {
  test::Random random(test::announcedSeed("BSpline", 1));
  for (const BSpline& spline : randomSplines(random)) {
    for (int repeat = 0; repeat < 4; ++repeat) {
      const double t =
          repeat == 3
              ? 1.0
              : test::uniform(random, 0.0, spline.pieceCount());  // also at a knot that is there
      const BSpline finer = withKnot(spline, t);
      if (finer == spline) {
        EXPECT_TRUE(repeat == 3 &&
                    (spline.degree() == 1 || spline.pieceCount() == 1 || spline.degree() == 2))
            << spline.degree();
        continue;
      }
      EXPECT_EQ(finer.points().size(), spline.points().size() + 1);
      for (int piece = 0; piece < spline.pieceCount(); ++piece) {
        const double u =
            spline.knotAt(piece) + 0.37 * (spline.knotAt(piece + 1) - spline.knotAt(piece));
        EXPECT_LT((byBasis(finer, u) - byBasis(spline, u)).norm(), 1e-13)
            << "degree " << spline.degree() << " closed " << spline.closed() << " t " << t;
      }
    }
  }
}

TEST(BSpline, SaysWhyThereIsNone) {
  EXPECT_TRUE(BSpline::whyInvalid(0, false, 4, {}));
  EXPECT_TRUE(BSpline::whyInvalid(3, false, 3, {0, 0, 0, 0, 1, 1, 1}));
  EXPECT_TRUE(BSpline::whyInvalid(3, false, 4, {0, 0, 0, 0, 1, 1, 1}));     // a knot too few
  EXPECT_TRUE(BSpline::whyInvalid(3, false, 4, {0, 0, 0, 1, 0, 1, 1, 1}));  // falls
  EXPECT_TRUE(BSpline::whyInvalid(1, false, 4, {0, 0, 1, 1, 2, 2}));        // breaks
  EXPECT_TRUE(BSpline::whyInvalid(2, false, 4, {0, 0, 0, 0, 0, 0, 0}));     // no domain
  EXPECT_TRUE(BSpline::whyInvalid(2, true, 3, {0, 0, 0, 1}));               // 3 times at the seam
  EXPECT_FALSE(BSpline::whyInvalid(2, true, 3, {0, 0, 1, 2}));
  EXPECT_FALSE(BSpline::whyInvalid(3, false, 4, {0, 0, 0, 0, 1, 1, 1, 1}));
}

TEST(Rational, AQuarterCircleHasConstantCurvature) {
  const Curve quarter =
      RationalBezier(2, false, {{2, 0}, {2, 2}, {0, 2}}, {1.0, std::sqrt(0.5), 1.0});
  for (int i = 0; i <= 100; ++i) {
    const Jet jet = jetAt(quarter, 0, i / 100.0);
    EXPECT_NEAR(jet.p.norm(), 2.0, 1e-15 * 2);
    const Frame frame = frameOf(jet, -1);
    EXPECT_NEAR(frame.k, 0.5, 1e-14);
    EXPECT_NEAR(frame.kPrime, 0.0, 1e-13);
  }
}

TEST(Rational, SplittingAndElevatingKeepTheShape) {
  const RationalBezier curve(3, true, {{0, 0}, {1, -1}, {3, 0}, {3, 1}, {2, 3}, {0, 2}},
                             {1, 2, 0.5, 1, 3, 0.7});
  for (const Curve& same : {Curve(splitAt(curve, 1.3)), Curve(elevated(curve))}) {
    for (int i = 0; i <= 40; ++i) {
      const Vec2 p = pointAt(Curve(curve), i / 20.0);
      EXPECT_LT(nearestPoint(same, p).distance, 1e-14 * 5);
    }
  }
  EXPECT_EQ(splitAt(curve, 1.3).pieceCount(), 3);
  EXPECT_EQ(splitAt(curve, 1.0), curve);
}

TEST(Families, HaveTheirClosedFormCurvature) {
  for (int i = 1; i < 40; ++i) {
    const double t = i / 40.0, phi = 2.0 * kPi * t, s = std::sin(phi), c = std::cos(phi);
    // Walked counter-clockwise the outer side is the right one.
    EXPECT_NEAR(curvatureAt(familyCurve("circle", {2.5}), t, -1), 0.4, 1e-15);
    const double a = 1.3, b = 0.6;
    EXPECT_NEAR(curvatureAt(familyCurve("ellipse", {a, b}), t, -1),
                a * b / std::pow(a * a * s * s + b * b * c * c, 1.5), 1e-13);
    // Graphs: on the upper (left) side k = -f'' / (1 + f'^2)^(3/2).
    const double w = 1.5, x = w * (2.0 * t - 1.0);
    EXPECT_NEAR(curvatureAt(familyCurve("parabola", {0.7, w}), t, 1),
                -1.4 / std::pow(1.0 + 1.96 * x * x, 1.5), 1e-14);
    EXPECT_NEAR(
        curvatureAt(familyCurve("sine", {0.5, 2.0, w}), t, 1),
        2.0 * std::sin(2.0 * x) / std::pow(1.0 + std::cos(2.0 * x) * std::cos(2.0 * x), 1.5),
        1e-14);
    const double h = 2.0, sigma = 0.8, g = h * std::exp(-0.5 * x * x / (sigma * sigma));
    const double d1 = -x / (sigma * sigma) * g;
    const double d2 = (x * x / std::pow(sigma, 4) - 1.0 / (sigma * sigma)) * g;
    EXPECT_NEAR(curvatureAt(familyCurve("gaussian", {h, sigma, w}), t, 1),
                -d2 / std::pow(1.0 + d1 * d1, 1.5), 1e-13);
    // Cycloid r = d: 1 / (4 r sin(phi / 2)), bulging upwards.
    EXPECT_NEAR(curvatureAt(familyCurve("cycloid", {0.5, 0.5, 2}), 1.0 + t, 1),
                1.0 / (2.0 * std::sin(0.5 * phi)), 1e-12);
    // Lissajous x = a cos(phi), y = b sin(2 phi)
    const double x1 = -s, x2 = -c, y1 = 2 * std::cos(2 * phi), y2 = -4 * std::sin(2 * phi);
    EXPECT_NEAR(curvatureAt(familyCurve("lissajous", {1, 1, 1, 2, 90}), t, 1),
                -(x1 * y2 - y1 * x2) / std::pow(x1 * x1 + y1 * y1, 1.5), 1e-11);
  }
}

TEST(Families, ASuperellipseSatisfiesItsEquationAndIsAnEllipseForN2) {
  for (const double n : {1.0, 2.0, 2.5, 4.0, 7.3}) {
    const Curve curve = familyCurve("superellipse", {1.5, 0.8, n});
    for (int i = 0; i < 80; ++i) {
      const Vec2 p = pointAt(curve, i / 20.0);
      EXPECT_NEAR(std::pow(std::abs(p.x()) / 1.5, n) + std::pow(std::abs(p.y()) / 0.8, n), 1.0,
                  1e-14);
      if (n == 2.0) {
        const double gradient = std::hypot(p.x() / (1.5 * 1.5), p.y() / (0.8 * 0.8));
        EXPECT_NEAR(curvatureAt(curve, i / 20.0, -1),
                    1.0 / (std::pow(1.5 * 0.8, 2) * std::pow(gradient, 3)), 1e-12);
      }
    }
    EXPECT_EQ(pointAt(curve, 1.0), Vec2(0.0, 0.8)) << n;
    // Counter-clockwise.
    EXPECT_GT(twiceSignedArea(curve), 0.0);
  }
  EXPECT_NEAR(twiceSignedArea(familyCurve("superellipse", {1.5, 0.8, 1.0})), 4 * 1.5 * 0.8, 1e-12);
}

TEST(Families, ACycloidHasExactCuspsAtItsJoints) {
  const Curve curve = familyCurve("cycloid", {0.5, 0.5, 3});
  ASSERT_EQ(pieceCount(curve), 3);
  for (const double end : {0.0, 1.0}) EXPECT_EQ(jetAt(curve, 1, end).d1, Vec2(0.0, 0.0));
  EXPECT_EQ(pointAt(curve, 1.0).y(), 0.0);
}

// Every kind, for what must hold of all.
std::vector<Curve> oneOfEach() {
  std::vector<Curve> curves;
  curves.emplace_back(BezierChain(Bezier{{{0, 0}, {1, 2}, {2, -1}, {3, 1}, {3.5, 0}}}));
  curves.emplace_back(
      BSpline(3, true, {{0, 0}, {2, 0}, {3, 1}, {1, 2}, {0, 1}}, {0, 1, 1.5, 3, 4, 5}));
  curves.emplace_back(
      RationalBezier(2, false, {{0, 0}, {1, 2}, {2, 0}, {3, -2}, {4, 1}}, {1, 3, 1, 0.4, 2}));
  for (const Family& family : families()) {
    curves.emplace_back(*FormulaCurve::make(initialCurve(family), {0.5, -0.25}).curve);
  }
  const TypedFormula typed{
      "cos(t) * (1 + a*cos(3*t))", "sin(t)*(1+a*cos(3*t))", "0", "2*pi", {{"a", 0.3}}};
  curves.emplace_back(*FormulaCurve::make(typed).curve);
  return curves;
}

TEST(EveryKind, DerivativesAreThoseOfThePoints) {
  for (const Curve& curve : oneOfEach()) {
    for (int piece = 0; piece < pieceCount(curve); ++piece) {
      for (const double t : {0.21, 0.5, 0.83}) {
        constexpr double h = 1e-3;
        const auto d = derivativesAt(curve, piece, t);
        EXPECT_LT((d[0] - pointAt(curve, piece + t)).norm(), 1e-14);
        for (std::size_t k = 1; k < 5; ++k) {
          // Central difference of the derivative before, fourth order.
          const auto at = [&](double s) { return derivativesAt(curve, piece, t + s)[k - 1]; };
          const Vec2 difference = (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h);
          const double scale = d[k].norm() + lengthScale(curve);
          EXPECT_LT((difference - d[k]).norm(), 1e-5 * scale) << kindName(curve) << " order " << k;
        }
      }
    }
  }
}

TEST(EveryKind, IsDrawnWithinTheTolerance) {
  for (const Curve& curve : oneOfEach()) {
    const double size = boundsOf(curve).diagonal();
    for (const double tolerance : {1e-2 * size, 1e-5 * size}) {
      const BezierChain drawn = drawnAs(curve, tolerance);
      EXPECT_EQ(drawn.closed(), isClosed(curve));
      for (const Vec2& p : sampledPoints(curve, 64)) {
        EXPECT_LT(nearestPoint(drawn, p).distance, tolerance) << kindName(curve);
      }
      const auto stretches = cubicsWithin(curve, 0.3, 0.8, tolerance);
      EXPECT_EQ(stretches.front().tLow, 0.3);
      EXPECT_EQ(stretches.back().tHigh, 0.8);
      EXPECT_LT((stretches.back().cubic.points.back() - pointAt(curve, 0.8)).norm(), 1e-14 * size);
    }
  }
}

TEST(EveryKind, LiesInItsBoundsAndHasTheNearestPointItSays) {
  for (const Curve& curve : oneOfEach()) {
    const Bounds box = boundsOf(curve);
    const double size = box.diagonal();
    const std::vector<Vec2> samples = sampledPoints(curve, 96);
    for (const Vec2& p : samples) {
      EXPECT_LT((box.low - p).maxCoeff(), 1e-3 * size);
      EXPECT_LT((p - box.high).maxCoeff(), 1e-3 * size);
    }
    for (const Vec2& away : {Vec2(0.1, 0.3), Vec2(-2, 1), Vec2(4, 4)}) {
      const Nearest nearest = nearestPoint(curve, away);
      EXPECT_NEAR((pointAt(curve, nearest.t) - away).norm(), nearest.distance, 1e-15 * 10);
      for (const Vec2& p : samples) EXPECT_LE(nearest.distance, (p - away).norm() + 1e-12);
    }
  }
}

TEST(EveryKind, MovesAsAWhole) {
  for (const Curve& curve : oneOfEach()) {
    const Vec2 delta(3.0, -7.0);
    const Curve moved = translated(curve, delta);
    EXPECT_TRUE(sameTopology(curve, moved));
    EXPECT_FALSE(curve == moved);
    for (const double t : {0.0, 0.4, 0.9}) {
      EXPECT_LT((pointAt(moved, t) - pointAt(curve, t) - delta).norm(), 1e-14 * 10);
    }
    EXPECT_NEAR(twiceSignedArea(curve), twiceSignedArea(moved), 1e-12);
  }
}

TEST(EveryKind, HasItsArcLength) {
  EXPECT_NEAR(arcLength(familyCurve("circle", {2.0}), 0.0, 1.0, 1e-12).value, 4.0 * kPi, 1e-12);
  EXPECT_NEAR(arcLength(familyCurve("circle", {2.0}), 0.75, 0.25, 1e-12).value, -2.0 * kPi, 1e-12);
  // An arch of a cycloid is 8 r long; cusps at its ends.
  const ArcLength arches = arcLength(familyCurve("cycloid", {0.5, 0.5, 3}), 0.0, 3.0, 1e-10);
  EXPECT_NEAR(arches.value, 12.0, 1e-10);
  EXPECT_TRUE(arches.converged);
  EXPECT_NEAR(twiceSignedArea(familyCurve("ellipse", {1.3, 0.6})), 2.0 * kPi * 1.3 * 0.6, 1e-12);
}

}  // namespace
}  // namespace flatland
