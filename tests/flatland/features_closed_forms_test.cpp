// SPDX-License-Identifier: GPL-3.0-or-later
// Closed forms. Curves that are no polynomials are fitted by Beziers of degree 16 to 20 on an
// interval short enough that the fit is exact to rounding; what remains is the rounding of its
// control points (1e-16), which the third derivative magnifies by about degree^3 / width^3: some
// 1e-11 in place.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flatland/features/features.h"
#include "tests/support/fitted_bezier.h"

namespace flatland::test {
namespace {

constexpr double kPlace = 1e-10;

Scene sceneOf(const Bezier& curve, double angleDeg) {
  return Scene{.curves = {SceneCurve{.shape = BezierChain(curve), .flipNormal = false}},
               .view = {.angleDeg = angleDeg, .distance = {}}};
}

std::vector<Mark> marksOf(const FeatureSet& found, std::initializer_list<MarkKind> kinds) {
  std::vector<Mark> marks;
  for (const Mark& mark : found.marks) {
    if (std::count(kinds.begin(), kinds.end(), mark.kind)) marks.push_back(mark);
  }
  return marks;
}

Bezier graph(const PreciseFunction& f, double low, double high) {
  return fittedBezier([](const Precise& x) { return x; }, f, low, high, 16);
}

TEST(ClosedForms, SineSeenObliquely) {
  const Bezier sine = graph([](const Precise& x) { return sin(2 * x) / 2; }, 0.45, 1.0);
  const double places[][2] = {{15, 0.739422981666}, {30, 0.67229729362}, {40, 0.534538108401}};
  for (const auto& [obliqueDeg, x] : places) {
    // w = (sin p, cos p)
    const FeatureSet found = findFeatures(sceneOf(sine, 90.0 - obliqueDeg));
    EXPECT_TRUE(found.complete());
    const auto ridges = marksOf(found, {MarkKind::ApparentRidge});
    ASSERT_EQ(ridges.size(), 1u) << obliqueDeg;
    EXPECT_NEAR(ridges[0].point.x(), x, kPlace) << obliqueDeg;
    // The crest itself does not move.
    const auto crest = marksOf(found, {MarkKind::Ridge});
    ASSERT_EQ(crest.size(), 1u);
    EXPECT_NEAR(crest[0].point.x(), std::numbers::pi / 4, kPlace);
    EXPECT_NEAR(*crest[0].lambda, 4.0 / std::pow(std::cos(obliqueDeg * std::numbers::pi / 180), 2),
                1e-8);
  }
}

TEST(ClosedForms, GaussianBump) {
  const double places[][3] = {{1.0, 1.8294353933636, 1.8738477201948},
                              {2.0, 2.004241986613, 2.0977024939058},
                              {0.5, 1.7595430126626, 1.7730636181997}};
  for (const auto& [height, apparent, ridge] : places) {
    const double h = height;
    const Bezier bump = graph([h](const Precise& x) { return h * exp(-x * x / 2); }, 1.5, 2.3);
    const FeatureSet found = findFeatures(sceneOf(bump, 90.0));
    EXPECT_TRUE(found.complete());
    const auto ridges = marksOf(found, {MarkKind::ApparentRidge});
    ASSERT_EQ(ridges.size(), 1u) << h;
    EXPECT_NEAR(ridges[0].point.x(), apparent, kPlace) << h;
    EXPECT_NEAR(*ridges[0].screen, apparent, kPlace) << h;
    // Hollow towards the viewer: an extremum of the curvature with k < 0.
    const auto valleys = marksOf(found, {MarkKind::Valley});
    ASSERT_EQ(valleys.size(), 1u) << h;
    EXPECT_NEAR(valleys[0].point.x(), ridge, kPlace) << h;
    // lambda = f''^2 / (1 + f'^2)^2, with f' = -x f and f'' = (x^2 - 1) f.
    const double x = apparent, f = h * std::exp(-x * x / 2);
    const double lambda = std::pow((x * x - 1) * f / (1 + x * x * f * f), 2);
    EXPECT_NEAR(*ridges[0].lambda, lambda, 1e-9 * lambda);
  }
}

// (a cos t, b sin t) around the tip that faces the viewer.
Bezier ellipse(const Precise& a, const Precise& b, double halfAngle) {
  const Precise top = boost::math::constants::half_pi<Precise>();
  return fittedBezier([a](const Precise& t) { return a * cos(t); },
                      [b](const Precise& t) { return b * sin(t); }, top - halfAngle,
                      top + halfAngle, 20);
}

TEST(ClosedForms, EllipseTipIsAnApparentRidgeBeyondItsBifurcation) {
  const double critical = std::sqrt(1.5);
  for (const double ratio : {critical * 0.8, critical * 0.99, critical * 0.999, critical * 1.001,
                             critical * 1.01, 1.3, 1.5}) {
    const FeatureSet found = findFeatures(sceneOf(ellipse(1, ratio, 0.9), 90.0));
    EXPECT_TRUE(found.complete()) << ratio;
    const auto ridges = marksOf(found, {MarkKind::ApparentRidge});
    const auto minima = marksOf(found, {MarkKind::ApparentMinimum});
    if (ratio < critical) {
      EXPECT_EQ(ridges.size(), 0u) << ratio;
      ASSERT_EQ(minima.size(), 1u) << ratio;
      // Near the bifurcation the place is soft: its stiffness falls with the distance from it.
      EXPECT_NEAR(minima[0].point.x(), 0.0, kPlace / (critical - ratio)) << ratio;
    } else {
      ASSERT_EQ(ridges.size(), 1u) << ratio;
      EXPECT_NEAR(ridges[0].point.x(), 0.0, kPlace / (ratio - critical)) << ratio;
      EXPECT_NEAR(*ridges[0].lambda, ratio * ratio, 1e-9);
      EXPECT_NEAR(*ridges[0].offset, 0.0, 1e-9);
      ASSERT_EQ(minima.size(), 2u) << ratio;
      const double sinSq = ratio * ratio / (3.0 * (ratio * ratio - 1.0));
      for (const Mark& minimum : minima) {
        EXPECT_NEAR(std::abs(minimum.point.x()), std::sqrt(1.0 - sinSq),
                    kPlace / (ratio - critical))
            << ratio;
      }
    }
    // The tip is the curvature's own extremum for every ratio but 1: a ridge if the ellipse is
    // slim.
    const auto extrema = marksOf(found, {MarkKind::Ridge, MarkKind::Flat});
    ASSERT_EQ(extrema.size(), 1u) << ratio;
    EXPECT_EQ(extrema[0].kind, ratio > 1.0 ? MarkKind::Ridge : MarkKind::Flat);
  }
}

TEST(ClosedForms, CircleHasOneMinimumFacingTheViewer) {
  for (const double radius : {1.0, 2.5}) {
    for (const double obliqueDeg : {0.0, 10.0, -25.0}) {
      const FeatureSet found =
          findFeatures(sceneOf(ellipse(radius, radius, 0.9), 90.0 + obliqueDeg));
      EXPECT_TRUE(
          marksOf(found, {MarkKind::ApparentRidge, MarkKind::Silhouette, MarkKind::Inflection})
              .empty());
      const auto minima = marksOf(found, {MarkKind::ApparentMinimum});
      ASSERT_EQ(minima.size(), 1u);
      EXPECT_NEAR(std::atan2(-minima[0].point.x(), minima[0].point.y()) * 180 / std::numbers::pi,
                  obliqueDeg, 1e-8);
      EXPECT_NEAR(*minima[0].lambda, 1 / (radius * radius), 1e-10);
    }
  }
}

TEST(ClosedForms, ParabolaIsExact) {
  for (const double a : {0.25, 1.0, 3.0}) {
    const FeatureSet found = findFeatures(sceneOf(Bezier{{{-1, a}, {0, -a}, {1, a}}}, 90.0));
    EXPECT_TRUE(found.complete());
    ASSERT_EQ(found.marks.size(), 2u);
    const auto ridges = marksOf(found, {MarkKind::ApparentRidge});
    const auto valleys = marksOf(found, {MarkKind::Valley});  // hollow towards the viewer
    ASSERT_EQ(ridges.size(), 1u);
    ASSERT_EQ(valleys.size(), 1u);
    EXPECT_EQ(ridges[0].t, 0.5);
    EXPECT_EQ(valleys[0].t, 0.5);
    EXPECT_EQ(ridges[0].point, Vec2(0, 0));
    EXPECT_EQ(*ridges[0].offset, 0.0);
    EXPECT_EQ(*ridges[0].feature, 0.0);
    EXPECT_DOUBLE_EQ(*ridges[0].lambda, 4 * a * a);
    EXPECT_TRUE(ridges[0].visible);
  }
}

// Seen at the lean 2q / (1 + 3 q^2) = tan(lean) from its axis, the parabola y = x^2 has its
// apparent ridge at slope q < 1/sqrt(3); beyond 30 degrees there is none.
TEST(ClosedForms, LeaningParabolaLosesItsRidgeAtThirtyDegrees) {
  const Bezier parabola{{{-1, 1}, {0, -1}, {1, 1}}};
  for (const double leanDeg : {5.0, 20.0, 29.9, 30.1, 40.0}) {
    const auto ridges =
        marksOf(findFeatures(sceneOf(parabola, 90.0 + leanDeg)), {MarkKind::ApparentRidge});
    ASSERT_EQ(ridges.size(), leanDeg < 30.0 ? 1u : 0u) << leanDeg;
    if (ridges.empty()) continue;
    const double T = std::tan(leanDeg * std::numbers::pi / 180);
    const double q = (1.0 - std::sqrt(1.0 - 3.0 * T * T)) / (3.0 * T);
    EXPECT_NEAR(std::abs(ridges[0].point.x()), 0.5 * q, 1e-12) << leanDeg;
  }
}

// (3.13) as printed does not vanish at the marks; the corrected sum does.
TEST(ClosedForms, PrintedSignsFailAtTrueRidges) {
  const Bezier sine = graph([](const Precise& x) { return sin(2 * x) / 2; }, 0.45, 1.0);
  for (const double obliqueDeg : {15.0, 30.0, 40.0}) {
    const auto ridges =
        marksOf(findFeatures(sceneOf(sine, 90.0 - obliqueDeg)), {MarkKind::ApparentRidge});
    ASSERT_EQ(ridges.size(), 1u);
    const double feature = *ridges[0].feature, offset = *ridges[0].offset;
    EXPECT_NEAR(feature + offset, 0.0, 1e-9 * std::abs(offset));
    EXPECT_GT(std::abs(-feature + offset), 1.9 * std::abs(offset));
    EXPECT_GT(std::abs(offset), 0.1);
  }
}

}  // namespace
}  // namespace flatland::test
