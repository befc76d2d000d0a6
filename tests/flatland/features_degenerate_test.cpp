// SPDX-License-Identifier: GPL-3.0-or-later
// The stated answers where the textbook formula has none (docs/math/features.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "flatland/features/features.h"
#include "tests/support/brute_marks.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

Scene sceneOf(BezierChain chain, double angleDeg) {
  return Scene{.curves = {SceneCurve{.shape = std::move(chain), .flipNormal = false}},
               .view = {.angleDeg = angleDeg, .distance = {}}};
}
Scene sceneOf(std::vector<Vec2> points, double angleDeg) {
  return sceneOf(BezierChain(Bezier{std::move(points)}), angleDeg);
}

std::vector<Mark> only(const FeatureSet& found, MarkKind kind) {
  std::vector<Mark> marks;
  std::copy_if(found.marks.begin(), found.marks.end(), std::back_inserter(marks),
               [kind](const Mark& mark) { return mark.kind == kind; });
  return marks;
}
std::size_t count(const FeatureSet& found, MarkKind kind) { return only(found, kind).size(); }

std::string listed(const FeatureSet& found) {
  std::ostringstream text;
  text.precision(17);
  for (const Mark& m : found.marks) text << '\n' << nameOf(m.kind) << " at " << m.t;
  for (const Unresolved& u : found.unresolved) {
    text << "\nunresolved " << nameOf(u.kind) << " in " << u.tLow << ", " << u.tHigh << ": "
         << u.reason;
  }
  return text.str();
}

bool allFinite(const FeatureSet& found) {
  return std::all_of(found.marks.begin(), found.marks.end(), [](const Mark& m) {
    return std::isfinite(m.t) && std::isfinite(m.u) && m.point.allFinite() &&
           std::isfinite(m.residual) && std::isfinite(m.lambda.value_or(0)) &&
           std::isfinite(m.feature.value_or(0)) && std::isfinite(m.offset.value_or(0)) &&
           std::isfinite(m.screen.value_or(0));
  });
}

TEST(FeaturesDegenerate, CuspIsACornerOf180Degrees) {
  const std::vector<Vec2> cusp{{0, 0}, {1, 1}, {0, 1}, {1, 0}};
  for (const double angle : {0.0, 37.0, 90.0, -120.0}) {
    const FeatureSet found = findFeatures(sceneOf(cusp, angle));
    const auto corners = only(found, MarkKind::Corner);
    ASSERT_EQ(corners.size(), 1u) << angle;
    EXPECT_EQ(corners[0].t, 0.5);
    EXPECT_LT((corners[0].point - Vec2(0.5, 0.75)).norm(), 1e-15);
    EXPECT_EQ(std::abs(corners[0].turnDeg), 180.0);
    EXPECT_FALSE(corners[0].lambda);
    EXPECT_TRUE(found.complete()) << angle << listed(found);
    EXPECT_TRUE(found.degenerate.empty());
    EXPECT_TRUE(allFinite(found));
    // The cusp points up: its image folds unless seen from the side where the arms spread evenly.
    const bool folds = std::abs(std::cos(angle * std::numbers::pi / 180)) > 1e-9;
    const auto silhouettes = only(found, MarkKind::Silhouette);
    const auto atCusp = std::count_if(silhouettes.begin(), silhouettes.end(),
                                      [](const Mark& m) { return m.t == 0.5; });
    if (folds) {
      EXPECT_EQ(atCusp, 1) << angle;
    }
  }
}

TEST(FeaturesDegenerate, CoincidentEndPoints) {
  Random random(announcedSeed("coincident ends", 31));
  for (int i = 0; i < 60; ++i) {
    std::vector<Vec2> points;
    for (int k = 0; k < 5; ++k) points.emplace_back(uniform(random, 0, 1), uniform(random, 0, 1));
    // One end, the other, both; three at one end; and both with a pair inside, where k stays finite
    // at the ends although the curve stops there.
    const int kind = i % 5;
    if (kind == 0 || kind == 2 || kind == 3) points[1] = points[0];
    if (kind == 1 || kind == 2 || kind == 4) points[3] = points[4];
    if (kind == 3) points[2] = points[0];
    if (kind == 4) points[2] = points[1];
    const Scene scene = sceneOf(points, uniform(random, -180, 180));
    const FeatureSet found = findFeatures(scene);
    EXPECT_TRUE(allFinite(found)) << described(scene);
    EXPECT_TRUE(found.complete()) << listed(found) << described(scene);
    EXPECT_EQ(count(found, MarkKind::Corner), 0u) << described(scene);
    EXPECT_EQ(differenceFromBrute(scene, found, 0), "") << described(scene);
    // k(0) = 0 where the first three points but the first coincide; elsewhere k is infinite or
    // finite but not 0 at the ends.
    for (const Mark& mark : found.marks) {
      if (kind == 4 && mark.kind == MarkKind::Inflection && mark.t == 0.0) continue;
      EXPECT_TRUE(mark.t > 1e-9 && mark.t < 1 - 1e-9) << listed(found) << described(scene);
    }
    if (kind == 4) {
      EXPECT_GE(count(found, MarkKind::Inflection), 1u) << listed(found) << described(scene);
    }
  }
}

