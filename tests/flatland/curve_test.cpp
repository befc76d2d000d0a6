// SPDX-License-Identifier: GPL-3.0-or-later
// Curves: shape-preserving edits, jets, arc length, cubics, chains.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "flatland/curve/arc_length.h"
#include "flatland/curve/bezier_chain.h"
#include "flatland/curve/chain_editing.h"
#include "tests/support/precise.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

Bezier randomBezier(Random& random, int points) {
  Bezier b;
  for (int i = 0; i < points; ++i)
    b.points.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1));
  return b;
}

// Point and derivatives up to `order` by the Bernstein sum of differences, in 50 digits.
Vec2 preciseDerivative(const Bezier& curve, double t, int order) {
  Vec2 result;
  for (int axis = 0; axis < 2; ++axis) {
    std::vector<Precise> c;
    for (const Vec2& p : curve.points) c.push_back(p(axis));
    for (int k = 0; k < order; ++k) {
      if (c.size() == 1) {
        c = {Precise(0)};
        break;
      }
      const int n = static_cast<int>(c.size()) - 1;
      for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] = n * (c[i + 1] - c[i]);
      c.pop_back();
    }
    const int n = static_cast<int>(c.size()) - 1;
    Precise sum = 0, binomial = 1;
    for (int i = 0; i <= n; ++i) {
      sum += binomial * pow(Precise(t), i) * pow(1 - Precise(t), n - i) *
             c[static_cast<std::size_t>(i)];
      binomial = binomial * (n - i) / (i + 1);
    }
    result(axis) = static_cast<double>(sum);
  }
  return result;
}

// Rounding of de Casteljau and of the differences, by degree.
constexpr double kRounding = 1e-15;

TEST(Bezier, JetsAgreeWithFiftyDigits) {
  Random random(announcedSeed("jets", 101));
  for (int i = 0; i < 400; ++i) {
    const Bezier curve = randomBezier(random, 1 + i % 10);
    const int n = curve.degree();
    const double t = i % 7 == 0 ? i % 2 : uniform(random, 0, 1);
    const Jet jet = jetAt(curve, t);
    const Vec2 parts[] = {jet.p, jet.d1, jet.d2, jet.d3};
    double size = 2;
    for (int order = 0; order < 4; ++order) {
      EXPECT_LE((parts[order] - preciseDerivative(curve, t, order)).norm(),
                kRounding * (n + 1) * size)
          << "order " << order << " degree " << n << " t " << t;
      size *= 2.0 * std::max(1, n - order);
    }
    EXPECT_LE((jet.p - pointAt(curve, t)).norm(), kRounding * (n + 1));
  }
  EXPECT_EQ(jetAt(Bezier{{{1, 2}}}, 0.3).d1, Vec2(0, 0));
}

TEST(Bezier, SplitElevateReverseKeepThePoints) {
  Random random(announcedSeed("edits", 102));
  for (int i = 0; i < 200; ++i) {
    const Bezier curve = randomBezier(random, 2 + i % 8);
    const double cut = uniform(random, 0, 1), s = uniform(random, 0, 1);
    const auto [low, high] = splitAt(curve, cut);
    EXPECT_EQ(low.degree(), curve.degree());
    EXPECT_EQ(high.degree(), curve.degree());
    EXPECT_EQ(low.points.back(), high.points.front());
    EXPECT_EQ(low.points.front(), curve.points.front());
    EXPECT_EQ(high.points.back(), curve.points.back());
    EXPECT_LE((pointAt(low, s) - preciseDerivative(curve, cut * s, 0)).norm(), 1e-14);
    EXPECT_LE((pointAt(high, s) - preciseDerivative(curve, cut + (1 - cut) * s, 0)).norm(), 1e-14);
    const Bezier higher = elevated(curve);
    EXPECT_EQ(higher.degree(), curve.degree() + 1);
    EXPECT_LE((pointAt(higher, s) - preciseDerivative(curve, s, 0)).norm(), 1e-14);
    EXPECT_LE((jetAt(higher, s).d2 - preciseDerivative(curve, s, 2)).norm(), 1e-12);
    EXPECT_LE((pointAt(reversed(curve), s) - preciseDerivative(curve, 1 - s, 0)).norm(), 1e-14);
  }
}

