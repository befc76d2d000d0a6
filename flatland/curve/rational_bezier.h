// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "flatland/curve/bezier_chain.h"

namespace flatland {

/// Rational Bezier pieces of one degree, joined and stored like those of a BezierChain, with a
/// weight above 0 for each control point: conics exactly, among them circles. The curve lies in the
/// convex hull of its points. A plain value.
class RationalBezier {
 public:
  /// Precondition: whyInvalid(...) is empty.
  RationalBezier(int degree, bool closed, std::vector<Vec2> points, std::vector<double> weights);

  /// Why there is no such curve, in words for a person; nullopt if there is. As many weights as
  /// points; each above 0; the largest at most kWeightRange times the smallest.
  static std::optional<std::string> whyInvalid(int degree, bool closed, std::size_t pointCount,
                                               const std::vector<double>& weights);

  /// Beyond it, a piece is so unevenly walked that double precision cannot follow.
  static constexpr double kWeightRange = 1e6;

  int degree() const { return polygon_.degree(); }
  bool closed() const { return polygon_.closed(); }
  int pieceCount() const { return polygon_.pieceCount(); }
  const std::vector<Vec2>& points() const { return polygon_.points(); }
  const std::vector<double>& weights() const { return weights_; }

  /// The chain of the same control points: where pieces begin and which points are joints.
  const BezierChain& polygon() const { return polygon_; }

  /// Precondition: index in range.
  void setPoint(std::size_t index, const Vec2& point) { polygon_.setPoint(index, point); }

  bool operator==(const RationalBezier&) const = default;

 private:
  BezierChain polygon_;
  std::vector<double> weights_;
};

/// Position and derivatives by t to order 4 on one piece, t in [0, 1], by the quotient rule on
/// homogeneous coordinates: exact up to rounding. Precondition: 0 <= piece < pieceCount().
std::array<Vec2, 5> derivativesAt(const RationalBezier& curve, int piece, double t);

/// The same set of points with one more joint, at chain parameter t (de Casteljau on homogeneous
/// coordinates). Unchanged at a joint.
RationalBezier splitAt(const RationalBezier& curve, double t);

/// Every piece written with one more control point (the shape does not change).
RationalBezier elevated(const RationalBezier& curve);

}  // namespace flatland
