// SPDX-License-Identifier: GPL-3.0-or-later
// The roots of (3.13) as printed: found exactly, and shown to miss the maxima of lambda.
#include "flatland/features/printed_roots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flatland/features/orientation.h"
#include "flatland/features/terms.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

// (n.w) k' + k^2 (t.w) over the sizes of the two, by the formulas of the frame.
double printedResidual(const SceneCurve& curve, double t, const View& view) {
  const ViewFrame frame = frameOf(view);
  const Terms a = termsAt(jetAt(curve.shape, t), frame, normalSide(curve, frame));
  const double one = a.nw * a.kPrime, two = a.k * a.k * a.tw;
  return (one + two) / (std::abs(one) + std::abs(two));
}

Scene randomScene(Random& random, bool perspective) {
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i) points.emplace_back(uniform(random, 0, 1), uniform(random, 0, 1));
  Scene scene{{{BezierChain(Bezier{points})}}, {uniform(random, -180, 180), std::nullopt}};
  if (perspective) scene.view.distance = uniform(random, 2.5, 5.0);
  return scene;
}

// Roots of the residual's sign over a fine grid: slow, and shares nothing with the polynomials.
int signChanges(const Scene& scene, int steps) {
  int changes = 0;
  double before = printedResidual(scene.curves[0], 0.5 / steps, scene.view);
  for (int i = 1; i < steps; ++i) {
    const double now = printedResidual(scene.curves[0], (i + 0.5) / steps, scene.view);
    if ((now > 0.0) != (before > 0.0)) ++changes;
    before = now;
  }
  return changes;
}

TEST(PrintedRoots, SolveThePrintedEquationAndNoneIsMissed) {
  Random random(announcedSeed("PrintedRoots", 30));
  int total = 0, differ = 0;
  for (int n = 0; n < 150; ++n) {
    const Scene scene = randomScene(random, n % 3 == 0);
    const PrintedRoots found = findPrintedRoots(scene, findFeatures(scene));
    total += static_cast<int>(found.roots.size());
    for (const PrintedRoot& root : found.roots) {
      EXPECT_LT(std::abs(printedResidual(scene.curves[0], root.t, scene.view)), 1e-8) << root.t;
    }
    // The grid may step over a pair of roots, or see the jump of a near cusp.
    if (signChanges(scene, 4000) != static_cast<int>(found.roots.size())) ++differ;
  }
  EXPECT_GT(total, 150);
  EXPECT_LE(differ, 3);
}

TEST(PrintedRoots, MissTheMaxima) {
  Random random(announcedSeed("PrintedRoots.Miss", 31));
  int roots = 0, maxima = 0;
  for (int n = 0; n < 500; ++n) {
    const Scene scene = randomScene(random, false);
    const PrintedRoots found = findPrintedRoots(scene, findFeatures(scene));
    roots += static_cast<int>(found.roots.size());
    maxima += found.maxima();
    for (const PrintedRoot& root : found.roots) {
      if (root.toApparentRidge) {
        EXPECT_GT(*root.toApparentRidge, 0.0);
      }
    }
  }
  std::cout << roots << " printed roots on 500 curves, " << maxima << " at maxima of lambda\n";
  EXPECT_GT(roots, 500);
  EXPECT_EQ(maxima, 0);
}

// The one case in which the misprint does no harm: a ridge seen head-on, where the offset is 0.
TEST(PrintedRoots, AgreeAtARidgeSeenHeadOn) {
  const Scene parabola{{{BezierChain(Bezier{{{-1, 1}, {0, -1}, {1, 1}}})}}, {90.0, std::nullopt}};
  const PrintedRoots found = findPrintedRoots(parabola, findFeatures(parabola));
  ASSERT_EQ(found.roots.size(), 1u);
  EXPECT_EQ(found.roots[0].t, 0.5);
  EXPECT_TRUE(found.roots[0].isMaximum);
  EXPECT_EQ(found.roots[0].toApparentRidge, 0.0);
}