TEST(FeaturesDegenerate, AllPointsCoincide) {
  for (const Vec2& p : {Vec2(0, 0), Vec2(0.3, -7.1)}) {
    const FeatureSet found = findFeatures(sceneOf(std::vector<Vec2>{p, p, p, p, p}, 12));
    EXPECT_TRUE(found.marks.empty());
    EXPECT_TRUE(found.complete());
    ASSERT_EQ(found.degenerate.size(), 1u);
    EXPECT_EQ(found.degenerate[0].what, Degenerate::What::Point);
    EXPECT_EQ(found.degenerate[0].tLow, 0.0);
    EXPECT_EQ(found.degenerate[0].tHigh, 1.0);
  }
}

TEST(FeaturesDegenerate, StraightAlsoWhenRounded) {
  const std::vector<std::vector<Vec2>> lines{
      {{0, 0}, {1, 1}},
      {{0, 0}, {0.1, 0.3}, {0.2, 0.6}},
      {{0, 0}, {0.1, 0.3}, {0.2, 0.6}, {0.7, 2.1}},
      {{-1, 2}, {-0.7, 2.3}, {0.1, 3.1}, {0.9, 3.9}, {1.1, 4.1}}};
  for (const auto& line : lines) {
    const Vec2 along = line.back() - line.front();
    const double lineDeg = std::atan2(along.y(), along.x()) * 180 / std::numbers::pi;
    for (const double aside : {90.0, 30.0, -100.0, 0.0, 180.0}) {
      const FeatureSet found = findFeatures(sceneOf(line, lineDeg + aside));
      EXPECT_TRUE(found.marks.empty()) << lineDeg << ' ' << aside;
      EXPECT_TRUE(found.complete());
      ASSERT_EQ(found.degenerate.size(), 1u);
      const bool endOn = aside == 0.0 || aside == 180.0;
      EXPECT_EQ(found.degenerate[0].what,
                endOn ? Degenerate::What::StraightEndOn : Degenerate::What::Straight)
          << lineDeg << ' ' << aside;
    }
  }
}

TEST(FeaturesDegenerate, StraightThatTurnsBack) {
  // x = -1 + 3t(1-t)... back and forth on a line: a corner of 180 degrees at the far end, a fold.
  const FeatureSet found = findFeatures(sceneOf(std::vector<Vec2>{{0, 0}, {2, 2}, {0, 0}}, 90));
  const auto corners = only(found, MarkKind::Corner);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].t, 0.5);
  EXPECT_EQ(corners[0].turnDeg, 180.0);
  EXPECT_LT((corners[0].point - Vec2(1, 1)).norm(), 1e-15);
  EXPECT_EQ(count(found, MarkKind::Silhouette), 1u);
  EXPECT_EQ(found.marks.size(), 2u);
  EXPECT_FALSE(found.degenerate.empty());
}

TEST(FeaturesDegenerate, InflectionAtAnEnd) {
  // y = x^3 for x in [0, 1]: k = 0 at the start. And the mirrored walk.
  const std::vector<Vec2> cubic{{0, 0}, {1.0 / 3, 0}, {2.0 / 3, 0}, {1, 1}};
  for (const bool backwards : {false, true}) {
    std::vector<Vec2> points = cubic;
    if (backwards) std::reverse(points.begin(), points.end());
    const FeatureSet found = findFeatures(sceneOf(points, 90));
    const auto inflections = only(found, MarkKind::Inflection);
    ASSERT_EQ(inflections.size(), 1u);
    EXPECT_EQ(inflections[0].t, backwards ? 1.0 : 0.0);
    EXPECT_EQ(inflections[0].lambda, 0.0);
    for (const MarkKind kind : {MarkKind::ApparentRidge, MarkKind::ApparentMinimum, MarkKind::Ridge,
                                MarkKind::Valley, MarkKind::Flat}) {
      for (const Mark& mark : only(found, kind))
        EXPECT_TRUE(mark.t > 1e-6 && mark.t < 1 - 1e-6) << nameOf(kind);
    }
  }
}

