// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "flatland/curve/curve.h"
#include "flatland/roots/chebyshev.h"

namespace flatland {

/// A function of a place of a curve, given by position and derivatives to order 4 there
/// (derivativesAt), with its size.
using CurveFunction = std::function<Measured(const std::array<Vec2, 5>&)>;

/// Where the function vanishes along a curve: one answer for each piece, in its local parameter, by
/// proxies whatever the kind of curve. Zeros that come from a vanishing speed at a cusp are not
/// taken out. A root at a joint appears in both pieces.
std::vector<ProxyRoots> rootsAlong(const Curve& curve, const CurveFunction& f);

}  // namespace flatland
