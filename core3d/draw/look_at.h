// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core3d/draw/drawing.h"
#include "core3d/draw/sight.h"
#include "core3d/draw/strokes.h"

namespace flatland {

/// Asks what is seen of chains and fills their stretches, on all cores. What is outline is told
/// apart if exterior silhouettes are on. A contour or boundary that is hidden while there is
/// background right beside it is the outline covered by a facet that sticks out: it counts as seen
/// where no other contour or boundary is drawn along that outline, so that outlines have no gaps.
/// Stretches stay empty where it is stopped. Returns how many
/// rays were cast: about one a px of visible lines, two where outlines are looked for or may be.
std::size_t lookAt(std::vector<SeenChain>& chains, const Sight& sight, const Projection& projection,
                   const LineOptions& lines, const StrokeOptions& strokes);

}  // namespace flatland
