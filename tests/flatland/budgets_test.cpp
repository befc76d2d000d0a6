// SPDX-License-Identifier: GPL-3.0-or-later
// What any scene may cost, counted in evaluations (docs/decisions/0022-budgets.md), and visibility
// against a slow, obvious reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flatland/features/features.h"
#include "flatland/roots/chebyshev.h"
#include "flatland/screen/sight_rays.h"
#include "flatland/screen/sweep.h"
#include "flatland/screen/sweep_visibility.h"
#include "flatland/screen/visibility.h"
#include "flatland/study/limits.h"
#include "flatland/study/profile.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

struct Wild {
  const char *x, *y, *from, *to;
};

constexpr Wild kWild[] = {
    {"t", "sin(1000*t)", "0", "1"},
    {"t", "sqrt(abs(sin(20*t)))", "0", "1"},
    {"t", "tan(1.5*t)", "0", "1.04"},
    {"t", "abs(abs(abs(sin(9*t))-0.5)-0.2)", "0", "1"},
    {"t", "sin(1/t)", "0.001", "1"},
    {"t", "1/(t-0.3)^2", "0", "1"},
    {"t", "exp(exp(exp(t)))", "0", "1.2"},
    {"t", "atan(tan(20*t))", "0", "1"},  // a saw: floor is not among the functions
    {"t", "tanh(1000*sin(40*t))", "0", "1"},
    {"sin(37*t)", "cos(41*t)", "0", "2*pi"},
    {"t", "sin(7*t)+sin(49*t)/2+sin(343*t)/4", "0", "1"},
    {"abs(t)+t", "abs(t)+t^3", "-1", "1"},
};

Scene sceneOf(const Curve& curve, double angleDeg) {
  Scene scene;
  scene.curves.push_back({curve, false});
  scene.view.angleDeg = angleDeg;
  return scene;
}

template <class Work>
std::uint64_t evaluationsOf(const Work& work) {
  const std::uint64_t before = FormulaCurve::evaluations();
  work();
  return FormulaCurve::evaluations() - before;
}

