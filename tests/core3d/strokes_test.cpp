// SPDX-License-Identifier: GPL-3.0-or-later
// From chains to strokes: gaps, hysteresis, crumbs, simplification, ink.
#include "core3d/draw/strokes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core3d/draw/bridges.h"
#include "core3d/draw/compose.h"
#include "core3d/draw/ink.h"
#include "core3d/mesh/build_mesh.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// 1 unit is 1 px, the origin at the picture's middle.
Projection flatProjection() {
  Projection projection;
  projection.axes = Eigen::Matrix3d::Identity();
  projection.width = 800.0;
  projection.height = 600.0;
  return projection;
}

// A straight chain along x from 0, or the outline of a square of that side.
ScreenChain straight(std::vector<float> strength, double step = 1.0) {
  LineChain chain;
  chain.family = LineFamily::ApparentRidges;
  for (std::size_t i = 0; i < strength.size(); ++i) {
    chain.points.emplace_back(static_cast<float>(step * static_cast<double>(i)), 0.0f, 0.0f);
  }
  chain.triangles.assign(strength.size() - 1, 0);
  chain.strength = std::move(strength);
  return onScreen(chain, flatProjection()).front();
}

ScreenChain ring(std::vector<float> strength, double radius = 50.0) {
  LineChain chain;
  chain.family = LineFamily::ApparentRidges;
  chain.closed = true;
  const std::size_t n = strength.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    chain.points.push_back((radius * Vector3d(std::cos(a), std::sin(a), 0.0)).cast<float>());
  }
  chain.triangles.assign(n, 0);
  chain.strength = std::move(strength);
  return onScreen(chain, flatProjection()).front();
}

// Visible but between the given places.
std::vector<Stretch> seenBut(const ScreenChain& chain, std::vector<std::pair<double, double>> gaps,
                             double smallestGapPx) {
  return stretchesOf(chain, smallestGapPx, [&](const ScreenChain::Point& p) {
    const double x = p.at.x();
    for (const auto& [from, to] : gaps) {
      if (x >= from && x < to) return Seen::Hidden;
    }
    return Seen::Visible;
  });
}

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

TEST(Hysteresis, FollowsDownFromASeed) {
  //                                       0  1  2  3  4  5  6  7  8  9 10 11
  const ScreenChain chain = straight({0, 0, 4, 10, 7, 6, 4, 0, 7, 7, 0, 10}, 10.0);
  const auto strong = strongStretches(chain, 8.0, 0.5);  // down to 4; 8 and 9 have no seed
  ASSERT_EQ(strong.size(), 2u);
  EXPECT_DOUBLE_EQ(strong[0].first, 20.0);
  EXPECT_DOUBLE_EQ(strong[0].second, 60.0);
  EXPECT_DOUBLE_EQ(strong[1].first, 104.0);  // 4 of 10 on the way up
  EXPECT_DOUBLE_EQ(strong[1].second, 110.0);
  EXPECT_EQ(strongStretches(chain, 0.0, 0.5).size(), 1u);
  EXPECT_TRUE(strongStretches(chain, 11.0, 0.5).empty());
}

// The slow reference: strength sampled densely, stretches grown from every seed.
double strongLength(const ScreenChain& chain, double threshold, double hysteresis) {
  constexpr int kPerPx = 50;
  const auto n = static_cast<int>(chain.length() * kPerPx);
  std::vector<bool> keep(n, false);
  const auto strength = [&](int i) { return chain.at((i + 0.5) / kPerPx).strength; };
  const bool closed = chain.chain.closed;
  for (int i = 0; i < n; ++i) {
    if (strength(i) < threshold) continue;
    for (const int step : {1, -1}) {
      for (int k = i, count = 0; count < n; k += step, ++count) {
        if (closed) k = (k + n) % n;
        if (k < 0 || k >= n || strength(k) < hysteresis * threshold) break;
        if (keep[k] && k != i) break;
        keep[k] = true;
      }
    }
  }
  return static_cast<double>(std::count(keep.begin(), keep.end(), true)) / kPerPx;
}

