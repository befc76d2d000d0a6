// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue of degenerate cases: each preset's expected answer, in full. Places come from
// closed forms where there are any; where not, the marks are also held against the brute-force
// search.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "flatland/features/features.h"
#include "flatland/io/scene_json.h"
#include "flatland/scene/degenerate_presets.h"
#include "flatland/screen/sweep.h"
#include "flatland/screen/visibility.h"
#include "tests/support/brute_marks.h"

namespace flatland::test {
namespace {

constexpr double kPlace = 1e-13;  // of coordinates of order 1

const Preset& preset(const std::string& id) {
  const auto found = std::find_if(allPresets().begin(), allPresets().end(),
                                  [&](const Preset& p) { return p.id == id; });
  if (found == allPresets().end()) throw std::runtime_error("no preset " + id);
  return *found;
}

struct Expected {
  MarkKind kind;
  Vec2 point;
  double tolerance = kPlace;
};
using Kind = MarkKind;
using What = Degenerate::What;

/// All marks, in the order of the program, all degenerate stretches, and nothing unresolved.
FeatureSet expectAnswer(const std::string& id, const std::vector<Expected>& marks,
                        const std::vector<Degenerate>& degenerate) {
  FeatureSet found = findFeatures(preset(id).scene);
  EXPECT_TRUE(found.complete()) << id;
  EXPECT_EQ(found.marks.size(), marks.size()) << id;
  for (std::size_t i = 0; i < std::min(marks.size(), found.marks.size()); ++i) {
    EXPECT_EQ(nameOf(found.marks[i].kind), nameOf(marks[i].kind)) << id << ' ' << i;
    EXPECT_LT((found.marks[i].point - marks[i].point).norm(), marks[i].tolerance)
        << id << ' ' << nameOf(found.marks[i].kind) << " at " << found.marks[i].point.transpose();
    EXPECT_LT(std::abs(found.marks[i].residual), 1e-13) << id << ' ' << i;
  }
  EXPECT_EQ(found.degenerate.size(), degenerate.size()) << id;
  for (std::size_t i = 0; i < std::min(degenerate.size(), found.degenerate.size()); ++i) {
    EXPECT_EQ(found.degenerate[i].what, degenerate[i].what) << id;
    EXPECT_EQ(found.degenerate[i].tLow, degenerate[i].tLow) << id;
    EXPECT_EQ(found.degenerate[i].tHigh, degenerate[i].tHigh) << id;
  }
  found.marks.resize(marks.size());
  return found;
}

TEST(DegeneratePresets, Cusp) {
  // The minimum of lambda has no closed form; its residual says that it is one.
  const FeatureSet found =
      expectAnswer("cusp",
                   {{Kind::ApparentMinimum, {-0.852826413953, -0.67916621688}, 1e-11},
                    {Kind::Silhouette, {0, 0.4}},
                    {Kind::Corner, {0, 0.4}}},
                   {});
  EXPECT_EQ(found.marks[1].t, 0.5);
  EXPECT_EQ(found.marks[2].t, 0.5);
  EXPECT_EQ(std::abs(found.marks[2].turnDeg), 180.0);
}

TEST(DegeneratePresets, Pause) {
  const FeatureSet found =
      expectAnswer("pause", {{Kind::Valley, {0, 0}}, {Kind::ApparentRidge, {0, 0}}}, {});
  for (const Mark& mark : found.marks) {
    EXPECT_EQ(mark.t, 0.5);
    EXPECT_FALSE(mark.lambda);  // infinite
  }
}

TEST(DegeneratePresets, Straight) {
  expectAnswer("collinear", {}, {{What::Straight, 0, 0, 1}});
  expectAnswer("end-on", {}, {{What::StraightEndOn, 0, 0, 1}});
  const FeatureSet back =
      expectAnswer("turning-back", {{Kind::Silhouette, {1, 0.5}}, {Kind::Corner, {1, 0.5}}},
                   {{What::Straight, 0, 0, 0.5}, {What::Straight, 0, 0.5, 1}});
  EXPECT_EQ(std::abs(back.marks[1].turnDeg), 180.0);
}

TEST(DegeneratePresets, Point) { expectAnswer("point", {}, {{What::Point, 0, 0, 1}}); }

TEST(DegeneratePresets, Coincident) {
  expectAnswer("coincident",
               {{Kind::Flat, {-1.216221468133, -0.25332471994}, 1e-11},
                {Kind::ApparentMinimum, {-1.155345211143, -0.206098282149}, 1e-11},
                {Kind::Ridge, {0.6828881348, 0.319991386606}, 1e-11},
                {Kind::ApparentRidge, {0.909177487162, 0.208374426094}, 1e-11}},
               {});
}

// For a graph y = f(x) seen from above: apparent ridge f''' (1 + f'^2) = 2 f' f''^2, ridge or
// valley f''' (1 + f'^2) = 3 f' f''^2.
TEST(DegeneratePresets, InflectionAtAnEnd) {
  // f = 4/9 x^3: x^4 = 3/16, and 9/80.
  const auto at = [](double x) { return Vec2(x, 4.0 / 9.0 * x * x * x); };
  const FeatureSet found = expectAnswer("inflection-at-end",
                                        {{Kind::Inflection, {0, 0}},
                                         {Kind::Valley, at(std::pow(9.0 / 80.0, 0.25))},
                                         {Kind::ApparentRidge, at(std::pow(3.0 / 16.0, 0.25))}},
                                        {});
  EXPECT_EQ(found.marks[0].t, 0.0);
  EXPECT_EQ(found.marks[0].lambda, 0.0);
  // lambda = f''^2 / (1 + f'^2)^2 = 3 x^2 4 ... = sqrt(3) at x^4 = 3/16.
  EXPECT_NEAR(*found.marks[2].lambda, std::sqrt(3.0), 1e-13);
}

TEST(DegeneratePresets, SilhouetteAtAnInflection) {
  // f = 8/27 x^3: curvature is extreme at x^4 = 81/320.
  const double x = std::pow(81.0 / 320.0, 0.25), y = 8.0 / 27.0 * x * x * x;
  const FeatureSet found = expectAnswer("silhouette-at-inflection",
                                        {{Kind::Valley, {-x, -y}},
                                         {Kind::Silhouette, {0, 0}},
                                         {Kind::Inflection, {0, 0}},
                                         {Kind::Ridge, {x, y}}},
                                        {});
  EXPECT_EQ(found.marks[1].t, 0.5);
  EXPECT_EQ(found.marks[2].t, 0.5);
}

TEST(DegeneratePresets, Undulation) {
  const double a = std::pow(1.0 / 32.0, 1.0 / 6.0), v = std::pow(1.0 / 56.0, 1.0 / 6.0);
  const auto at = [](double x) { return Vec2(x, std::pow(x, 4)); };
  const FeatureSet found = expectAnswer("undulation",
                                        {{Kind::ApparentRidge, at(-a)},
                                         {Kind::Valley, at(-v)},
                                         {Kind::Flat, {0, 0}},
                                         {Kind::ApparentMinimum, {0, 0}},
                                         {Kind::Valley, at(v)},
                                         {Kind::ApparentRidge, at(a)}},
                                        {});
  EXPECT_EQ(found.marks[2].t, 0.5);
  EXPECT_EQ(found.marks[3].lambda, 0.0);
}

TEST(DegeneratePresets, ConstantCurvature) {
  const FeatureSet found = expectAnswer("constant-curvature",
                                        {{Kind::Silhouette, {1, 0}},
                                         {Kind::ApparentMinimum, {0, 1}},
                                         {Kind::Silhouette, {-1, 0}},
                                         {Kind::ApparentMinimum, {0, -1}}},
                                        {{What::ConstantCurvature, 0, 0, 1}});
  // lambda = 1 / (R n.w)^2
  EXPECT_NEAR(*found.marks[1].lambda, 1.0, 1e-14);
  EXPECT_NEAR(*found.marks[3].lambda, 1.0, 1e-14);
}

TEST(DegeneratePresets, DoubleRoot) {
  const FeatureSet found =
      expectAnswer("double-root",
                   {{Kind::ApparentMinimum, 3 * Vec2(-0.196345045243, -0.17868303568), 1e-11},
                    {Kind::ApparentRidge, 3 * Vec2(0.363673427224, 0.445107122393), 1e-11}},
                   {});
  // The double root is really there: k' vanishes at the middle and is positive (by size) beside it.
  const SceneCurve& curve = preset("double-root").scene.curves[0];
  const auto kPrime = [&](double t) { return frameOf(jetAt(curve.shape, t)).kPrime; };
  EXPECT_NEAR(kPrime(0.5), 0.0, 1e-16);
  const double left = kPrime(0.45), right = kPrime(0.55);
  EXPECT_GT(left * right, 0.0);
  EXPECT_GT(std::abs(left), 1e-6);
  EXPECT_NEAR(kPrime(0.505) / kPrime(0.51), 0.25, 0.05);  // of second order
}

TEST(DegeneratePresets, StraightPiece) {
  expectAnswer(
      "straight-piece",
      {{Kind::Valley, {0.234991101039, 0.160557380565}, 1e-11}, {Kind::Silhouette, {0.5, 1}}},
      {{What::Straight, 0, 0, 1}});
}

TEST(DegeneratePresets, CornerWithAFold) {
  const std::vector<Degenerate> straight{{What::Straight, 0, 0, 1}, {What::Straight, 0, 1, 2}};
  const FeatureSet found =
      expectAnswer("corner-fold", {{Kind::Silhouette, {0, -1}}, {Kind::Corner, {0, -1}}}, straight);
  // From direction (1, -2) to (1, 1.5).
  EXPECT_NEAR(found.marks[1].turnDeg,
              (std::atan2(1.5, 1.0) + std::atan2(2.0, 1.0)) * 180.0 / std::acos(-1.0), 1e-12);
  Scene above = preset("corner-fold").scene;
  above.view.angleDeg = 90.0;
  const FeatureSet unfolded = findFeatures(above);
  ASSERT_EQ(unfolded.marks.size(), 1U);
  EXPECT_EQ(unfolded.marks[0].kind, Kind::Corner);
}

TEST(DegeneratePresets, CurvatureJumps) {
  const FeatureSet found =
      expectAnswer("jump", {{Kind::Ridge, {0, 1}}, {Kind::ApparentRidge, {0, 1}}}, {});
  for (const Mark& mark : found.marks) {
    EXPECT_EQ(mark.t, 1.0);
    EXPECT_NEAR(*mark.lambda, 16.0, 1e-13);  // k = 4 on the right, seen straight on
  }
}

TEST(DegeneratePresets, TheWholeCatalogue) {
  std::set<std::string> ids;
  int degenerate = 0;
  for (const Preset& p : allPresets()) {
    EXPECT_TRUE(ids.insert(p.id).second) << p.id;
    EXPECT_EQ(p.group == kDegenerateGroup, !p.expected.empty()) << p.id;
    degenerate += p.group == kDegenerateGroup;
    // Whatever the case, everything that can be done with a scene can be done.
    EXPECT_EQ(sceneFromJson(sceneToJson(p.scene), p.id), p.scene);
    for (const double turn : {0.0, 33.0, 90.0}) {
      Scene scene = p.scene;
      scene.view.angleDeg += turn;
      for (const std::optional<double> distance : {std::optional<double>(), std::optional(8.0)}) {
        scene.view.distance = distance;
        const FeatureSet found = findFeatures(scene);
        for (const Mark& mark : found.marks) {
          EXPECT_TRUE(mark.point.allFinite()) << p.id;
          EXPECT_FALSE(std::isnan(mark.residual)) << p.id << ' ' << turn;
        }
        const Visibility visibility(scene);
        for (std::size_t i = 0; i < scene.curves.size(); ++i) {
          for (const auto& interval : visibility.visibleIntervals(static_cast<int>(i))) {
            EXPECT_LT(interval.tLow, interval.tHigh) << p.id;
          }
        }
      }
    }
    std::size_t points = 0;
    for (const SweepBranch& branch : sweepOf(p.scene).branches) points += branch.points.size();
    EXPECT_LT(points, 100'000U) << p.id;  // where curvature is infinite there is no end of detail
    const FeatureSet found = findFeatures(p.scene);
    // The search by sampling knows sign changes inside smooth pieces: no zero of the speed, and no
    // silhouette that only touches.
    const bool known = p.id != "pause" && p.id != "cusp" && p.id != "silhouette-at-inflection";
    if (!p.expected.empty() && known && found.degenerate.empty()) {
      EXPECT_EQ(differenceFromBrute(p.scene, found, 0), "") << p.id;
    }
  }
  EXPECT_GE(degenerate, 14);
}

}  // namespace
}  // namespace flatland::test
