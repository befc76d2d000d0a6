// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth joints at which curvature jumps or is infinite.
#include <gtest/gtest.h>

#include <cmath>

#include "flatland/features/features.h"
#include "flatland/features/terms.h"

namespace {

using namespace flatland;

Scene chainScene(int degree, std::vector<Vec2> points, double angleDeg) {
  return {{{BezierChain(degree, false, std::move(points))}}, {angleDeg, std::nullopt}};
}

// Two parabolas that meet at the origin with a level tangent. A quadratic starting with P0, P1, P2
// has curvature (P1 - P0) x (P2 - P1) / (2 |P1 - P0|^3) there: 0.5 * 2 / (2 * 0.125) = 4 on the
// left.
TEST(Joints, MarkAtACurvatureJumpCarriesTheLargerSide) {
  const Scene scene = chainScene(2, {{-4, -2}, {-0.5, 0}, {0, 0}, {4, 0}, {8, -6}}, 90.0);
  const FeatureSet features = findFeatures(scene);
  int ridges = 0;
  for (const Mark& mark : features.marks) {
    if (mark.kind != MarkKind::ApparentRidge || mark.t != 1.0) continue;
    ++ridges;
    EXPECT_NEAR(*mark.lambda, 16.0, 1e-12);
  }
  EXPECT_EQ(ridges, 1);
  EXPECT_TRUE(features.complete());
}

// The same walked backwards: the larger side comes after the joint.
TEST(Joints, AlsoWhenTheLargerSideComesSecond) {
  Scene scene = chainScene(2, {{-4, -2}, {-0.5, 0}, {0, 0}, {4, 0}, {8, -6}}, 90.0);
  scene.curves[0].shape = reversed(scene.curves[0].chain());
  int ridges = 0;
  for (const Mark& mark : findFeatures(scene).marks) {
    if (mark.kind != MarkKind::ApparentRidge || mark.t != 1.0) continue;
    ++ridges;
    EXPECT_NEAR(*mark.lambda, 16.0, 1e-12);
  }
  EXPECT_EQ(ridges, 1);
}

// Retracted handles on both sides make curvature infinite at the joint, of either sign: the curve
// changes side there. Infinite values of different sign are not one value, nor is an infinite one a
// finite one.
TEST(Joints, InfiniteCurvatureIsNotEverything) {
  const Scene scene =
      chainScene(3, {{-2, 1}, {-1, 0}, {0, 0}, {0, 0}, {0, 0}, {1, 0}, {2, -1}}, 90.0);
  const FeatureSet features = findFeatures(scene);
  int inflections = 0;
  for (const Mark& mark : features.marks) {
    if (mark.t == 1.0 && mark.kind == MarkKind::Inflection) ++inflections;
  }
  EXPECT_EQ(inflections, 1);
}

// Squares and cubes of such sizes leave the range of double; better no answer than a wrong one.
TEST(Extremes, SizesBeyondDoubleAreSaidNotGuessed) {
  for (const double size : {1e-120, 1e-200, 1e100}) {
    const FeatureSet features = findFeatures(
        {{{BezierChain(Bezier{{{0, 0}, {size, 2 * size}, {2 * size, -size}, {3 * size, 0}}})}},
         {}});
    EXPECT_TRUE(features.marks.empty());
    EXPECT_FALSE(features.complete());
  }
}

// A curve through the viewer: nothing there is finite nonsense.
TEST(Joints, CurveThroughTheViewerHasNoNumbersThere) {
  Scene scene{{{BezierChain(Bezier{{{-1, 1}, {2, 0.5}, {2, -0.5}, {-1, -1}}})}}, {0.0, 1.25}};
  for (const Mark& mark : findFeatures(scene).marks) {
    if (mark.lambda) {
      EXPECT_TRUE(std::isfinite(*mark.lambda));
    }
    if (mark.perspective) {
      EXPECT_TRUE(std::isfinite(*mark.perspective));
    }
    EXPECT_TRUE(std::isfinite(mark.residual));
    if (mark.screen) {
      EXPECT_LT(std::abs(*mark.screen), 1e10);
    }
  }
  // Exactly beside the viewer the image runs off the screen.
  EXPECT_FALSE(screenCoordinate(frameOf(View{60.0, 1.0}), Vec2(2.0, 0.0)));
}

}  // namespace
