// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "flatland/scene/scene.h"

namespace flatland {

/// Preset::group of the catalogue.
inline constexpr const char* kDegenerateGroup = "Degenerate cases";

/// The catalogue of degenerate cases, for allPresets(): curves on which a formula has no answer or
/// a double one, each with the answer expected.
std::vector<Preset> degeneratePresets();

}  // namespace flatland
