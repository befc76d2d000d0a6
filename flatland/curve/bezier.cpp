// SPDX-License-Identifier: MIT
#include "flatland/curve/bezier.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace flatland {

namespace {

// One de Casteljau step in place on the first `count` points: each becomes the blend with its
// successor.
void blend(std::vector<Vec2>& points, std::size_t count, double t) {
  for (std::size_t i = 0; i + 1 < count; ++i) {
    points[i] = (1.0 - t) * points[i] + t * points[i + 1];
  }
}

// Deviation of the cubic from the curve: the largest distance at matching parameters, sampled. The
// difference is a polynomial of the curve's degree, so 4 samples per degree see its maximum
// closely.
double deviation(const Bezier& curve, const Bezier& cubic) {
  const int samples = 4 * curve.degree();
  double worstSq = 0.0;
  for (int i = 1; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    worstSq = std::max(worstSq, (pointAt(curve, t) - pointAt(cubic, t)).squaredNorm());
  }
  return std::sqrt(worstSq);
}

}  // namespace

Vec2 pointAt(const Bezier& curve, double t) {
  assert(!curve.points.empty());
  std::vector<Vec2> b = curve.points;
  for (std::size_t count = b.size(); count > 1; --count) blend(b, count, t);
  return b.front();
}

std::array<Vec2, 5> derivativesAt(const Bezier& curve, double t) {
  assert(!curve.points.empty());
  // The last rows of the de Casteljau triangle give the derivatives as scaled differences. Taken
  // relative to the first point, so that a curve far from the origin does not lose its digits.
  const Vec2 origin = curve.points.front();
  std::vector<Vec2> b = curve.points;
  for (Vec2& p : b) p -= origin;
  const int n = curve.degree();
  std::size_t count = b.size();
  std::array<Vec2, 5> d;
  d.fill(Vec2::Zero());
  const auto second = [&b](std::size_t i) -> Vec2 {
    return b[i + 2] - b[i + 1] - (b[i + 1] - b[i]);
  };
  for (; count > 5; --count) blend(b, count, t);
  if (count == 5) {
    const double factor = 1.0 * n * (n - 1) * (n - 2) * (n - 3);
    d[4] = factor * (second(2) - second(1) - (second(1) - second(0)));
    blend(b, count--, t);
  }
  if (count == 4) {
    d[3] = n * (n - 1) * (n - 2) * (second(1) - second(0));
    blend(b, count--, t);
  }
  if (count == 3) {
    d[2] = n * (n - 1) * second(0);
    blend(b, count--, t);
  }
  if (count == 2) {
    d[1] = n * (b[1] - b[0]);
    blend(b, count--, t);
  }
  d[0] = origin + b[0];
  return d;
}

Jet jetAt(const Bezier& curve, double t) {
  const std::array<Vec2, 5> d = derivativesAt(curve, t);
  return {d[0], d[1], d[2], d[3]};
}

std::pair<Bezier, Bezier> splitAt(const Bezier& curve, double t) {
  std::vector<Vec2> b = curve.points;
  Bezier low, high;
  low.points.resize(b.size());
  high.points.resize(b.size());
  for (std::size_t count = b.size(); count > 0; --count) {
    low.points[b.size() - count] = b.front();
    high.points[count - 1] = b[count - 1];
    blend(b, count, t);
  }
  return {low, high};
}

Bezier elevated(const Bezier& curve) {
  const std::size_t n = curve.points.size();  // the new degree
  Bezier result;
  result.points.reserve(n + 1);
  result.points.push_back(curve.points.front());
  for (std::size_t i = 1; i < n; ++i) {
    const double w = static_cast<double>(i) / static_cast<double>(n);
    result.points.push_back(w * curve.points[i - 1] + (1.0 - w) * curve.points[i]);
  }
  result.points.push_back(curve.points.back());
  return result;
}

Bezier reversed(const Bezier& curve) {
  return {std::vector<Vec2>(curve.points.rbegin(), curve.points.rend())};
}

std::vector<Bezier> toCubics(const Bezier& curve, double tolerance) {
  assert(curve.points.size() >= 2 && tolerance > 0.0);
  if (curve.degree() <= 3) {
    Bezier cubic = curve;
    while (cubic.degree() < 3) cubic = elevated(cubic);
    return {cubic};
  }
  // Hermite: same ends and end derivatives. Its error falls with the fourth power of the length,
  // so halving ends soon; the depth bound only stops a tolerance below rounding.
  constexpr int kMaxDepth = 16;
  std::vector<Bezier> cubics;
  std::vector<std::pair<Bezier, int>> stack{{curve, 0}};
  while (!stack.empty()) {
    const auto [part, depth] = stack.back();
    stack.pop_back();
    const double third = part.degree() / 3.0;
    const auto& q = part.points;
    const Bezier cubic{{q.front(), q.front() + third * (q[1] - q.front()),
                        q.back() - third * (q.back() - q[q.size() - 2]), q.back()}};
    if (depth == kMaxDepth || deviation(part, cubic) <= tolerance) {
      cubics.push_back(cubic);
      continue;
    }
    auto [low, high] = splitAt(part, 0.5);
    stack.emplace_back(std::move(high), depth + 1);
    stack.emplace_back(std::move(low), depth + 1);
  }
  return cubics;
}

}  // namespace flatland