std::vector<float> randomStrengths(Random& random, int n) {
  std::vector<float> strength;
  for (int i = 0; i < n; ++i) strength.push_back(static_cast<float>(uniform(random, 0.0, 10.0)));
  return strength;
}

TEST(Hysteresis, AgreesWithGrowingFromSeeds) {
  Random random(announcedSeed("AgreesWithGrowingFromSeeds", 8));
  for (int trial = 0; trial < 60; ++trial) {
    const auto strength = randomStrengths(random, 30);
    const ScreenChain chain = trial % 2 ? straight(strength, 7.0) : ring(strength);
    const double threshold = uniform(random, 1.0, 10.0);
    double length = 0.0;
    for (const auto& [from, to] : strongStretches(chain, threshold, 0.6)) {
      EXPECT_LT(from, chain.length());
      length += to - from;
    }
    // Sampling misses peaks thinner than 1/50 px, and stretches that hang on them.
    EXPECT_NEAR(length, strongLength(chain, threshold, 0.6), 0.04 * 30) << "trial " << trial;
  }
}

TEST(Strokes, NeverGrowWithTheThreshold) {
  Random random(announcedSeed("NeverGrowWithTheThreshold", 9));
  for (int trial = 0; trial < 40; ++trial) {
    const auto strength = randomStrengths(random, 40);
    SeenChain chain{trial % 2 ? straight(strength, 5.0) : ring(strength), {}};
    chain.stretches = seenBut(chain.line, {{-20.0, 3.0}, {30.0, 41.0}}, 3.0);
    std::vector<StrokePart> before;
    for (double threshold = 10.0; threshold > 0.0; threshold -= 0.25) {
      const auto parts = strokeParts(chain, 0, {threshold, 6.0}, 0.6);
      const auto covered = [&](double place, Seen seen) {
        return std::any_of(parts.begin(), parts.end(), [&](const StrokePart& p) {
          const double round = chain.line.length();
          return p.seen == seen && ((place >= p.from && place <= p.to) ||
                                    (place + round >= p.from && place + round <= p.to));
        });
      };
      for (const StrokePart& p : before) {
        for (double place = p.from + 0.01; place < p.to; place += 1.0) {
          EXPECT_TRUE(covered(std::fmod(place, chain.line.length()), p.seen));
        }
      }
      before = parts;
    }
  }
}

TEST(Strokes, CrumbsGoAndOutlinesOfPartsStay) {
  SeenChain chain{straight(std::vector<float>(101, 1.0f)), {}};
  chain.stretches = seenBut(chain.line, {{4.0, 50.0}, {55.0, 60.0}}, 3.0);
  const auto parts = strokeParts(chain, 7, {0.5, 6.0}, 0.6);
  ASSERT_EQ(parts.size(), 2u);  // hidden 4 to 50 and visible 60 to 100; 4, 5 and 5 px are crumbs
  EXPECT_EQ(parts[0].seen, Seen::Hidden);
  EXPECT_NEAR(parts[1].from, 60.0, 0.05);
  EXPECT_EQ(parts[1].chain, 7u);

  SeenChain loop{ring(std::vector<float>(12, 1.0f), 0.5), {}};
  loop.stretches = seenBut(loop.line, {}, 3.0);
  EXPECT_TRUE(strokeParts(loop, 0, {0.0, 6.0}, 0.6).empty());
  loop.line.chain.family = LineFamily::OccludingContours;
  EXPECT_TRUE(strokeParts(loop, 0, {0.0, 6.0}, 0.6).empty());
  loop.outlineOfPart = true;
  ASSERT_EQ(strokeParts(loop, 0, {0.0, 6.0}, 0.6).size(), 1u);
  EXPECT_TRUE(strokeParts(loop, 0, {0.0, 6.0}, 0.6).front().closed);
}