// Distance to the curve: 400 samples, and golden section around every one lower than its
// neighbours.
double distanceTo(const Bezier& curve, const Vec2& p) {
  constexpr int kSamples = 400;
  const auto distance = [&](double t) { return (pointAt(curve, t) - p).norm(); };
  std::vector<double> at;
  for (int i = 0; i <= kSamples; ++i) at.push_back(distance(static_cast<double>(i) / kSamples));
  double best = std::min(at.front(), at.back());
  for (std::size_t i = 0; i <= kSamples; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min<std::size_t>(i + 1, kSamples);
    if (at[i] > at[before] || at[i] > at[after]) continue;
    double a = static_cast<double>(before) / kSamples, b = static_cast<double>(after) / kSamples;
    for (int k = 0; k < 70; ++k) {
      const double x = b - 0.618 * (b - a), y = a + 0.618 * (b - a);
      (distance(x) < distance(y) ? b : a) = distance(x) < distance(y) ? y : x;
    }
    best = std::min(best, distance(0.5 * (a + b)));
  }
  return best;
}

TEST(Chains, NearestPointIsTheNearest) {
  Random random(announcedSeed("nearest", 107));
  for (int i = 0; i < 1500; ++i) {
    const Bezier curve = randomBezier(random, 3 + i % 6);
    // On the curve, close to it, and anywhere: near a crossing the other branch must not win.
    const double t = uniform(random, 0, 1);
    const double aside = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1e-3 : 0.5;
    const Vec2 p = pointAt(curve, t) + aside * Vec2(normal(random), normal(random));
    const Nearest nearest = nearestPoint(BezierChain(curve), p);
    EXPECT_LE(nearest.distance, distanceTo(curve, p) + 1e-7) << "case " << i;
    EXPECT_NEAR((pointAt(curve, nearest.t) - p).norm(), nearest.distance, 1e-12);
  }
}

TEST(Bezier, ToCubicsStaysWithinTolerance) {
  Random random(announcedSeed("cubics", 103));
  for (int i = 0; i < 24; ++i) {
    const Bezier curve = randomBezier(random, 2 + i % 8);
    for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
      const auto cubics = toCubics(curve, tolerance);
      ASSERT_FALSE(cubics.empty());
      if (curve.degree() <= 3) {
        EXPECT_EQ(cubics.size(), 1u);
      }
      EXPECT_EQ(cubics.front().points.front(), curve.points.front());
      EXPECT_LT((cubics.back().points.back() - curve.points.back()).norm(), 1e-15);
      for (std::size_t k = 0; k < cubics.size(); ++k) {
        EXPECT_EQ(cubics[k].degree(), 3);
        if (k > 0) {
          EXPECT_EQ(cubics[k].points[0], cubics[k - 1].points[3]);
        }
        // From the cubic to the nearest point of the curve, and back for the curve's samples.
        for (const double s : {0.13, 0.5, 0.81}) {
          EXPECT_LE(distanceTo(curve, pointAt(cubics[k], s)), 1.01 * tolerance);
        }
      }
      for (int k = 0; k <= 20; ++k) {
        const Vec2 p = pointAt(curve, k / 20.0);
        double nearest = 1e9;
        for (const Bezier& cubic : cubics) {
          nearest = std::min(nearest, distanceTo(cubic, p));
        }
        EXPECT_LE(nearest, 1.01 * tolerance);
      }
    }
  }
}

TEST(ArcLengths, ParabolaInClosedForm) {
  // y = x^2 from 0 to b: b sqrt(1 + 4b^2) / 2 + asinh(2b) / 4.
  const Bezier parabola{{{-1, 1}, {0, -1}, {1, 1}}};
  const auto length = [](double b) {
    return 0.5 * b * std::sqrt(1 + 4 * b * b) + 0.25 * std::asinh(2 * b);
  };
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    const ArcLength got = arcLength(parabola, 0.5, t, 1e-13);
    EXPECT_NEAR(got.value, length(2 * t - 1), 2e-15);  // odd in t: negative backwards
    EXPECT_TRUE(got.converged);
  }
  EXPECT_EQ(arcLength(parabola, 0.3, 0.3, 1e-9).value, 0.0);
}

// Ten-point Gauss-Legendre on 20,000 panels: good to 1e-13 but within 1e-4 of a cusp.
double slowLength(const Bezier& curve) {
  constexpr double kNode[] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                              0.8650633666889845, 0.9739065285171717};
  constexpr double kWeight[] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820,
                                0.1494513491505806, 0.0666713443086881};
  constexpr int kPanels = 20000;
  double sum = 0.0;
  for (int i = 0; i < kPanels; ++i) {
    for (int k = 0; k < 5; ++k) {
      for (const double side : {-1.0, 1.0}) {
        sum += kWeight[k] * jetAt(curve, (i + 0.5 + 0.5 * side * kNode[k]) / kPanels).d1.norm();
      }
    }
  }
  return sum / (2.0 * kPanels);
}

