// SPDX-License-Identifier: GPL-3.0-or-later
// The sweep against marks found view by view, and against a parabola, where all of it is known.
#include "flatland/screen/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "flatland/screen/sweep_visibility.h"
#include "tests/support/fitted_bezier.h"
#include "tests/support/seed.h"

namespace {

using namespace flatland;

Scene sceneOf(std::vector<Vec2> points) { return {{{BezierChain(Bezier{std::move(points)})}}, {}}; }

// Arc lengths at which the branches of one kind pass the view angle, sorted.
std::vector<double> crossings(const Sweep& sweep, MarkKind kind, double angleDeg) {
  std::vector<double> at;
  for (const SweepBranch& branch : sweep.branches) {
    if (branch.kind != kind) continue;
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const SweepPoint &a = branch.points[i], &b = branch.points[i + 1];
      const double low = std::min(a.angleDeg, b.angleDeg), high = std::max(a.angleDeg, b.angleDeg);
      const double angle = angleDeg + 180.0 * std::ceil((low - angleDeg) / 180.0);
      if (angle < low || angle >= high) continue;
      at.push_back(a.u + (b.u - a.u) * (angle - a.angleDeg) / (b.angleDeg - a.angleDeg));
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

constexpr int kAngles = 200;

// Every mark of every view lies on a branch, and every branch is met by a mark.
void expectAgreesWithFeatures(Scene scene, double offsetDeg) {
  const Sweep sweep = sweepOf(scene);
  double nearestFold = 180.0;
  for (int i = 0; i < kAngles; ++i) {
    scene.view.angleDeg = 180.0 / kAngles * i + offsetDeg;
    // Within the sampling of a fold, two branches nearly touch and may be counted or not.
    nearestFold = 180.0;
    for (const SweepEvent& event : sweep.events) {
      if (event.what != SweepEvent::What::Fold) continue;
      nearestFold =
          std::min(nearestFold, std::abs(halfTurnDeg(event.angleDeg - scene.view.angleDeg)));
    }
    if (nearestFold < 1e-6) continue;
    const FeatureSet features = findFeatures(scene);
    for (const MarkKind kind :
         {MarkKind::Silhouette, MarkKind::ApparentRidge, MarkKind::ApparentMinimum}) {
      std::vector<double> marks;
      for (const Mark& mark : features.marks) {
        if (mark.kind == kind) marks.push_back(mark.u);
      }
      const std::vector<double> branches = crossings(sweep, kind, scene.view.angleDeg);
      ASSERT_EQ(branches.size(), marks.size()) << nameOf(kind) << " at " << scene.view.angleDeg;
      // A branch is drawn with chords of up to 1/100 of the length.
      const double length = sweep.branches.front().points.back().u + 1.0;
      for (std::size_t m = 0; m < marks.size(); ++m) {
        EXPECT_NEAR(branches[m], marks[m], 0.01 * length)
            << nameOf(kind) << " at " << scene.view.angleDeg;
      }
    }
  }
}

TEST(Sweep, AgreesWithTheMarksOfEveryViewOnTheDefaultCurve) {
  expectAgreesWithFeatures(defaultScene(), 0.3);
}

TEST(Sweep, AgreesWithTheMarksOfEveryViewOnRandomCurves) {
  flatland::test::Random random(flatland::test::announcedSeed("Sweep", 20070202));
  const auto unit = [&] { return flatland::test::uniform(random, 0.0, 1.0); };
  for (int i = 0; i < 12; ++i) {
    std::vector<Vec2> points;
    for (int j = 0; j < 5; ++j) {
      const double x = unit();
      points.emplace_back(x, unit());
    }
    SCOPED_TRACE(i);
    expectAgreesWithFeatures(sceneOf(std::move(points)), unit());
  }
}

// y = x^2: at slope q = 2 x the stationary view leans by p with tan p = 2 q / (1 + 3 q^2) from the
// axis (from the oblique form of the equation with f''' = 0), so the largest lean is 30 degrees, at
// q = 1/sqrt 3.
TEST(Sweep, ParabolaFoldsAtThirtyDegrees) {
  const Sweep sweep = sweepOf(sceneOf({{-2.0, 4.0}, {0.0, -4.0}, {2.0, 4.0}}));
  std::vector<SweepEvent> folds, headOn;
  for (const SweepEvent& event : sweep.events) {
    if (event.what == SweepEvent::What::Fold) folds.push_back(event);
    if (event.what == SweepEvent::What::HeadOn) headOn.push_back(event);
  }
  ASSERT_EQ(folds.size(), 2u);
  ASSERT_EQ(headOn.size(), 1u);
  const double x = 0.5 / std::numbers::sqrt3;
  EXPECT_NEAR(folds[0].t, (2.0 - x) / 4.0, 1e-14);
  EXPECT_NEAR(folds[1].t, (2.0 + x) / 4.0, 1e-14);
  // Slope +: the view leans towards +x, 60 degrees from the x axis.
  EXPECT_NEAR(folds[1].angleDeg, 60.0, 1e-11);
  EXPECT_NEAR(folds[0].angleDeg, -60.0, 1e-11);
  EXPECT_NEAR(headOn[0].t, 0.5, 1e-15);
  EXPECT_NEAR(headOn[0].angleDeg, 90.0, 1e-12);
  for (const SweepBranch& branch : sweep.branches) {
    for (const SweepPoint& point : branch.points) {
      const double q = 2.0 * (4.0 * point.t - 2.0);
      const double expected = branch.kind == MarkKind::Silhouette
                                  ? std::atan2(q, 1.0)
                                  : std::atan2(1.0 + 3.0 * q * q, 2.0 * q);
      EXPECT_NEAR(halfTurnDeg(point.angleDeg - expected * 180.0 / std::numbers::pi), 0.0, 1e-9);
      if (branch.kind == MarkKind::Silhouette) continue;
      // Between the folds, where the view is nearly head-on, a ridge; outside a minimum.
      EXPECT_EQ(branch.kind == MarkKind::ApparentRidge, std::abs(q) < 1.0 / std::numbers::sqrt3)
          << point.t;
    }
  }
}

// The ellipse (a cos t, b sin t). lambda = k^2 / (n.w)^2 is stationary, from the direction phi,
// where
//   tan(phi) = b/a tau (a^2 tau^2 + 3 b^2 - 2 a^2) / ((3 a^2 - 2 b^2) tau^2 + b^2),  tau = tan(t),
// and folds where the derivative of that by tau vanishes, a quadratic in tau^2:
//   a^2 q x^2 + (3 a^2 r - p q) x + p r = 0,  p = 3 b^2 - 2 a^2, q = 3 a^2 - 2 b^2, r = b^2.
// The tip (tau infinite) is an apparent ridge if q < 0: b/a > sqrt(3/2).
TEST(Sweep, EllipseBirthsAreThoseOfTheClosedForm) {
  using test::Precise;
  for (const double b : {1.1, 1.2, 1.25, 1.3, 2.0, 3.0}) {
    const double margin = 0.35, low = margin, high = std::numbers::pi - margin;
    const Bezier arc = test::fittedBezier([](const Precise& t) -> Precise { return cos(t); },
                                          [b](const Precise& t) -> Precise { return b * sin(t); },
                                          Precise(low), Precise(high), 14);
    const Sweep sweep = sweepOf({{{BezierChain(arc)}}, {}});
    std::vector<SweepEvent> folds;
    for (const SweepEvent& event : sweep.events) {
      if (event.what == SweepEvent::What::Fold) folds.push_back(event);
    }
    const double p = 3.0 * b * b - 2.0, q = 3.0 - 2.0 * b * b, r = b * b;
    std::vector<double> wanted;  // t of the ellipse, where it is on the arc
    const double half = 0.5 * (3.0 * r - p * q) / q, constant = p * r / q;
    if (half * half > constant) {
      for (const double sign : {-1.0, 1.0}) {
        const double x = -half + sign * std::sqrt(half * half - constant);
        if (!(x > 0.0)) continue;
        for (const double t : {std::atan(std::sqrt(x)), std::numbers::pi - std::atan(std::sqrt(x))})
          if (t > low && t < high) wanted.push_back(t);
      }
    }
    std::sort(wanted.begin(), wanted.end());
    ASSERT_EQ(folds.size(), wanted.size()) << b;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double tau = std::tan(wanted[i]);
      const double phi = std::atan(b * tau * (tau * tau + p) / (q * tau * tau + r));
      EXPECT_NEAR(low + folds[i].t * (high - low), wanted[i], 1e-6) << b;
      EXPECT_NEAR(halfTurnDeg(folds[i].angleDeg - phi * 180.0 / std::numbers::pi), 0.0, 1e-6) << b;
    }
    // The tip, seen head-on.
    for (const SweepBranch& branch : sweep.branches) {
      if (branch.kind == MarkKind::Silhouette) continue;
      if (branch.points.front().t > 0.5 || branch.points.back().t < 0.499) continue;
      EXPECT_EQ(branch.kind == MarkKind::ApparentRidge, b > std::sqrt(1.5)) << b;
    }
    EXPECT_EQ(!wanted.empty(), b > std::sqrt(1.5)) << b;
  }
}

// Ridge or valley as findFeatures says for the scene's own view.
TEST(Sweep, LinesCarryTheNamesOfTheSceneItself) {
  for (const Preset& preset : presets()) {
    for (const bool flip : {false, true}) {
      Scene scene = preset.scene;
      scene.curves[0].flipNormal = flip;
      std::vector<std::pair<double, MarkKind>> lines, marks;
      for (const SweepLine& line : sweepOf(scene).lines) lines.emplace_back(line.t, line.kind);
      for (const Mark& mark : findFeatures(scene).marks) {
        const bool moves = mark.kind == MarkKind::Silhouette ||
                           mark.kind == MarkKind::ApparentRidge ||
                           mark.kind == MarkKind::ApparentMinimum;
        if (!moves) marks.emplace_back(mark.t, mark.kind);
      }
      std::sort(lines.begin(), lines.end());
      EXPECT_EQ(lines, marks) << preset.id << (flip ? " flipped" : "");
    }
  }
}

// A near cusp turns its tangent by almost half a turn within 1e-4 of t; sampled from afar that
// looks like no turn at all. x' >= 0 all along, so the tangent starts and ends within a quarter
// turn of 0.
TEST(Sweep, FollowsATangentThatTurnsWithinAHair) {
  for (const double y : {0.81, 0.801, 0.80001}) {
    const Sweep sweep = sweepOf(sceneOf({{-1.0, -0.8}, {1.0, 0.8}, {-1.0, y}, {1.0, -0.8}}));
    double angle = 0.0, turned = 0.0;
    bool first = true;
    for (const SweepBranch& branch : sweep.branches) {
      if (branch.kind != MarkKind::Silhouette) continue;
      if (!first) turned += halfTurnDeg(branch.points.front().angleDeg - angle);
      first = false;
      turned += branch.points.back().angleDeg - branch.points.front().angleDeg;
      angle = branch.points.back().angleDeg;
    }
    const double expected = -std::atan2(y + 0.8, 2.0) - std::atan2(1.6, 2.0);
    EXPECT_NEAR(turned, expected * 180.0 / std::numbers::pi, 1e-6) << y;
  }
}

TEST(Sweep, ApparentRidgeRunsIntoTheSilhouetteAtAnInflection) {
  const Sweep sweep = sweepOf(sceneOf({{-0.4, -1.0}, {1.6, -0.6}, {-1.6, 0.6}, {0.4, 1.0}}));
  const auto event =
      std::find_if(sweep.events.begin(), sweep.events.end(),
                   [](const SweepEvent& e) { return e.what == SweepEvent::What::MeetsSilhouette; });
  ASSERT_NE(event, sweep.events.end());
  EXPECT_NEAR(event->t, 0.5, 1e-15);
  // The tangent there is p3 + p2 - p1 - p0 = (-2.4, 3.2).
  EXPECT_NEAR(event->angleDeg, std::atan2(3.2, -2.4) * 180.0 / std::numbers::pi - 180.0, 1e-10);
}

TEST(Sweep, NeighbouringPointsAreClose) {
  const Sweep sweep = sweepOf(defaultScene());
  ASSERT_TRUE(sweep.complete);
  double length = 0.0;
  for (const SweepBranch& branch : sweep.branches)
    length = std::max(length, branch.points.back().u);
  for (const SweepBranch& branch : sweep.branches) {
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      EXPECT_LE(std::abs(branch.points[i + 1].angleDeg - branch.points[i].angleDeg), 2.0);
      EXPECT_GT(branch.points[i + 1].u, branch.points[i].u);
      EXPECT_LE(branch.points[i + 1].u - branch.points[i].u, 0.011 * length);
    }
  }
}

// The nearest mark of a kind in a view, or null.
const Mark* markNear(const FeatureSet& features, MarkKind kind, int curve, double t) {
  const Mark* best = nullptr;
  for (const Mark& mark : features.marks) {
    if (mark.kind != kind || mark.curve != curve) continue;
    if (!best || std::abs(mark.t - t) < std::abs(best->t - t)) best = &mark;
  }
  return best;
}

// What the sweep says is hidden is what findFeatures says of the same view.
TEST(SweepVisibility, AgreesWithTheMarksOfEachView) {
  int hidden = 0, seen = 0, compared = 0;
  for (const int preset : {0, 5}) {
    Scene scene = presets()[static_cast<std::size_t>(preset)].scene;
    const Sweep sweep = sweepOf(scene);
    const SweepVisibility visibility = visibilityOf(sweep, scene);
    ASSERT_EQ(visibility.branches.size(), sweep.branches.size());
    for (std::size_t b = 0; b < sweep.branches.size(); ++b) {
      const SweepBranch& branch = sweep.branches[b];
      for (std::size_t i = 1; i + 1 < branch.points.size(); i += 3) {
        for (const int copy : {0, 1}) {
          scene.view.angleDeg = normalizedDeg(branch.points[i].angleDeg + 180.0 * copy);
          const FeatureSet features = findFeatures(scene);
          const Mark* mark = markNear(features, branch.kind, branch.curve, branch.points[i].t);
          // Where two roots all but coincide the rounded angle has other roots than the point.
          if (!mark || std::abs(mark->t - branch.points[i].t) > 1e-7) continue;
          ++compared;
          EXPECT_EQ(visibility.branchAt(b, i, copy), mark->visible)
              << nameOf(branch.kind) << " at " << scene.view.angleDeg << ", t " << mark->t;
          ++(mark->visible ? seen : hidden);
        }
      }
    }
    for (int degree = -180; degree < 180; degree += 7) {
      scene.view.angleDeg = degree + 1e-3;
      const FeatureSet features = findFeatures(scene);
      for (std::size_t i = 0; i < sweep.lines.size(); ++i) {
        // The names may change with the side; the place does not.
        for (const Mark& mark : features.marks) {
          if (std::abs(mark.t - sweep.lines[i].t) > 1e-9) continue;
          EXPECT_EQ(visibility.lineAt(i, degree), mark.visible) << degree;
          EXPECT_EQ(visibility.lineAt(i, degree + 360.2), mark.visible) << degree;
        }
      }
    }
  }
  EXPECT_GT(compared, 300);
  EXPECT_GT(hidden, 50);
  EXPECT_GT(seen, 50);
}

TEST(SweepVisibility, StopsWhenTold) {
  const Scene scene = defaultScene();
  const Sweep sweep = sweepOf(scene);
  int asked = 0;
  const SweepVisibility none = visibilityOf(sweep, scene, [&asked] { return ++asked < 5; });
  EXPECT_EQ(asked, 5);
  EXPECT_TRUE(none.branches.empty());
}

TEST(Sweep, StraightAndPointCurvesHaveNoBranches) {
  EXPECT_TRUE(sweepOf(sceneOf({{0, 0}, {1, 2}, {2, 4}})).branches.empty());
  EXPECT_TRUE(sweepOf(sceneOf({{1, 1}, {1, 1}})).branches.empty());
}

}  // namespace
