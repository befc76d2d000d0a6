// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change the marks: turning scene and view together, size, direction of the walk,
// splitting and degree elevation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "flatland/curve/arc_length.h"
#include "flatland/features/features.h"
#include "tests/support/brute_marks.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

// Rounded control points move a mark by about 1e-15 times its condition, which is up to 1e6 on
// curves that nearly have a cusp.
constexpr double kPlace = 1e-8;
constexpr double kValue = 1e-5;

Scene randomScene(Random& random, int variant) {
  const int points = 4 + variant % 3;
  Scene scene;
  const int curves = 1 + variant % 2;
  for (int c = 0; c < curves; ++c) {
    Bezier b;
    for (int i = 0; i < points; ++i)
      b.points.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1));
    scene.curves.push_back({.shape = BezierChain(b), .flipNormal = variant % 5 == 0});
  }
  scene.view.angleDeg = uniform(random, -180, 180);
  if (variant % 3 == 0) scene.view.distance = uniform(random, 3, 8);
  return scene;
}

template <class F>
Scene mapped(const Scene& scene, const F& f) {
  Scene result = scene;
  for (SceneCurve& curve : result.curves) {
    for (std::size_t i = 0; i < curve.chain().points().size(); ++i) {
      curve.chain().setPoint(i, f(curve.chain().points()[i]));
    }
  }
  return result;
}

// The marks of `a` and `b` are the same after b's points went through `back`; lengths of b are
// `scale` times those of a.
template <class F>
void expectSame(const FeatureSet& a, const FeatureSet& b, const F& back, double scale,
                const std::string& what, double place = kPlace, bool reversed = false) {
  EXPECT_EQ(a.complete(), b.complete()) << what;
  ASSERT_EQ(a.marks.size(), b.marks.size()) << what;
  std::vector<bool> taken(b.marks.size());
  for (const Mark& mark : a.marks) {
    std::size_t best = b.marks.size();
    double bestDistance = 0.0;
    for (std::size_t j = 0; j < b.marks.size(); ++j) {
      if (taken[j] || b.marks[j].kind != mark.kind || b.marks[j].curve != mark.curve) continue;
      const double distance = (back(b.marks[j].point) - mark.point).norm();
      if (best == b.marks.size() || distance < bestDistance) best = j, bestDistance = distance;
    }
    ASSERT_LT(best, b.marks.size()) << "no " << nameOf(mark.kind) << " for t = " << mark.t << what;
    EXPECT_LT(bestDistance, place) << nameOf(mark.kind) << " t = " << mark.t << what;
    taken[best] = true;
    const Mark& other = b.marks[best];
    EXPECT_EQ(mark.visible, other.visible) << nameOf(mark.kind) << " t = " << mark.t << what;
    ASSERT_EQ(mark.screen.has_value(), other.screen.has_value()) << what;
    if (mark.screen) {
      EXPECT_NEAR(*mark.screen, *other.screen / scale, 30 * place) << what;
    }
    ASSERT_EQ(mark.lambda.has_value(), other.lambda.has_value()) << what;
    if (mark.kind == MarkKind::ApparentRidge || mark.kind == MarkKind::ApparentMinimum) {
      EXPECT_NEAR(*mark.lambda, *other.lambda * scale * scale, kValue * *mark.lambda) << what;
      // feature turns its sign with the direction of the walk: dk/du does.
      const double size =
          std::abs(*mark.feature) + std::abs(*mark.offset) + std::abs(*mark.perspective);
      const double sign = reversed ? -1.0 : 1.0, cube = sign * scale * scale * scale;
      EXPECT_NEAR(*mark.offset, *other.offset * cube, kValue * size) << what;
      EXPECT_NEAR(*mark.feature, *other.feature * cube, kValue * size) << what;
      EXPECT_NEAR(*mark.perspective, *other.perspective * cube, kValue * size) << what;
    }
    if (!reversed) {
      EXPECT_NEAR(mark.u, other.u / scale, 30 * place) << what;
    }
  }
}

const auto same = [](const Vec2& p) { return p; };

TEST(FeaturesInvariance, RotationOfSceneAndView) {
  Random random(announcedSeed("rotation", 11));
  for (int i = 0; i < 400; ++i) {
    const Scene scene = randomScene(random, i);
    const FeatureSet found = findFeatures(scene);
    const double turnDeg = uniform(random, -180, 180), a = turnDeg * std::numbers::pi / 180;
    const auto turn = [](double angle) {
      return [angle](const Vec2& p) {
        return Vec2(std::cos(angle) * p.x() - std::sin(angle) * p.y(),
                    std::sin(angle) * p.x() + std::cos(angle) * p.y());
      };
    };
    Scene turned = mapped(scene, turn(a));
    turned.view.angleDeg += turnDeg;
    expectSame(found, findFeatures(turned), turn(-a), 1.0, described(scene));
  }
}

