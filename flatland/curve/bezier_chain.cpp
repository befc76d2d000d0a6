// SPDX-License-Identifier: MIT
#include "flatland/curve/bezier_chain.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace flatland {

BezierChain::BezierChain(Bezier bezier)
    : degree_(bezier.degree()), closed_(false), points_(std::move(bezier.points)) {
  assert(points_.size() >= 2);
}

BezierChain::BezierChain(int degree, bool closed, std::vector<Vec2> points)
    : degree_(degree), closed_(closed), points_(std::move(points)) {
  assert(!whyInvalid(degree_, closed_, points_.size()));
}

std::optional<std::string> BezierChain::whyInvalid(int degree, bool closed,
                                                   std::size_t pointCount) {
  if (degree < 1) return "a degree of " + std::to_string(degree) + " is below 1";
  const auto d = static_cast<std::size_t>(degree);
  const std::string found =
      "degree " + std::to_string(degree) + " with " + std::to_string(pointCount) + " points: ";
  const std::string pieces = std::to_string(degree) + " m";
  if (closed && (pointCount == 0 || pointCount % d != 0)) {
    return found + "a closed chain of m pieces needs " + pieces +
           " points (the first is not repeated)";
  }
  if (closed && pointCount < 2) return found + "a closed chain needs at least 2 points";
  if (!closed && (pointCount < 2 || (pointCount - 1) % d != 0)) {
    return found + "an open chain of m pieces needs " + pieces + " + 1 points";
  }
  return std::nullopt;
}

int BezierChain::pieceCount() const {
  return static_cast<int>(points_.size() - (closed_ ? 0 : 1)) / degree_;
}

void BezierChain::setPoint(std::size_t index, const Vec2& point) { points_.at(index) = point; }

Bezier BezierChain::piece(int i) const {
  assert(0 <= i && i < pieceCount());
  Bezier bezier;
  const auto first = static_cast<std::size_t>(i * degree_);
  const auto count = static_cast<std::size_t>(degree_) + 1;
  bezier.points.reserve(count);
  for (std::size_t j = 0; j < count; ++j)
    bezier.points.push_back(points_[(first + j) % points_.size()]);
  return bezier;
}

ChainParameter BezierChain::locate(double t) const {
  const int last = pieceCount() - 1;
  const int piece = std::clamp(static_cast<int>(std::floor(t)), 0, last);
  return {piece, std::clamp(t - piece, 0.0, 1.0)};
}

Jet jetAt(const BezierChain& chain, double t) {
  const auto [piece, local] = chain.locate(t);
  return jetAt(chain.piece(piece), local);
}

Vec2 pointAt(const BezierChain& chain, double t) {
  const auto [piece, local] = chain.locate(t);
  return pointAt(chain.piece(piece), local);
}

namespace {

// The chain of the same topology whose pieces are given; neighbours share their ends.
BezierChain joined(const std::vector<Bezier>& pieces, bool closed) {
  std::vector<Vec2> points;
  for (const Bezier& piece : pieces) {
    points.insert(points.end(), piece.points.begin(), piece.points.end() - 1);
  }
  if (!closed) points.push_back(pieces.back().points.back());
  return BezierChain(pieces.front().degree(), closed, std::move(points));
}

std::vector<Bezier> piecesOf(const BezierChain& chain) {
  std::vector<Bezier> pieces;
  for (int i = 0; i < chain.pieceCount(); ++i) pieces.push_back(chain.piece(i));
  return pieces;
}

}  // namespace

BezierChain splitAt(const BezierChain& chain, double t) {
  const auto [piece, local] = chain.locate(t);
  if (local <= 0.0 || local >= 1.0) return chain;
  std::vector<Bezier> pieces = piecesOf(chain);
  auto [low, high] = splitAt(pieces[static_cast<std::size_t>(piece)], local);
  pieces[static_cast<std::size_t>(piece)] = std::move(low);
  pieces.insert(pieces.begin() + piece + 1, std::move(high));
  return joined(pieces, chain.closed());
}

