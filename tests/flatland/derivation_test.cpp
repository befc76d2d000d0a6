// SPDX-License-Identifier: GPL-3.0-or-later
// The derivation step by step: left sides differentiated from their definitions, right sides by the
// formulas, difference quotients of the curve evaluated anew, and the misprints of the thesis.
#include "flatland/study/derivation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flatland/features/orientation.h"
#include "flatland/features/terms.h"
#include "flatland/scene/scene.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Step = DerivationStep;

// Both sides are some hundred rounded operations, and the residual accounts for what cancels; the
// largest seen over all places below is 6e-16.
constexpr double kRounding = 1e-14;

std::vector<Step> allSteps() {
  std::vector<Step> steps;
  for (int i = 0; i < kDerivationStepCount; ++i) steps.push_back(static_cast<Step>(i));
  return steps;
}

DerivationPlace placeOn(const SceneCurve& curve, double t, const View& view) {
  const ViewFrame frame = frameOf(view);
  return {curve.shape, t, frame, normalSide(curve, frame)};
}

// Random open curves of 5 points in the unit square and closed cubic chains, seen from anywhere.
SceneCurve randomCurve(Random& random) {
  const int points = uniformInt(random, 4, 6);
  std::vector<Vec2> list;
  for (int i = 0; i < points; ++i) list.emplace_back(uniform(random, 0, 1), uniform(random, 0, 1));
  if (points == 6) return {BezierChain(3, true, list)};
  return {BezierChain(Bezier{list}), uniformInt(random, 0, 1) == 1};
}

std::vector<std::pair<SceneCurve, View>> manyCurves(Random& random) {
  std::vector<std::pair<SceneCurve, View>> curves;
  for (const Preset& preset : presets()) {
    for (const SceneCurve& curve : preset.scene.curves) {
      for (double turn : {0.0, 37.0, 90.0, 161.0, 251.0}) {
        View view = preset.scene.view;
        view.angleDeg += turn;
        view.distance.reset();
        curves.emplace_back(curve, view);
      }
    }
  }
  for (int i = 0; i < 150; ++i) {
    const SceneCurve curve = randomCurve(random);
    curves.emplace_back(curve, View{uniform(random, -180, 180), std::nullopt});
  }
  return curves;
}

double largest(const StepValue& v) {
  double most = 0.0;
  for (int i = 0; i < v.count(); ++i) {
    most = std::max(most, std::abs(v.entries[static_cast<std::size_t>(i)]));
  }
  return most;
}

double medianOf(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
  return v[v.size() / 2];
}

TEST(Derivation, CorrectedStepsHoldToRoundingAndPrintedOnesAreOff) {
  Random random(announcedSeed("Derivation", 20));
  const auto curves = manyCurves(random);
  for (const Step step : allSteps()) {
    const DerivationStepText& text = textOf(step);
    int evaluated = 0, nonzero = 0, wrong = 0;
    double worst = 0.0;
    std::vector<double> off;
    for (const auto& [curve, view] : curves) {
      const double end = pieceCount(curve.shape);
      for (int i = 0; i < 23; ++i) {
        const double t = end * (i + 0.37) / 23.0;
        const StepReading reading = readStep(step, placeOn(curve, t, view));
        if (!reading.corrected) continue;
        ++evaluated;
        worst = std::max(worst, reading.corrected->residual);
        if (!(reading.corrected->residual < kRounding)) ++wrong;
        if (largest(reading.corrected->left) > 1e-9) ++nonzero;
        ASSERT_EQ(reading.printed.has_value(), text.isMisprinted()) << text.id;
        if (reading.printed) off.push_back(reading.printed->apart);
      }
    }
    EXPECT_EQ(wrong, 0) << text.id << " worst residual " << worst;
    EXPECT_GT(evaluated, 4000) << text.id;
    // A flipped sign shows only where a side is not 0.
    if (step != Step::Eq3_1) {
      EXPECT_GT(nonzero, evaluated * 9 / 10) << text.id;
    }
    if (text.isMisprinted()) {
      const double median = medianOf(off);
      std::cout << text.id << ": printed off by " << median << " (median), corrected by " << worst
                << " at most\n";
      EXPECT_GT(median, 0.1) << text.id;
      const auto holds = std::count_if(off.begin(), off.end(), [](double r) { return r < 1e-6; });
      EXPECT_LT(holds, static_cast<std::ptrdiff_t>(off.size()) / 100) << text.id;
    }
  }
}

