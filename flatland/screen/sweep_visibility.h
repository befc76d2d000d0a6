// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "flatland/screen/sweep.h"

namespace flatland {

/// What of a sweep the viewer can see. Marks are the same from opposite directions, but what hides
/// them is not.
struct SweepVisibility {
  /// For each branch and each of its points: bit 0 is set if it is visible from the point's
  /// angleDeg, bit 1 if from angleDeg + 180.
  std::vector<std::vector<std::uint8_t>> branches;

  /// For each line, whether it is visible from the whole degrees -180, -179, ..., 179.
  std::vector<std::vector<bool>> lines;

  /// False if there were more than kMostRays lines of sight to follow: then nothing is marked as
  /// hidden, and whoever shows it has to say so.
  bool marked = true;
  static constexpr std::size_t kMostRays = 500'000;
  /// How many there are: two for each point of a branch and 360 for each line.
  static std::size_t raysFor(const Sweep& sweep);

  /// Whether point `point` of a branch is visible in the copy of the branch that is shifted by
  /// `halfTurns` times 180 degrees.
  bool branchAt(std::size_t branch, std::size_t point, int halfTurns) const {
    return ((branches[branch][point] >> (halfTurns & 1)) & 1) != 0;
  }
  /// At the whole degree nearest to any angle.
  bool lineAt(std::size_t line, double angleDeg) const;
};

/// Visibility (screen/sight_rays.h) at every point of the sweep of this scene, orthographic as the
/// sweep. Cost: a few microseconds for each ray (tests/bench). `goOn` is asked now and then; once
/// it says no, the answer is empty.
SweepVisibility visibilityOf(const Sweep& sweep, const Scene& scene,
                             const std::function<bool()>& goOn = {});

}  // namespace flatland
