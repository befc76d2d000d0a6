// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flatland/scene/scene.h"

namespace flatland {

/// Scales a scene of Bezier chains by a power of two, which rounds nothing, so that the longer side
/// of the box around its control points is more than 2 and at most 4 units, and moves the box's
/// centre to the origin. Returns what was done, in words ("scaled by 1/16 and centred"). Throws
/// InputError in the name of `source` if the scene is too small to be told from a point (below
/// 1e-50 units).
std::string makeComfortable(Scene& scene, const std::string& source);

}  // namespace flatland
