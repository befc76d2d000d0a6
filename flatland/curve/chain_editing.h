// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>

#include "flatland/curve/bezier_chain.h"

namespace flatland {

/// What the neighbours of a moved point of a chain do.
enum class JointMode {
  Keep,   ///< a moved joint takes its two handles along; a moved handle turns the opposite one so
          ///< that a smooth joint stays smooth
  Break,  ///< only the named points move
};

/// Moves the points `indices` by `delta`. Precondition: indices in range.
BezierChain movePoints(const BezierChain& chain, const std::set<std::size_t>& indices,
                       const Vec2& delta, JointMode mode);

/// The chain without the points `indices`, or the reason (for a person) why they cannot go.
/// A single Bezier loses control points and with them degree (at least 2 points stay). A chain
/// loses joints: the two pieces at an inner joint become one, exactly the curve they were split
/// from if there is such a curve (so inserting and removing a joint changes nothing), else one that
/// keeps the outer handles.
struct RemovalResult {
  std::optional<BezierChain> chain;
  std::string reason;
};
RemovalResult removePoints(const BezierChain& chain, const std::set<std::size_t>& indices);

/// True if the tangents on both sides of the joint `index` agree in direction to within
/// kSmoothJointRad (see features/tolerances.h).
bool isSmoothJoint(const BezierChain& chain, std::size_t index);

}  // namespace flatland
