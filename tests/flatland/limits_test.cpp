// SPDX-License-Identifier: GPL-3.0-or-later
// Orders and coefficients at silhouettes, on curves where they are known in closed form.
#include "flatland/study/limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flatland/features/features.h"

namespace {

using namespace flatland;

Scene sceneOf(std::vector<Vec2> points, double angleDeg) {
  return {{{BezierChain(Bezier{std::move(points)})}}, {angleDeg, std::nullopt}};
}

// y = x^2 on [-1, 1], x = 2 t - 1.
Scene parabola(double angleDeg) { return sceneOf({{-1, 1}, {0, -1}, {1, 1}}, angleDeg); }
// y = x^3 on [-1, 1].
Scene cubic(double angleDeg) {
  return sceneOf({{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}}, angleDeg);
}
// (tau^2, tau^3) with tau = 2 t - 1: a cusp at the origin that points to -x.
Scene cusp(double angleDeg) {
  return sceneOf({{1, -1}, {-1.0 / 3, 1}, {-1.0 / 3, -1}, {1, 1}}, angleDeg);
}

const LimitLaw& lawOf(const LimitSeries& series, LimitQuantity quantity) {
  for (const LimitLaw& law : series.laws) {
    if (law.quantity == quantity) return law;
  }
  throw std::runtime_error("no such law");
}

// Fitted order and coefficient against numbers given here, and the prediction against the same.
void expectLaw(const LimitSeries& series, LimitQuantity quantity, double order, double coefficient,
               double orderTolerance, double coefficientTolerance) {
  SCOPED_TRACE(std::string(nameOf(series.experiment)) + ", " + std::string(nameOf(quantity)));
  const LimitLaw& law = lawOf(series, quantity);
  ASSERT_TRUE(law.order && law.coefficient && law.fit);
  EXPECT_NEAR(*law.order, order, 1e-12);
  EXPECT_NEAR(*law.coefficient / coefficient, 1.0, 1e-9);
  EXPECT_NEAR(law.fit->slope, order, orderTolerance);
  EXPECT_NEAR(law.fit->coefficient / coefficient, 1.0, coefficientTolerance);
  EXPECT_LE(law.fit->slopeError, orderTolerance);
  EXPECT_GE(law.fit->points, 8);
  // The points are those of one decade, the last.
  EXPECT_LE(law.fit->xHigh / law.fit->xLow, 10.001);
}

TEST(LogLogFit, FindsAPowerAndItsError) {
  std::vector<double> x, exact, noisy;
  for (int i = 0; i < 20; ++i) {
    x.push_back(std::pow(1.3, i));
    exact.push_back(3.0 * std::pow(x.back(), -1.5));
    noisy.push_back(exact.back() * (i % 2 == 0 ? 1.1 : 1.0 / 1.1));
  }
  const auto fit = fitLogLog(x, exact, 0.0, 1e9);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->slope, -1.5, 1e-13);
  EXPECT_NEAR(fit->coefficient, 3.0, 1e-12);
  EXPECT_LT(fit->slopeError, 1e-13);
  const auto rough = fitLogLog(x, noisy, 0.0, 1e9);
  // Standard error of a slope: sigma / sqrt(sum of squares of x).
  double mean = 0.0, squares = 0.0;
  for (const double v : x) mean += std::log(v) / 20.0;
  for (const double v : x) squares += (std::log(v) - mean) * (std::log(v) - mean);
  EXPECT_NEAR(rough->slopeError, std::log(1.1) * std::sqrt(20.0 / 18.0 / squares), 1e-3);
  EXPECT_FALSE(fitLogLog({1, 2, 3}, {1, 2, 3}, 0.0, 10.0));
  EXPECT_FALSE(fitLogLog({1, 2, 3, 4}, {1, 2, 0, NAN}, 0.0, 10.0));
}

