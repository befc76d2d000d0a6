// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace flatland {

struct StraightPairs {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  ///< numbers of ends, none twice
  std::size_t compared = 0;  ///< how often two directions were compared
};

/// Of the ends of lines at a junction, which go on into which: the straightest pair first, then the
/// straightest of those left, and so on while two are left that turn by less than 60 degrees.
/// Equally straight: the pair with the smaller numbers first. The pairs are given in no order.
///
/// `outward`: directions away from the junction, unit vectors.
///
/// The straightest partner of each of two ends being the other makes them a pair, whatever becomes
/// of the rest, so the pairs are found along chains of nearest neighbours: O(n) searches in a tree
/// of directions, O(n log n) together unless most ends are equally far from straight on.
StraightPairs straightPairs(std::span<const Eigen::Vector3d> outward);

}  // namespace flatland
