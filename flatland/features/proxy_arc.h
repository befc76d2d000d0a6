// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "flatland/features/viewed_arc.h"
#include "flatland/roots/chebyshev.h"

namespace flatland {

/// Position and derivatives by t to order 4 on one piece, t in [0, 1], one-sided at the ends.
using PieceDerivatives = std::function<std::array<Vec2, 5>(double)>;

/// The function of an arc at a point with these derivatives, with its size (see Measured). Same
/// sign as ArcFunction says, times powers of the speed and of the distance to the viewer.
Measured arcFunctionAt(ArcFunction function, const std::array<Vec2, 5>& d, const ViewFrame& frame);

/// The arcs of a piece that is no polynomial; their roots come from proxies (roots/chebyshev.h).
/// Empty if no point of it is farther than 1e-13 of `extent` from another. Interior cusps are where
/// the speed falls to what rounding t by a few units makes of it. A piece is straight, and a
/// curvature constant, where no sampled value exceeds 1e-13 of its size.
std::vector<std::unique_ptr<ViewedArc>> proxyArcs(const PieceDerivatives& derivatives, int index,
                                                  const ViewFrame& frame, double extent);

}  // namespace flatland