// On a parabola at slope q: k = 2 / (1 + q^2)^(3/2), dk/du = -12 q / (1 + q^2)^3 ... with the left
// normal k is negative; sizes only.
TEST(Limits, TurningTheViewAtAPointGrowsLambdaWithTheInverseSquare) {
  const double q = 0.6;  // at x = 0.3, t = 0.65
  const double k = 2.0 / std::pow(1.0 + q * q, 1.5);
  const double kPrime = 12.0 * q / std::pow(1.0 + q * q, 3.0);
  const auto series = turnToSilhouette(parabola(0.0), 0, 0.65);
  ASSERT_TRUE(series);
  EXPECT_EQ(series->x.front(), 1.0);
  EXPECT_NEAR(series->x.back(), 1e-6, 1e-12);
  expectLaw(*series, LimitQuantity::Lambda, -2.0, k * k, 1e-9, 1e-8);
  expectLaw(*series, LimitQuantity::Feature, 1.0, k * kPrime, 1e-9, 1e-8);
  expectLaw(*series, LimitQuantity::Offset, 0.0, k * k * k, 1e-9, 1e-8);
  expectLaw(*series, LimitQuantity::Ratio, -1.0, k * k / kPrime, 1e-9, 1e-8);
  // lambda is exact all along, not only in the limit.
  const LimitLaw& lambda = lawOf(*series, LimitQuantity::Lambda);
  for (std::size_t i = 0; i < series->x.size(); ++i) {
    EXPECT_NEAR(lambda.values[i] * series->x[i] * series->x[i] / (k * k), 1.0, 1e-9);
  }
}

TEST(Limits, AtAnExtremumTheFeatureTermVanishesAndHasNoLaw) {
  const auto series = turnToSilhouette(parabola(0.0), 0, 0.5);
  ASSERT_TRUE(series);
  EXPECT_FALSE(lawOf(*series, LimitQuantity::Feature).order);
  EXPECT_FALSE(lawOf(*series, LimitQuantity::Ratio).order);
  EXPECT_FALSE(lawOf(*series, LimitQuantity::Ratio).fit);
  expectLaw(*series, LimitQuantity::Lambda, -2.0, 4.0, 1e-9, 1e-8);
}

// Seen along its tangent at slope q the parabola has a silhouette there. lambda ~ 1 / s^2 whatever
// the curvature: the coefficient is 1.
TEST(Limits, WalkingToAnOrdinarySilhouette) {
  const double q = 0.6;
  const double k = 2.0 / std::pow(1.0 + q * q, 1.5);
  const double kPrime = 12.0 * q / std::pow(1.0 + q * q, 3.0);
  for (const double from : {0.5, 0.9}) {  // from either side
    const auto series =
        walkToSilhouette(parabola(std::atan2(q, 1.0) * 180.0 / std::numbers::pi), 0, from);
    ASSERT_TRUE(series);
    EXPECT_EQ(series->limitCase, LimitCase::OrdinarySilhouette);
    EXPECT_NEAR(series->t, 0.65, 1e-12);
    expectLaw(*series, LimitQuantity::Lambda, -2.0, 1.0, 1e-5, 3e-4);
    expectLaw(*series, LimitQuantity::Feature, 1.0, k * k * kPrime, 1e-5, 3e-4);
    expectLaw(*series, LimitQuantity::Offset, 0.0, k * k * k, 1e-5, 3e-4);
    expectLaw(*series, LimitQuantity::Ratio, -1.0, k / kPrime, 1e-5, 3e-4);
  }
}

// 1 / s^2, whatever the curvature at the silhouette.
TEST(Limits, TheCoefficientOfLambdaDoesNotDependOnTheCurve) {
  int walks = 0;
  for (const Preset& preset : presets()) {
    if (preset.id == "cusp") continue;
    for (const double angle : {10.0, 50.0, 100.0}) {
      Scene scene = preset.scene;
      scene.view = {angle, std::nullopt};
      const auto series = walkToSilhouette(scene, 0, 0.4);
      if (!series || series->limitCase != LimitCase::OrdinarySilhouette) continue;
      ++walks;
      expectLaw(*series, LimitQuantity::Lambda, -2.0, 1.0, 1e-3, 1e-2);
    }
  }
  EXPECT_GT(walks, 8);
}

