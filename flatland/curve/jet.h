// SPDX-License-Identifier: MIT
#pragma once

#include "flatland/curve/vec2.h"

namespace flatland {

/// A point of a curve with its derivatives by the parameter up to order 3: all that curvature and
/// its derivative need.
struct Jet {
  Vec2 p;   ///< the point
  Vec2 d1;  ///< first derivative by the parameter; zero at a cusp
  Vec2 d2;  ///< second derivative
  Vec2 d3;  ///< third derivative
};

/// Unit-speed quantities of a jet. Orientation: `normal` is the tangent turned by +90 degrees
/// (the left normal) times `side`; k follows the thesis (3.5), dn/du = k t, so k > 0 where the
/// curve bulges towards its normal. A counter-clockwise circle of radius R has k = -1/R on its
/// left (inner) side and +1/R with side = -1.
struct Frame {
  Vec2 tangent;   ///< t, unit
  Vec2 normal;    ///< n, unit
  double k;       ///< signed curvature, 1/length
  double kPrime;  ///< dk/du by arc length, 1/length^2
  double speed;   ///< |d1|, length per parameter
};

/// Frame of a jet; `side` is +1 or -1. Precondition: d1 is not zero.
Frame frameOf(const Jet& jet, int side = 1);

}  // namespace flatland
