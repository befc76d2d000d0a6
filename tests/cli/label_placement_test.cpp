// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/label_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/seed.h"

namespace flatland::ui {
namespace {

double cost(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

TEST(PlaceFree, LeavesOutWhereAnyPlaceCoversSomething) {
  LabelPlacer placer;
  const Vec2 half(4.5, 6.0), left(-1.0, 0.0);
  // As many as have room stand clear of each other; then there is none, and nothing is blocked.
  std::vector<Vec2> placed;
  while (const auto at = placer.placeFree(Vec2::Zero(), half, left)) {
    for (const Vec2& other : placed) {
      EXPECT_GE(((*at - other).cwiseAbs() - 2.0 * half).maxCoeff(), -1e-12);
    }
    placed.push_back(*at);
    ASSERT_LT(placed.size(), 50u);
  }
  EXPECT_GE(placed.size(), 4u);
  EXPECT_FALSE(placer.placeFree(Vec2::Zero(), half, left));
  EXPECT_TRUE(placer.placeFree(Vec2(200.0, 0.0), half, left)) << "elsewhere there is room";
}

TEST(IsFree, SaysWhetherABoxIsCovered) {
  LabelPlacer placer;
  placer.block(Vec2(100.0, 50.0), Vec2(70.0, 4.0));  // wider than a square of the search
  const Vec2 half(4.5, 6.0);
  EXPECT_FALSE(placer.isFree(Vec2(100.0, 50.0), half));
  EXPECT_FALSE(placer.isFree(Vec2(174.0, 50.0), half));
  EXPECT_FALSE(placer.isFree(Vec2(26.0, 59.5), half));
  EXPECT_TRUE(placer.isFree(Vec2(174.6, 50.0), half));
  EXPECT_TRUE(placer.isFree(Vec2(100.0, 60.1), half));
}

TEST(SpreadApart, LeavesWhatIsFarEnough) {
  EXPECT_TRUE(spreadApart({}, 10.0).empty());
  EXPECT_EQ(spreadApart({7.0}, 10.0), std::vector<double>{7.0});
  const std::vector<double> wide{0.0, 10.0, 25.0};
  EXPECT_EQ(spreadApart(wide, 10.0), wide);
}

TEST(SpreadApart, PushesEquallyToBothSides) {
  EXPECT_EQ(spreadApart({5.0, 5.0}, 10.0), (std::vector<double>{0.0, 10.0}));
  EXPECT_EQ(spreadApart({0.0, 0.0, 0.0}, 4.0), (std::vector<double>{-4.0, 0.0, 4.0}));
  // The pushed pair meets the third, which gives way too.
  const std::vector<double> placed = spreadApart({0.0, 0.0, 6.0}, 6.0);
  EXPECT_NEAR(placed[0], -4.0, 1e-12);
  EXPECT_NEAR(placed[1], 2.0, 1e-12);
  EXPECT_NEAR(placed[2], 8.0, 1e-12);
}

TEST(SpreadApart, IsTheNearestOfAllThatKeepTheGap) {
  test::Random random(test::announcedSeed("spreadApart", 20070502));
  for (int run = 0; run < 300; ++run) {
    std::vector<double> wanted(static_cast<std::size_t>(test::uniformInt(random, 1, 12)));
    for (double& w : wanted) w = test::uniform(random, 0.0, 60.0);
    std::sort(wanted.begin(), wanted.end());
    const double gap = test::uniform(random, 0.0, 12.0);
    const std::vector<double> placed = spreadApart(wanted, gap);
    ASSERT_EQ(placed.size(), wanted.size());
    for (std::size_t i = 1; i < placed.size(); ++i) {
      EXPECT_GE(placed[i] - placed[i - 1], gap - 1e-9);
    }
    // No admissible placing is nearer: tried by moving it towards random admissible ones, which
    // finds any better one since both the set and the distance are convex.
    for (int other = 0; other < 30; ++other) {
      std::vector<double> trial = wanted;
      for (double& x : trial) x += test::uniform(random, -15.0, 15.0);
      std::sort(trial.begin(), trial.end());
      for (std::size_t i = 1; i < trial.size(); ++i) {
        trial[i] = std::max(trial[i], trial[i - 1] + gap);
      }
      for (const double share : {1.0, 0.1, 1e-3}) {
        std::vector<double> mixed = placed;
        for (std::size_t i = 0; i < mixed.size(); ++i) mixed[i] += share * (trial[i] - placed[i]);
        EXPECT_GE(cost(mixed, wanted), cost(placed, wanted) - 1e-9);
      }
    }
  }
}

bool overlap(const Vec2& a, const Vec2& b, const Vec2& half) {
  return ((a - b).cwiseAbs() - 2.0 * half).maxCoeff() < 0.0;
}

TEST(LabelPlacer, TakesThePreferredSideWhenFree) {
  LabelPlacer placer;
  const Vec2 place = placer.place({100, 100}, {4, 6}, {-1, 0});
  EXPECT_LT(place.x(), 95.0);
  EXPECT_DOUBLE_EQ(place.y(), 100.0);
}

TEST(LabelPlacer, LabelsOfOnePointDoNotOverlap) {
  LabelPlacer placer;
  const Vec2 half(4, 6);
  std::vector<Vec2> places;
  for (int i = 0; i < 6; ++i) places.push_back(placer.place({50, 50}, half, {1, 0}));
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(overlap(places[i], places[j], half)) << i << " over " << j;
    }
  }
}

TEST(LabelPlacer, KeepsOffBlockedBoxesAndCurves) {
  const Vec2 half(4, 6);
  LabelPlacer blocked;
  blocked.block({30, 50}, {14, 20});  // the whole left side
  EXPECT_FALSE(
      ((blocked.place({50, 50}, half, {-1, 0}) - Vec2(30, 50)).cwiseAbs() - (half + Vec2(14, 20)))
          .maxCoeff() < 0.0);

  LabelPlacer discouraged;
  for (double x = 0.0; x < 50.0; x += 1.0) discouraged.discourage({x, 50.0});
  const Vec2 place = discouraged.place({50, 50}, half, {-1, 0});
  EXPECT_GE(std::abs(place.y() - 50.0), half.y()) << "on the line";
}

TEST(LabelPlacer, AnswersWhereNothingIsFree) {
  LabelPlacer placer;
  placer.block({0, 0}, {1000, 1000});
  const Vec2 place = placer.place({0, 0}, {4, 6}, {0, 1});
  EXPECT_LT(place.norm(), 40.0);
  EXPECT_TRUE(place.allFinite());
}

TEST(LabelPlacer, FarThingsOfAnySizeChangeNothingAndNearOnesDo) {
  // The same letters with and without thousands of things out of their reach, in all four
  // quadrants.
  test::Random random(test::announcedSeed("far things", 20070505));
  const Vec2 half(4, 6);
  LabelPlacer alone, among;
  for (int i = 0; i < 5000; ++i) {
    const double angle = test::uniform(random, -3.2, 3.2), far = test::uniform(random, 300, 2000);
    const Vec2 at = far * Vec2(std::cos(angle), std::sin(angle));
    among.block(at, {test::uniform(random, 1, 60), test::uniform(random, 1, 60)});
    among.discourage(at);
  }
  for (int i = 0; i < 60; ++i) {
    const Vec2 near(test::uniform(random, -90, 90), test::uniform(random, -90, 90));
    alone.block(near, half);
    among.block(near, half);
    const Vec2 anchor(test::uniform(random, -90, 90), test::uniform(random, -90, 90));
    EXPECT_EQ(alone.place(anchor, half, {0, 1}), among.place(anchor, half, {0, 1})) << i;
  }
  // One wide box whose centre is far, but which reaches over the preferred side.
  LabelPlacer wide;
  wide.block({500, 20}, {499, 10});
  EXPECT_LT((wide.place({20, 0}, half, {0, 1})).y(), 10.0);
}

TEST(LabelPlacer, InACrowdTheLetterIsWherePreferred) {
  LabelPlacer placer;
  for (int i = 0; i < 5000; ++i) placer.discourage({0.01 * (i % 100), 0.01 * (i / 100)});
  EXPECT_EQ(placer.place({0, 0}, {4, 6}, {1, 0}).y(), 0.0);
}

}  // namespace
}  // namespace flatland::ui