TEST(Strokes, WhereALoopStartsDoesNotMatter) {
  constexpr int n = 60;
  std::vector<float> usual(n, 0.0f);  // two stretches that are strong, one of them over the start
  for (int i = 0; i < n; ++i) usual[i] = i < 20 || i > 50 ? 10.0f : i > 28 && i < 41 ? 8.0f : 0.0f;
  for (int turned = 0; turned < n; ++turned) {
    std::vector<float> strength = usual;
    std::rotate(strength.begin(), strength.begin() + turned, strength.end());
    SeenChain chain{ring(strength), {}};
    const double length = chain.line.length(), back = length * turned / n;
    // Hidden from 55 to 65 and from 75 to 90 hundredths, over the start for some.
    double place = 0.55 * length - back;
    if (place < 0.0) place += length;
    chain.stretches = {{place, place + 0.1 * length, Seen::Hidden},
                       {place + 0.1 * length, place + 0.2 * length, Seen::Visible},
                       {place + 0.2 * length, place + 0.35 * length, Seen::Hidden},
                       {place + 0.35 * length, place + length, Seen::Visible}};
    for (Stretch& s : chain.stretches) {
      const double round = s.from >= length ? length : 0.0;
      s.from -= round;
      s.to -= round;
    }
    std::sort(chain.stretches.begin(), chain.stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    std::vector<double> hidden, visible;
    for (const StrokePart& part : strokeParts(chain, 0, {5.0, 6.0}, 0.6)) {
      EXPECT_GE(part.from, 0.0) << turned;
      EXPECT_LT(part.from, length) << turned;
      (part.seen == Seen::Hidden ? hidden : visible).push_back((part.to - part.from) / length);
    }
    std::sort(hidden.begin(), hidden.end());
    std::sort(visible.begin(), visible.end());
    // Strong down to 0.6 of 5: from 28.4 to 40.6 and from 50.3 to 79.7, of 60.
    const double first = (28.0 + 3.0 / 8.0) / n, last = (41.0 - 3.0 / 8.0) / n;
    const double start = 50.3 / n, end = 79.7 / n;
    std::vector<double> hiddenThen = {0.65 - 0.55, 0.9 - start};
    std::vector<double> visibleThen = {0.55 - first, last - 0.65, end - 0.9};
    std::sort(hiddenThen.begin(), hiddenThen.end());
    std::sort(visibleThen.begin(), visibleThen.end());
    ASSERT_EQ(hidden.size(), hiddenThen.size()) << turned;
    ASSERT_EQ(visible.size(), visibleThen.size()) << turned;
    for (std::size_t i = 0; i < hidden.size(); ++i) EXPECT_NEAR(hidden[i], hiddenThen[i], 1e-6);
    for (std::size_t i = 0; i < visible.size(); ++i) EXPECT_NEAR(visible[i], visibleThen[i], 1e-6);
  }
}

TEST(Strokes, WhatFollowsOverTheStartOfALoopIsOneLine) {
  SeenChain chain{ring(std::vector<float>(60, 1.0f)), {}};
  const double length = chain.line.length();
  chain.stretches = {{0.0, 4.0, Seen::Visible},
                     {4.0, length - 4.0, Seen::Hidden},
                     {length - 4.0, length, Seen::Outline}};
  EXPECT_EQ(strokeParts(chain, 0, {0.0, 6.0}, 0.6).size(), 3u);
  EXPECT_EQ(strokeParts(chain, 0, {0.0, 9.0}, 0.6).size(), 1u);
}

TEST(Strokes, APartOfAPieceWeighsByItsOwnStrength) {
  // From 1.5 at 7.5 px to 6 at 30: the integral of 0.2 x / 3 is 28.125.
  const SeenChain chain{straight({0.0f, 6.0f}, 30.0), {{0.0, 30.0, Seen::Visible}}};
  const auto count = [&](double weight) {
    StrokeFilter filter;
    filter.threshold = 3.0;
    filter.unitStrength = 3.0;
    filter.minWeightPx = weight;
    return strokeParts(chain, 0, filter, 0.5).size();
  };
  EXPECT_EQ(count(28.0), 1u);
  EXPECT_EQ(count(28.3), 0u);
}

TEST(Strokes, PinholesGoAndHolesStay) {
  const auto count = [](double radius, LineFamily family, Seen seen) {
    SeenChain loop{ring(std::vector<float>(12, 1.0f), radius), {}};
    loop.line.chain.family = family;
    loop.stretches = {{0.0, loop.line.length(), seen}};
    return strokeParts(loop, 0, {.minLengthPx = 6.0, .minHolePx = 30.0}, 0.6).size();
  };
  EXPECT_EQ(count(4.0, LineFamily::Boundaries, Seen::Visible), 0u);  // 25 px round
  EXPECT_EQ(count(6.0, LineFamily::Boundaries, Seen::Visible), 1u);  // 37 px
  EXPECT_EQ(count(4.0, LineFamily::Boundaries, Seen::Outline), 1u);
  EXPECT_EQ(count(4.0, LineFamily::Creases, Seen::Visible), 1u);
}

TEST(Strokes, ShortOnesHaveToBeStrong) {
  // A unit of 2: strength 4 weighs twice the length, 9 no more than three times.
  const auto kept = [](float strength, double length) {
    SeenChain chain{straight({strength, strength}, length), {}};
    chain.stretches = {{0.0, length, Seen::Visible}};
    StrokeFilter filter;
    filter.threshold = 1.0;
    filter.minWeightPx = 30.0;
    filter.unitStrength = 2.0;
    return strokeParts(chain, 0, filter, 0.6).size() == 1;
  };
  EXPECT_TRUE(kept(2.0f, 30.1));
  EXPECT_FALSE(kept(2.0f, 29.9));
  EXPECT_TRUE(kept(4.0f, 15.1));
  EXPECT_FALSE(kept(4.0f, 14.9));
  EXPECT_TRUE(kept(90.0f, 10.1));
  EXPECT_FALSE(kept(90.0f, 9.9));
  EXPECT_TRUE(kept(1.0f, 60.1));
  EXPECT_FALSE(kept(1.0f, 59.9));
}

// A line of which only some pieces of 1 px stand out.
std::vector<LineSegment> partlyClear(int length, const std::function<bool(int)>& standsOut) {
  std::vector<LineSegment> segments;
  for (int i = 0; i < length; ++i) {
    segments.push_back({{{static_cast<float>(i), 0, 0}, 10.0f, freeNode(i)},
                        {{static_cast<float>(i + 1), 0, 0}, 10.0f, freeNode(i + 1)},
                        0,
                        0,
                        standsOut(i)});
  }
  return segments;
}

TEST(Strokes, WhatStandsOutIsJudgedAlongTheLine) {
  const auto judged = [](const std::function<bool(int)>& standsOut) {
    const auto chains = chainSegments(LineFamily::Ridges, partlyClear(200, standsOut));
    return onScreen(chains.front(), flatProjection()).front().judged;
  };
  for (const float j : judged([](int) { return true; })) EXPECT_EQ(j, 10.0f);
  for (const float j : judged([](int) { return false; })) EXPECT_EQ(j, 0.0f);
  // Every second or third piece is enough; one in six, 4 px of 24, is worth 5 / 9 of the strength.
  for (const float j : judged([](int i) { return i % 3 == 0; })) EXPECT_NEAR(j, 10.0f, 1.0f);
  const auto sixth = judged([](int i) { return i % 6 == 0; });
  for (int i = 20; i < 180; ++i) EXPECT_NEAR(sixth[i], 10.0 * (1.0 / 6.0) / 0.3, 0.01);
  // Half of a line that stands out does not speak for the other half.
  const auto half = judged([](int i) { return i < 100; });
  EXPECT_EQ(half[80], 10.0f);
  EXPECT_EQ(half[120], 0.0f);
}

TEST(Strokes, WhatStandsOutIsJudgedRoundALoop) {
  constexpr int n = 200;
  const auto judged = [](int first) {  // three pieces stand out
    LineChain chain = ring(std::vector<float>(n, 10.0f)).chain;
    chain.standsOut.assign(n, false);
    for (int i = first; i < first + 3; ++i) chain.standsOut[i % n] = true;
    return onScreen(std::move(chain), flatProjection()).front().judged;
  };
  const auto usual = judged(100);
  EXPECT_GT(usual[102], 1.0f);
  for (int first = n - 15; first < n + 15; ++first) {
    const auto turned = judged(first % n);
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(turned[(i + first) % n], usual[(i + 100) % n], 1e-3f) << first << " " << i;
  }
}

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

TEST(Strokes, OutlineAndContourAreOneLineWhenCrumbsAreLookedFor) {
  SeenChain chain{straight(std::vector<float>(101, 1.0f)), {}};
  chain.stretches = {{0.0, 4.0, Seen::Outline},
                     {4.0, 8.0, Seen::Visible},
                     {8.0, 90.0, Seen::Hidden},
                     {90.0, 95.0, Seen::Visible},
                     {95.0, 100.0, Seen::Hidden}};
  const auto parts = strokeParts(chain, 0, {0.0, 6.0}, 0.6);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].to, 4.0);
  EXPECT_EQ(parts[1].to, 8.0);
  EXPECT_EQ(parts[2].seen, Seen::Hidden);
}

