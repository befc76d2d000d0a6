// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of random curves against brute force: none missing, none extra, of every kind.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "flatland/features/features.h"
#include "flatland/features/orientation.h"
#include "tests/support/brute_marks.h"
#include "tests/support/seed.h"
#include "tests/support/sturm.h"

namespace flatland::test {
namespace {

Bezier randomBezier(Random& random, int points) {
  Bezier b;
  for (int i = 0; i < points; ++i)
    b.points.emplace_back(uniform(random, 0, 1), uniform(random, 0, 1));
  return b;
}

struct Totals {
  long curves = 0;
  std::array<long, kMarkKindCount> marks{};
  double worstResidual = 0.0;
};

void print(const Totals& totals) {
  std::cout << "curves " << totals.curves;
  for (int k = 0; k < kMarkKindCount; ++k) {
    std::cout << ", " << nameOf(static_cast<MarkKind>(k)) << ' '
              << totals.marks[static_cast<std::size_t>(k)];
  }
  std::cout << ", worst residual " << totals.worstResidual << '\n';
}

FeatureSet checkAgainstBrute(const Scene& scene, Totals& totals) {
  const FeatureSet found = findFeatures(scene);
  EXPECT_TRUE(found.complete()) << described(scene);
  EXPECT_TRUE(found.degenerate.empty()) << described(scene);
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    ++totals.curves;
    const std::string difference = differenceFromBrute(scene, found, static_cast<int>(i));
    EXPECT_TRUE(difference.empty()) << difference << described(scene);
  }
  const ViewFrame frame = frameOf(scene.view);
  for (const Mark& mark : found.marks) {
    ++totals.marks[static_cast<std::size_t>(mark.kind)];
    totals.worstResidual = std::max(totals.worstResidual, mark.residual);
    const BezierChain& chain = scene.curves[static_cast<std::size_t>(mark.curve)].chain();
    EXPECT_LT((pointAt(chain, mark.t) - mark.point).norm(), 1e-14);
    EXPECT_EQ(mark.lambda.has_value(),
              mark.kind != MarkKind::Silhouette && mark.kind != MarkKind::Corner);
    if (mark.lambda) {
      const ChainParameter at = chain.locate(mark.t);
      double lambda = bruteLambda(chain.piece(at.piece), frame, at.t);
      if (at.t == 0.0 && (at.piece > 0 || chain.closed())) {
        // At a joint lambda may jump: the mark has the value that makes it one.
        const int count = chain.pieceCount();
        const double before = bruteLambda(chain.piece((at.piece + count - 1) % count), frame, 1.0);
        const bool nearerBefore = std::abs(*mark.lambda - before) < std::abs(*mark.lambda - lambda);
        if (mark.kind == MarkKind::ApparentRidge) {
          lambda = std::max(lambda, before);
        } else if (mark.kind == MarkKind::ApparentMinimum) {
          lambda = std::min(lambda, before);
        } else if (nearerBefore) {
          lambda = before;
        }
      }
      // At an inflection lambda is the square of rounding.
      if (mark.kind != MarkKind::Inflection) {
        EXPECT_NEAR(*mark.lambda, lambda, 1e-6 * lambda) << described(scene);
      }
    }
    if (mark.screen && !frame.distance) {
      EXPECT_NEAR(*mark.screen, mark.point.dot(frame.axis), 1e-14);
    }
    // At joints the derivative may jump past zero.
    if (mark.kind == MarkKind::ApparentRidge && mark.t != std::floor(mark.t)) {
      const double sum = *mark.feature + *mark.offset + *mark.perspective;
      const double size =
          std::abs(*mark.feature) + std::abs(*mark.offset) + std::abs(*mark.perspective);
      EXPECT_LE(std::abs(sum), 1e-6 * size + 1e-9) << described(scene);
    }
  }
  return found;
}

// Exact numbers of roots for a view along an axis: only signs of integers decide. All roots of
// random curves are simple.
void checkCounts(const Scene& scene, const FeatureSet& found) {
  const ViewFrame frame = frameOf(scene.view);
  const BezierChain& chain = scene.curves[0].chain();
  std::vector<double> along, towards;
  for (const Vec2& p : chain.points()) {
    along.push_back(p.dot(frame.axis));  // exact: the axis has entries 0 and +-1
    towards.push_back(p.dot(frame.towards));
  }
  std::vector<double> all = along;
  all.insert(all.end(), towards.begin(), towards.end());
  const int shift = ExactPolynomial::shiftFor(all);
  const ExactPolynomial x = ExactPolynomial::fromBernstein(along, shift).derivative();
  const ExactPolynomial y = ExactPolynomial::fromBernstein(towards, shift).derivative();
  const ExactPolynomial c = x * y.derivative() - y * x.derivative(), s2 = x * x + y * y, v = s2 * x;
  const auto expect = [&](const ExactPolynomial& p, std::initializer_list<MarkKind> kinds) {
    long marks = 0;
    for (const Mark& mark : found.marks) marks += std::count(kinds.begin(), kinds.end(), mark.kind);
    EXPECT_EQ(Sturm(p).distinct(0.0, 1.0), marks) << nameOf(*kinds.begin()) << described(scene);
  };
  expect(x, {MarkKind::Silhouette});
  expect(c, {MarkKind::Inflection});
  expect(Integer(2) * (c.derivative() * s2) - Integer(3) * (c * s2.derivative()),
         {MarkKind::Ridge, MarkKind::Valley, MarkKind::Flat});
  expect(c.derivative() * v - c * v.derivative(),
         {MarkKind::ApparentRidge, MarkKind::ApparentMinimum});
}

Scene sceneOf(BezierChain chain, const View& view) {
  return Scene{.curves = {SceneCurve{.shape = std::move(chain), .flipNormal = false}},
               .view = view};
}

TEST(FeaturesBrute, OpenCurvesOfFivePoints) {
  Random random(announcedSeed("five points", 55));
  Totals totals;
  for (int i = 0; i < 2000; ++i) {
    const bool axis = i % 4 == 0;
    const View view{.angleDeg = axis ? 90.0 * uniformInt(random, 0, 3) : uniform(random, -180, 180),
                    .distance = {}};
    Scene scene = sceneOf(BezierChain(randomBezier(random, 5)), view);
    scene.curves[0].flipNormal = i % 7 == 0;
    const FeatureSet found = checkAgainstBrute(scene, totals);
    if (axis) checkCounts(scene, found);
  }
  print(totals);
  for (const MarkKind kind :
       {MarkKind::Silhouette, MarkKind::Inflection, MarkKind::Ridge, MarkKind::Valley,
        MarkKind::Flat, MarkKind::ApparentRidge, MarkKind::ApparentMinimum}) {
    EXPECT_GT(totals.marks[static_cast<std::size_t>(kind)], 300) << nameOf(kind);
  }
  // On near-cusps one unit in the last place of t shows; elsewhere residuals are rounding.
  EXPECT_LT(totals.worstResidual, 1e-8);
}

TEST(FeaturesBrute, OtherDegrees) {
  Random random(announcedSeed("other degrees", 66));
  Totals totals;
  for (int i = 0; i < 350; ++i) {
    const int points = std::array{3, 4, 6, 7, 8, 9}[static_cast<std::size_t>(i % 6)];
    const View view{
        .angleDeg = i % 3 ? uniform(random, -180, 180) : 90.0 * uniformInt(random, 0, 3),
        .distance = {}};
    const Scene scene = sceneOf(BezierChain(randomBezier(random, points)), view);
    const FeatureSet found = checkAgainstBrute(scene, totals);
    if (i % 3 == 0 && points > 3) checkCounts(scene, found);
  }
  print(totals);
}

TEST(FeaturesBrute, Perspective) {
  Random random(announcedSeed("perspective", 77));
  Totals totals;
  for (int i = 0; i < 300; ++i) {
    // From near enough that perspective matters, outside the unit square.
    const View view{.angleDeg = uniform(random, -180, 180), .distance = uniform(random, 1.5, 4.0)};
    checkAgainstBrute(sceneOf(BezierChain(randomBezier(random, uniformInt(random, 3, 6))), view),
                      totals);
  }
  print(totals);
}

TEST(FeaturesBrute, KinkedChains) {
  Random random(announcedSeed("kinked chains", 88));
  Totals totals;
  for (int i = 0; i < 150; ++i) {
    const int degree = uniformInt(random, 2, 5), pieces = uniformInt(random, 2, 4);
    const bool closed = i % 2 == 0;
    const std::size_t count = static_cast<std::size_t>(degree * pieces + (closed ? 0 : 1));
    const BezierChain chain(degree, closed, randomBezier(random, static_cast<int>(count)).points);
    const View view{.angleDeg = uniform(random, -180, 180),
                    .distance = i % 3 ? std::nullopt : std::optional(uniform(random, 1.5, 4.0))};
    const Scene scene = sceneOf(chain, view);
    const FeatureSet found = checkAgainstBrute(scene, totals);
    // Every joint is a corner; it is also a silhouette exactly if the screen motion reverses there.
    const ViewFrame frame = frameOf(view);
    for (int joint = closed ? 0 : 1; joint < pieces; ++joint) {
      const Bezier in = chain.piece((joint + pieces - 1) % pieces), out = chain.piece(joint);
      const Vec2 point = out.points[0], before = in.points.back() - in.points[in.points.size() - 2],
                 after = out.points[1] - point;
      const Vec2 w = towardsViewer(frame, point);
      const bool folds = cross(before, w) * cross(after, w) < 0.0;
      int corners = 0, silhouettes = 0, others = 0;
      double turnDeg = 0.0;
      for (const Mark& mark : found.marks) {
        if (mark.t != joint && !(closed && joint == 0 && mark.t == pieces)) continue;
        if (mark.kind == MarkKind::Corner) turnDeg = mark.turnDeg;
        ++(mark.kind == MarkKind::Corner       ? corners
           : mark.kind == MarkKind::Silhouette ? silhouettes
                                               : others);
      }
      EXPECT_EQ(corners, 1) << joint << described(scene);
      EXPECT_EQ(silhouettes, folds ? 1 : 0) << joint << described(scene);
      EXPECT_EQ(others, 0) << joint << described(scene);
      EXPECT_NEAR(turnDeg,
                  std::atan2(cross(before, after), before.dot(after)) * 180.0 / 3.14159265358979324,
                  1e-9);
    }
  }
  print(totals);
}

// Chains with smooth joints where curvature jumps: marks at the joints are judged by values beside
// them.
TEST(FeaturesBrute, SmoothChains) {
  Random random(announcedSeed("smooth chains", 99));
  Totals totals;
  for (int i = 0; i < 150; ++i) {
    const int pieces = uniformInt(random, 2, 4);
    const bool closed = i % 2 == 0;
    std::vector<Vec2> points = randomBezier(random, 3 * pieces + (closed ? 0 : 1)).points;
    const int count = static_cast<int>(points.size());
    for (int joint = closed ? 0 : 3; joint < (closed ? count : count - 1); joint += 3) {
      const std::size_t at = static_cast<std::size_t>(joint),
                        before = static_cast<std::size_t>((joint + count - 1) % count);
      points[at] = 0.5 * (points[before] + points[static_cast<std::size_t>((joint + 1) % count)]);
    }
    const BezierChain chain(3, closed, points);
    const View view{.angleDeg = uniform(random, -180, 180), .distance = {}};
    const Scene scene = sceneOf(chain, view);
    const FeatureSet found = checkAgainstBrute(scene, totals);
    const ViewFrame frame = frameOf(view);
    const int side = normalSide(scene.curves[0], frame);
    for (int joint = closed ? 0 : 1; joint < pieces; ++joint) {
      const Bezier in = chain.piece((joint + pieces - 1) % pieces), out = chain.piece(joint);
      // Values at the joint from both sides, and a little further.
      constexpr double kAside = 1e-7;
      const auto curvature = [&](const Bezier& b, double t) {
        return frameOf(jetAt(b, t), side).k;
      };
      const auto judged = [&](double leftFar, double left, double right, double rightFar) {
        const double high = std::max(left, right), low = std::min(left, right);
        return std::pair(leftFar < high && rightFar<high, leftFar> low && rightFar > low);
      };
      const double kl = curvature(in, 1.0), kr = curvature(out, 0.0);
      const auto [kMax, kMin] = judged(curvature(in, 1.0 - kAside), kl, kr, curvature(out, kAside));
      const auto [lMax, lMin] =
          judged(bruteLambda(in, frame, 1.0 - kAside), bruteLambda(in, frame, 1.0),
                 bruteLambda(out, frame, 0.0), bruteLambda(out, frame, kAside));
      std::array<int, kMarkKindCount> here{};
      for (const Mark& mark : found.marks) {
        if (mark.t == joint || (closed && joint == 0 && mark.t == pieces)) {
          ++here[static_cast<std::size_t>(mark.kind)];
        }
      }
      const auto countOf = [&](MarkKind kind) { return here[static_cast<std::size_t>(kind)]; };
      const std::string where = " joint " + std::to_string(joint) + described(scene);
      EXPECT_EQ(countOf(MarkKind::Corner), 0) << where;
      EXPECT_EQ(countOf(MarkKind::Silhouette), 0) << where;
      EXPECT_EQ(countOf(MarkKind::Inflection), kl * kr < 0 ? 1 : 0) << where;
      EXPECT_EQ(countOf(MarkKind::Ridge), kMax && std::max(kl, kr) > 0 ? 1 : 0) << where;
      EXPECT_EQ(countOf(MarkKind::Valley), kMin && std::min(kl, kr) < 0 ? 1 : 0) << where;
      EXPECT_EQ(countOf(MarkKind::ApparentRidge), lMax ? 1 : 0) << where;
      if (kl * kr > 0) {
        EXPECT_EQ(countOf(MarkKind::ApparentMinimum), lMin ? 1 : 0) << where;
      }
    }
  }
  print(totals);
}

}  // namespace
}  // namespace flatland::test
