// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace flatland {

namespace detail {

/// One step of the three-dimensional Hilbert curve: from the octant at one level, in one of 24
/// poses, to its place along the curve and the pose inside it (bibliography: hamilton2006).
struct HilbertStep {
  std::uint8_t place;
  std::uint8_t pose;
};

constexpr std::array<std::array<HilbertStep, 8>, 24> hilbertSteps() {
  std::array<std::array<HilbertStep, 8>, 24> steps{};
  const auto rotateLeft = [](unsigned b, unsigned by) {
    by %= 3;
    return ((b << by) | (b >> (3 - by))) & 7u;
  };
  const auto gray = [](unsigned i) { return i ^ (i >> 1); };
  for (unsigned entry = 0; entry < 8; ++entry) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (unsigned octant = 0; octant < 8; ++octant) {
        const unsigned turned = rotateLeft(octant ^ entry, 3 - (axis + 1) % 3);
        const unsigned place = turned ^ (turned >> 1) ^ (turned >> 2);
        const unsigned entryInside = place == 0 ? 0 : gray(2 * ((place - 1) / 2));
        const unsigned odd = place == 0 ? 0 : (place % 2 == 1 ? place : place - 1);
        const unsigned axisInside = static_cast<unsigned>(std::countr_one(odd)) % 3;
        const unsigned nextEntry = entry ^ rotateLeft(entryInside, axis + 1);
        const unsigned nextAxis = (axis + axisInside + 1) % 3;
        steps[entry * 3 + axis][octant] = {static_cast<std::uint8_t>(place),
                                           static_cast<std::uint8_t>(nextEntry * 3 + nextAxis)};
      }
    }
  }
  return steps;
}

}  // namespace detail

/// The place of a cell along the Hilbert curve through a cube of 2^bits cells a side; coordinates
/// below 2^bits, bits <= 21. Cells that follow each other share a face.
inline std::uint64_t hilbertKey(std::uint32_t x, std::uint32_t y, std::uint32_t z, int bits) {
  static constexpr auto kSteps = detail::hilbertSteps();
  std::uint64_t key = 0;
  unsigned pose = 0;
  for (int level = bits - 1; level >= 0; --level) {
    const unsigned octant =
        ((x >> level) & 1u) | (((y >> level) & 1u) << 1) | (((z >> level) & 1u) << 2);
    const detail::HilbertStep step = kSteps[pose][octant];
    key = (key << 3) | step.place;
    pose = step.pose;
  }
  return key;
}

}  // namespace flatland
