// SPDX-License-Identifier: MIT
#include "flatland/curve/bspline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace flatland {

namespace {

std::size_t unsignedOf(int i) { return static_cast<std::size_t>(i); }

int wrapped(int index, int count) { return ((index % count) + count) % count; }

}  // namespace

BSpline::BSpline(int degree, bool closed, std::vector<Vec2> points, std::vector<double> knots)
    : degree_(degree),
      closed_(closed),
      points_(std::move(points)),
      knots_(std::move(knots)),
      bezier_(Bezier{{Vec2::Zero(), Vec2::Zero()}}) {
  assert(!whyInvalid(degree_, closed_, points_.size(), knots_));
  build();
}

std::vector<double> BSpline::uniformKnots(int degree, bool closed, std::size_t pointCount) {
  const int n = static_cast<int>(pointCount);
  std::vector<double> knots;
  for (int i = 0; i < (closed ? n + 1 : n + degree + 1); ++i) {
    knots.push_back(closed ? i : std::clamp(i - degree, 0, n - degree));
  }
  return knots;
}

std::optional<std::string> BSpline::whyInvalid(int degree, bool closed, std::size_t pointCount,
                                               const std::vector<double>& knots) {
  if (degree < 1) return "a degree of " + std::to_string(degree) + " is below 1";
  const std::size_t d = unsignedOf(degree);
  const std::size_t least = std::max<std::size_t>(d + 1, closed ? 3 : 2);
  if (pointCount < least) {
    return "a B-spline of degree " + std::to_string(degree) + " needs at least " +
           std::to_string(least) + " points, found " + std::to_string(pointCount);
  }
  const std::size_t expected = closed ? pointCount + 1 : pointCount + d + 1;
  if (knots.size() != expected) {
    return "expected " + std::to_string(expected) + " knots for " + std::to_string(pointCount) +
           " points of degree " + std::to_string(degree) + ", found " +
           std::to_string(knots.size());
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) return "a knot is not a finite number";
    if (i > 0 && knots[i] < knots[i - 1]) {
      return "knots must not decrease, but knot " + std::to_string(i) + " is below the one before";
    }
  }
  const double low = closed ? knots.front() : knots[d];
  const double high = closed ? knots.back() : knots[pointCount];
  if (!(low < high)) return "the knots leave no room for the curve";
  // Piece parameters need differences and ratios of knots.
  if (!std::isfinite(knots.back() - knots.front())) return "the knots lie too far apart";
  for (std::size_t i = 0; i < knots.size();) {
    std::size_t end = i;
    while (end < knots.size() && knots[end] == knots[i]) ++end;
    const bool inner = closed || (knots[i] > low && knots[i] < high);
    const std::size_t most = inner ? d : d + 1;
    // The first and the last knot of a closed spline are the same one.
    std::size_t times = end - i;
    if (closed && knots[i] == low) {
      times += static_cast<std::size_t>(std::count(knots.begin(), knots.end(), high)) - 1;
    }
    if (times > most) {
      return "a knot occurs " + std::to_string(times) + " times; more than " +
             std::to_string(most) + " would break the curve";
    }
    i = end;
  }
  return std::nullopt;
}

// Knot `index` of the open spline with the same curve: its domain begins at index degree_.
double BSpline::extendedKnot(int index) const {
  if (!closed_) return knots_[unsignedOf(index)];
  const int n = static_cast<int>(points_.size());
  const int i = index - degree_;
  const int turns = (i - wrapped(i, n)) / n;
  return knots_[unsignedOf(wrapped(i, n))] + turns * (knots_.back() - knots_.front());
}

void BSpline::build() {
  const int n = static_cast<int>(points_.size()), d = degree_;
  const int last = closed_ ? n + d : n;  // the domain is [knot d, knot last]
  std::vector<Vec2> chain;
  breaks_.clear();
  for (int span = d; span < last; ++span) {
    const double low = extendedKnot(span), high = extendedKnot(span + 1);
    if (!(low < high)) continue;
    breaks_.push_back(low);
    // Bezier point j is the blossom at (low, ..., low, high, ..., high) with j times `high`.
    for (int j = breaks_.size() == 1 ? 0 : 1; j <= d; ++j) {
      std::vector<Vec2> b;
      for (int i = span - d; i <= span; ++i) b.push_back(points_[unsignedOf(wrapped(i, n))]);
      for (int level = 1; level <= d; ++level) {
        const double u = level <= j ? high : low;
        for (int i = d; i >= level; --i) {
          const double from = extendedKnot(span - d + i);
          const double to = extendedKnot(span + 1 + i - level);
          const double w = (u - from) / (to - from);
          b[unsignedOf(i)] = (1.0 - w) * b[unsignedOf(i - 1)] + w * b[unsignedOf(i)];
        }
      }
      chain.push_back(b[unsignedOf(d)]);
    }
  }
  breaks_.push_back(extendedKnot(last));
  if (closed_) chain.pop_back();  // the last piece ends at the first point
  bezier_ = BezierChain(d, closed_, std::move(chain));
}