double distanceTo(const Vector2d& p, const std::vector<Vector2d>& line, bool closed) {
  double nearest = 1e9;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i) {
    const Vector2d a = line[i], d = line[(i + 1) % line.size()] - a;
    const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-30), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * d).norm());
  }
  return nearest;
}

TEST(Simplify, StaysWithinTheTolerance) {
  Random random(announcedSeed("StaysWithinTheTolerance", 10));
  for (int trial = 0; trial < 20; ++trial) {
    const bool closed = trial % 2 == 1;
    const double tolerance = std::pow(10.0, uniform(random, -2.0, 1.0));
    std::vector<Vector2d> line;
    for (int i = 0; i < 400; ++i) {
      const double a = 2.0 * std::numbers::pi * i / 400.0;
      const double r = 100.0 + 10.0 * std::sin(7.0 * a) + uniform(random, -1.0, 1.0);
      line.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    const auto kept = simplified(line, closed, tolerance);
    std::vector<Vector2d> result;
    for (const std::size_t i : kept) result.push_back(line[i]);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    EXPECT_EQ(kept.front(), 0u);
    if (!closed) {
      EXPECT_EQ(kept.back(), 399u);
    }
    double worst = 0.0;
    for (const Vector2d& p : line) worst = std::max(worst, distanceTo(p, result, closed));
    EXPECT_LE(worst, tolerance * (1.0 + 1e-12));
    if (tolerance > 3.0) {
      EXPECT_LT(kept.size(), 60u);
    }
    EXPECT_GE(kept.size(), closed ? 3u : 2u);
  }
}

TEST(Simplify, KeepsTheFarthestPointOfALoop) {
  const ScreenChain loop = ring(std::vector<float>(8, 1.0f));
  EXPECT_EQ(simplified(loop.screen, true, 1000.0), (std::vector<std::size_t>{0, 4}));
}

TEST(Simplify, CarriesPointsAndStrengthAlong) {
  SeenChain chain{straight(std::vector<float>(11, 1.0f), 10.0), {}};
  chain.line.chain.points[5].y() = 8.0f;
  chain.line = onScreen(chain.line.chain, flatProjection()).front();
  chain.line.chain.strength[5] = 3.0f;
  const StrokePart part{0, 15.0, chain.line.length() - 4.0, Seen::Visible, false};
  const Polyline line = polylineOf(chain, part, flatProjection(), 0.5);
  ASSERT_EQ(line.points.size(), 5u);  // cut ends, the tip and its feet
  EXPECT_NEAR(line.points[0].x(), 15.0f, 1e-4f);
  EXPECT_EQ(line.points[2], Eigen::Vector3f(50.0f, 8.0f, 0.0f));
  EXPECT_EQ(line.strength[2], 3.0f);
  EXPECT_NEAR(line.screen[0].x(), 415.0, 1e-4);
  EXPECT_NEAR(line.points[4].x(), 96.0f, 1e-4f);
}

TEST(Ink, CountsThePixelsWhoseMiddleIsCovered) {
  Random random(announcedSeed("CountsThePixelsWhoseMiddleIsCovered", 11));
  InkRaster raster(61.0, 47.5);
  const double pixels = 61.0 * 48.0;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vector2d> line;
    const int n = uniformInt(random, 1, 5);
    for (int i = 0; i < n; ++i) {
      line.emplace_back(uniform(random, -20.0, 80.0), uniform(random, -20.0, 70.0));
    }
    if (trial % 5 == 0) line.back() = line.front();
    const double width = uniform(random, 0.3, 12.0);
    const bool closed = trial % 2 == 1;
    raster.clear();
    raster.add(line, closed, width);
    std::size_t expected = 0;
    for (int y = 0; y < 48 && n > 1; ++y) {
      for (int x = 0; x < 61; ++x) {
        expected += distanceTo({x + 0.5, y + 0.5}, line, closed) <= width / 2.0;
      }
    }
    EXPECT_EQ(raster.covered(), expected) << "trial " << trial;
    EXPECT_DOUBLE_EQ(raster.share(), static_cast<double>(expected) / pixels);
    raster.add(line, closed, width);
    EXPECT_EQ(raster.covered(), expected);  // the same ink twice is the same ink
  }
}

