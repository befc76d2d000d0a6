// SPDX-License-Identifier: GPL-3.0-or-later
#include "core3d/draw/line_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace flatland {
namespace {

LineSegment piece(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  LineSegment s{};
  s.a.at = a.cast<float>();
  s.b.at = b.cast<float>();
  return s;
}

// A straight line from x = 0 to x = length at (y, z), in `count` pieces.
std::vector<LineSegment> straight(double length, double y, double z, int count) {
  std::vector<LineSegment> line;
  for (int i = 0; i < count; ++i) {
    line.push_back(piece({length * i / count, y, z}, {length * (i + 1) / count, y, z}));
  }
  return line;
}

double distance(const LineSegment& s, const Eigen::Vector3d& p) {
  double least = 1e300;
  for (int i = 0; i <= 500; ++i) {
    const Eigen::Vector3d q = s.a.at.cast<double>() + i / 500.0 * (s.b.at - s.a.at).cast<double>();
    least = std::min(least, (q - p).norm());
  }
  return least;
}

TEST(LineDifference, ParallelLinesAgreeWithinTheTolerance) {
  const auto here = straight(4.0, 0.0, 0.0, 40);
  // As one piece, in coarse and in fine ones: how a line is cut says nothing.
  for (const int count : {1, 7, 400}) {
    const auto near = differenceOf(here, straight(4.0, 0.3, 0.4, count), 0.501);
    EXPECT_EQ(near.common.size(), here.size()) << count;
    EXPECT_EQ(near.addedShare(), 0.0);
    EXPECT_EQ(near.missingShare(), 0.0);
    const auto far = differenceOf(here, straight(4.0, 0.3, 0.4, count), 0.499);
    EXPECT_EQ(far.common.size(), 0u);
    EXPECT_DOUBLE_EQ(far.addedShare(), 1.0);
    EXPECT_DOUBLE_EQ(far.missingShare(), 1.0);
  }
}

TEST(LineDifference, SharesAreLengths) {
  // The reference goes on for 4 where the line is 3 long, of which the last 1 is elsewhere.
  auto lines = straight(2.0, 0.0, 0.0, 20);
  const auto aside = straight(1.0, 5.0, 0.0, 3);
  lines.insert(lines.end(), aside.begin(), aside.end());
  const auto found = differenceOf(lines, straight(4.0, 0.0, 0.01, 400), 0.02);
  EXPECT_NEAR(found.linesLength, 3.0, 1e-6);
  EXPECT_NEAR(found.referenceLength, 4.0, 1e-6);
  EXPECT_NEAR(found.addedLength, 1.0, 1e-6);
  EXPECT_NEAR(found.addedShare(), 1.0 / 3.0, 1e-6);
  // What is within the tolerance beyond the end still agrees: 0.0173, two middles.
  EXPECT_NEAR(found.missingLength, 1.98, 1e-6);
  EXPECT_EQ(found.added.size(), 3u);
  EXPECT_EQ(found.common.size(), 20u);
  EXPECT_EQ(found.missing.size(), 198u);
}

TEST(LineDifference, TheOtherWayRoundAddedAndMissingChangePlaces) {
  const auto a = straight(1.0, 0.0, 0.0, 10), b = straight(2.0, 0.1, 0.0, 9);
  const auto ab = differenceOf(a, b, 0.15), ba = differenceOf(b, a, 0.15);
  EXPECT_EQ(ab.added.size(), ba.missing.size());
  EXPECT_EQ(ab.missing.size(), ba.added.size());
  EXPECT_EQ(ab.addedShare(), ba.missingShare());
  EXPECT_EQ(ab.missingShare(), ba.addedShare());
  EXPECT_GT(ab.missingShare(), 0.3);
}

TEST(LineDifference, AgreesWithTryingEveryPair) {
  const unsigned seed = 20261125;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.0, 1.0), size(0.0, 0.6);
  const auto some = [&](int count) {
    std::vector<LineSegment> lines;
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d a(place(random), place(random), place(random));
      const Eigen::Vector3d d(place(random), place(random), place(random));
      lines.push_back(piece(a, a + size(random) * d));
    }
    return lines;
  };
  for (const double tolerance : {0.15, 0.25, 0.5}) {
    const auto lines = some(150), reference = some(40);
    const auto found = differenceOf(lines, reference, tolerance);
    std::size_t common = 0, unsure = 0;
    for (const LineSegment& s : lines) {
      const Eigen::Vector3d middle = (s.a.at + s.b.at).cast<double>() / 2.0;
      double least = 1e300;
      for (const LineSegment& r : reference) least = std::min(least, distance(r, middle));
      // The slow one samples, and so finds a distance that is a little large.
      if (std::abs(least - tolerance) < 1e-3) ++unsure;
      if (least <= tolerance) ++common;
    }
    EXPECT_GT(common, 0u) << seed;
    EXPECT_LE(found.common.size(), common + unsure) << seed;
    EXPECT_GE(found.common.size() + unsure, common) << seed;
  }
}

TEST(LineDifference, NothingAndPoints) {
  const auto line = straight(1.0, 0.0, 0.0, 4);
  EXPECT_EQ(differenceOf({}, {}, 0.1).addedShare(), 0.0);
  EXPECT_EQ(differenceOf(line, {}, 0.1).addedShare(), 1.0);
  EXPECT_EQ(differenceOf({}, line, 0.1).missingShare(), 1.0);
  EXPECT_EQ(differenceOf(line, line, 0.0).common.size(), 4u);
  const std::vector<LineSegment> point{piece({0.5, 0.0, 0.0}, {0.5, 0.0, 0.0})};
  EXPECT_EQ(differenceOf(point, line, 0.0).common.size(), 1u);
  EXPECT_EQ(differenceOf(point, line, 0.0).addedShare(), 0.0);
}

}  // namespace
}  // namespace flatland
