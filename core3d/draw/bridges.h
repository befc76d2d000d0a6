// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core3d/draw/screen_chain.h"

namespace flatland {

/// True for the families of which noise tears pieces out: maxima and zeros of what is estimated
/// from third derivatives.
bool isBridged(LineFamily family);

/// Joins chains of one family and level whose ends nearly meet, in one line: the gap is no longer
/// than `largestGapPx`, nor than either chain, it points the same way as both ends within 45
/// degrees and they as each other within 60, and on the surface it is not much longer than it
/// looks. Where one chain takes over from another beside it, no more than 2.5 px apart for no more
/// than twice `largestGapPx`, both are cut back and joined, so that no line is drawn twice there.
/// The nearest ends are joined first, each once; a chain whose own ends meet is closed. A bridge is
/// one straight piece; it lies in the triangle that it starts from and stands out as the piece
/// before it does.
///
/// The result does not depend on thresholds. Cost: O(n log n) for n chains that are not crowded.
std::vector<ScreenChain> bridged(std::vector<ScreenChain> lines, const Projection& projection,
                                 double largestGapPx);

}  // namespace flatland