TEST(ArcLengths, ErrorStaysBelowTheAccuracyAskedFor) {
  Random random(announcedSeed("accuracy", 104));
  for (int i = 0; i < 40; ++i) {
    const Bezier curve = randomBezier(random, 3 + i % 6);
    const double reference = slowLength(curve);
    for (int digits = 1; digits <= 12; ++digits) {
      const double accuracy = std::pow(10.0, -digits);
      const ArcLength got = arcLength(curve, 0, 1, accuracy);
      EXPECT_TRUE(got.converged);
      EXPECT_LE(got.errorEstimate, accuracy);
      EXPECT_LE(std::abs(got.value - reference), accuracy + 1e-12)
          << "curve " << i << " to " << accuracy;
      EXPECT_NEAR(arcLength(curve, 1, 0, accuracy).value, -got.value, accuracy);
    }
    // Never shorter than the chord, never longer than the control polygon.
    double polygon = 0.0;
    for (std::size_t k = 1; k < curve.points.size(); ++k)
      polygon += (curve.points[k] - curve.points[k - 1]).norm();
    EXPECT_GE(reference, (curve.points.back() - curve.points.front()).norm());
    EXPECT_LE(reference, polygon);
  }
}

TEST(ArcLengths, CuspConvergesAndTooMuchIsSaid) {
  // (0,0) (1,1) (0,1) (1,0) has speed 3 |1 - 2t| sqrt((1 - 2t)^2 + 1).
  const Bezier cusp{{{0, 0}, {1, 1}, {0, 1}, {1, 0}}};
  // 3 int |u| sqrt(u^2 + 1) du / 2 over [-1, 1] = sqrt(8) - 1.
  const double exact = 2 * std::sqrt(2.0) - 1;
  for (const double accuracy : {1e-3, 1e-6, 1e-12}) {
    const ArcLength got = arcLength(cusp, 0, 1, accuracy);
    EXPECT_LE(std::abs(got.value - exact), accuracy);
    EXPECT_TRUE(got.converged);
    EXPECT_LE(std::abs(arcLength(cusp, 0.1, 0.9, accuracy).value - (std::pow(1 + 0.64, 1.5) - 1)),
              accuracy);
  }
  const ArcLength greedy = arcLength(cusp, 0.1, 0.95, 1e-30);
  EXPECT_FALSE(greedy.converged);
  EXPECT_NEAR(greedy.value, 0.5 * (std::pow(1.64, 1.5) + std::pow(1.81, 1.5)) - 1, 1e-14);
}

TEST(Chains, OpenAndClosedIndices) {
  EXPECT_TRUE(BezierChain::whyInvalid(3, false, 6));
  EXPECT_FALSE(BezierChain::whyInvalid(3, false, 7));
  EXPECT_TRUE(BezierChain::whyInvalid(3, true, 7));
  EXPECT_FALSE(BezierChain::whyInvalid(3, true, 6));
  EXPECT_TRUE(BezierChain::whyInvalid(0, false, 3));
  EXPECT_TRUE(BezierChain::whyInvalid(2, false, 1));
  Random random(announcedSeed("chains", 105));
  const BezierChain open(3, false, randomBezier(random, 7).points),
      closed(3, true, randomBezier(random, 6).points);
  EXPECT_EQ(open.pieceCount(), 2);
  EXPECT_EQ(closed.pieceCount(), 2);
  EXPECT_EQ(closed.piece(1).points.back(), closed.points().front());
  EXPECT_EQ(open.piece(1).points.back(), open.points().back());
  EXPECT_EQ(open.piece(0).points.back(), open.piece(1).points.front());
  EXPECT_EQ(open.locate(1.0).piece, 1);
  EXPECT_EQ(open.locate(1.0).t, 0.0);
  EXPECT_EQ(open.locate(2.0).piece, 1);
  EXPECT_EQ(open.locate(2.0).t, 1.0);
  EXPECT_EQ(open.locate(-3.0).piece, 0);
  EXPECT_EQ(open.locate(-3.0).t, 0.0);
  EXPECT_EQ(open.locate(9.0).t, 1.0);
  EXPECT_EQ(closed.locate(1.25).piece, 1);
  EXPECT_EQ(pointAt(closed, 2.0), closed.points()[0]);
  EXPECT_TRUE(open.isJoint(0));
  EXPECT_TRUE(open.isJoint(6));
  EXPECT_FALSE(open.isJoint(2));
}