// A picture of strokes on a plane: 400 short ones of random strength, 3 creases without threshold.
struct Sheet {
  TriangleMesh mesh;
  FeatureLines found;
  LineOptions lines;

  Sheet() {
    PolygonSoup soup;
    soup.addVertex(-1, -1, 0);
    soup.addVertex(1, -1, 0);
    soup.addVertex(1, 1, 0);
    soup.addVertex(-1, 1, 0);
    soup.addTriangle(0, 1, 2);
    soup.addTriangle(0, 2, 3);
    mesh = buildMesh(soup).mesh;
    Random random(announcedSeed("Sheet", 12));
    std::uint64_t node = 0;
    const auto add = [&](LineFamily family, double length, float strength) {
      const double a = uniform(random, 0.0, 6.3);
      const Vector3d p(uniform(random, -0.9, 0.9), uniform(random, -0.9, 0.9), 0.0);
      const Vector3d q = p + length * Vector3d(std::cos(a), std::sin(a), 0.0);
      found.of(family).push_back({{p.cast<float>(), strength, freeNode(node)},
                                  {q.cast<float>(), strength, freeNode(node + 1)},
                                  0});
      node += 2;
    };
    for (int i = 0; i < 400; ++i) {
      add(LineFamily::ApparentRidges, 0.08, static_cast<float>(std::exp(normal(random))));
    }
    for (int i = 0; i < 400; ++i) {
      add(LineFamily::Ridges, 0.06, static_cast<float>(5.0 * std::exp(normal(random))));
    }
    for (int i = 0; i < 3; ++i) add(LineFamily::Creases, 0.4, 90.0f);
    lines[LineFamily::ApparentRidges] = lines[LineFamily::Ridges] = lines[LineFamily::Creases] =
        true;
    lines.threshold[static_cast<std::size_t>(LineFamily::Ridges)] = 7.0;
  }