// The definition, by difference quotients of order 2 down to rounding; as printed they never come
// near.
TEST(Derivation, DifferenceQuotientsConvergeWithOrderTwo) {
  Random random(announcedSeed("Derivation.Quotients", 21));
  for (const Step step : allSteps()) {
    if (step == Step::Eq3_2 || step == Step::Eq3_1) continue;
    const DerivationStepText& text = textOf(step);
    std::vector<double> best, orders, bestPrinted;
    for (int n = 0; n < 60; ++n) {
      const SceneCurve curve = randomCurve(random);
      const double t = (n % 7 == 0) ? 0.0 : uniform(random, 0.2, 0.8);  // one-sided at the end too
      const auto sweep =
          stepSizeSweep(step, placeOn(curve, t, {uniform(random, -180, 180), std::nullopt}));
      if (sweep.empty()) continue;
      const auto least =
          std::min_element(sweep.begin(), sweep.end(),
                           [](const auto& a, const auto& b) { return a.corrected < b.corrected; });
      best.push_back(least->corrected);
      // Slope over a decade, a decade and a half before rounding takes over.
      const auto at = least - sweep.begin();
      if (at >= 8) {
        orders.push_back(std::log10(sweep[static_cast<std::size_t>(at - 7)].corrected /
                                    sweep[static_cast<std::size_t>(at - 4)].corrected));
      }
      if (text.isMisprinted()) {
        double least2 = 1e300;
        for (const StepDifference& d : sweep) least2 = std::min(least2, d.printed.value());
        bestPrinted.push_back(least2);
      }
      // Rounding takes over in the end, with slope -1: a billion times smaller is worse again.
      EXPECT_GT(sweep.back().corrected, least->corrected) << text.id;
    }
    ASSERT_GT(orders.size(), 30u) << text.id;
    EXPECT_LT(medianOf(best), 1e-8) << text.id;
    EXPECT_NEAR(medianOf(orders), 2.0, 0.15) << text.id;
    if (text.isMisprinted()) {
      EXPECT_GT(medianOf(bestPrinted), 0.02) << text.id;
    }
  }
}

// Rounding rises with slope -1 as steps shrink.
TEST(Derivation, RoundingRisesWithSlopeMinusOne) {
  const SceneCurve& curve = defaultScene().curves[0];
  for (const Step step : {Step::Eq3_7, Step::Eq3_10, Step::Eq4_7, Step::CurveForm}) {
    std::vector<double> small, large;  // rounding is erratic: medians over many places
    for (int i = 0; i < 41; ++i) {
      const auto sweep = stepSizeSweep(step, placeOn(curve, 0.2 + 0.014 * i, {20.0, {}}));
      ASSERT_EQ(sweep.size(), 37u);
      small.push_back(sweep[33].corrected);
      large.push_back(sweep[27].corrected);
    }
    EXPECT_NEAR(std::log10(medianOf(small) / medianOf(large)), 2.0, 0.5) << textOf(step).id;
  }
}

// The sides of (3.13) are the terms that marks are found with.
TEST(Derivation, TheEquationIsThatOfTheMarks) {
  Random random(announcedSeed("Derivation.Terms", 22));
  for (int n = 0; n < 200; ++n) {
    const SceneCurve curve = randomCurve(random);
    const DerivationPlace place =
        placeOn(curve, uniform(random, 0.0, 1.0), {uniform(random, -180, 180), std::nullopt});
    const Terms terms = termsAt(jetAt(curve.shape, place.t), place.view, place.side);
    const StepReading reading = readStep(Step::Eq3_13, place);
    ASSERT_TRUE(reading.corrected);
    const double walk = -place.side;
    const double size = std::abs(terms.feature) + std::abs(terms.offset);
    EXPECT_NEAR(reading.corrected->right.entries[0], walk * terms.sum(), 1e-12 * size);
    EXPECT_NEAR(reading.printed->right.entries[0], walk * (-terms.feature + terms.offset),
                1e-12 * size);
    // D_tA lambda is taken per screen step in the direction of r = sign(k) / |n.w|.
    const StepReading curveForm = readStep(Step::CurveForm, place);
    const double r = (terms.k < 0.0 ? -1.0 : 1.0) / std::abs(terms.nw);
    EXPECT_NEAR(curveForm.corrected->right.entries[0], walk * terms.sum() * r * r * r / terms.nw,
                1e-11 * size * std::abs(r * r * r / terms.nw));
  }
}

TEST(Derivation, PerspectiveHasItsTermInTheLastForm) {
  Random random(announcedSeed("Derivation.Perspective", 23));
  double smallestTerm = 1e300;
  for (int n = 0; n < 300; ++n) {
    const SceneCurve curve = randomCurve(random);
    const View view{uniform(random, -180, 180), uniform(random, 2.0, 4.0)};
    for (const Step step : allSteps()) {
      const DerivationPlace place = placeOn(curve, uniform(random, 0.0, 1.0), view);
      const StepReading reading = readStep(step, place);
      ASSERT_TRUE(reading.corrected) << textOf(step).id;
      EXPECT_LT(reading.corrected->residual, kRounding) << textOf(step).id;
      if (step == Step::CurveForm) {
        const Terms terms = termsAt(jetAt(curve.shape, place.t), place.view, place.side);
        smallestTerm = std::min(smallestTerm, std::abs(terms.perspective / terms.sum()));
      }
    }
  }
  EXPECT_GT(smallestTerm, 0.0);
}

