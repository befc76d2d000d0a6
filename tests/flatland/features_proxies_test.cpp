// SPDX-License-Identifier: GPL-3.0-or-later
// The same Bezier curves by both ways: certified Bernstein polynomials and Chebyshev proxies. The
// two share the equations but neither the arithmetic nor the way to a root.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flatland/features/curve_marks.h"
#include "flatland/features/orientation.h"
#include "tests/support/brute_marks.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

// Where a root is nearly double, rounding of the function moves it by the root of the rounding.
constexpr double kPlace = 1e-7;

std::vector<CurveMark> sorted(std::vector<CurveMark> marks) {
  std::sort(marks.begin(), marks.end(), [](const CurveMark& a, const CurveMark& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.piece + a.t < b.piece + b.t;
  });
  return marks;
}

// What differs; empty if number, kind, order and place of all marks agree.
std::string difference(const CurveMarks& a, const CurveMarks& b) {
  std::ostringstream text;
  text.precision(17);
  const auto p = sorted(a.marks), q = sorted(b.marks);
  for (std::size_t i = 0; i < std::max(p.size(), q.size()); ++i) {
    const bool agree = i < p.size() && i < q.size() && p[i].kind == q[i].kind &&
                       std::abs(p[i].piece + p[i].t - q[i].piece - q[i].t) <= kPlace;
    if (agree) continue;
    if (i < p.size()) text << nameOf(p[i].kind) << " at " << p[i].piece + p[i].t << " ";
    text << "against ";
    if (i < q.size()) text << nameOf(q[i].kind) << " at " << q[i].piece + q[i].t;
    return text.str();
  }
  return "";
}

Scene randomCurve(Random& random, bool chain) {
  const int degree = uniformInt(random, 2, 6);
  const bool closed = chain && uniformInt(random, 0, 1) == 1;
  const int pieces = chain ? uniformInt(random, 2, 3) : 1;
  std::vector<Vec2> points;
  for (int j = 0; j < degree * pieces + (closed ? 0 : 1); ++j) {
    points.emplace_back(uniform(random, 0.0, 1.0), uniform(random, 0.0, 1.0));
  }
  Scene scene;
  scene.curves.push_back({BezierChain(degree, closed, std::move(points)), false});
  scene.view.angleDeg = uniform(random, -180.0, 180.0);
  if (uniformInt(random, 0, 2) == 0) scene.view.distance = uniform(random, 2.0, 6.0);
  return scene;
}

TEST(FeaturesByProxies, AgreeWithBernsteinOnRandomCurves) {
  Random random(announcedSeed("ProxiesAgainstBernstein", 51));
  int undecided = 0;
  std::size_t marks = 0;
  double bound = 0.0;
  constexpr int kCurves = 700;
  for (int round = 0; round < kCurves; ++round) {
    const Scene scene = randomCurve(random, round % 4 == 0);
    const SceneCurve& curve = scene.curves.front();
    const ViewFrame frame = frameOf(scene.view);
    const int side = normalSide(curve, frame);
    const CurveMarks exact = findCurveMarks(curve.shape, frame, side);
    const CurveMarks found = findCurveMarks(curve.shape, frame, side, RootMethod::Proxies);
    EXPECT_EQ(exact.quality.pieces, 0);
    EXPECT_GT(found.quality.pieces, 0);
    bound = std::max(bound, found.quality.error);
    if (!found.unresolved.empty()) {
      ++undecided;
      std::cout << "undecided: " << found.unresolved.front().reason << " "
                << nameOf(found.unresolved.front().kind) << " " << found.unresolved.front().tLow
                << " " << found.unresolved.front().tHigh << "\n";
      continue;
    }
    marks += found.marks.size();
    EXPECT_EQ(difference(exact, found), "") << round << " " << described(scene);
  }
  EXPECT_LE(undecided, kCurves / 200);
  EXPECT_GT(marks, 3000u);
  EXPECT_LT(bound, 1e-12);
  std::cout << marks << " marks agree, " << undecided << " curves undecided, bound " << bound
            << "\n";
}

}  // namespace
}  // namespace flatland::test
