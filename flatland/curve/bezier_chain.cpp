// SPDX-License-Identifier: MIT
#include "flatland/curve/bezier_chain.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "flatland/roots/isolate.h"

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
  // int (p - origin) x dp, piece by piece, by the exact integrals of products of Bernstein
  // polynomials: in scaled form, a product of degree m integrates to the mean of its plain
  // coefficients.
  const Vec2 origin = chain.points().front();
  double area = 0.0;
  for (int m = 0; m < chain.pieceCount(); ++m) {
    std::vector<double> x, y;
    for (const Vec2& point : chain.piece(m).points) {
      x.push_back(point.x() - origin.x());
      y.push_back(point.y() - origin.y());
    }
    const Bernstein bx = Bernstein::fromDoubles(x), by = Bernstein::fromDoubles(y);
    const auto coefficients = (bx * derivative(by) - by * derivative(bx)).coefficients();
    double sum = 0.0;
    for (const Bounded& c : coefficients) sum += c.value();
    area += sum / static_cast<double>(coefficients.size());
  }
  return area;  // an open chain is closed by its chord, which adds nothing as seen from its start
}

Nearest nearestPoint(const BezierChain& chain, const Vec2& p) {
  // The ends, and every root of (curve - p) . derivative.
  Nearest best{0.0, std::numeric_limits<double>::infinity()};
  for (int m = 0; m < chain.pieceCount(); ++m) {
    const Bezier piece = chain.piece(m);
    const auto consider = [&](double t) {
      const double distance = (pointAt(piece, t) - p).norm();
      if (distance < best.distance) best = {m + t, distance};
    };
    consider(0.0);
    consider(1.0);
    std::vector<double> x, y;
    for (const Vec2& point : piece.points) {
      x.push_back(point.x() - p.x());
      y.push_back(point.y() - p.y());
    }
    const Bernstein bx = Bernstein::fromDoubles(x), by = Bernstein::fromDoubles(y);
    const Roots roots = isolateRoots(bx * derivative(bx) + by * derivative(by));
    for (const Root& root : roots.roots) consider(root.t);
    for (const RootInterval& open : roots.unresolved) consider(0.5 * (open.low + open.high));
  }
  return best;
}

}  // namespace flatland