// y = x^3 seen along the x axis: at the inflection k = 6 s, n.w = 3 s^2: lambda = 4 / s^2, and the
// offset term is twice the feature term.
TEST(Limits, SilhouetteAtAnInflection) {
  const auto series = walkToSilhouette(cubic(0.0), 0, 0.6);
  ASSERT_TRUE(series);
  EXPECT_EQ(series->limitCase, LimitCase::SilhouetteAtInflection);
  EXPECT_NEAR(series->t, 0.5, 1e-9);
  expectLaw(*series, LimitQuantity::Lambda, -2.0, 4.0, 1e-4, 1e-3);
  expectLaw(*series, LimitQuantity::Feature, 3.0, 108.0, 1e-4, 1e-3);
  expectLaw(*series, LimitQuantity::Offset, 3.0, 216.0, 1e-4, 1e-3);
  expectLaw(*series, LimitQuantity::Ratio, 0.0, 2.0, 1e-4, 1e-3);
}

// (tau^2, tau^3): s ~ tau^2, k = 6 tau^2 / (2 tau)^3 = 3 / (4 tau) = 0.75 s^(-1/2).
TEST(Limits, CuspSeenAcrossAndAlong) {
  const double a = 0.75, p = 35.0 / 180.0 * std::numbers::pi;
  const auto across = walkToSilhouette(cusp(35.0), 0, 0.52);
  ASSERT_TRUE(across);
  EXPECT_EQ(across->limitCase, LimitCase::CuspSeenAcross);
  const double nw = std::sin(p), tw = std::cos(p);
  expectLaw(*across, LimitQuantity::Lambda, -1.0, a * a / (nw * nw), 5e-3, 5e-2);
  expectLaw(*across, LimitQuantity::Feature, -2.0, 0.5 * nw * a * a, 5e-3, 5e-2);
  expectLaw(*across, LimitQuantity::Offset, -1.5, a * a * a * tw, 5e-3, 5e-2);
  expectLaw(*across, LimitQuantity::Ratio, 0.5, 2.0 * a * tw / nw, 5e-3, 5e-2);
  const auto along = walkToSilhouette(cusp(0.0), 0, 0.52);
  ASSERT_TRUE(along);
  EXPECT_EQ(along->limitCase, LimitCase::CuspSeenAlong);
  expectLaw(*along, LimitQuantity::Lambda, -2.0, 0.25, 1e-3, 1e-2);
  expectLaw(*along, LimitQuantity::Feature, -1.5, a * a * a, 1e-3, 1e-2);
  expectLaw(*along, LimitQuantity::Offset, -1.5, a * a * a, 1e-3, 1e-2);
  expectLaw(*along, LimitQuantity::Ratio, 0.0, 1.0, 1e-3, 1e-2);
}

// y = x^3: k' = 6 at the inflection, so apparent ridge and silhouette stand sqrt(2 d / 6) off at
// the angle d; found anew at each angle by findFeatures.
TEST(Limits, RidgeSlidesIntoTheSilhouetteWithTheSquareRoot) {
  const auto series = slideIntoSilhouette(cubic(70.0), 0, 0.6);
  ASSERT_TRUE(series);
  EXPECT_NEAR(series->t, 0.5, 1e-12);
  EXPECT_NEAR(series->angleDeg, 0.0, 1e-9);
  const double coefficient = std::sqrt(2.0 / 6.0);
  expectLaw(*series, LimitQuantity::RidgeDistance, 0.5, coefficient, 1e-4, 1e-3);
  expectLaw(*series, LimitQuantity::SilhouetteDistance, 0.5, coefficient, 1e-4, 1e-3);
  // On the silhouettes' side there is no apparent ridge near.
  Scene beyond = cubic(1e-3);  // the tangents of y = x^3 all rise
  for (const Mark& mark : findFeatures(beyond).marks) {
    if (mark.kind != MarkKind::ApparentRidge) continue;
    EXPECT_GT(std::abs(mark.t - 0.5), 0.05);
  }
}

TEST(Limits, SlidesOnEveryInflectionOfTheDefaultCurve) {
  for (const double t : {0.35, 0.65}) {
    const auto series = slideIntoSilhouette(defaultScene(), 0, t);
    ASSERT_TRUE(series);
    for (const LimitLaw& law : series->laws) {
      ASSERT_TRUE(law.fit);
      EXPECT_NEAR(law.fit->slope, 0.5, 1e-3);
      EXPECT_NEAR(law.fit->coefficient / *law.coefficient, 1.0, 1e-2);
    }
  }
}