  Drawing draw(const StrokeOptions& strokes) const {
    const SurfaceFields none;
    return composeDrawing(found, Sight(mesh, none), projectionOf(Camera(), mesh), lines, strokes);
  }
};

TEST(Ink, IsMetByOneFactorOnTheThresholds) {
  const Sheet sheet;
  for (const double ink : {0.005, 0.01, 0.02, 0.03}) {
    const Drawing drawing = sheet.draw({.minWeightPx = 0.0, .ink = ink});
    EXPECT_NEAR(drawing.stats.ink, ink, 0.01 * ink);
    EXPECT_TRUE(drawing.stats.inkReached);
    // The factor is what it says: drawing with it gives the same strokes, creases all the while.
    Sheet again = sheet;
    for (double& threshold : again.lines.threshold) threshold *= drawing.stats.thresholdFactor;
    const Drawing same = again.draw({.minWeightPx = 0.0});
    EXPECT_EQ(same.polylines.size(), drawing.polylines.size());
    EXPECT_DOUBLE_EQ(same.stats.ink, drawing.stats.ink);
    EXPECT_EQ(std::count_if(drawing.polylines.begin(), drawing.polylines.end(),
                            [](const Polyline& p) { return p.family == LineFamily::Creases; }),
              3);
  }
}

TEST(Ink, OneStrongPointDoesNotMatter) {
  Sheet sheet;
  const Drawing before = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  sheet.found.of(LineFamily::ApparentRidges).front().a.strength = 1e30f;
  const Drawing after = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  EXPECT_TRUE(after.stats.inkReached);
  EXPECT_NEAR(after.stats.thresholdFactor, before.stats.thresholdFactor,
              0.1 * before.stats.thresholdFactor);
}