// Closed form: on y = x^2 seen from (sin p, cos p), with W = 1 + 4 x^2, k' ~ -f''' W + 3 f' f''^2:
// corrected -24 x (c - 2 x s) + 4 (s + 2 x c) = 0; printed has the second sign turned:
// 24 x (c - 2 x s) + 4 (s + 2 x c) = 0, that is 12 s x^2 - 8 c x - s = 0.
TEST(PrintedRoots, OfAParabolaSeenObliquely) {
  const double p = 0.4, s = std::sin(p), c = std::cos(p);
  const Scene scene{{{BezierChain(Bezier{{{-1, 1}, {0, -1}, {1, 1}}})}},
                    {90.0 - p * 180.0 / 3.14159265358979323846, std::nullopt}};
  const PrintedRoots found = findPrintedRoots(scene, findFeatures(scene));
  const double x = (8.0 * c - std::sqrt(64.0 * c * c + 48.0 * s * s)) / (24.0 * s);
  ASSERT_EQ(found.roots.size(), 1u);
  EXPECT_NEAR(found.roots[0].point.x(), x, 1e-14);
  EXPECT_FALSE(found.roots[0].isMaximum);
  // The maximum is at the smaller root of 12 s x^2 - 4 c x + s = 0; arc length in closed form.
  const double ridge = (4.0 * c - std::sqrt(16.0 * c * c - 48.0 * s * s)) / (24.0 * s);
  const auto length = [](double from, double to) {
    const auto primitive = [](double v) {
      return 0.5 * v * std::sqrt(1.0 + 4.0 * v * v) + 0.25 * std::asinh(2.0 * v);
    };
    return primitive(to) - primitive(from);
  };
  EXPECT_NEAR(found.roots[0].u, length(-1.0, x), 1e-9);
  ASSERT_TRUE(found.roots[0].alongToApparentRidge);
  EXPECT_NEAR(*found.roots[0].alongToApparentRidge, length(x, ridge), 1e-9);
  EXPECT_NEAR(*found.roots[0].shareToApparentRidge, length(x, ridge) / length(-1.0, 1.0), 1e-9);
  EXPECT_EQ(found.nearest(), &found.roots[0]);
  EXPECT_EQ(found.farthest(), &found.roots[0]);
}

// The shorter way round: moving the start of a closed curve changes no distance.
TEST(PrintedRoots, DistancesDoNotDependOnWhereAClosedCurveStarts) {
  const auto distances = [](int start) {
    std::vector<Vec2> corners{{2, 0}, {1.2, 1.7}, {-1, 1.1}, {-2.2, -0.4}, {-0.3, -1.6}};
    std::rotate(corners.begin(), corners.begin() + start, corners.end());
    const BSpline spline(3, true, corners, BSpline::uniformKnots(3, true, corners.size()));
    const Scene scene{{{spline.bezierForm()}}, {20.0, std::nullopt}};
    std::vector<double> found;
    for (const PrintedRoot& root : findPrintedRoots(scene, findFeatures(scene)).roots) {
      EXPECT_LE(root.shareToApparentRidge.value_or(0.0), 0.5);
      found.push_back(root.alongToApparentRidge.value_or(-1.0));
    }
    std::sort(found.begin(), found.end());
    return found;
  };
  const std::vector<double> expected = distances(0);
  ASSERT_GE(expected.size(), 2u);
  for (int start = 1; start < 5; ++start) {
    const std::vector<double> now = distances(start);
    ASSERT_EQ(now.size(), expected.size());
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i], expected[i], 1e-7);
  }
}

TEST(PrintedRoots, ProxiesFindTheSame) {
  Random random(announcedSeed("PrintedRoots.Proxy", 32));
  int compared = 0;
  for (int n = 0; n < 60; ++n) {
    const Scene scene = randomScene(random, n % 2 == 0);
    const PrintedRoots exact = findPrintedRoots(scene, findFeatures(scene));
    const Roots proxy = printedRootsByProxy(scene.curves[0].shape, 0, frameOf(scene.view));
    if (!proxy.resolved() || exact.unresolved > 0) continue;
    ASSERT_EQ(proxy.roots.size(), exact.roots.size()) << n;
    for (std::size_t i = 0; i < exact.roots.size(); ++i) {
      EXPECT_NEAR(proxy.roots[i].t, exact.roots[i].t, 1e-9);
    }
    ++compared;
  }
  EXPECT_GT(compared, 50);
}

TEST(PrintedRoots, NothingOnStraightAndEmptyScenes) {
  EXPECT_TRUE(findPrintedRoots({}, {}).roots.empty());
  const Scene straight{{{BezierChain(Bezier{{{0, 0}, {1, 1}, {3, 3}}})}}, {10.0, std::nullopt}};
  EXPECT_TRUE(findPrintedRoots(straight, findFeatures(straight)).roots.empty());
}

}  // namespace
}  // namespace flatland::test
