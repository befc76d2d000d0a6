// SPDX-License-Identifier: MIT
#include "flatland/curve/rational_bezier.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "flatland/curve/taylor.h"

namespace flatland {

namespace {

/// A piece as two polynomial curves: weighted points relative to the first one, and (weight, 0).
struct Homogeneous {
  Vec2 origin;
  Bezier weighted;
  Bezier weight;
};

Homogeneous homogeneousPiece(const RationalBezier& curve, int index) {
  const auto d = static_cast<std::size_t>(curve.degree());
  const auto first = static_cast<std::size_t>(index) * d;
  Homogeneous piece;
  piece.origin = curve.points()[first];
  for (std::size_t j = 0; j <= d; ++j) {
    const std::size_t i = (first + j) % curve.points().size();
    const double w = curve.weights()[i];
    piece.weighted.points.push_back(w * (curve.points()[i] - piece.origin));
    piece.weight.points.emplace_back(w, 0.0);
  }
  return piece;
}

/// Pieces put together again; neighbours share their ends.
RationalBezier joined(const std::vector<Homogeneous>& pieces, bool closed) {
  std::vector<Vec2> points;
  std::vector<double> weights;
  const auto append = [&](const Homogeneous& piece, std::size_t i) {
    const double w = piece.weight.points[i].x();
    points.push_back(piece.origin + piece.weighted.points[i] / w);
    weights.push_back(w);
  };
  const std::size_t d = pieces.front().weight.points.size() - 1;
  for (const Homogeneous& piece : pieces) {
    for (std::size_t i = 0; i < d; ++i) append(piece, i);
  }
  if (!closed) append(pieces.back(), d);
  return RationalBezier(static_cast<int>(d), closed, std::move(points), std::move(weights));
}

std::vector<Homogeneous> piecesOf(const RationalBezier& curve) {
  std::vector<Homogeneous> pieces;
  for (int i = 0; i < curve.pieceCount(); ++i) pieces.push_back(homogeneousPiece(curve, i));
  return pieces;
}

}  // namespace

RationalBezier::RationalBezier(int degree, bool closed, std::vector<Vec2> points,
                               std::vector<double> weights)
    : polygon_(degree, closed, std::move(points)), weights_(std::move(weights)) {
  assert(!whyInvalid(degree, closed, polygon_.points().size(), weights_));
}

std::optional<std::string> RationalBezier::whyInvalid(int degree, bool closed,
                                                      std::size_t pointCount,
                                                      const std::vector<double>& weights) {
  if (auto why = BezierChain::whyInvalid(degree, closed, pointCount)) return why;
  if (weights.size() != pointCount) {
    return "expected " + std::to_string(pointCount) + " weights, one for each point, found " +
           std::to_string(weights.size());
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 0.0) || !std::isfinite(weights[i])) {
      return "weight " + std::to_string(i) + " is not above 0";
    }
  }
  const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
  if (*most / kWeightRange > *least) {
    return "the largest weight is more than a million times the smallest";
  }
  return std::nullopt;
}

std::array<Vec2, 5> derivativesAt(const RationalBezier& curve, int piece, double t) {
  const Homogeneous h = homogeneousPiece(curve, piece);
  const std::array<Vec2, 5> p = derivativesAt(h.weighted, t), w = derivativesAt(h.weight, t);
  Taylor<4> x, y, weight;
  double factorial = 1.0;
  for (std::size_t k = 0; k < 5; ++k) {
    if (k > 1) factorial *= static_cast<double>(k);
    x.c[k] = p[k].x() / factorial;
    y.c[k] = p[k].y() / factorial;
    weight.c[k] = w[k].x() / factorial;
  }
  x = x / weight;
  y = y / weight;
  std::array<Vec2, 5> result;
  for (int k = 0; k < 5; ++k) {
    result[static_cast<std::size_t>(k)] = Vec2(x.derivative(k), y.derivative(k));
  }
  result[0] += h.origin;
  return result;
}

RationalBezier splitAt(const RationalBezier& curve, double t) {
  const auto [piece, local] = curve.polygon().locate(t);
  if (local <= 0.0 || local >= 1.0) return curve;
  std::vector<Homogeneous> pieces = piecesOf(curve);
  Homogeneous& low = pieces[static_cast<std::size_t>(piece)];
  Homogeneous high = low;
  std::tie(low.weighted, high.weighted) = splitAt(low.weighted, local);
  std::tie(low.weight, high.weight) = splitAt(low.weight, local);
  pieces.insert(pieces.begin() + piece + 1, std::move(high));
  return joined(pieces, curve.closed());
}

RationalBezier elevated(const RationalBezier& curve) {
  std::vector<Homogeneous> pieces = piecesOf(curve);
  for (Homogeneous& piece : pieces) {
    piece.weighted = elevated(piece.weighted);
    piece.weight = elevated(piece.weight);
  }
  return joined(pieces, curve.closed());
}

}  // namespace flatland
