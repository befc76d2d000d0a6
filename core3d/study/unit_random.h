// SPDX-License-Identifier: MIT
#pragma once

#include <random>

namespace flatland {

/// Uniform in [0, 1), from the upper 53 bits. The same on every platform, unlike the distributions
/// of the standard library.
inline double unitRandom(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11U) * 0x1p-53;
}

}  // namespace flatland
