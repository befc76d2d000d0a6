// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn at the probe, against the order of contact, finite differences and closed forms.
#include "flatland/study/probe_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flatland/curve/arc_length.h"
#include "tests/support/seed.h"

namespace flatland {
namespace {

using test::announcedSeed;
using test::Random;
using test::uniform;

constexpr double kNoLimit = 1e30;

Bezier randomCurve(Random& random) {
  Bezier curve;
  for (int i = 0; i < 5; ++i) {
    const double x = uniform(random, 0.0, 1.0);
    curve.points.emplace_back(x, uniform(random, 0.0, 1.0));
  }
  return curve;
}

TEST(OsculatingCircle, TouchesToSecondOrder) {
  Random random(announcedSeed("OsculatingCircle", 3001));
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Bezier curve = randomCurve(random);
    const double t = uniform(random, 0.2, 0.8);
    const auto circle = osculatingCircle(jetAt(curve, t), kNoLimit);
    ASSERT_TRUE(circle);
    const auto gap = [&](double h) {
      return std::abs((pointAt(curve, t + h) - circle->centre).norm() - circle->radius);
    };
    constexpr double h = 1e-3;
    if (gap(h) < 1e-9 || circle->radius < 0.1 || circle->radius > 10.0) continue;
    // Third order: half the step, an eighth of the gap. A wrong radius or side would be second.
    EXPECT_NEAR(gap(h) / gap(0.5 * h), 8.0, 1.5) << "t = " << t;
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(OsculatingCircle, OfAStraightPlaceIsNone) {
  EXPECT_FALSE(osculatingCircle(jetAt(Bezier{{{0, 0}, {1, 2}}}, 0.5), kNoLimit));
  const Bezier parabola{{{-1, 1}, {0, -1}, {1, 1}}};  // y = x^2, radius 1/2 at its vertex
  const auto circle = osculatingCircle(jetAt(parabola, 0.5), 1.0);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, 0.5, 1e-15);
  EXPECT_NEAR((circle->centre - Vec2(0.0, 0.5)).norm(), 0.0, 1e-15);
  EXPECT_FALSE(osculatingCircle(jetAt(parabola, 0.5), 0.49));
}

TEST(ScreenTurn, IsTheDifferenceQuotientOfTheNormal) {
  Random random(announcedSeed("ScreenTurn", 3002));
  int checked = 0;
  for (int i = 0; i < 200; ++i) {
    const Bezier curve = randomCurve(random);
    const ViewFrame view = frameOf({uniform(random, -180.0, 180.0), std::nullopt});
    const double t = uniform(random, 0.1, 0.9);
    const int side = i % 2 == 0 ? 1 : -1;
    const Jet jet = jetAt(curve, t);
    const Terms terms = termsAt(jet, view, side);
    if (std::abs(terms.nw) < 0.2 || jet.d1.norm() < 0.3) continue;
    constexpr double h = 1e-5;
    const auto normal = [&](double s) { return frameOf(jetAt(curve, s), side).normal; };
    const Vec2 turn = (normal(t + h) - normal(t - h)) /
                      (pointAt(curve, t + h) - pointAt(curve, t - h)).dot(view.axis);
    // Its component along the screen is k, its size that of dn/di; the sign is that of k.
    EXPECT_NEAR(turn.dot(view.axis), terms.k, 1e-4 * (1.0 + std::abs(terms.k)));
    ASSERT_TRUE(screenTurnAt(terms));
    EXPECT_NEAR(std::abs(*screenTurnAt(terms)), turn.norm(), 1e-4 * (1.0 + turn.norm()));
    EXPECT_GE(*screenTurnAt(terms) * terms.k, 0.0);
    EXPECT_NEAR(*lambdaAt(terms), turn.squaredNorm(), 1e-3 * (1.0 + turn.squaredNorm()));
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(ProbeValues, HaveNoneWhereTheyAreInfinite) {
  // y = x^2 seen along x: a silhouette at its vertex, which is also its ridge.
  const Jet vertex = jetAt(Bezier{{{-1, 1}, {0, -1}, {1, 1}}}, 0.5);
  const Terms aside = termsAt(vertex, frameOf({0.0, std::nullopt}), 1);
  EXPECT_FALSE(lambdaAt(aside));
  EXPECT_FALSE(screenTurnAt(aside));
  EXPECT_FALSE(termRatioAt(aside, 2.0));
  const Terms headOn = termsAt(vertex, frameOf({90.0, std::nullopt}), 1);
  EXPECT_NEAR(*lambdaAt(headOn), 4.0, 1e-14);
  EXPECT_NEAR(*screenTurnAt(headOn), headOn.k, 1e-14);
  EXPECT_FALSE(termRatioAt(headOn, 2.0)) << "k is extreme: the feature term is 0";
  const Terms beside =
      termsAt(jetAt(Bezier{{{-1, 1}, {0, -1}, {1, 1}}}, 0.75), frameOf({90.0, std::nullopt}), 1);
  EXPECT_NEAR(*termRatioAt(beside, 2.0), 1.0 / 3.0, 1e-14);  // a parabola's, everywhere
  const Terms straight =
      termsAt(jetAt(Bezier{{{0, 0}, {1, 2}}}, 0.5), frameOf({0.0, std::nullopt}), 1);
  EXPECT_FALSE(termRatioAt(straight, 2.0));
  EXPECT_EQ(*lambdaAt(straight), 0.0);
}

TEST(CurvatureComb, TeethAreEvenlySpacedAndPointAwayFromTheCentre) {
  Random random(announcedSeed("CurvatureComb", 3003));
  const Bezier bezier = randomCurve(random);
  const Curve curve{BezierChain(bezier)};
  const double length = arcLength(curve, 0.0, 1.0, 1e-10).value;
  constexpr double scale = 0.01;
  const auto combs = curvatureComb(curve, length / 40.0, scale, kNoLimit);
  ASSERT_EQ(combs.size(), 1u);
  ASSERT_EQ(combs[0].size(), 41u);
  double u = 0.0, last = 0.0;
  for (std::size_t i = 0; i < combs[0].size(); ++i) {
    const CombTooth& tooth = combs[0][i];
    const Nearest at = nearestPoint(curve, tooth.foot);
    EXPECT_LT(at.distance, 1e-12);
    u += arcLength(curve, last, at.t, 1e-10).value;
    last = at.t;
    EXPECT_NEAR(u, length * static_cast<double>(i) / 40.0, 1e-3 * length);
    const auto circle = osculatingCircle(jetAt(curve, at.t), kNoLimit);
    ASSERT_TRUE(circle);
    EXPECT_NEAR((tooth.tip - tooth.foot).norm() * circle->radius, scale, 1e-6 * scale);
    EXPECT_NEAR((tooth.tip - circle->centre).norm(),
                circle->radius + (tooth.tip - tooth.foot).norm(), 1e-6 * circle->radius);
  }
}

TEST(CurvatureComb, IsBoundedAndBreaksAtJoints) {
  const BezierChain chain(2, false, {{-2, 0}, {-1, 0}, {0, 0}, {0.5, 0}, {1, 1}});
  const auto combs = curvatureComb(Curve{chain}, 0.1, 1.0, 0.5);
  ASSERT_EQ(combs.size(), 2u);
  EXPECT_NEAR((combs[0].back().tip - combs[0].back().foot).norm(), 0.0, 1e-15);
  EXPECT_NEAR((combs[1].front().tip - combs[1].front().foot).norm(), 0.5, 1e-15);  // k = 2, cut
  EXPECT_LE(curvatureComb(Curve{chain}, 1e-9, 1.0, 1.0)[0].size(), 2001u);
  EXPECT_TRUE(curvatureComb(Curve{BezierChain(Bezier{{{1, 1}, {1, 1}}})}, 0.1, 1.0, 1.0).empty());
}

}  // namespace
}  // namespace flatland
