// SPDX-License-Identifier: GPL-3.0-or-later
// From chains to strokes: hysteresis, judging, loops, crumbs.
#include "core3d/draw/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core3d/draw/chains.h"
#include "tests/core3d/screen_lines.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

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

// Steep ends, far below 0 where a definition stops to hold, have no weight of their own.
TEST(Strokes, AStrokeWeighsNoLessForSteepEnds) {
  SeenChain chain{straight({-900.0f, 6.0f, 6.0f, -900.0f}, 20.0), {{0.0, 60.0, Seen::Visible}}};
  StrokeFilter filter{.threshold = 2.0, .minWeightPx = 30.0, .unitStrength = 2.0};
  ASSERT_EQ(strokeParts(chain, 0, filter, 0.6).size(), 1u);  // 20 px of three times the unit
}

TEST(Strokes, LowerThresholdsKeepEveryStroke) {
  constexpr double kRounding = 1e-9;
  Random random(announcedSeed("LowerThresholdsKeepEveryStroke", 3));
  for (int run = 0; run < 300; ++run) {
    std::vector<float> strengths(12);
    for (float& s : strengths) {
      s = static_cast<float>(
          std::copysign(std::pow(10.0, uniform(random, -2.0, 2.0)), uniform(random, -0.3, 1.0)));
    }
    const SeenChain chain{straight(strengths, 8.0), {{0.0, 88.0, Seen::Visible}}};
    std::vector<StrokePart> before;
    for (const double threshold : {30.0, 3.0, 0.3, 0.03, 1e-3, 1e-6, 1e-300}) {
      const StrokeFilter filter{.threshold = threshold,
                                .minLengthPx = 6.0,
                                .minWeightPx = 30.0,
                                .unitStrength = threshold};
      const std::vector<StrokePart> now = strokeParts(chain, 0, filter, 0.6);
      for (const StrokePart& part : before) {
        EXPECT_TRUE(std::any_of(now.begin(), now.end(),
                                [&part](const StrokePart& wider) {
                                  return wider.from <= part.from + kRounding &&
                                         part.to <= wider.to + kRounding;
                                }))
            << run << ": " << part.from << " to " << part.to << " is gone at " << threshold;
      }
      before = now;
    }
  }
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

}  // namespace
}  // namespace flatland::test
