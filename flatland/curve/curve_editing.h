// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>

#include "flatland/curve/chain_editing.h"
#include "flatland/curve/curve.h"

namespace flatland {

/// A changed curve, or the reason (for a person) why it cannot be changed so.
struct EditResult {
  std::optional<Curve> curve;
  std::string reason;
};

/// Moves control points by `delta`: those of Bezier and rational chains take along what `mode`
/// says, those of B-splines go alone. Precondition: indices in range.
Curve movePoints(const Curve& curve, const std::set<std::size_t>& indices, const Vec2& delta,
                 JointMode mode);

/// One control point at a place, alone. Precondition: index in range.
Curve withPoint(const Curve& curve, std::size_t index, const Vec2& place);

/// One point more at parameter t without a change of shape: a joint of a chain, a knot of a
/// B-spline. Unchanged where there is one already.
EditResult withPointAt(const Curve& curve, double t);

/// The control point that withPointAt added at parameter t, or the one nearest to it.
std::size_t pointAddedAt(const Curve& after, const Curve& before, double t);

/// Without some of its control points. A B-spline loses with each a knot near it; its shape
/// changes.
EditResult withoutPoints(const Curve& curve, const std::set<std::size_t>& indices);

/// Every piece written with one more control point, without a change of shape.
EditResult withRaisedDegree(const Curve& curve);

/// True if the curve passes through its control point `index`. Precondition: index in range.
bool isJoint(const Curve& curve, std::size_t index);

/// As a chain of polynomial pieces: exact where there is a Bezier form, else cubic and within
/// `tolerance` (see drawnAs).
BezierChain asBezierChain(const Curve& curve, double tolerance);

}  // namespace flatland
