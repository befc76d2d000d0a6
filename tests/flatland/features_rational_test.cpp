// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of rational Beziers: against those of the curves they are, and against samples.
#include <gtest/gtest.h>

#include <cmath>

#include "flatland/features/terms.h"
#include "tests/support/found_marks.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

// A rational quadratic that is exactly a quarter of a circle against the circle, and a rational
// curve of equal weights against the Bezier curve it is.
TEST(RationalMarks, EqualWeightsGiveTheMarksOfTheBezierCurve) {
  Random random(announcedSeed("EqualWeights", 61));
  for (int round = 0; round < 100; ++round) {
    const int degree = uniformInt(random, 2, 5);
    std::vector<Vec2> points;
    for (int i = 0; i <= degree; ++i) {
      points.emplace_back(uniform(random, 0.0, 1.0), uniform(random, 0.0, 1.0));
    }
    const double angle = uniform(random, -180.0, 180.0);
    const FeatureSet exact = findFeatures(sceneOf(BezierChain(Bezier{points}), angle));
    const FeatureSet found = findFeatures(sceneOf(
        RationalBezier(degree, false, points, std::vector<double>(points.size(), 2.0)), angle));
    ASSERT_TRUE(found.complete()) << round << said(found);
    ASSERT_EQ(found.marks.size(), exact.marks.size()) << round << said(found) << said(exact);
    for (std::size_t i = 0; i < exact.marks.size(); ++i) {
      EXPECT_EQ(found.marks[i].kind, exact.marks[i].kind) << round;
      EXPECT_NEAR(found.marks[i].t, exact.marks[i].t, 1e-8) << round;
      EXPECT_EQ(found.marks[i].visible, exact.marks[i].visible) << round << " " << i;
    }
  }
}

TEST(RationalMarks, ExactCircleOfFourPiecesIsACircle) {
  const double w = std::sqrt(0.5);
  const RationalBezier circle(
      2, true, {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}},
      {1, w, 1, w, 1, w, 1, w});
  const FeatureSet found = findFeatures(sceneOf(circle, 70.0));
  EXPECT_TRUE(found.complete()) << said(found);
  EXPECT_EQ(found.degenerate.size(), 4u);
  EXPECT_EQ(found.marks.size(), 4u) << said(found);
  EXPECT_EQ(marksOf(found, {MarkKind::Silhouette}).size(), 2u);
  EXPECT_EQ(marksOf(found, {MarkKind::ApparentMinimum}).size(), 2u);
}

// Random weights against sign changes of the terms at 4,000 samples: other formulas, no roots.
TEST(RationalMarks, AgreeWithSignChangesOfTheTermsOnRandomCurves) {
  Random random(announcedSeed("RationalAgainstSamples", 62));
  constexpr int kSamples = 4000;
  int compared = 0;
  for (int round = 0; round < 150; ++round) {
    const int degree = uniformInt(random, 2, 5);
    std::vector<Vec2> points;
    std::vector<double> weights;
    for (int i = 0; i <= degree; ++i) {
      points.emplace_back(uniform(random, 0.0, 1.0), uniform(random, 0.0, 1.0));
      weights.push_back(std::exp(uniform(random, -1.5, 1.5)));
    }
    Scene scene = sceneOf(RationalBezier(degree, false, points, weights), 0.0);
    scene.view.angleDeg = uniform(random, -180.0, 180.0);
    if (round % 3 == 0) scene.view.distance = uniform(random, 2.0, 5.0);
    const FeatureSet found = findFeatures(scene);
    ASSERT_TRUE(found.complete()) << round << said(found);
    // Roots that the samples cannot part are left out.
    bool crowded = false;
    for (std::size_t i = 1; i < found.marks.size(); ++i) {
      crowded = crowded || found.marks[i].t - found.marks[i - 1].t < 2.0 / kSamples;
    }
    if (crowded) continue;
    ++compared;
    const ViewFrame frame = frameOf(scene.view);
    std::vector<Terms> terms;
    for (int i = 1; i < kSamples; ++i) {
      terms.push_back(
          termsAt(jetAt(scene.curves[0].shape, static_cast<double>(i) / kSamples), frame, 1));
    }
    std::size_t silhouettes = 0, inflections = 0, extrema = 0, ridges = 0, minima = 0;
    for (std::size_t i = 1; i < terms.size(); ++i) {
      const Terms &a = terms[i - 1], &b = terms[i];
      const bool folds = a.nw * b.nw < 0.0, bends = a.k * b.k < 0.0;
      silhouettes += folds;
      inflections += bends;
      extrema += a.kPrime * b.kPrime < 0.0;
      // (n.w)^3 / 2 dlambda/du
      const double before = a.sum() * a.nw, after = b.sum() * b.nw;
      ridges += !folds && before > 0.0 && after < 0.0;
      minima += !folds && !bends && before < 0.0 && after > 0.0;
    }
    EXPECT_EQ(marksOf(found, {MarkKind::Silhouette}).size(), silhouettes) << round << said(found);
    EXPECT_EQ(marksOf(found, {MarkKind::Inflection}).size(), inflections) << round << said(found);
    EXPECT_EQ(marksOf(found, {MarkKind::Ridge, MarkKind::Valley, MarkKind::Flat}).size(), extrema)
        << round << said(found);
    EXPECT_EQ(marksOf(found, {MarkKind::ApparentRidge}).size(), ridges) << round << said(found);
    EXPECT_EQ(marksOf(found, {MarkKind::ApparentMinimum}).size(), minima) << round << said(found);
  }
  EXPECT_GE(compared, 100);
}

}  // namespace
}  // namespace flatland::test