// About 10 million evaluations are a second.
TEST(Budgets, NoFormulaCostsMoreThanItMay) {
  int accepted = 0;
  for (const Wild& wild : kWild) {
    SCOPED_TRACE(std::string(wild.x) + ", " + wild.y);
    FormulaCurve::Result made;
    const auto entry = evaluationsOf([&] {
      made = FormulaCurve::make(TypedFormula{wild.x, wild.y, wild.from, wild.to, {}});
    });
    EXPECT_LT(entry, 60'000u);
    if (!made.curve) continue;
    ++accepted;
    const Scene scene = sceneOf(*made.curve, 60.0);
    FeatureSet features;
    EXPECT_LT(evaluationsOf([&] { features = findFeatures(scene); }), 2'000'000u);
    EXPECT_LT(evaluationsOf([&] { Visibility(scene).visibleIntervals(0); }), 8'000'000u);
    EXPECT_LT(evaluationsOf([&] { profileOf(scene, features, 0); }), 500'000u);
    EXPECT_LT(evaluationsOf([&] { sweepOf(scene); }), 5'000'000u);
    EXPECT_LT(evaluationsOf([&] {
                turnToSilhouette(scene, 0, 0.4);
                walkToSilhouette(scene, 0, 0.4);
              }),
              5'000'000u);
  }
  EXPECT_GE(accepted, 9);
}

TEST(Budgets, ProxiesKeepToTheirsAndSayWhatIsLeft) {
  ProxyBudget budget;
  budget.evaluations = 5000;
  const ProxyRoots found = proxyRoots(
      [](double t) {
        const double value = std::sin(4000.0 * t * t);
        return Measured{value, 1.0};
      },
      {}, budget);
  EXPECT_GE(found.evaluations, budget.evaluations);
  EXPECT_LE(found.evaluations, 3 * budget.evaluations);
  EXPECT_FALSE(found.roots.resolved());
  // What is said is true all the same: every root lies in a bracket or in what is open.
  for (int k = 1; k < 1200; ++k) {
    const double root = std::sqrt(3.14159265358979323846 * k / 4000.0);
    const bool told = std::any_of(found.roots.roots.begin(), found.roots.roots.end(),
                                  [&](const Root& r) { return std::abs(r.t - root) < 1e-12; }) ||
                      std::any_of(found.roots.unresolved.begin(), found.roots.unresolved.end(),
                                  [&](const RootInterval& open) {
                                    return open.low <= root && root <= open.high;
                                  });
    EXPECT_TRUE(told) << k;
  }
}

TEST(Budgets, OneJumpLeavesTheRestOfTheFunctionSeen) {
  // A jump takes all it can get, down to 2^-40; the wave beside it is resolved all the same.
  ProxyBudget budget;
  budget.evaluations = 3000;
  const ProxyRoots found = proxyRoots(
      [](double t) {
        return Measured{t < 0.1 ? 2.0 : std::sin(40.0 * t), 2.0};
      },
      {}, budget);
  for (int k = 2; 3.14159265358979 * k / 40.0 < 1.0; ++k) {
    const double root = 3.14159265358979323846 * k / 40.0;
    EXPECT_TRUE(std::any_of(found.roots.roots.begin(), found.roots.roots.end(), [&](const Root& r) {
      return std::abs(r.t - root) < 1e-12;
    })) << k;
  }
}

TEST(Budgets, LengthOfACurveWithInfiniteSpeedConverges) {
  // x = 0, y = sqrt(t): length 1.
  const auto made = FormulaCurve::make(TypedFormula{"0", "sqrt(t)", "0", "1", {}});
  ASSERT_TRUE(made.curve);
  const Curve curve = *made.curve;
  ArcLength length{};
  EXPECT_LT(evaluationsOf([&] { length = arcLength(curve, 0.0, 1.0, 1e-13); }), 20'000u);
  EXPECT_NEAR(length.value, 1.0, 1e-7);
}

// Segments in general position: what is seen, by asking every one of them.
bool seenBySearch(const std::vector<std::pair<Vec2, Vec2>>& lines, const Vec2& q,
                  const ViewFrame& frame) {
  for (const auto& [a, b] : lines) {
    const double xa = (a - q).dot(frame.axis), xb = (b - q).dot(frame.axis);
    if ((xa > 0.0) == (xb > 0.0)) continue;
    const Vec2 p = a + (b - a) * (xa / (xa - xb));
    if ((p - q).dot(frame.towards) > 1e-9) return false;
  }
  return true;
}

TEST(Visibility, OfManySegmentsIsThatOfASearch) {
  Random random(announcedSeed("budgets 1", 1));
  for (const int count : {40, 300}) {
    Scene scene;
    std::vector<std::pair<Vec2, Vec2>> lines;
    for (int i = 0; i < count; ++i) {
      const Vec2 a(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      const Vec2 b = a + 0.4 * Vec2(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      lines.emplace_back(a, b);
      scene.curves.push_back({BezierChain(Bezier{{a, b}})});
    }
    scene.view.angleDeg = uniform(random, -180.0, 180.0);
    const ViewFrame frame = frameOf(scene.view);
    const Visibility visibility(scene);
    const SightRays rays(scene);
    int seen = 0, hidden = 0;
    for (int i = 0; i < count; ++i) {
      const auto& own = visibility.visibleIntervals(i);
      for (int k = 0; k < 40; ++k) {
        const double t = (k + 0.5) / 40.0;
        const auto& [a, b] = lines[static_cast<std::size_t>(i)];
        const bool truth = seenBySearch(lines, a + t * (b - a), frame);
        ++(truth ? seen : hidden);
        EXPECT_EQ(visibility.isVisible(i, t), truth) << i << " at " << t;
        EXPECT_EQ(rays.isVisible(i, t, scene.view.angleDeg), truth) << i << " at " << t;
        const bool inside =
            std::any_of(own.begin(), own.end(), [t](const Visibility::Interval& interval) {
              return t >= interval.tLow && t <= interval.tHigh;
            });
        EXPECT_EQ(inside, truth) << i << " at " << t;
      }
    }
    EXPECT_GT(seen, count);
    EXPECT_GT(hidden, count);
  }
}

// Intervals and single questions come by different ways.
TEST(Visibility, IntervalsAgreeWithSingleQuestionsInBothProjections) {
  Random random(announcedSeed("budgets 2", 2));
  int seen = 0, hidden = 0;
  for (int round = 0; round < 60; ++round) {
    Scene scene;
    for (int c = 0; c < 3; ++c) {
      std::vector<Vec2> points;
      for (int j = 0; j < 3 + round % 4; ++j) {
        points.emplace_back(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      }
      scene.curves.push_back({BezierChain(Bezier{points})});
    }
    scene.view.angleDeg = uniform(random, -180.0, 180.0);
    if (round % 2 == 1) scene.view.distance = round % 4 == 1 ? 5.0 : 0.3;
    const Visibility visibility(scene);
    for (int c = 0; c < 3; ++c) {
      const auto& own = visibility.visibleIntervals(c);
      for (int k = 0; k < 50; ++k) {
        const double t = (k + 0.37) / 50.0;
        // Not within a hair of where the answer changes.
        const bool nearEdge =
            std::any_of(own.begin(), own.end(), [t](const Visibility::Interval& interval) {
              return std::abs(t - interval.tLow) < 1e-6 || std::abs(t - interval.tHigh) < 1e-6;
            });
        if (nearEdge) continue;
        const bool inside =
            std::any_of(own.begin(), own.end(), [t](const Visibility::Interval& interval) {
              return t >= interval.tLow && t <= interval.tHigh;
            });
        EXPECT_EQ(inside, visibility.isVisible(c, t)) << round << ": " << c << " at " << t;
        if (!scene.view.distance) {
          SightRays rays(scene);
          EXPECT_EQ(inside, rays.isVisible(c, t, scene.view.angleDeg)) << round << " at " << t;
        }
        ++(inside ? seen : hidden);
      }
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(hidden, 1000);
}

TEST(SightRays, AgreeWithVisibilityOnFormulas) {
  const auto made = FormulaCurve::make(TypedFormula{"sin(3*t)", "cos(4*t)", "0", "2*pi", {}});
  ASSERT_TRUE(made.curve);
  Scene scene = sceneOf(*made.curve, 0.0);
  const SightRays rays(scene);
  int seen = 0, hidden = 0;
  for (int angle = 3; angle < 360; angle += 40) {
    scene.view.angleDeg = angle;
    const Visibility visibility(scene);
    for (int k = 0; k < 100; ++k) {
      const double t = (k + 0.5) / 100.0;
      EXPECT_EQ(rays.isVisible(0, t, angle), visibility.isVisible(0, t)) << angle << " at " << t;
      ++(visibility.isVisible(0, t) ? seen : hidden);
    }
  }
  EXPECT_GT(seen, 100);
  EXPECT_GT(hidden, 100);
}

TEST(SweepVisibility, BeyondItsRaysNothingIsMarkedAndThatIsSaid) {
  Scene scene;
  Sweep sweep;
  sweep.branches.push_back({MarkKind::Silhouette, 0, {}});
  sweep.branches.back().points.resize(SweepVisibility::kMostRays / 2 + 1);
  const SweepVisibility visibility = visibilityOf(sweep, scene);
  EXPECT_FALSE(visibility.marked);
  EXPECT_TRUE(visibility.branchAt(0, 0, 0));
}

TEST(Budgets, StandingStillIsStated) {
  const auto made = FormulaCurve::make(TypedFormula{"abs(t)+t", "(abs(t)+t)^2", "-1", "1", {}});
  ASSERT_TRUE(made.curve);
  const Scene scene = sceneOf(*made.curve, 60.0);
  const FeatureSet found = findFeatures(scene);
  ASSERT_EQ(found.degenerate.size(), 1u);
  EXPECT_EQ(found.degenerate[0].what, Degenerate::What::Point);
  EXPECT_NEAR(found.degenerate[0].tLow, 0.0, 1e-9);
  EXPECT_NEAR(found.degenerate[0].tHigh, 0.5, 1e-9);
  for (const ProfileSegment& segment : profileOf(scene, found, 0).segments) {
    for (const ProfileSample& sample : segment.samples) {
      EXPECT_TRUE(std::isfinite(sample.k) && std::isfinite(sample.nw)) << sample.t;
    }
  }
}

TEST(Budgets, PolesThatKeepTheirSignAreRefusedAndPeaksAreNot) {
  for (const char* y : {"1/(t-0.3)^2", "1/abs(t-0.3)", "-1/(t-0.31)^4", "1/abs(t-0.3)^0.5"}) {
    EXPECT_FALSE(FormulaCurve::make(TypedFormula{"t", y, "0", "1", {}}).curve) << y;
  }
  for (const char* y : {"exp(-1e8*(t-0.3)^2)", "1/((t-0.3)^2+1e-6)", "-abs(t-0.3)", "sin(400*t)",
                        "sqrt(1-abs(t-0.3))"}) {
    EXPECT_TRUE(FormulaCurve::make(TypedFormula{"t", y, "0", "1", {}}).curve) << y;
  }
}

// What nearestPoint promises on curves without a Bezier form, over every place it samples.
void expectNearestKept(const Curve& curve, const std::vector<double>& ends, int perStretch,
                       const Vec2& p) {
  const Nearest found = nearestPoint(curve, p);
  EXPECT_NEAR(found.distance, (pointAt(curve, found.t) - p).norm(), 1e-12);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    for (int k = 0; k <= perStretch; ++k) {
      const double t = ends[i] + (ends[i + 1] - ends[i]) * k / perStretch;
      EXPECT_LE(found.distance, (pointAt(curve, t) - p).norm() + 1e-12) << t;
    }
  }
  if (found.t <= 1e-9 || found.t >= pieceCount(curve) - 1e-9) return;
  const Jet jet = jetAt(curve, found.t);
  EXPECT_NEAR((jet.p - p).dot(jet.d1) / jet.d1.norm(), 0.0, 1e-9) << found.t;
}

TEST(NearestPoint, OnAFormulaIsAFootNoFartherThanAnySample) {
  Random random(announcedSeed("budgets 3", 3));
  for (const char* y : {"sin(30*t)", "t^2*sin(9/(t+0.05))", "exp(-300*(t-0.4)^2)"}) {
    SCOPED_TRACE(y);
    const auto made = FormulaCurve::make(TypedFormula{"t", y, "0", "1", {}});
    ASSERT_TRUE(made.curve);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p(uniform(random, -0.5, 1.5), uniform(random, -1.5, 1.5));
      expectNearestKept(*made.curve, made.curve->cuts(), 4, p);
    }
  }
}

TEST(NearestPoint, OnARationalPieceIsAFootNoFartherThanAnySample) {
  Random random(announcedSeed("budgets 4", 4));
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec2> points;
    std::vector<double> weights;
    for (int j = 0; j < 5; ++j) {
      points.emplace_back(uniform(random, -1.0, 1.0), uniform(random, -1.0, 1.0));
      // Far apart: the speed changes much between two samples.
      weights.push_back(std::exp(uniform(random, -4.0, 4.0)));
    }
    const Vec2 p(uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5));
    expectNearestKept(RationalBezier(4, false, points, weights), {0.0, 1.0}, 32, p);
  }
}

TEST(Limits, SlideOfADearFormulaLooksAroundOnly) {
  const auto made = FormulaCurve::make(TypedFormula{"t", "sin(a*t)", "0.1", "1.1", {{"a", 1000}}});
  ASSERT_TRUE(made.curve);
  std::optional<LimitSeries> series;
  EXPECT_LT(
      evaluationsOf([&] { series = slideIntoSilhouette(sceneOf(*made.curve, 60.0), 0, 0.5); }),
      1'500'000u);
  ASSERT_TRUE(series);
  EXPECT_GE(series->x.size(), 8u);
  // At each inflection y' = +-1000 and y''' = -+1e9: k' = 1e9 / (1 + 1e6)^2.
  const double speedSq = 1.0 + 1e6;
  const double coefficient = std::sqrt(2.0 * speedSq * speedSq / 1e9);
  for (const LimitLaw& law : series->laws) {
    ASSERT_TRUE(law.fit);
    EXPECT_NEAR(law.fit->slope, 0.5, 1e-3);
    EXPECT_NEAR(law.fit->coefficient, coefficient, 0.02 * coefficient);
  }
  EXPECT_NEAR(std::remainder(1000.0 * (0.1 + series->t), 3.14159265358979323846), 0.0, 1e-9);
}

}  // namespace
}  // namespace flatland::test
