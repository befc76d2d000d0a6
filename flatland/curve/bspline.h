// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "flatland/curve/bezier_chain.h"

namespace flatland {

/// A B-spline curve, open or closed (periodic), with any admissible knots. A plain value that keeps
/// its exact Bezier form beside it: the pieces are the knot intervals of its domain that have a
/// length, each with a parameter in [0, 1].
///
/// Open, n points, degree d: n + d + 1 knots, the domain is [knots[d], knots[n]]. Knots of
/// multiplicity d + 1 at the ends (clamped) let the curve begin and end at its first and last
/// point. Closed: n points, n + 1 knots, the domain [knots[0], knots[n]] and periodic beyond it.
class BSpline {
 public:
  /// Precondition: whyInvalid(...) is empty.
  BSpline(int degree, bool closed, std::vector<Vec2> points, std::vector<double> knots);

  /// Knots 0, 1, 2, ...; of an open one clamped at both ends.
  static std::vector<double> uniformKnots(int degree, bool closed, std::size_t pointCount);

  /// Why there is no such B-spline, in words for a person; nullopt if there is. Degree at least 1,
  /// more points than the degree (closed: at least 3), knots finite and in order, no inner knot
  /// more than `degree` times, a domain that has a length.
  static std::optional<std::string> whyInvalid(int degree, bool closed, std::size_t pointCount,
                                               const std::vector<double>& knots);

  int degree() const { return degree_; }
  bool closed() const { return closed_; }
  const std::vector<Vec2>& points() const { return points_; }
  const std::vector<double>& knots() const { return knots_; }
  int pieceCount() const { return bezier_.pieceCount(); }

  /// The same curve as a chain of Bezier pieces, exact up to rounding.
  const BezierChain& bezierForm() const { return bezier_; }

  /// The knot at which piece i begins; that of pieceCount() ends the curve.
  double knotAt(int piece) const { return breaks_[static_cast<std::size_t>(piece)]; }

  /// True if d successive knots are one, so that the curve passes through the point `index`.
  bool passesThrough(std::size_t index) const;

  /// Same knots, a point moved. Precondition: index in range.
  void setPoint(std::size_t index, const Vec2& point);

  bool operator==(const BSpline& other) const;

 private:
  void build();
  double extendedKnot(int index) const;

  int degree_;
  bool closed_;
  std::vector<Vec2> points_;
  std::vector<double> knots_;
  std::vector<double> breaks_;  ///< the different knots of the domain
  BezierChain bezier_;
};

/// The same curve with a knot (and with it a control point) more, at t, a chain parameter (piece
/// index plus local parameter): Boehm's algorithm. Unchanged where the knot already has its full
/// multiplicity, the degree.
BSpline withKnot(const BSpline& spline, double t);

}  // namespace flatland