// From t = 0.03 of an ellipse the silhouette at 0.94 is 0.09 away, over the seam of the parameter,
// and the other, half a turn from it, 0.41.
TEST(Limits, WalksTheShorterWayAroundAClosedCurve) {
  const auto ellipse = FormulaCurve::make(FamilyCurve{familyNamed("ellipse")->id, {1.0, 1.5}});
  ASSERT_TRUE(ellipse.curve);
  const Scene scene{{{*ellipse.curve}}, {75.0, std::nullopt}};
  for (const double t : {0.03, 0.97, 0.44}) {
    double nearest = 1.0, there = 0.0;
    for (const Mark& mark : findFeatures(scene).marks) {
      if (mark.kind != MarkKind::Silhouette) continue;
      const double gap = std::abs(mark.t - t), way = std::min(gap, 1.0 - gap);
      if (way < nearest) nearest = way, there = mark.t;
    }
    const auto series = walkToSilhouette(scene, 0, t);
    ASSERT_TRUE(series);
    EXPECT_NEAR(series->t, there, 1e-12) << t;
    EXPECT_LT(nearest, 0.1);
    // On either side the law is that of an ordinary silhouette.
    expectLaw(*series, LimitQuantity::Lambda, -2.0, 1.0, 1e-3, 1e-2);
  }
}

TEST(Limits, SlideStopsWhenToldAndSeesOneCurveOnly) {
  Scene scene = cubic(70.0);
  int asked = 0;
  EXPECT_FALSE(slideIntoSilhouette(scene, 0, 0.6, [&asked] { return ++asked < 4; }));
  EXPECT_EQ(asked, 4);
  const auto alone = slideIntoSilhouette(scene, 0, 0.6);
  const Scene other = parabola(0.0);
  scene.curves.insert(scene.curves.begin(), other.curves[0]);
  const auto second = slideIntoSilhouette(scene, 1, 0.6);
  ASSERT_TRUE(alone && second);
  EXPECT_EQ(second->curve, 1);
  EXPECT_EQ(second->x, alone->x);
  EXPECT_EQ(second->laws[1].values, alone->laws[1].values);
}

TEST(Limits, NoAnswerWhereThereIsNothingToMeasure) {
  EXPECT_FALSE(slideIntoSilhouette(parabola(0.0), 0, 0.5));  // no inflection
  EXPECT_FALSE(walkToSilhouette(sceneOf({{0, 0}, {1, 1}}, 20.0), 0, 0.5));
  EXPECT_FALSE(turnToSilhouette(cusp(0.0), 0, 0.5));
  EXPECT_FALSE(walkToSilhouette(sceneOf({{1, 1}, {1, 1}}, 20.0), 0, 0.5));
  // A straight line turned: all zero, and no law is claimed.
  const auto line = turnToSilhouette(sceneOf({{0, 0}, {1, 1}}, 20.0), 0, 0.5);
  ASSERT_TRUE(line);
  for (const LimitLaw& law : line->laws) EXPECT_FALSE(law.order || law.fit);
}

TEST(Limits, ViewsWithAGivenForeshortening) {
  const Vec2 tangent(0.6, 0.8);
  for (const double near : {10.0, 100.0, -60.0, 200.0}) {
    const Vec2 w0 = frameOf(View{near, std::nullopt}).towards;
    for (const double nw : {1.0, 0.7, 0.01, 0.0}) {
      const Vec2 w =
          frameOf(View{angleDegWithForeshortening(tangent, nw, near), std::nullopt}).towards;
      EXPECT_NEAR(std::abs(rotateCcw(tangent).dot(w)), nw, 1e-15);
      EXPECT_TRUE(nw == 1.0 || tangent.dot(w) * tangent.dot(w0) > 0.0);
      EXPECT_TRUE(nw == 0.0 || rotateCcw(tangent).dot(w) * rotateCcw(tangent).dot(w0) > 0.0);
    }
  }
}

}  // namespace