TEST(Ink, TellsWhatCountsAsWeak) {
  const Sheet sheet;
  const auto weak = [&sheet](LineFamily family, std::optional<double> ink) {
    const Drawing drawing = sheet.draw({.minWeightPx = 0.0, .ink = ink});
    const auto i = static_cast<std::size_t>(family);
    return std::pair(drawing.weak[i] / sheet.lines.threshold[i], drawing.stats.thresholdFactor);
  };
  for (const LineFamily family : {LineFamily::ApparentRidges, LineFamily::Creases}) {
    EXPECT_DOUBLE_EQ(weak(family, std::nullopt).first, 1.0);
  }
  const auto [share, factor] = weak(LineFamily::Ridges, 0.005);
  EXPECT_GT(factor, 1.0);
  EXPECT_DOUBLE_EQ(share, factor);
  const auto [less, lowered] = weak(LineFamily::Ridges, 0.02);
  EXPECT_LT(lowered, 1.0);
  EXPECT_DOUBLE_EQ(less, std::sqrt(lowered));
  EXPECT_DOUBLE_EQ(weak(LineFamily::Ridges, 0.5).first, 0.3);  // all lines: the factor is 0
  EXPECT_DOUBLE_EQ(weak(LineFamily::Creases, 0.005).first, 1.0);
}

TEST(Ink, SaysWhenItCannotBeMet) {
  const Sheet sheet;
  const Drawing all = sheet.draw({.minWeightPx = 0.0, .largestGapPx = 0.0, .ink = 0.5});
  EXPECT_FALSE(all.stats.inkReached);
  EXPECT_EQ(all.polylines.size(), 803u);
  EXPECT_EQ(all.stats.thresholdFactor, 0.0);
  const Drawing creases = sheet.draw({.ink = 1e-4});
  EXPECT_FALSE(creases.stats.inkReached);
  EXPECT_EQ(creases.polylines.size(), 3u);
  EXPECT_GT(creases.stats.ink, 1e-4);
}

