// SPDX-License-Identifier: GPL-3.0-or-later
// Which stretches of a chain are seen.
#include <gtest/gtest.h>

#include "tests/core3d/screen_lines.h"

namespace flatland::test {
namespace {

using Eigen::Vector2d;

TEST(Stretches, ChangesAreLocated) {
  const ScreenChain chain = straight(std::vector<float>(101, 1.0f));
  const auto stretches = seenBut(chain, {{20.3, 71.77}}, 3.0);
  ASSERT_EQ(stretches.size(), 3u);
  EXPECT_EQ(stretches[0].seen, Seen::Visible);
  EXPECT_EQ(stretches[1].seen, Seen::Hidden);
  EXPECT_NEAR(stretches[1].from, 20.3, 1.0 / 32.0);
  EXPECT_NEAR(stretches[1].to, 71.77, 1.0 / 32.0);
  EXPECT_EQ(stretches[2].to, 100.0);
}

TEST(Stretches, ShortOnesTakeTheirNeighboursAnswer) {
  const ScreenChain chain = straight(std::vector<float>(101, 1.0f));
  // A short gap closes, a short sight in a long gap vanishes, ends too; long ones stay.
  const auto stretches =
      seenBut(chain, {{0.0, 2.0}, {10.0, 12.5}, {40.0, 60.0}, {62.0, 80.0}, {98.5, 101.0}}, 3.0);
  ASSERT_EQ(stretches.size(), 3u);
  EXPECT_NEAR(stretches[1].from, 40.0, 0.05);
  EXPECT_NEAR(stretches[1].to, 80.0, 0.05);
  EXPECT_EQ(stretches[1].seen, Seen::Hidden);
  EXPECT_EQ(
      seenBut(chain, {{0.0, 2.0}, {10.0, 12.5}, {40.0, 60.0}, {62.0, 80.0}, {98.5, 101.0}}, 0.5)
          .size(),
      9u);
}

TEST(Stretches, TheLongerNeighbourIsTakenOnEitherSide) {
  const ScreenChain chain = straight(std::vector<float>(101, 1.0f));
  const auto smoothed = [&](std::vector<Stretch> stretches) {
    smoothStretches(stretches, chain, 3.0);
    return stretches;
  };
  using enum Seen;
  auto result = smoothed({{0.0, 60.0, Outline}, {60.0, 62.0, Hidden}, {62.0, 100.0, Visible}});
  ASSERT_EQ(result.size(), 2u);
  EXPECT_EQ(result[0].to, 62.0);
  result = smoothed({{0.0, 40.0, Outline}, {40.0, 42.0, Hidden}, {42.0, 100.0, Visible}});
  ASSERT_EQ(result.size(), 2u);
  EXPECT_EQ(result[0].to, 40.0);
  // What is covered only beside what is hidden is hidden too.
  result = smoothed({{0.0, 60.0, Outline}, {60.0, 62.0, Covered}, {62.0, 100.0, Hidden}});
  ASSERT_EQ(result.size(), 2u);
  EXPECT_EQ(result[0].to, 60.0);
}

TEST(Stretches, GoRoundAClosedChain) {
  const ScreenChain chain = ring(std::vector<float>(200, 1.0f));
  // Hidden where x > 0: half of the ring, over the start.
  const auto stretches = seenBut(chain, {{0.0, 1e9}}, 3.0);
  ASSERT_EQ(stretches.size(), 2u);
  double hidden = 0.0;
  for (const Stretch& s : stretches) {
    if (s.seen == Seen::Hidden) hidden += s.to - s.from;
  }
  EXPECT_NEAR(hidden, chain.length() / 2.0, 0.1);
  const auto all = seenBut(chain, {}, 3.0);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].to, chain.length());
}

TEST(Stretches, LeaveOutWhatIsBehindTheViewer) {
  Projection projection = flatProjection();
  projection.distance = 100.0;
  LineChain chain;
  for (int i = 0; i < 10; ++i) {
    chain.points.emplace_back(static_cast<float>(i), 0.0f, i == 4 || i == 9 ? 200.0f : 0.0f);
    chain.strength.push_back(static_cast<float>(i));
    if (i > 0) chain.triangles.push_back(static_cast<std::uint32_t>(i - 1));
  }
  auto parts = onScreen(chain, projection);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].chain.points.size(), 4u);
  EXPECT_EQ(parts[1].chain.triangles, (std::vector<std::uint32_t>{5, 6, 7}));
  chain.closed = true;
  chain.triangles.push_back(9);
  parts = onScreen(chain, projection);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].chain.strength, (std::vector<float>{5, 6, 7, 8}));
  EXPECT_EQ(parts[1].chain.strength, (std::vector<float>{0, 1, 2, 3}));
}

// Half the diagonal of 800 x 600 beyond each side.
constexpr double kLeft = -500.0, kRight = 1300.0;

TEST(Stretches, LinesAreCutOutsideThePicture) {
  Projection projection = flatProjection();
  LineChain chain;
  chain.points = {{-1e6f, 0.0f, 0.0f},   {-100.0f, 0.0f, 0.0f}, {100.0f, 0.0f, 0.0f},
                  {3000.0f, 0.0f, 0.0f}, {3000.0f, 1e7f, 0.0f}, {0.0f, 1e7f, 0.0f}};
  chain.strength = {1, 2, 3, 4, 5, 6};
  chain.triangles = {0, 1, 2, 3, 4};
  auto parts = onScreen(chain, projection);
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_EQ(parts[0].screen.size(), 4u);
  EXPECT_EQ(parts[0].screen[1], Vector2d(300.0, 300.0));
  EXPECT_NEAR(parts[0].screen[0].x(), kLeft, 1e-6);
  EXPECT_NEAR(parts[0].screen[3].x(), kRight, 1e-6);
  EXPECT_NEAR(parts[0].length(), kRight - kLeft, 1e-6);
  EXPECT_NEAR(parts[0].chain.points[3].x(), kRight - 400.0, 1e-3);
  EXPECT_NEAR(parts[0].chain.strength[3], 3.0 + 800.0 / 2900.0, 1e-6);
  EXPECT_EQ(parts[0].chain.triangles, (std::vector<std::uint32_t>{0, 1, 2}));
  // Closed it comes back from far above, down to where it began: nothing more is near.
  chain.closed = true;
  chain.triangles.push_back(5);
  parts = onScreen(chain, projection);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_FALSE(parts[0].chain.closed);
  EXPECT_NEAR(parts[0].length(), kRight - kLeft, 1e-6);
}

TEST(Stretches, CutsOfSteepLinesAreWhereTheyAreSeen) {
  Projection projection = flatProjection();
  projection.distance = 100.0;
  projection.pxPerUnit = 40.0;
  LineChain chain;
  chain.points = {{0.0f, 0.0f, -300.0f}, {60.0f, 10.0f, 90.0f}};
  chain.strength = {0, 1};
  chain.triangles = {0};
  const auto parts = onScreen(chain, projection);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].screen[1].x(), kRight, 1e-6);
  const Vector2d seen = *projection.toScreen(parts[0].chain.points[1].cast<double>());
  EXPECT_NEAR((seen - parts[0].screen[1]).norm(), 0.0, 0.01);
}

}  // namespace
}  // namespace flatland::test
