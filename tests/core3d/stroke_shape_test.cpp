// SPDX-License-Identifier: GPL-3.0-or-later
// How wide and dark strokes are drawn.
#include "core3d/draw/stroke_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flatland::test {
namespace {

using Eigen::Vector2d;

Polyline polyline(std::vector<Vector2d> screen, std::vector<float> strength, bool closed = false) {
  Polyline line;
  line.family = LineFamily::ApparentRidges;
  line.closed = closed;
  line.points.resize(screen.size());
  line.screen = std::move(screen);
  line.strength = std::move(strength);
  return line;
}

double areaOf(const std::vector<Vector2d>& polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += (a.x() * b.y() - a.y() * b.x()) / 2.0;
  }
  return area;
}

TEST(StrokeShape, PlainStyleIsAPlainLine) {
  const Polyline line = polyline({{0, 0}, {10, 0}, {10, 40}}, {1, 5, 9});
  const StrokeShape shape = shapeOf(line, {.widthPx = 2.0}, 1.0, 9.0);
  EXPECT_TRUE(shape.uniform);
  EXPECT_EQ(shape.centre, line.screen);
  EXPECT_EQ(shape.widthPx, std::vector<double>(3, 2.0));
}

TEST(StrokeShape, WidthAndDarknessFollowStrength) {
  const Polyline line = polyline({{0, 0}, {200, 0}}, {1, 9});
  const StrokeShape shape =
      shapeOf(line, {.widthPx = 4.0, .leastWidth = 0.25, .leastDarkness = 0.5}, 1.0, 9.0);
  EXPECT_FALSE(shape.uniform);
  ASSERT_GT(shape.centre.size(), 20u);
  for (std::size_t i = 0; i < shape.centre.size(); ++i) {
    const double x = shape.centre[i].x();
    if (x < 10.0 || x > 190.0) continue;  // there the average is one-sided
    const double level = (std::sqrt(1.0 + 8.0 * x / 200.0) - 1.0) / 2.0;
    EXPECT_NEAR(shape.widthPx[i], 4.0 * (0.25 + 0.75 * level), 1e-6);
    EXPECT_NEAR(shape.darkness[i], 0.5 + 0.5 * level, 1e-6);
  }
  EXPECT_NEAR(shape.widthPx.front(), 1.0, 0.2);
  EXPECT_NEAR(shape.widthPx.back(), 4.0, 0.1);
}

TEST(StrokeShape, TapersOpenEndsToAPoint) {
  const StrokeStyle style{.widthPx = 3.0, .taperPx = 30.0};
  const StrokeShape shape = shapeOf(polyline({{0, 0}, {200, 0}}, {1, 1}), style, 0.0, 0.0);
  EXPECT_EQ(shape.widthPx.front(), 0.0);
  EXPECT_NEAR(shape.widthPx.back(), 0.0, 1e-9);
  EXPECT_EQ(shape.centre.front(), Vector2d(0, 0));
  EXPECT_NEAR(shape.centre.back().x(), 200.0, 1e-9);
  EXPECT_NEAR(shape.widthPx[shape.widthPx.size() / 2], 3.0, 1e-12);
  // A parabola at either end takes a third of the taper's ink away.
  const auto outline = outlineOf(shape);
  ASSERT_EQ(outline.size(), 1u);
  EXPECT_NEAR(std::abs(areaOf(outline[0])), 3.0 * (200.0 - 2.0 * 30.0 / 3.0), 1.0);
  // Closed strokes have no ends.
  const StrokeShape ring =
      shapeOf(polyline({{0, 0}, {50, 0}, {50, 50}}, {1, 1, 1}, true), style, 0, 0);
  EXPECT_TRUE(ring.uniform);
}

TEST(StrokeShape, OutlineOfARingHasItsArea) {
  std::vector<Vector2d> circle;
  for (int i = 0; i < 90; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 90.0;
    circle.emplace_back(50.0 * std::cos(a), 50.0 * std::sin(a));
  }
  const auto outline = outlineOf(
      shapeOf(polyline(circle, std::vector<float>(90, 1.0f), true), {.widthPx = 4.0}, 0, 0));
  ASSERT_EQ(outline.size(), 2u);
  const double area = areaOf(outline[0]) + areaOf(outline[1]);
  EXPECT_NEAR(std::abs(area), 2.0 * std::numbers::pi * 50.0 * 4.0, 10.0);
}

}  // namespace
}  // namespace flatland::test
