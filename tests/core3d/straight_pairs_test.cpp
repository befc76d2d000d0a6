// SPDX-License-Identifier: GPL-3.0-or-later
// Which ends at a junction go on into which: against comparing all of them, and what it costs.
#include "core3d/draw/straight_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "tests/support/seed.h"

namespace flatland::test {
namespace {

using Eigen::Vector3d;
using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs sorted(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// The slow reference: all pairs, the straightest first.
Pairs comparingAll(const std::vector<Vector3d>& outward) {
  std::vector<std::tuple<double, std::uint32_t, std::uint32_t>> all;
  for (std::uint32_t i = 0; i < outward.size(); ++i) {
    for (std::uint32_t k = i + 1; k < outward.size(); ++k) {
      const double bend = (outward[i] + outward[k]).squaredNorm();
      if (bend < 1.0) all.emplace_back(bend, i, k);
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<bool> used(outward.size(), false);
  Pairs pairs;
  for (const auto& [bend, i, k] : all) {
    if (used[i] || used[k]) continue;
    used[i] = used[k] = true;
    pairs.emplace_back(i, k);
  }
  return sorted(pairs);
}

Vector3d randomDirection(Random& random) {
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

struct Junction {
  const char* name;
  std::vector<Vector3d> (*outward)(int count, Random& random);
};

const Junction kJunctions[] = {
    {"all round",
     [](int count, Random& random) {
       std::vector<Vector3d> outward;
       for (int i = 0; i < count; ++i) outward.push_back(randomDirection(random));
       return outward;
     }},
    {"a pleated fan",
     [](int count, Random&) {
       std::vector<Vector3d> outward;
       for (int i = 0; i < count; ++i) {
         const double angle = 2.0 * std::numbers::pi * i / count;
         outward.push_back(
             Vector3d(std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.2 : -0.2).normalized());
       }
       return outward;
     }},
    {"a cone too sharp to go on",
     [](int count, Random& random) {
       std::vector<Vector3d> outward;
       for (int i = 0; i < count; ++i) {
         outward.push_back((randomDirection(random) + Vector3d(3, 0, 0)).normalized());
       }
       return outward;
     }},
    {"the same few directions",
     [](int count, Random& random) {
       const Vector3d few[] = {Vector3d::UnitX(), -Vector3d::UnitX(), Vector3d::UnitZ(),
                               Vector3d(-0.8, 0.6, 0), Vector3d(-0.8, 0, -0.6)};
       std::vector<Vector3d> outward;
       for (int i = 0; i < count; ++i) outward.push_back(few[uniformInt(random, 0, 4)]);
       return outward;
     }},
    {"two bundles",
     [](int count, Random& random) {
       std::vector<Vector3d> outward;
       for (int i = 0; i < count; ++i) {
         const Vector3d axis(0, i % 3 == 0 ? -1 : 1, 0);
         outward.push_back((axis + 1e-4 * randomDirection(random)).normalized());
       }
       return outward;
     }},
};

TEST(StraightPairs, AreThoseOfComparingAll) {
  Random random(announcedSeed("AreThoseOfComparingAll", 5));
  for (const Junction& junction : kJunctions) {
    for (const int count : {0, 1, 2, 3, 8, 9, 17, 40, 333, 1000}) {
      const std::vector<Vector3d> outward = junction.outward(count, random);
      EXPECT_EQ(sorted(straightPairs(outward).pairs), comparingAll(outward))
          << junction.name << ", " << count << " ends";
    }
  }
}

// Comparing all would double what there is for each end when the ends are doubled.
TEST(StraightPairs, CompareEachEndWithAFewOthers) {
  Random random(announcedSeed("CompareEachEndWithAFewOthers", 6));
  constexpr double kMost = 120.0;
  for (const Junction& junction : kJunctions) {
    for (const int count : {2000, 20000, 100000}) {
      const std::size_t compared = straightPairs(junction.outward(count, random)).compared;
      EXPECT_LT(static_cast<double>(compared) / count, kMost)
          << junction.name << ", " << count << " ends";
    }
  }
}

}  // namespace
}  // namespace flatland::test
