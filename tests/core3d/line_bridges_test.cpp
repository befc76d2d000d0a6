// SPDX-License-Identifier: GPL-3.0-or-later
// Lines joined over their gaps.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core3d/draw/bridges.h"
#include "tests/core3d/screen_lines.h"

namespace flatland::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

ScreenChain piece(const Vector2d& from, const Vector2d& to, float z = 0.0f) {
  LineChain chain;
  chain.family = LineFamily::ApparentRidges;
  for (int i = 0; i <= 10; ++i) {
    const Vector2d p = from + 0.1 * i * (to - from);
    chain.points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), z);
    chain.strength.push_back(static_cast<float>(i));
    if (i > 0) chain.triangles.push_back(7);
    if (i > 0) chain.standsOut.push_back(true);
  }
  return onScreen(chain, flatProjection()).front();
}

TEST(Bridges, JoinWhatGoesOnInTheSameDirection) {
  // Three dashes in a row, the middle one the other way round.
  const auto joined =
      bridged({piece({0, 0}, {20, 0}), piece({44, 1}, {24, 0}), piece({48, 1}, {70, 0})},
              flatProjection(), 6.0);
  ASSERT_EQ(joined.size(), 1u);
  const LineChain& chain = joined[0].chain;
  ASSERT_EQ(chain.points.size(), 33u);
  EXPECT_EQ(chain.pieceCount(), chain.triangles.size());
  EXPECT_EQ(chain.pieceCount(), chain.standsOut.size());
  EXPECT_EQ(chain.strength[11], 10.0f);  // where the middle dash, turned round, begins
  for (std::size_t i = 0; i + 1 < 33; ++i) EXPECT_LT(chain.points[i].x(), chain.points[i + 1].x());
}

TEST(Bridges, LeaveApartWhatDoesNotBelongTogether) {
  const auto joins = [](const ScreenChain& a, const ScreenChain& b) {
    return bridged({a, b}, flatProjection(), 6.0).size() == 1;
  };
  const ScreenChain dash = piece({0, 0}, {20, 0});
  EXPECT_TRUE(joins(dash, piece({25, 1}, {45, 1})));
  EXPECT_FALSE(joins(dash, piece({27, 0}, {47, 0})));         // too far
  EXPECT_FALSE(joins(dash, piece({20, 4}, {40, 4})));         // beside it
  EXPECT_FALSE(joins(dash, piece({23, 0}, {23, 20})));        // round a corner
  EXPECT_FALSE(joins(dash, piece({24, 0}, {27, 0})));         // a crumb shorter than the gap
  EXPECT_FALSE(joins(dash, piece({24, 0}, {44, 0}, 30.0f)));  // before it, not on it
  ScreenChain other = piece({24, 0}, {44, 0});
  other.chain.level = 3;
  EXPECT_FALSE(joins(dash, other));
  EXPECT_EQ(bridged({dash, piece({24, 0}, {44, 0})}, flatProjection(), 0.0).size(), 2u);
}

TEST(Bridges, HandOverWhereLinesRunBesideEachOther) {
  const auto joined = [](const ScreenChain& a, const ScreenChain& b) {
    return bridged({a, b}, flatProjection(), 6.0);
  };
  const ScreenChain line = piece({0, 0}, {40, 0});
  // Either way round, in each order, and beside, ahead and behind.
  for (const double overlap : {10.0, 3.0, 0.0, -1.0}) {
    const Vector2d from(40.0 - overlap, 2.0), to(80.0, 2.0);
    for (const auto& lines : {joined(line, piece(from, to)), joined(piece(to, from), line)}) {
      ASSERT_EQ(lines.size(), 1u) << overlap;
      const LineChain& chain = lines[0].chain;
      EXPECT_EQ(chain.pieceCount(), chain.triangles.size());
      EXPECT_EQ(chain.pieceCount(), chain.standsOut.size());
      EXPECT_EQ(chain.points.size(), chain.strength.size());
      // Onward all the way, never doubled, and the step to the side is no steeper than 45 degrees.
      const float way = chain.points.back().x() > chain.points.front().x() ? 1.0f : -1.0f;
      for (std::size_t i = 0; i + 1 < chain.points.size(); ++i) {
        const Eigen::Vector3f step = chain.points[i + 1] - chain.points[i];
        EXPECT_GT(way * step.x(), 0.0f) << overlap;
        EXPECT_LE(std::abs(step.y()), 1.001f * std::abs(step.x())) << overlap;
      }
      EXPECT_NEAR(lines[0].length(), 80.0, 2.0);
    }
  }
  EXPECT_EQ(joined(line, piece({34, 3}, {80, 3})).size(), 2u);   // too far beside
  EXPECT_EQ(joined(line, piece({26, 2}, {80, 2})).size(), 2u);   // for too long
  EXPECT_EQ(joined(line, piece({80, 2}, {36, -9})).size(), 2u);  // crosses it
  EXPECT_EQ(joined(line, piece({36, 2}, {40, 2})).size(), 2u);   // nothing would be left
  EXPECT_EQ(joined(line, piece({39, 2}, {0, 2})).size(), 2u);    // a hairpin
}

TEST(Bridges, MayLeaveNothingOfACrumbBetweenTwo) {
  // In a small picture a line is shorter than what its two neighbours take of it.
  const double length = 0.45, reach = 0.28;
  const auto joined = bridged({piece({-20.0, reach}, {reach, reach}), piece({0, 0}, {length, 0}),
                               piece({length - reach, -reach}, {20.0, -reach})},
                              flatProjection(), 6.0);
  ASSERT_EQ(joined.size(), 1u);
  const LineChain& chain = joined[0].chain;
  EXPECT_EQ(chain.pieceCount(), chain.triangles.size());
  EXPECT_EQ(chain.pieceCount(), chain.standsOut.size());
  EXPECT_EQ(chain.points.size(), chain.strength.size());
  for (const Eigen::Vector3f& p : chain.points) EXPECT_LE(std::abs(p.x()), 20.0f);
}

TEST(Bridges, CloseALoopWithAGap) {
  LineChain chain;
  for (int i = 0; i <= 95; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 97.0;
    chain.points.push_back((30.0 * Vector3d(std::cos(a), std::sin(a), 0.0)).cast<float>());
    chain.strength.push_back(1.0f);
  }
  chain.triangles.assign(95, 0);
  chain.standsOut.assign(95, true);
  const auto joined = bridged(onScreen(chain, flatProjection()), flatProjection(), 6.0);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_TRUE(joined[0].chain.closed);
  EXPECT_EQ(joined[0].chain.points.size(), 96u);
  EXPECT_EQ(joined[0].chain.triangles.size(), 96u);
}

}  // namespace
}  // namespace flatland::test
