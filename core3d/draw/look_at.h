// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core3d/draw/drawing.h"
#include "core3d/draw/sight.h"
#include "core3d/draw/strokes.h"

namespace flatland {

/// Asks what is seen of chains and fills their stretches, on all cores. What is outline is told
/// apart if exterior silhouettes are on. Stretches stay empty where it is stopped. Returns how many
/// rays were cast: about one a px of visible lines, two where outlines are looked for.
std::size_t lookAt(std::vector<SeenChain>& chains, const Sight& sight, const Projection& projection,
                   const LineOptions& lines, const StrokeOptions& strokes);

}  // namespace flatland