TEST(FeaturesDegenerate, SilhouetteAtAnInflection) {
  // y = x^3 seen along its inflection tangent: n.w touches 0 there and keeps its sign.
  const std::vector<Vec2> cubic{{-1, -1}, {-1.0 / 3, 1}, {1.0 / 3, -1}, {1, 1}};
  for (const double angle : {0.0, 180.0}) {
    const FeatureSet found = findFeatures(sceneOf(cubic, angle));
    const auto silhouettes = only(found, MarkKind::Silhouette);
    ASSERT_EQ(silhouettes.size(), 1u) << angle;
    EXPECT_NEAR(silhouettes[0].t, 0.5, 1e-15);
    EXPECT_FALSE(silhouettes[0].lambda);
    const auto inflections = only(found, MarkKind::Inflection);
    ASSERT_EQ(inflections.size(), 1u);
    EXPECT_NEAR(inflections[0].t, 0.5, 1e-15);
    EXPECT_TRUE(allFinite(found));
    // lambda = f''^2 / f'^2 ... grows towards the inflection: nothing else may be marked right
    // there.
    for (const Mark& mark : found.marks) {
      if (mark.kind == MarkKind::ApparentRidge || mark.kind == MarkKind::ApparentMinimum) {
        EXPECT_GT(std::abs(mark.t - 0.5), 1e-3);
      }
    }
  }
}

TEST(FeaturesDegenerate, FoldedSymmetrically) {
  // The screen coordinate -1, 2, -2, 1: two silhouettes placed evenly.
  const FeatureSet found =
      findFeatures(sceneOf(std::vector<Vec2>{{-1, 0}, {2, 1}, {-2, 2}, {1, 3}}, 90));
  const auto silhouettes = only(found, MarkKind::Silhouette);
  ASSERT_EQ(silhouettes.size(), 2u);
  EXPECT_NEAR(silhouettes[0].t + silhouettes[1].t, 1.0, 1e-15);
  // The screen coordinate -1, 1, -1, 1: x' = 6 (1 - 2t)^2 touches 0.
  const FeatureSet touching =
      findFeatures(sceneOf(std::vector<Vec2>{{-1, 0}, {1, 1}, {-1, 3}, {1, 4}}, 90));
  const auto touch = only(touching, MarkKind::Silhouette);
  ASSERT_EQ(touch.size(), 1u);
  EXPECT_EQ(touch[0].t, 0.5);
  EXPECT_TRUE(touching.complete());
}

TEST(FeaturesDegenerate, UndulationIsFlatAndNoInflection) {
  // y = x^4 on [-1, 1]: k touches 0.
  std::vector<Vec2> points;
  const double y[] = {1, -1, 1, -1, 1};
  for (int i = 0; i < 5; ++i) points.emplace_back(-1 + 0.5 * i, y[i]);
  const FeatureSet found = findFeatures(sceneOf(points, 90));
  EXPECT_EQ(count(found, MarkKind::Inflection), 0u);
  EXPECT_EQ(count(found, MarkKind::Silhouette), 0u);
  const auto flats = only(found, MarkKind::Flat);
  ASSERT_EQ(flats.size(), 1u);
  EXPECT_EQ(flats[0].t, 0.5);
  const auto minima = only(found, MarkKind::ApparentMinimum);
  ASSERT_EQ(minima.size(), 1u);
  EXPECT_EQ(minima[0].t, 0.5);
  EXPECT_EQ(*minima[0].lambda, 0.0);
  // f''' (1 + f'^2) = 2 f' f''^2 with f = x^4: 24 x (1 + 16 x^6) = 8 x^3 144 x^4, x^6 = 1/32.
  const auto ridges = only(found, MarkKind::ApparentRidge);
  ASSERT_EQ(ridges.size(), 2u);
  EXPECT_NEAR(ridges[1].point.x(), std::pow(32.0, -1.0 / 6.0), 1e-14);
  EXPECT_NEAR(ridges[0].point.x(), -std::pow(32.0, -1.0 / 6.0), 1e-14);
  EXPECT_TRUE(found.complete());
}

