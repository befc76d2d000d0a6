// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "flatland/curve/jet.h"

namespace flatland {

/// A Bezier curve of any degree: control points in order, degree = size - 1, parameter t in [0, 1].
/// A plain value. One point is a legal, constant curve.
struct Bezier {
  std::vector<Vec2> points;

  int degree() const { return static_cast<int>(points.size()) - 1; }
};

/// Point at t by de Casteljau; t outside [0, 1] extrapolates. Cost: O(degree^2).
Vec2 pointAt(const Bezier& curve, double t);

/// Point and derivatives to order 3 at t. Derivatives beyond the degree are zero.
Jet jetAt(const Bezier& curve, double t);

/// The same to order 4; element k is the k-th derivative.
std::array<Vec2, 5> derivativesAt(const Bezier& curve, double t);

/// The two halves [0, t] and [t, 1], each of the same degree and together the same set of points.
/// The last point of the first equals the first point of the second, bit for bit.
std::pair<Bezier, Bezier> splitAt(const Bezier& curve, double t);

/// The same curve written with one more control point (the shape does not change).
Bezier elevated(const Bezier& curve);

/// The same points walked the other way.
Bezier reversed(const Bezier& curve);

/// Cubic Beziers that stay within `tolerance` (length) of the curve and meet it and its tangent at
/// their ends; exact, one piece per curve, up to degree 3. For drawing formats that know only
/// cubics.
std::vector<Bezier> toCubics(const Bezier& curve, double tolerance);

}  // namespace flatland