TEST(Chains, EditsKeepTheShape) {
  Random random(announcedSeed("chain edits", 106));
  for (int i = 0; i < 120; ++i) {
    const int degree = 1 + i % 5, pieces = 1 + i % 3;
    const bool closed = i % 2 && pieces * degree >= 2;
    const BezierChain chain(degree, closed,
                            randomBezier(random, degree * pieces + (closed ? 0 : 1)).points);
    const double s = uniform(random, 0, pieces), cut = uniform(random, 0, pieces);
    EXPECT_LT((pointAt(elevated(chain), s) - pointAt(chain, s)).norm(), 1e-14);
    EXPECT_LT((pointAt(reversed(chain), pieces - s) - pointAt(chain, s)).norm(), 1e-14);
    EXPECT_EQ(reversed(chain).closed(), closed);
    const BezierChain split = splitAt(chain, cut);
    EXPECT_EQ(split.pieceCount(), pieces + 1);
    EXPECT_EQ(split.closed(), closed);
    const double whole = std::floor(cut), local = cut - whole;
    const double mapped = s < whole       ? s
                          : s < cut       ? whole + (s - whole) / local
                          : s < whole + 1 ? whole + 1 + (s - cut) / (1 - local)
                                          : s + 1;
    EXPECT_LT((pointAt(split, mapped) - pointAt(chain, s)).norm(), 1e-13);
    EXPECT_EQ(splitAt(chain, 0.0), chain);
    EXPECT_EQ(splitAt(chain, pieces), chain);
    EXPECT_NEAR(arcLength(split, 0, pieces + 1, 1e-12).value,
                arcLength(chain, 0, pieces, 1e-12).value, 1e-11);
    EXPECT_NEAR(twiceSignedArea(reversed(chain)), -twiceSignedArea(chain), 1e-13);
    EXPECT_NEAR(twiceSignedArea(split), twiceSignedArea(chain), 1e-13);
  }
  // A joint that was inserted and not moved can be taken out again without a trace.
  for (int i = 0; i < 60; ++i) {
    const int degree = 2 + i % 5;
    const BezierChain curve(randomBezier(random, degree + 1));
    const BezierChain split = splitAt(curve, uniform(random, 0.1, 0.9));
    const RemovalResult back = removePoints(split, {static_cast<std::size_t>(degree)});
    ASSERT_TRUE(back.chain) << back.reason;
    ASSERT_EQ(back.chain->points().size(), curve.points().size());
    for (std::size_t k = 0; k < curve.points().size(); ++k) {
      EXPECT_LT((back.chain->points()[k] - curve.points()[k]).norm(), 1e-9) << degree;
    }
    // Moved, it cannot; the ends stay where they are.
    const auto moved =
        movePoints(split, {static_cast<std::size_t>(degree)}, {0.3, 0.2}, JointMode::Keep);
    const RemovalResult other = removePoints(moved, {static_cast<std::size_t>(degree)});
    ASSERT_TRUE(other.chain) << other.reason;
    EXPECT_EQ(other.chain->points().front(), curve.points().front());
    EXPECT_EQ(other.chain->points().back(), curve.points().back());
  }
  EXPECT_DOUBLE_EQ(twiceSignedArea(BezierChain(1, true, {{0, 0}, {1, 0}, {1, 1}, {0, 1}})), 2.0);
  // Under y = 1 - x^2 ... the parabola's arch over its chord: area 4/3 below, walked clockwise.
  EXPECT_DOUBLE_EQ(twiceSignedArea(BezierChain(Bezier{{{-1, 0}, {0, 2}, {1, 0}}})), -8.0 / 3.0);
}

TEST(Frames, SignsFollowTheThesis) {
  // Counter-clockwise quarter turn seen from its outer side: k = +1/R.
  const Jet jet{{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
  EXPECT_DOUBLE_EQ(frameOf(jet, -1).k, 0.5);
  EXPECT_DOUBLE_EQ(frameOf(jet, 1).k, -0.5);
  EXPECT_EQ(frameOf(jet, -1).normal, Vec2(1, 0));
  EXPECT_DOUBLE_EQ(frameOf(jet).kPrime, 0.0);
  EXPECT_DOUBLE_EQ(frameOf(jet).speed, 2.0);
}

}  // namespace
}  // namespace flatland::test