TEST(FeaturesDegenerate, SquareHasFourCornersAndTwoSilhouettes) {
  for (const bool clockwise : {false, true}) {
    std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    if (clockwise) std::reverse(square.begin(), square.end());
    for (const double angle : {30.0, 100.0, -70.0, 200.0}) {
      const FeatureSet found = findFeatures(sceneOf(BezierChain(1, true, square), angle));
      const auto corners = only(found, MarkKind::Corner);
      ASSERT_EQ(corners.size(), 4u) << angle;
      for (const Mark& corner : corners)
        EXPECT_NEAR(corner.turnDeg, clockwise ? -90.0 : 90.0, 1e-12);
      const auto silhouettes = only(found, MarkKind::Silhouette);
      ASSERT_EQ(silhouettes.size(), 2u) << angle;
      // The outermost corners along the screen.
      const ViewFrame frame = frameOf(View{.angleDeg = angle, .distance = {}});
      double low = 1e9, high = -1e9;
      for (const Vec2& p : square) {
        low = std::min(low, p.dot(frame.axis)), high = std::max(high, p.dot(frame.axis));
      }
      std::vector<double> at{*silhouettes[0].screen, *silhouettes[1].screen};
      std::sort(at.begin(), at.end());
      EXPECT_NEAR(at[0], low, 1e-15 * 4);
      EXPECT_NEAR(at[1], high, 1e-15 * 4);
      EXPECT_EQ(found.marks.size(), 6u);
      EXPECT_EQ(found.degenerate.size(), 4u);
    }
    const FeatureSet endOn = findFeatures(sceneOf(BezierChain(1, true, square), 90));
    EXPECT_EQ(count(endOn, MarkKind::Corner), 4u);
    EXPECT_EQ(std::count_if(
                  endOn.degenerate.begin(), endOn.degenerate.end(),
                  [](const Degenerate& d) { return d.what == Degenerate::What::StraightEndOn; }),
              2);
  }
}

// A circle of n cubic arcs with the usual handles.
BezierChain circleOf(int arcs) {
  const double step = 2 * std::numbers::pi / arcs, handle = 4.0 / 3.0 * std::tan(step / 4);
  std::vector<Vec2> points;
  for (int i = 0; i < arcs; ++i) {
    const Vec2 a(std::cos(i * step), std::sin(i * step)),
        b(std::cos((i + 1) * step), std::sin((i + 1) * step));
    points.push_back(a);
    points.push_back(a + handle * rotateCcw(a));
    points.push_back(b - handle * rotateCcw(b));
  }
  return BezierChain(3, true, points);
}

TEST(FeaturesDegenerate, CirclesOfArcs) {
  for (const int arcs : {4, 8}) {
    for (const double angle : {0.0, 20.0, 90.0, 133.0}) {
      const Scene scene = sceneOf(circleOf(arcs), angle);
      const FeatureSet found = findFeatures(scene);
      EXPECT_TRUE(found.complete()) << arcs << ' ' << angle;
      EXPECT_EQ(count(found, MarkKind::Corner), 0u);
      EXPECT_EQ(count(found, MarkKind::Inflection), 0u);
      EXPECT_EQ(count(found, MarkKind::Valley), 0u);  // convex, normal outward: k > 0
      const auto silhouettes = only(found, MarkKind::Silhouette);
      ASSERT_EQ(silhouettes.size(), 2u) << arcs << ' ' << angle;
      EXPECT_NEAR(std::abs(*silhouettes[0].screen), 1.0, 3e-4);
      EXPECT_EQ(differenceFromBrute(scene, found, 0), "") << arcs << ' ' << angle;
      // Extrema of curvature alternate all the way round and every arc has the same.
      EXPECT_EQ(count(found, MarkKind::Ridge), count(found, MarkKind::Flat));
      EXPECT_EQ(count(found, MarkKind::Ridge) % static_cast<std::size_t>(arcs), 0u);
      EXPECT_GT(count(found, MarkKind::Ridge), 0u);
      // Between two silhouettes lambda comes down from infinity and goes up again.
      EXPECT_EQ(count(found, MarkKind::ApparentMinimum), count(found, MarkKind::ApparentRidge) + 2);
      for (const Mark& mark : found.marks) EXPECT_NEAR(mark.point.norm(), 1.0, 3e-4);
    }
  }
}

TEST(FeaturesDegenerate, NothingToSee) {
  EXPECT_TRUE(findFeatures(Scene{}).marks.empty());
  EXPECT_TRUE(findFeatures(Scene{}).complete());
}

TEST(FeaturesDegenerate, DefaultSceneShowsEveryKind) {
  const FeatureSet found = findFeatures(defaultScene());
  EXPECT_TRUE(found.complete());
  for (const MarkKind kind : {MarkKind::Silhouette, MarkKind::Inflection, MarkKind::Ridge,
                              MarkKind::Valley, MarkKind::ApparentRidge}) {
    EXPECT_GT(count(found, kind), 0u) << nameOf(kind);
  }
  EXPECT_FALSE(found.marks.empty());
  for (const Mark& mark : found.marks) EXPECT_LT(mark.residual, 1e-12) << nameOf(mark.kind);
  for (std::size_t i = 0; i < defaultScene().curves.size(); ++i) {
    EXPECT_EQ(differenceFromBrute(defaultScene(), found, static_cast<int>(i)), "");
  }
}

}  // namespace
}  // namespace flatland::test
