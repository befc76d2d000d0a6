// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace flatland::test {

/// The seed of a random test: FLATLAND_SEED from the environment, else `usual`. Printed, so that a
/// failure can be run again.
inline std::uint64_t announcedSeed(const char* test, std::uint64_t usual) {
  const char* asked = std::getenv("FLATLAND_SEED");
  const std::uint64_t seed = asked ? std::stoull(asked) : usual;
  std::cout << test << ": seed " << seed << " (FLATLAND_SEED changes it)\n";
  return seed;
}

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline int uniformInt(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

inline double normal(Random& random) { return std::normal_distribution<double>()(random); }

}  // namespace flatland::test
