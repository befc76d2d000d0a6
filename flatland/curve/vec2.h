// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace flatland {

/// A point or vector of the plane, (x, y), in the length unit of the scene; y points up.
using Vec2 = Eigen::Vector2d;

/// a.x b.y - a.y b.x: positive when b lies counter-clockwise of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// v turned by +90 degrees (counter-clockwise).
inline Vec2 rotateCcw(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace flatland
