// SPDX-License-Identifier: MIT
#pragma once

#include <variant>
#include <vector>

#include "flatland/curve/arc_length.h"
#include "flatland/curve/bezier_chain.h"

namespace flatland {

/// A curve of any kind the program knows. What every kind offers are the functions below; what only
/// one kind offers is asked of that kind (std::get_if).
///
/// Parameter: t in [0, pieceCount]; between whole numbers a curve is smooth, at them (the joints)
/// its derivatives may jump.
using Curve = std::variant<BezierChain>;

int pieceCount(const Curve& curve);

/// True if the end of the last piece is the start of the first.
bool isClosed(const Curve& curve);

/// Point and derivatives by t. A joint belongs to the piece it starts; t is clamped to the domain.
Jet jetAt(const Curve& curve, double t);

/// The same on one piece, t in [0, 1]: at its ends the one-sided derivatives. Precondition: 0 <=
/// piece < pieceCount.
Jet jetAt(const Curve& curve, int piece, double t);

Vec2 pointAt(const Curve& curve, double t);

/// See arc_length.h.
ArcLength arcLength(const Curve& curve, double t0, double t1, double accuracy);

/// The points a person can drag, in order; empty for a curve that is given by formulas.
const std::vector<Vec2>& controlPoints(const Curve& curve);

/// See Nearest in bezier_chain.h.
Nearest nearestPoint(const Curve& curve, const Vec2& p);

}  // namespace flatland