void BSpline::setPoint(std::size_t index, const Vec2& point) {
  points_.at(index) = point;
  build();
}

bool BSpline::passesThrough(std::size_t index) const {
  const int i = static_cast<int>(index);
  return extendedKnot(i + 1) == extendedKnot(i + degree_);
}

bool BSpline::operator==(const BSpline& other) const {
  return degree_ == other.degree_ && closed_ == other.closed_ && points_ == other.points_ &&
         knots_ == other.knots_;
}

BSpline withKnot(const BSpline& spline, double t) {
  const ChainParameter at = spline.bezierForm().locate(t);
  const double low = spline.knotAt(at.piece), high = spline.knotAt(at.piece + 1);
  const double u = at.t >= 1.0 ? high : low + at.t * (high - low);
  const int d = spline.degree(), n = static_cast<int>(spline.points().size());
  std::vector<double> knots = spline.knots();
  const bool closed = spline.closed();

  // At the ends of its domain an open curve is left alone.
  if (!closed && (u <= knots[unsignedOf(d)] || u >= knots[unsignedOf(n)])) return spline;
  int times = static_cast<int>(std::count(knots.begin(), knots.end(), u));
  if (closed && u == knots.front()) {
    times += static_cast<int>(std::count(knots.begin(), knots.end(), knots.back())) - 1;
  } else if (closed && u == knots.back()) {
    times += static_cast<int>(std::count(knots.begin(), knots.end(), knots.front())) - 1;
  }
  if (times >= d) return spline;

  if (!closed) {
    const auto place = std::upper_bound(knots.begin(), knots.end(), u);
    const int span = static_cast<int>(place - knots.begin()) - 1;
    std::vector<Vec2> points;
    for (int i = 0; i <= n; ++i) {
      if (i <= span - d) {
        points.push_back(spline.points()[unsignedOf(i)]);
      } else if (i > span - times) {
        points.push_back(spline.points()[unsignedOf(i - 1)]);
      } else {
        const double w =
            (u - knots[unsignedOf(i)]) / (knots[unsignedOf(i + d)] - knots[unsignedOf(i)]);
        points.push_back((1.0 - w) * spline.points()[unsignedOf(i - 1)] +
                         w * spline.points()[unsignedOf(i)]);
      }
    }
    knots.insert(place, u);
    return BSpline(d, false, std::move(points), std::move(knots));
  }

  // Closed: every new point is the blossom of the old curve at d successive new knots.
  const double period = knots.back() - knots.front();
  std::vector<double> more = knots;
  more.insert(std::upper_bound(more.begin(), more.end() - 1, u), u);
  const auto newKnot = [&](int i) {  // index 0 begins the domain
    const int r = wrapped(i, n + 1);
    return more[unsignedOf(r)] + (i - r) / (n + 1) * period;
  };
  const auto oldKnot = [&](int i) {
    const int r = wrapped(i, n);
    return knots[unsignedOf(r)] + (i - r) / n * period;
  };
  std::vector<Vec2> points;
  // Point i belongs to the knots i - d + 1 ... i, counted from the beginning of the domain.
  for (int i = 0; i <= n; ++i) {
    int span = -d - 1;  // the old span of the first of them: oldKnot(span) <= first < next
    while (!(oldKnot(span + 1) > newKnot(i - d + 1))) ++span;
    std::vector<Vec2> b;
    for (int j = span; j <= span + d; ++j) b.push_back(spline.points()[unsignedOf(wrapped(j, n))]);
    for (int level = 1; level <= d; ++level) {
      const double v = newKnot(i - d + level);
      for (int j = d; j >= level; --j) {
        const double from = oldKnot(span - d + j), to = oldKnot(span + 1 + j - level);
        const double w = (v - from) / (to - from);
        b[unsignedOf(j)] = (1.0 - w) * b[unsignedOf(j - 1)] + w * b[unsignedOf(j)];
      }
    }
    points.push_back(b[unsignedOf(d)]);
  }
  return BSpline(d, true, std::move(points), std::move(more));
}

}  // namespace flatland
