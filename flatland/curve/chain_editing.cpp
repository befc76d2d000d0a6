// SPDX-License-Identifier: MIT
#include "flatland/curve/chain_editing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "flatland/features/tolerances.h"

namespace flatland {

namespace {

using Index = std::size_t;

// The neighbours of point i along the chain; empty beyond the ends of an open chain.
std::optional<Index> before(const BezierChain& chain, Index i) {
  if (i > 0) return i - 1;
  return chain.closed() ? std::optional<Index>(chain.points().size() - 1) : std::nullopt;
}
std::optional<Index> after(const BezierChain& chain, Index i) {
  if (i + 1 < chain.points().size()) return i + 1;
  return chain.closed() ? std::optional<Index>(0) : std::nullopt;
}

// After the handle `handle` of `joint` moved, turns the handle on the other side to keep the two
// opposite; its length stays.
void alignOpposite(BezierChain& chain, Index joint, Index handle, Index opposite) {
  const Vec2 at = chain.points()[joint];
  const Vec2 arm = chain.points()[handle] - at;
  const double armLength = arm.norm();
  const double oppositeLength = (chain.points()[opposite] - at).norm();
  if (armLength > 0.0) chain.setPoint(opposite, at - arm * (oppositeLength / armLength));
}

}  // namespace

namespace {

// The curve that was split into the two pieces, if there is one: it continues the first by the
// ratio of the handles at the joint.
std::optional<Bezier> unsplit(const Bezier& low, const Bezier& high) {
  const std::size_t n = low.points.size();
  const double in = (low.points[n - 1] - low.points[n - 2]).norm();
  const double out = (high.points[1] - high.points[0]).norm();
  if (!(in > 0.0)) return std::nullopt;
  const Bezier whole = splitAt(low, (in + out) / in).first;
  double size = 0.0, deviation = 0.0;
  const Bezier again = splitAt(whole, in / (in + out)).second;
  for (std::size_t i = 0; i < n; ++i) {
    size = std::max(size, (whole.points[i] - whole.points[0]).norm());
    deviation = std::max(deviation, (again.points[i] - high.points[i]).norm());
  }
  // Points typed or rounded to pixels never agree so well by chance.
  constexpr double kSameShape = 1e-9;
  if (!(deviation <= kSameShape * size)) return std::nullopt;
  Bezier exact = whole;
  exact.points.back() = high.points.back();
  return exact;
}

// One piece in place of two: the very curve they are parts of, else one with the outer halves of
// their handles.
Bezier mergedPieces(const Bezier& low, const Bezier& high) {
  if (const auto whole = unsplit(low, high)) return *whole;
  Bezier merged = high;
  const std::size_t leading = low.points.size() / 2;
  std::copy_n(low.points.begin(), leading, merged.points.begin());
  return merged;
}

}  // namespace

bool isSmoothJoint(const BezierChain& chain, std::size_t index) {
  if (!chain.isJoint(index)) return true;
  const auto in = before(chain, index), out = after(chain, index);
  if (!in || !out) return false;
  const Vec2 a = chain.points()[index] - chain.points()[*in];
  const Vec2 b = chain.points()[*out] - chain.points()[index];
  if (a.squaredNorm() == 0.0 || b.squaredNorm() == 0.0) return false;
  return std::abs(std::atan2(cross(a, b), a.dot(b))) < kSmoothJointRad;
}

BezierChain movePoints(const BezierChain& chain, const std::set<std::size_t>& indices,
                       const Vec2& delta, JointMode mode) {
  BezierChain moved = chain;
  std::set<Index> all = indices;
  if (mode == JointMode::Keep && chain.degree() >= 2) {
    for (const Index i : indices) {
      if (!chain.isJoint(i) || chain.pieceCount() < 2) continue;
      if (const auto h = before(chain, i); h && !chain.isJoint(*h)) all.insert(*h);
      if (const auto h = after(chain, i); h && !chain.isJoint(*h)) all.insert(*h);
    }
  }
  for (const Index i : all) moved.setPoint(i, chain.points()[i] + delta);
  // Smooth joints need two handles: below degree 3 a handle serves two joints, and turning it for
  // one would spoil the other.
  if (mode != JointMode::Keep || chain.degree() < 3) return moved;
  for (const Index i : indices) {
    if (chain.isJoint(i)) continue;
    const auto previous = before(chain, i), next = after(chain, i);
    const auto align = [&](std::optional<Index> joint, std::optional<Index> opposite) {
      if (!joint || !opposite || !chain.isJoint(*joint)) return;
      if (all.contains(*joint) || all.contains(*opposite) || !isSmoothJoint(chain, *joint)) return;
      alignOpposite(moved, *joint, i, *opposite);
    };
    if (next) align(next, after(chain, *next));
    if (previous) align(previous, before(chain, *previous));
  }
  return moved;
}

RemovalResult removePoints(const BezierChain& chain, const std::set<std::size_t>& indices) {
  const auto& points = chain.points();
  if (indices.empty()) return {chain, {}};
  if (chain.pieceCount() == 1 && !chain.closed()) {
    std::vector<Vec2> kept;
    for (Index i = 0; i < points.size(); ++i) {
      if (!indices.contains(i)) kept.push_back(points[i]);
    }
    if (kept.size() < 2) return {std::nullopt, "a curve needs at least 2 control points"};
    return {BezierChain(Bezier{std::move(kept)}), {}};
  }
  for (const Index i : indices) {
    if (!chain.isJoint(i)) {
      return {std::nullopt, "only joints can be removed from a chain; this point is a handle"};
    }
  }
  const auto d = static_cast<Index>(chain.degree());
  const int pieces = chain.pieceCount();
  const Index jointCount = static_cast<Index>(pieces) + (chain.closed() ? 0 : 1);
  std::vector<Index> keptJoints;
  for (Index j = 0; j < jointCount; ++j) {
    if (!indices.contains(j * d)) keptJoints.push_back(j);
  }
  const Index needed = chain.closed() ? (chain.degree() == 1 ? 2 : 1) : 2;
  if (keptJoints.size() < needed) {
    return {std::nullopt, "too few joints would stay: remove the whole curve instead"};
  }
  std::vector<Vec2> result;
  const Index runs = chain.closed() ? keptJoints.size() : keptJoints.size() - 1;
  for (Index r = 0; r < runs; ++r) {
    const Index from = keptJoints[r];
    const Index to = r + 1 < keptJoints.size() ? keptJoints[r + 1] : keptJoints[0] + jointCount;
    Bezier merged = chain.piece(static_cast<int>(from) % pieces);
    for (Index i = from + 1; i < to; ++i)
      merged = mergedPieces(merged, chain.piece(static_cast<int>(i) % pieces));
    result.insert(result.end(), merged.points.begin(), merged.points.end() - 1);
  }
  if (!chain.closed()) result.push_back(points[keptJoints.back() * d]);
  return {BezierChain(chain.degree(), chain.closed(), std::move(result)), {}};
}

}  // namespace flatland