TEST(Compose, SaysHowMuchIsNoCrumb) {
  const Sheet sheet;
  // At 280 px a unit: ridges of 17 px are shorter than 2 % of the diagonal of 1000 px, the others
  // of 22 and 112 px longer.
  const Drawing drawing = sheet.draw({.minWeightPx = 0.0, .largestGapPx = 0.0});
  double total = 0.0, inLong = 0.0;
  for (const Polyline& line : drawing.polylines) {
    const double length = (line.screen[1] - line.screen[0]).norm();
    total += length;
    if (line.family != LineFamily::Ridges) inLong += length;
  }
  EXPECT_NEAR(drawing.stats.share, inLong / total, 1e-9);
  EXPECT_GT(drawing.stats.share, 0.3);
  EXPECT_LT(drawing.stats.share, 0.7);
}

TEST(Compose, PicturesOfAllSizesHaveTheSameStrokes) {
  const Sheet sheet;
  const SurfaceFields none;
  const Sight sight(sheet.mesh, none);
  const auto draw = [&](double scale) {
    Camera camera;
    camera.width *= scale;
    camera.height *= scale;
    camera.margin *= scale;
    return composeDrawing(sheet.found, sight, projectionOf(camera, sheet.mesh), sheet.lines,
                          {.minLengthPx = 20.0, .largestGapPx = 12.0, .ink = 0.015});
  };
  const Drawing usual = draw(1.0);
  EXPECT_GT(usual.polylines.size(), 20u);
  EXPECT_LT(usual.polylines.size(), 400u);
  for (const double scale : {0.25, 3.0}) {
    const Drawing other = draw(scale);
    ASSERT_EQ(other.polylines.size(), usual.polylines.size()) << scale;
    EXPECT_NEAR(other.stats.ink, usual.stats.ink, 1e-3 * usual.stats.ink);
    EXPECT_EQ(other.projection.width, 800.0 * scale);
    for (std::size_t i = 0; i < usual.polylines.size(); ++i) {
      const auto &a = usual.polylines[i].screen, &b = other.polylines[i].screen;
      EXPECT_LT((scale * a.front() - b.front()).norm(), 1e-6 * scale);
      EXPECT_LT((scale * a.back() - b.back()).norm(), 1e-6 * scale);
    }
  }
}

TEST(Compose, AsksForLinesDownToWhereTheyAreFollowed) {
  LineOptions lines;
  lines[LineFamily::ExteriorSilhouette] = true;
  const auto ridges = static_cast<std::size_t>(LineFamily::ApparentRidges);
  lines.threshold[ridges] = 10.0;
  const LineOptions asked = linesToFind(lines, {.hysteresis = 0.5});
  EXPECT_DOUBLE_EQ(asked.threshold[ridges], 5.0);
  EXPECT_TRUE(asked[LineFamily::OccludingContours]);
  EXPECT_TRUE(asked[LineFamily::Boundaries]);
  EXPECT_EQ(linesToFind(lines, {.ink = 0.04}).threshold[ridges], 0.0);
}

TEST(Compose, StopsWhenAsked) {
  const Sheet sheet;
  std::stop_source source;
  source.request_stop();
  const Drawing drawing = sheet.draw({.ink = 0.01, .stop = source.get_token()});
  EXPECT_TRUE(drawing.polylines.empty());
}

TEST(Compose, OrderOfSegmentsDoesNotMatter) {
  Sheet sheet;
  const Drawing before = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  Random random(announcedSeed("OrderOfSegmentsDoesNotMatter", 13));
  for (auto& segments : sheet.found.segments)
    std::shuffle(segments.begin(), segments.end(), random);
  const Drawing after = sheet.draw({.minWeightPx = 0.0, .ink = 0.02});
  ASSERT_EQ(before.polylines.size(), after.polylines.size());
  for (std::size_t i = 0; i < before.polylines.size(); ++i) {
    EXPECT_EQ(before.polylines[i].screen, after.polylines[i].screen);
    EXPECT_EQ(before.polylines[i].strength, after.polylines[i].strength);
  }
}

}  // namespace
}  // namespace flatland::test