TEST(FeaturesInvariance, QuarterTurnsAreExact) {
  Random random(announcedSeed("quarter turns", 12));
  for (int i = 0; i < 300; ++i) {
    Scene scene = randomScene(random, i);
    scene.view.angleDeg = uniformInt(random, -180, 180);  // so that adding 90 degrees is exact
    const FeatureSet found = findFeatures(scene);
    Scene turned = mapped(scene, [](const Vec2& p) { return rotateCcw(p); });
    turned.view.angleDeg += 90;
    const FeatureSet again = findFeatures(turned);
    expectSame(
        found, again, [](const Vec2& p) { return Vec2(-rotateCcw(p)); }, 1.0, described(scene),
        1e-13);
  }
}

TEST(FeaturesInvariance, Scaling) {
  Random random(announcedSeed("scaling", 13));
  for (int i = 0; i < 400; ++i) {
    const Scene scene = randomScene(random, i);
    const FeatureSet found = findFeatures(scene);
    for (const double scale : {1e-6, 1e6, 0x1p-40}) {
      Scene scaled = mapped(scene, [scale](const Vec2& p) { return Vec2(scale * p); });
      if (scaled.view.distance) *scaled.view.distance *= scale;
      expectSame(
          found, findFeatures(scaled), [scale](const Vec2& p) { return Vec2(p / scale); }, scale,
          described(scene), scale == 0x1p-40 ? 1e-13 : kPlace);
    }
  }
}

TEST(FeaturesInvariance, Reversal) {
  Random random(announcedSeed("reversal", 14));
  for (int i = 0; i < 400; ++i) {
    const Scene scene = randomScene(random, i);
    const FeatureSet found = findFeatures(scene);
    Scene backwards = scene;
    for (SceneCurve& curve : backwards.curves) curve.shape = reversed(curve.chain());
    const FeatureSet again = findFeatures(backwards);
    expectSame(found, again, same, 1.0, described(scene), 1e-9, true);
    // u runs from the other end.
    for (const Mark& mark : found.marks) {
      const BezierChain& chain = scene.curves[static_cast<std::size_t>(mark.curve)].chain();
      const double length = arcLength(chain, 0, chain.pieceCount(), 1e-13).value;
      const bool met = std::any_of(again.marks.begin(), again.marks.end(), [&](const Mark& other) {
        return other.kind == mark.kind && other.curve == mark.curve &&
               std::abs(other.u - (length - mark.u)) < 1e-8 &&
               std::abs(other.t - (1 - mark.t)) < 1e-8;
      });
      EXPECT_TRUE(met) << nameOf(mark.kind) << " t = " << mark.t << described(scene);
    }
  }
}

TEST(FeaturesInvariance, Elevation) {
  Random random(announcedSeed("elevation", 15));
  for (int i = 0; i < 400; ++i) {
    const Scene scene = randomScene(random, i);
    Scene higher = scene;
    for (SceneCurve& curve : higher.curves) curve.shape = elevated(elevated(curve.chain()));
    expectSame(findFeatures(scene), findFeatures(higher), same, 1.0, described(scene));
  }
}

// Rounding the control points of a piece of length s changes its third derivative by about
// 1e-16 degree^3 / s^3, so far shorter pieces really are other curves, with marks of their own.
constexpr double kShortestPiece = 0.02;

TEST(FeaturesInvariance, SplittingAnywhereAndExactlyAtMarks) {
  Random random(announcedSeed("splitting", 16));
  for (int i = 0; i < 400; ++i) {
    const Scene scene = randomScene(random, i);
    const FeatureSet found = findFeatures(scene);
    std::vector<double> places{uniform(random, 0.05, 0.95), 0.5};
    for (const Mark& mark : found.marks) {
      if (mark.curve == 0) places.push_back(mark.t);
    }
    for (const double t : places) {
      if (!(t > kShortestPiece && t < 1 - kShortestPiece)) continue;
      Scene split = scene;
      split.curves[0].shape = splitAt(scene.curves[0].chain(), t);
      ASSERT_EQ(split.curves[0].chain().pieceCount(), 2);
      expectSame(found, findFeatures(split), same, 1.0,
                 "\nsplit at " + std::to_string(t) + described(scene));
      // And once more: three pieces.
      split.curves[0].shape = splitAt(split.curves[0].chain(), 1.3);
      expectSame(found, findFeatures(split), same, 1.0,
                 "\nsplit twice at " + std::to_string(t) + described(scene));
    }
  }
}

}  // namespace
}  // namespace flatland::test
