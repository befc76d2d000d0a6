// SPDX-License-Identifier: MIT
#include "flatland/curve/curve_editing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatland {

namespace {

constexpr const char* kNoPoints =
    "The curve is given by a formula and has no points; convert it to a Bezier chain first.";

std::vector<Vec2> without(const std::vector<Vec2>& points, const std::set<std::size_t>& indices) {
  std::vector<Vec2> left;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!indices.contains(i)) left.push_back(points[i]);
  }
  return left;
}

/// The mean of the knots that belong to a control point: where it pulls most.
double greville(const BSpline& spline, std::size_t index) {
  const auto d = static_cast<std::size_t>(spline.degree());
  const std::vector<double>& knots = spline.knots();
  if (spline.closed()) return knots[index % spline.points().size()];
  double sum = 0.0;
  for (std::size_t k = index + 1; k <= index + d; ++k) sum += knots[k];
  return sum / static_cast<double>(d);
}

EditResult withoutPoint(const BSpline& spline, std::size_t index) {
  const std::size_t n = spline.points().size();
  const bool closed = spline.closed();
  std::vector<Vec2> points = without(spline.points(), {index});
  std::vector<double> knots = BSpline::uniformKnots(spline.degree(), closed, points.size());
  if (spline.knots() != BSpline::uniformKnots(spline.degree(), closed, n)) {
    // The inner knot nearest to where the point pulls.
    knots = spline.knots();
    const auto first = static_cast<std::size_t>(closed ? 1 : spline.degree() + 1);
    const std::size_t end = closed ? n : n;
    std::size_t nearest = first;
    const double where = greville(spline, index);
    for (std::size_t k = first; k < end; ++k) {
      if (std::abs(knots[k] - where) < std::abs(knots[nearest] - where)) nearest = k;
    }
    if (nearest < end) knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
  if (auto why = BSpline::whyInvalid(spline.degree(), closed, points.size(), knots)) {
    return {std::nullopt, "The points cannot go: " + *why + "."};
  }
  return {BSpline(spline.degree(), closed, std::move(points), std::move(knots)), {}};
}

EditResult withoutPoints(const BSpline& spline, const std::set<std::size_t>& indices) {
  EditResult result{spline, {}};
  for (auto i = indices.rbegin(); i != indices.rend() && result.curve; ++i) {
    result = withoutPoint(std::get<BSpline>(*result.curve), *i);
  }
  return result;
}

EditResult withoutPoints(const RationalBezier& curve, const std::set<std::size_t>& indices) {
  if (curve.closed() || curve.pieceCount() > 1) {
    return {std::nullopt,
            "Points of a rational chain cannot be removed; convert it to a Bezier chain first."};
  }
  std::vector<Vec2> points = without(curve.points(), indices);
  if (points.size() < 2) return {std::nullopt, "A rational Bezier curve keeps at least 2 points."};
  std::vector<double> weights;
  for (std::size_t i = 0; i < curve.weights().size(); ++i) {
    if (!indices.contains(i)) weights.push_back(curve.weights()[i]);
  }
  const int degree = static_cast<int>(points.size()) - 1;
  return {RationalBezier(degree, false, std::move(points), std::move(weights)), {}};
}

}  // namespace

Curve movePoints(const Curve& curve, const std::set<std::size_t>& indices, const Vec2& delta,
                 JointMode mode) {
  if (const auto* chain = std::get_if<BezierChain>(&curve)) {
    return movePoints(*chain, indices, delta, mode);
  }
  Curve moved = curve;
  if (auto* spline = std::get_if<BSpline>(&moved)) {
    std::vector<Vec2> points = spline->points();
    for (const std::size_t i : indices) points[i] += delta;
    return BSpline(spline->degree(), spline->closed(), std::move(points), spline->knots());
  }
  if (auto* rational = std::get_if<RationalBezier>(&moved)) {
    const BezierChain polygon = movePoints(rational->polygon(), indices, delta, mode);
    for (std::size_t i = 0; i < polygon.points().size(); ++i) {
      rational->setPoint(i, polygon.points()[i]);
    }
  }
  return moved;
}

Curve withPoint(const Curve& curve, std::size_t index, const Vec2& place) {
  Curve moved = curve;
  if (auto* chain = std::get_if<BezierChain>(&moved)) chain->setPoint(index, place);
  if (auto* spline = std::get_if<BSpline>(&moved)) spline->setPoint(index, place);
  if (auto* rational = std::get_if<RationalBezier>(&moved)) rational->setPoint(index, place);
  return moved;
}

EditResult withPointAt(const Curve& curve, double t) {
  if (const auto* chain = std::get_if<BezierChain>(&curve)) return {splitAt(*chain, t), {}};
  if (const auto* spline = std::get_if<BSpline>(&curve)) return {withKnot(*spline, t), {}};
  if (const auto* rational = std::get_if<RationalBezier>(&curve)) {
    return {splitAt(*rational, t), {}};
  }
  return {std::nullopt, kNoPoints};
}

std::size_t pointAddedAt(const Curve& after, const Curve& before, double t) {
  if (!std::holds_alternative<BSpline>(after)) {
    const ChainParameter at = locate(before, t);
    const std::size_t index = static_cast<std::size_t>((at.piece + 1) * degreeOf(after));
    return index % controlPoints(after).size();
  }
  const Vec2 place = pointAt(before, t);
  const std::vector<Vec2>& points = controlPoints(after);
  std::size_t best = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((points[i] - place).norm() < (points[best] - place).norm()) best = i;
  }
  return best;
}

EditResult withoutPoints(const Curve& curve, const std::set<std::size_t>& indices) {
  if (const auto* chain = std::get_if<BezierChain>(&curve)) {
    RemovalResult result = removePoints(*chain, indices);
    if (!result.chain) return {std::nullopt, std::move(result.reason)};
    return {std::move(*result.chain), {}};
  }
  if (const auto* spline = std::get_if<BSpline>(&curve)) return withoutPoints(*spline, indices);
  if (const auto* rational = std::get_if<RationalBezier>(&curve)) {
    return withoutPoints(*rational, indices);
  }
  return {std::nullopt, kNoPoints};
}

EditResult withRaisedDegree(const Curve& curve) {
  if (const auto* chain = std::get_if<BezierChain>(&curve)) return {elevated(*chain), {}};
  if (const auto* rational = std::get_if<RationalBezier>(&curve)) return {elevated(*rational), {}};
  if (std::holds_alternative<BSpline>(curve)) {
    return {std::nullopt,
            "The degree of a B-spline stays; convert it to a Bezier chain to raise it."};
  }
  return {std::nullopt, "The curve is given by a formula and has no degree."};
}

bool isJoint(const Curve& curve, std::size_t index) {
  if (const auto* chain = std::get_if<BezierChain>(&curve)) return chain->isJoint(index);
  if (const auto* spline = std::get_if<BSpline>(&curve)) return spline->passesThrough(index);
  if (const auto* rational = std::get_if<RationalBezier>(&curve)) {
    return rational->polygon().isJoint(index);
  }
  return false;
}

BezierChain asBezierChain(const Curve& curve, double tolerance) {
  if (const BezierChain* chain = bezierForm(curve)) return *chain;
  return drawnAs(curve, tolerance);
}

}  // namespace flatland
