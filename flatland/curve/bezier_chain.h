// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flatland/curve/bezier.h"

namespace flatland {

/// Where a chain parameter lies: piece index and the local parameter in [0, 1].
struct ChainParameter {
  int piece;
  double t;
};

/// Bezier pieces of one degree, each starting where the one before ends; a single Bezier is the
/// chain of one piece. Parameter: t in [0, pieceCount()], piece index plus local parameter.
///
/// Points are stored once: an open chain of m pieces of degree d has m d + 1 points, a closed one
/// m d (the last piece ends at point 0). Points 0, d, 2d, ... are the joints.
class BezierChain {
 public:
  /// A single open Bezier. Precondition: at least two points.
  explicit BezierChain(Bezier bezier);

  /// Precondition: whyInvalid(degree, closed, points.size()) is empty.
  BezierChain(int degree, bool closed, std::vector<Vec2> points);

  /// Why a chain cannot have this many points, in words for a person; nullopt if it can.
  static std::optional<std::string> whyInvalid(int degree, bool closed, std::size_t pointCount);

  int degree() const { return degree_; }
  bool closed() const { return closed_; }
  int pieceCount() const;
  const std::vector<Vec2>& points() const { return points_; }

  /// Same topology, points moved. Precondition: index in range.
  void setPoint(std::size_t index, const Vec2& point);

  /// Piece i as a Bezier. Precondition: 0 <= i < pieceCount().
  Bezier piece(int i) const;

  /// True for the points where pieces meet or an open chain ends.
  bool isJoint(std::size_t index) const { return index % static_cast<std::size_t>(degree_) == 0; }

  /// Piece and local parameter of t, clamped to the domain; a joint belongs to the piece it starts,
  /// the end of the last piece to that piece.
  ChainParameter locate(double t) const;

  bool operator==(const BezierChain& other) const = default;

 private:
  int degree_;
  bool closed_;
  std::vector<Vec2> points_;
};

/// Jet at chain parameter t (derivatives by the local parameter of the piece).
Jet jetAt(const BezierChain& chain, double t);
Vec2 pointAt(const BezierChain& chain, double t);

/// The same set of points with one more joint, at t. At a joint the chain comes back unchanged.
BezierChain splitAt(const BezierChain& chain, double t);

/// Every piece written with one more control point (the shape does not change).
BezierChain elevated(const BezierChain& chain);

/// The same points walked the other way.
BezierChain reversed(const BezierChain& chain);

/// Twice the signed area enclosed, the open end closed by its chord: positive when walked
/// counter-clockwise. Exact up to rounding.
double twiceSignedArea(const BezierChain& chain);

/// The nearest point of the chain to `p`: its parameter and distance, by certified roots
/// (roots/isolate.h), so no nearer branch is missed. Where several points are equally near, one of
/// them.
struct Nearest {
  double t;
  double distance;
};
Nearest nearestPoint(const BezierChain& chain, const Vec2& p);

}  // namespace flatland
