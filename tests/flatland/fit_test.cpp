// SPDX-License-Identifier: GPL-3.0-or-later
// Fits of Bezier chains to rows of points: within the tolerance by an independent distance, smooth
// but at corners.
#include "flatland/curve/fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/seed.h"

namespace flatland::test {
namespace {

constexpr double kPi = std::numbers::pi;

// By certified roots, which the fit does not use.
double farthest(const std::vector<Vec2>& points, const BezierChain& chain) {
  double worst = 0.0;
  for (const Vec2& p : points) worst = std::max(worst, nearestPoint(chain, p).distance);
  return worst;
}

// Largest turn of the tangent at joints, degrees.
double largestTurnDeg(const BezierChain& chain) {
  double worst = 0.0;
  const int pieces = chain.pieceCount();
  for (int i = chain.closed() ? 0 : 1; i < pieces; ++i) {
    const Vec2 a = jetAt(chain.piece((i + pieces - 1) % pieces), 1.0).d1,
               b = jetAt(chain.piece(i), 0.0).d1;
    worst = std::max(worst, std::abs(std::atan2(cross(a, b), a.dot(b))) * 180.0 / kPi);
  }
  return worst;
}

TEST(Fit, AnEllipseIsAFewSmoothPieces) {
  std::vector<Vec2> points;
  for (int i = 0; i < 200; ++i) {
    points.emplace_back(3.0 * std::cos(2 * kPi * i / 200), std::sin(2 * kPi * i / 200));
  }
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const auto fit = fitBezierChain(points, true, {.tolerance = tolerance});
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->chain.closed());
    EXPECT_EQ(fit->corners, 0u);
    EXPECT_LE(fit->maxDeviation, tolerance);
    EXPECT_LE(farthest(points, fit->chain), fit->maxDeviation + 1e-12);
    EXPECT_LT(largestTurnDeg(fit->chain), 1e-6);
    // Tangents are good to second order of the distance of the points, which sets the number.
    EXPECT_LE(fit->chain.pieceCount(), tolerance < 1e-5 ? 64 : 32);
  }
}

TEST(Fit, KeepsTheCornersOfASquare) {
  std::vector<Vec2> points;
  const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 10; ++i) {
      points.emplace_back(corners[k] + (corners[(k + 1) % 4] - corners[k]) * i / 10.0);
    }
  }
  const auto fit = fitBezierChain(points, true, {.tolerance = 1e-3});
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->corners, 4u);
  EXPECT_EQ(fit->chain.pieceCount(), 4);
  EXPECT_LT(farthest(points, fit->chain), 1e-9);
}

TEST(Fit, RandomRowsStayWithinTheTolerance) {
  Random random(announcedSeed("rows", 73));
  for (int i = 0; i < 40; ++i) {
    std::vector<Vec2> points{Vec2(0, 0)};
    double heading = 0.0;
    const int count = uniformInt(random, 2, 60);
    for (int k = 0; k < count; ++k) {
      heading += uniform(random, -0.6, 0.6);
      points.push_back(points.back() +
                       uniform(random, 0.001, 1.0) * Vec2(std::cos(heading), std::sin(heading)));
    }
    const double tolerance = std::pow(10.0, uniform(random, -4, -1));
    for (const int degree : {3, 5}) {
      const auto fit =
          fitBezierChain(points, i % 2 == 0, {.tolerance = tolerance, .degree = degree});
      ASSERT_TRUE(fit);
      EXPECT_LE(fit->maxDeviation, tolerance);
      EXPECT_LE(farthest(points, fit->chain), fit->maxDeviation + 1e-9);
    }
  }
}

TEST(Fit, DegenerateRows) {
  EXPECT_FALSE(fitBezierChain({}, false, {.tolerance = 0.1}));
  EXPECT_FALSE(fitBezierChain({{1, 1}, {1, 1}}, true, {.tolerance = 0.1}));
  const auto line = fitBezierChain({{0, 0}, {0, 0}, {3, 0}}, false, {.tolerance = 0.1});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->chain.pieceCount(), 1);
  EXPECT_EQ(line->maxDeviation, 0.0);
}

}  // namespace
}  // namespace flatland::test