BezierChain elevated(const BezierChain& chain) {
  std::vector<Bezier> pieces = piecesOf(chain);
  for (Bezier& piece : pieces) piece = elevated(piece);
  return joined(pieces, chain.closed());
}

BezierChain reversed(const BezierChain& chain) {
  std::vector<Vec2> points(chain.points().rbegin(), chain.points().rend());
  // A closed chain keeps its first joint first.
  if (chain.closed()) std::rotate(points.begin(), points.end() - 1, points.end());
  return BezierChain(chain.degree(), chain.closed(), std::move(points));
}

double twiceSignedArea(const BezierChain& chain) {
  // Integral of cross(p - origin, dp) piece by piece, by Gauss-Legendre of enough points to be
  // exact would do; the control polygon form is shorter: for a Bezier piece the integral is sum_ij
  // cross(P_i, P_j - P_i weights); here by exact Bernstein integration of p x p'.
  const Vec2 origin = chain.points().front();
  double area = 0.0;
  for (int m = 0; m < chain.pieceCount(); ++m) {
    const Bezier piece = chain.piece(m);
    const int n = piece.degree();
    // int_0^1 B_i^n B_j^(n-1) dt = binom(n, i) binom(n - 1, j) / (binom(2n - 1, i + j) 2 n)
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double logWeight = std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1) +
                                 std::lgamma(n) - std::lgamma(j + 1) - std::lgamma(n - j) -
                                 std::lgamma(2 * n) + std::lgamma(i + j + 1) +
                                 std::lgamma(2 * n - i - j);
        const Vec2 p = piece.points[static_cast<std::size_t>(i)] - origin;
        const Vec2 d = piece.points[static_cast<std::size_t>(j) + 1] -
                       piece.points[static_cast<std::size_t>(j)];
        area += 0.5 * std::exp(logWeight) * cross(p, d);
      }
    }
  }
  return area;  // an open chain is closed by its chord, which adds nothing as seen from its start
}

Nearest nearestPoint(const BezierChain& chain, const Vec2& p) {
  // Enough samples per piece to land in the basin of the nearest point of any curve a hand can
  // draw; then golden-section search, which needs no derivative and survives cusps.
  const int samples = 16 * chain.degree();
  Nearest best{0.0, std::numeric_limits<double>::infinity()};
  for (int m = 0; m < chain.pieceCount(); ++m) {
    const Bezier piece = chain.piece(m);
    const auto distanceSq = [&](double t) { return (pointAt(piece, t) - p).squaredNorm(); };
    int nearest = 0;
    double nearestSq = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= samples; ++i) {
      const double dSq = distanceSq(static_cast<double>(i) / samples);
      if (dSq < nearestSq) nearestSq = dSq, nearest = i;
    }
    if (std::sqrt(nearestSq) > 2.0 * best.distance && best.distance > 0.0) continue;
    double a = std::max(0, nearest - 1) / static_cast<double>(samples);
    double b = std::min(samples, nearest + 1) / static_cast<double>(samples);
    constexpr double kGolden = 0.6180339887498949;
    for (int i = 0; i < 42; ++i) {  // 0.618^42 is about 2e-9 of a sample step
      const double x1 = b - kGolden * (b - a), x2 = a + kGolden * (b - a);
      (distanceSq(x1) <= distanceSq(x2) ? b : a) = distanceSq(x1) <= distanceSq(x2) ? x2 : x1;
    }
    double t = 0.5 * (a + b);
    // The ends are legal answers that the search only approaches.
    for (const double end : {0.0, 1.0}) {
      if (distanceSq(end) <= distanceSq(t)) t = end;
    }
    const double distance = std::sqrt(distanceSq(t));
    if (distance < best.distance) best = {m + t, distance};
  }
  return best;
}

}  // namespace flatland
