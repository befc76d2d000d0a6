// SPDX-License-Identifier: GPL-3.0-or-later
// Segments become chains: against what a slow union of nodes says, on loops, junctions and noise.
#include "core3d/draw/chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector3f;

constexpr LineFamily kFamily = LineFamily::ApparentRidges;

LineSegment segment(std::uint64_t a, const Vector3f& pa, std::uint64_t b, const Vector3f& pb,
                    std::uint32_t triangle = 0, std::uint32_t level = 0) {
  return {{pa, 1.0f, freeNode(a)}, {pb, 1.0f, freeNode(b)}, triangle, level};
}

double lengthOf(const LineChain& chain) {
  double length = 0.0;
  for (std::size_t i = 0; i < chain.pieceCount(); ++i) {
    length += (chain.points[(i + 1) % chain.points.size()] - chain.points[i]).norm();
  }
  return length;
}

bool same(const LineChain& a, const LineChain& b) {
  return a.level == b.level && a.closed == b.closed && a.points == b.points &&
         a.strength == b.strength && a.triangles == b.triangles;
}

TEST(Chains, StringOfSegmentsBecomesOneChain) {
  std::vector<LineSegment> segments;
  for (std::uint32_t i = 0; i < 10; ++i) {
    const Vector3f a(static_cast<float>(i), 0, 0), b(static_cast<float>(i + 1), 0, 0);
    segments.push_back(i % 2 ? segment(i + 1, b, i, a, i) : segment(i, a, i + 1, b, i));
  }
  segments[3].a.strength = 7.0f;  // node 4
  const auto chains = chainSegments(kFamily, segments);
  ASSERT_EQ(chains.size(), 1u);
  const LineChain& chain = chains.front();
  EXPECT_FALSE(chain.closed);
  EXPECT_EQ(chain.family, kFamily);
  ASSERT_EQ(chain.points.size(), 11u);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(chain.points[i], Vector3f(static_cast<float>(i), 0, 0));
    if (i < 10) {
      EXPECT_EQ(chain.triangles[i], i);
    }
    EXPECT_EQ(chain.strength[i], i == 4 ? 7.0f : 1.0f) << "at node " << i;
  }
}

TEST(Chains, LoopIsClosedAndNotRepeated) {
  std::vector<LineSegment> segments;
  constexpr int n = 12;
  const auto at = [](int i) {
    const double angle = 2.0 * std::numbers::pi * i / n;
    return Vector3f(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0);
  };
  for (int i = 0; i < n; ++i) {
    segments.push_back(segment(i, at(i), (i + 1) % n, at((i + 1) % n), i));
  }
  const auto chains = chainSegments(kFamily, segments);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_TRUE(chains.front().closed);
  EXPECT_EQ(chains.front().points.size(), std::size_t{n});
  EXPECT_EQ(chains.front().triangles.size(), std::size_t{n});
  EXPECT_NEAR(lengthOf(chains.front()), 2 * n * std::sin(std::numbers::pi / n), 1e-5);
}

TEST(Chains, StraightestGoesOnAtAJunction) {
  // A cross whose arms are a little bent, with a fifth arm that finds no partner.
  const Vector3f o(0, 0, 0);
  const std::vector<LineSegment> segments = {
      segment(0, o, 1, {1, 0, 0}, 1),    segment(2, {-1, 0.2f, 0}, 0, o, 2),
      segment(0, o, 3, {0.1f, 1, 0}, 3), segment(4, {0, -1, 0}, 0, o, 4),
      segment(0, o, 5, {1, 0.9f, 0}, 5),
  };
  const auto chains = chainSegments(kFamily, segments);
  ASSERT_EQ(chains.size(), 3u);
  std::set<std::set<std::uint32_t>> triangles;
  for (const LineChain& c : chains) triangles.insert({c.triangles.begin(), c.triangles.end()});
  EXPECT_EQ(triangles, (std::set<std::set<std::uint32_t>>{{1, 2}, {3, 4}, {5}}));
}

TEST(Chains, AFanOfManyLinesGoesOnStraightOverItsMiddle) {
  // Lines all round at unlike heights: each has its own continuation, straight on.
  constexpr std::uint32_t kLines = 10000;
  std::vector<LineSegment> segments;
  const auto tip = [](std::uint32_t i, float side) {
    const double angle = std::numbers::pi * i / kLines;
    return Vector3f(side * static_cast<float>(std::cos(angle)),
                    side * static_cast<float>(std::sin(angle)),
                    side * static_cast<float>(i % 7) * 0.1f);
  };
  const Vector3f o(0, 0, 0);
  for (std::uint32_t i = 0; i < kLines; ++i) {
    segments.push_back(segment(0, o, 1 + i, tip(i, 1), i));
    segments.push_back(segment(1 + kLines + i, tip(i, -1), 0, o, i));
  }
  const auto chains = chainSegments(kFamily, segments);
  ASSERT_EQ(chains.size(), kLines);
  for (const LineChain& chain : chains) {
    ASSERT_EQ(chain.points.size(), 3u);
    EXPECT_EQ(chain.points[1], o);
    EXPECT_EQ(chain.triangles[0], chain.triangles[1]);
  }
}