// The misprint of (4.7) leaves out a part as large as the one it has, and the sheet shows both.
TEST(Derivation, TheSheetTurnsBothWays) {
  const SceneCurve& curve = defaultScene().curves[0];
  std::vector<double> ratios;
  for (int i = 1; i < 40; ++i) {
    const StepReading reading = readStep(Step::Eq4_7, placeOn(curve, i / 40.0, {15.0, {}}));
    ASSERT_TRUE(reading.corrected);
    ASSERT_TRUE(reading.printed);
    ratios.push_back(largest(reading.printed->left) / largest(reading.corrected->left));
    // What is printed turns in the plane; what is left out, out of it. Neither is nothing.
    EXPECT_GT(largest(reading.corrected->left), 1e-3);
  }
  EXPECT_GT(medianOf(ratios), 0.1);
  EXPECT_LT(medianOf(ratios), 10.0);
}

TEST(Derivation, SilhouetteCuspAndInflectionHaveTheirAnswers) {
  // A parabola head-on at its tip is seen edge-on from the side.
  const SceneCurve parabola{BezierChain(Bezier{{{-1, 1}, {0, -1}, {1, 1}}})};
  for (const Step step : allSteps()) {
    const StepReading side = readStep(step, placeOn(parabola, 0.5, {0.0, {}}));
    if (step == Step::Eq3_5) {
      EXPECT_EQ(side.answer, StepAnswer::Evaluated) << "dn/du does not know the view";
      continue;
    }
    EXPECT_EQ(side.answer, StepAnswer::Silhouette) << textOf(step).id;
    EXPECT_FALSE(side.corrected || side.printed);
    EXPECT_TRUE(stepSizeSweep(step, placeOn(parabola, 0.5, {0.0, {}})).empty());
  }
  const SceneCurve cusp{BezierChain(Bezier{{{-1, 0}, {1, 1}, {-1, 1}, {1, 0}}})};
  for (const Step step : allSteps()) {
    const StepReading reading = readStep(step, placeOn(cusp, 0.5, {90.0, {}}));
    EXPECT_EQ(reading.answer, StepAnswer::NoTangent) << textOf(step).id;
    EXPECT_FALSE(reading.corrected || reading.printed);
  }
  // The cubic through its own centre: k = 0 there, exactly.
  const SceneCurve inflected{BezierChain(Bezier{{{-3, -1}, {-1, 2}, {1, -2}, {3, 1}}})};
  for (const Step step : allSteps()) {
    const DerivationPlace place = placeOn(inflected, 0.5, {70.0, {}});
    const StepReading reading = readStep(step, place);
    ASSERT_TRUE(reading.corrected) << textOf(step).id;
    EXPECT_LT(reading.corrected->residual, kRounding) << textOf(step).id;
    for (const double e : reading.corrected->right.entries) EXPECT_TRUE(std::isfinite(e));
    for (const StepDifference& d : stepSizeSweep(step, place)) {
      EXPECT_TRUE(std::isfinite(d.corrected)) << textOf(step).id;
    }
  }
  EXPECT_EQ(readStep(Step::Eq3_13, placeOn(inflected, 0.5, {70.0, {}})).corrected->right.entries[0],
            0.0);
}

// Both sides turn with the scene, and their residuals do not change with its size.
TEST(Derivation, ScalingChangesValuesByTheirDimensionOnly) {
  const std::vector<Vec2> points{{0, 0}, {1, 2}, {3, -1}, {4, 1}};
  for (const double scale : {1e-6, 1e6}) {
    std::vector<Vec2> scaled;
    for (const Vec2& p : points) scaled.push_back(scale * p);
    const SceneCurve a{BezierChain(Bezier{points})}, b{BezierChain(Bezier{scaled})};
    for (const Step step : allSteps()) {
      const auto ra = readStep(step, placeOn(a, 0.31, {50.0, {}}));
      const auto rb = readStep(step, placeOn(b, 0.31, {50.0, {}}));
      EXPECT_LT(rb.corrected->residual, kRounding) << textOf(step).id;
      if (!ra.printed) continue;
      // (4.7) divides C by a difference of squared curvatures: as printed its units are wrong.
      const bool mixesUnits = step == Step::Eq4_7 || step == Step::Eq4_8;
      const double change = rb.printed->apart / ra.printed->apart;
      if (mixesUnits) {
        EXPECT_GT(std::abs(change - 1.0), 1e-3) << textOf(step).id;
      } else {
        EXPECT_NEAR(change, 1.0, 1e-6) << textOf(step).id;
      }
    }
    // lambda' is 1/length^3.
    const double la =
        readStep(Step::Eq3_12, placeOn(a, 0.31, {50.0, {}})).corrected->left.entries[0];
    const double lb =
        readStep(Step::Eq3_12, placeOn(b, 0.31, {50.0, {}})).corrected->left.entries[0];
    EXPECT_NEAR(lb * scale * scale * scale / la, 1.0, 1e-9);
  }
}

TEST(Derivation, NamesAreUniqueAndKnown) {
  for (const Step step : allSteps()) EXPECT_EQ(derivationStepNamed(textOf(step).id), step);
  EXPECT_FALSE(derivationStepNamed("3.14"));
}

}  // namespace
}  // namespace flatland::test