TEST(Chains, SharpTurnsEndAtAJunctionButNotElsewhere) {
  const Vector3f o(0, 0, 0);
  // Three arms at right angles and 90 degrees: none goes on.
  const std::vector<LineSegment> corner = {segment(0, o, 1, {1, 0, 0}), segment(0, o, 2, {0, 1, 0}),
                                           segment(0, o, 3, {0, 0, 1})};
  EXPECT_EQ(chainSegments(kFamily, corner).size(), 3u);
  const std::vector<LineSegment> two = {corner[0], corner[1]};
  EXPECT_EQ(chainSegments(kFamily, two).size(), 1u);
}

TEST(Chains, DuplicatesCountOnceAndPointsVanish) {
  const Vector3f a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  const std::vector<LineSegment> segments = {
      segment(0, a, 1, b, 5), segment(1, b, 0, a, 3),  // the same edge from both sides
      segment(1, b, 7, b),                             // through a vertex: no length
      segment(7, b, 2, c, 4), segment(8, a, 9, a),     // a point by itself
  };
  const auto chains = chainSegments(kFamily, segments);
  ASSERT_EQ(chains.size(), 1u);
  EXPECT_EQ(chains.front().points, (std::vector<Vector3f>{a, b, c}));
  EXPECT_EQ(chains.front().triangles, (std::vector<std::uint32_t>{3, 4}));
}

TEST(Chains, LevelsStayApart) {
  const Vector3f a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  const std::vector<LineSegment> segments = {segment(0, a, 1, b, 0, 2), segment(1, b, 2, c, 0, 1)};
  const auto chains = chainSegments(LineFamily::Isophotes, segments);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_EQ(chains[0].level, 1u);
  EXPECT_EQ(chains[1].level, 2u);
}

TEST(Chains, NothingGivesNothing) { EXPECT_TRUE(chainSegments(kFamily, {}).empty()); }

struct Graph {
  std::vector<LineSegment> segments;  // no two between the same nodes
  int nodes;
};

Graph randomGraph(Random& random) {
  Graph graph;
  graph.nodes = uniformInt(random, 5, 40);
  std::vector<Vector3f> at;
  for (int i = 0; i < graph.nodes; ++i) {
    at.emplace_back(static_cast<float>(normal(random)), static_cast<float>(normal(random)),
                    static_cast<float>(normal(random)));
  }
  std::set<std::pair<int, int>> used;
  for (int i = 0; i < 2 * graph.nodes; ++i) {
    const int a = uniformInt(random, 0, graph.nodes - 1),
              b = uniformInt(random, 0, graph.nodes - 1);
    if (a == b || !used.insert({std::min(a, b), std::max(a, b)}).second) continue;
    LineSegment s = segment(a, at[a], b, at[b], static_cast<std::uint32_t>(graph.segments.size()));
    s.a.strength = static_cast<float>(a);
    s.b.strength = static_cast<float>(b);
    graph.segments.push_back(s);
  }
  return graph;
}

// The slow reference: connected parts of the graph by repeated relabelling.
std::vector<int> partsOf(const Graph& graph) {
  std::vector<int> label(graph.nodes);
  std::iota(label.begin(), label.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const LineSegment& s : graph.segments) {
      int& a = label[static_cast<int>(s.a.strength)];
      int& b = label[static_cast<int>(s.b.strength)];
      if (a != b) {
        a = b = std::min(a, b);
        changed = true;
      }
    }
  }
  return label;
}

TEST(Chains, EachSegmentIsUsedOnceAndPartsKeepTheirLength) {
  Random random(announcedSeed("EachSegmentIsUsedOnceAndPartsKeepTheirLength", 3));
  for (int trial = 0; trial < 200; ++trial) {
    const Graph graph = randomGraph(random);
    const std::vector<int> label = partsOf(graph);
    std::map<int, double> expected, found;
    for (const LineSegment& s : graph.segments) {
      expected[label[static_cast<int>(s.a.strength)]] += (s.a.at - s.b.at).norm();
    }
    std::vector<int> uses(graph.segments.size(), 0);
    for (const LineChain& chain : chainSegments(kFamily, graph.segments)) {
      ASSERT_EQ(chain.triangles.size(), chain.pieceCount());
      found[label[static_cast<int>(chain.strength.front())]] += lengthOf(chain);
      for (std::size_t i = 0; i < chain.pieceCount(); ++i) {
        ++uses[chain.triangles[i]];
        // The piece is its segment, one way round or the other.
        const LineSegment& s = graph.segments[chain.triangles[i]];
        const std::set<float> ends = {chain.strength[i],
                                      chain.strength[(i + 1) % chain.points.size()]};
        ASSERT_EQ(ends, (std::set<float>{s.a.strength, s.b.strength}));
      }
    }
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 1), static_cast<long>(uses.size()));
    ASSERT_EQ(expected.size(), found.size());
    for (const auto& [part, length] : expected) EXPECT_NEAR(found[part], length, 1e-4);
  }
}

TEST(Chains, OrderAndDirectionDoNotMatter) {
  Random random(announcedSeed("OrderAndDirectionDoNotMatter", 4));
  for (int trial = 0; trial < 50; ++trial) {
    Graph graph = randomGraph(random);
    const auto before = chainSegments(kFamily, graph.segments);
    std::shuffle(graph.segments.begin(), graph.segments.end(), random);
    for (LineSegment& s : graph.segments) {
      if (uniformInt(random, 0, 1) == 1) std::swap(s.a, s.b);
    }
    const auto after = chainSegments(kFamily, graph.segments);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_TRUE(same(before[i], after[i]));
  }
}

}  // namespace
}  // namespace flatland::test
