// SPDX-License-Identifier: MIT
#include "flatland/curve/fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace flatland {

namespace {

constexpr int kRounds = 6;             // of new parameters for one piece
constexpr double kStray = 0.25;        // of the distance of two points, see fit.h
constexpr int kTangentReach = 3;       // points on each side that a tangent comes from
constexpr double kShortestArm = 1e-3;  // of the chord: below it the end has no tangent

double binomial(int n, int k) {
  double value = 1.0;
  for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
  return value;
}

double bernstein(int n, int k, double t) {
  return binomial(n, k) * std::pow(t, k) * std::pow(1.0 - t, n - k);
}

class Fitter {
 public:
  Fitter(std::vector<Vec2> points, bool closed, const FitOptions& options)
      : points_(std::move(points)), closed_(closed), options_(options) {
    findCorners();
  }

  FittedChain run() {
    const std::size_t n = points_.size();
    // A closed row starts at a corner if there is one.
    std::vector<std::size_t> cuts;
    for (std::size_t i = 0; i < n; ++i) {
      if (corner_[i] || (!closed_ && (i == 0 || i + 1 == n))) cuts.push_back(i);
    }
    if (cuts.empty()) cuts.push_back(0);
    if (closed_) cuts.push_back(cuts.front() + n);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) fit(cuts[i], cuts[i + 1]);
    if (!closed_) control_.push_back(points_.back());
    const auto corners = static_cast<std::size_t>(std::count(corner_.begin(), corner_.end(), true));
    return {BezierChain(options_.degree, closed_, control_), deviation_, corners};
  }

 private:
  const Vec2& at(std::size_t i) const { return points_[i % points_.size()]; }

  /// The point that lies at least `reach` of way from point i, forward or back; the end of an open
  /// row at the latest.
  Vec2 away(std::size_t i, int step, double reach) const {
    double way = 0.0;
    std::size_t j = i;
    const std::size_t n = points_.size();
    for (std::size_t count = 0; count < n && way < reach; ++count) {
      if (!closed_ && ((step < 0 && j == 0) || (step > 0 && j + 1 == n))) break;
      const std::size_t next = step > 0 ? j + 1 : (j == 0 ? n - 1 : j - 1);
      way += (at(next) - at(j)).norm();
      j = next % n;
    }
    return at(j);
  }

  // By chords of at least half a usual distance: of two points that nearly coincide, the direction
  // between them says nothing.
  void findCorners() {
    const std::size_t n = points_.size();
    corner_.assign(n, false);
    std::vector<double> steps;
    for (std::size_t i = 0; i + (closed_ ? 0U : 1U) < n; ++i) {
      steps.push_back((at(i + 1) - at(i)).norm());
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    const double reach = 0.5 * *middle;
    std::vector<double> turns(n, 0.0);
    for (std::size_t i = closed_ ? 0U : 1U; i + (closed_ ? 0U : 1U) < n; ++i) {
      const Vec2 before = at(i) - away(i, -1, reach), after = away(i, 1, reach) - at(i);
      turns[i] = std::abs(std::atan2(cross(before, after), before.dot(after)));
    }
    const double limit = options_.cornerDeg * std::numbers::pi / 180.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (!(turns[i] > limit)) continue;
      // Of near points that see the same corner, the one that turns most.
      const bool first = closed_ || i > 0, last = closed_ || i + 1 < n;
      const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
      const bool less =
          (first && (at(before) - at(i)).norm() < reach && turns[before] > turns[i]) ||
          (last && (at(after) - at(i)).norm() < reach && turns[after] >= turns[i]);
      corner_[i] = !less;
    }
  }

  /// Direction of a parabola by least squares through the points around i, in [low, high].
  Vec2 tangentAt(std::size_t i, std::size_t low, std::size_t high) const {
    std::vector<double> ways{0.0};
    std::vector<Vec2> offsets{Vec2::Zero()};
    for (const int step : {-1, 1}) {
      double way = 0.0;
      std::size_t j = i;
      for (int k = 0; k < kTangentReach; ++k) {
        if (step < 0 ? j == low : j == high) break;
        const std::size_t next = step < 0 ? j - 1 : j + 1;
        way += step * (at(next) - at(j)).norm();
        ways.push_back(way);
        offsets.push_back(at(next) - at(i));
        j = next;
      }
    }
    if (ways.size() < 3) return offsets.back() * (ways.back() < 0.0 ? -1.0 : 1.0);
    // p(s) = a s + b s^2, through the point itself.
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d right = Eigen::Matrix2d::Zero();
    for (std::size_t k = 1; k < ways.size(); ++k) {
      const Eigen::Vector2d row(ways[k], ways[k] * ways[k]);
      normal += row * row.transpose();
      right += row * offsets[k].transpose();
    }
    const Eigen::Matrix2d both = normal.colPivHouseholderQr().solve(right);
    const Vec2 tangent = both.row(0).transpose();
    return tangent.allFinite() && tangent.norm() > 0.0 ? tangent : offsets.back();
  }

  // From corner to corner, or once round: then both ends have one tangent.
  void fit(std::size_t low, std::size_t high) {
    const bool round = closed_ && high - low == points_.size() && !corner_[low % points_.size()];
    if (round) {
      const std::size_t n = points_.size();
      const Vec2 tangent = tangentAt(low + n, low + n - kTangentReach, low + n + kTangentReach);
      split(low, high, tangent, tangent);
    } else {
      split(low, high, tangentAt(low, low, high), tangentAt(high, low, high));
    }
  }

  void split(std::size_t low, std::size_t high, const Vec2& start, const Vec2& end) {
    if (high - low > 1) {
      std::vector<Vec2> piece;
      const double off = fitted(low, high, start.normalized(), end.normalized(), piece);
      if (off <= options_.tolerance) {
        deviation_ = std::max(deviation_, off);
        control_.insert(control_.end(), piece.begin(), piece.end() - 1);
        return;
      }
      const std::size_t middle = low + (high - low) / 2;
      const Vec2 tangent = tangentAt(middle, low, high);
      split(low, middle, start, tangent);
      split(middle, high, tangent, end);
      return;
    }
    // Two points: a straight line says all that is known.
    for (int k = 0; k < options_.degree; ++k) {
      control_.push_back(at(low) + (at(high) - at(low)) * k / options_.degree);
    }
  }

  /// Control points of one piece; returns the largest distance, infinite if it strays.
  double fitted(std::size_t low, std::size_t high, const Vec2& start, const Vec2& end,
                std::vector<Vec2>& piece) const {
    const int d = options_.degree;
    const auto count = static_cast<Eigen::Index>(high - low + 1);
    std::vector<double> t(static_cast<std::size_t>(count), 0.0);
    for (std::size_t i = 1; i < t.size(); ++i) {
      t[i] = t[i - 1] + (at(low + i) - at(low + i - 1)).norm();
    }
    const double length = t.back();
    for (double& each : t) each /= length;
    t.back() = 1.0;
    // Unknown: the two arms along the tangents, and the points between (x and y).
    const Eigen::Index inner = d - 3, unknowns = 2 + 2 * inner;
    double worst = 0.0;
    for (int round = 0; round < kRounds; ++round) {
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * count, unknowns);
      Eigen::VectorXd right(2 * count);
      for (Eigen::Index i = 0; i < count; ++i) {
        const double s = t[static_cast<std::size_t>(i)];
        const double first = bernstein(d, 1, s), last = bernstein(d, d - 1, s);
        const Vec2 fixed =
            at(low) * (bernstein(d, 0, s) + first) + at(high) * (bernstein(d, d, s) + last);
        const Vec2 rest = at(low + static_cast<std::size_t>(i)) - fixed;
        for (Eigen::Index c = 0; c < 2; ++c) {
          rows(2 * i + c, 0) = first * start[c];
          rows(2 * i + c, 1) = -last * end[c];
          for (Eigen::Index k = 0; k < inner; ++k) {
            rows(2 * i + c, 2 + 2 * k + c) = bernstein(d, static_cast<int>(k) + 2, s);
          }
          right(2 * i + c) = rest[c];
        }
      }
      // The shortest solution where there are fewer points than unknowns: towards even spacing.
      Eigen::VectorXd usual(unknowns);
      usual(0) = usual(1) = length / d;
      for (Eigen::Index k = 0; k < inner; ++k) {
        const double share = static_cast<double>(k + 2) / d;
        usual.segment<2>(2 + 2 * k) = (1.0 - share) * at(low) + share * at(high);
      }
      const Eigen::VectorXd solved =
          usual + rows.completeOrthogonalDecomposition().solve(right - rows * usual);
      piece.assign(static_cast<std::size_t>(d) + 1, Vec2::Zero());
      piece.front() = at(low);
      piece.back() = at(high);
      piece[1] = at(low) + solved(0) * start;
      piece[static_cast<std::size_t>(d) - 1] = at(high) - solved(1) * end;
      for (Eigen::Index k = 0; k < inner; ++k) {
        piece[static_cast<std::size_t>(k) + 2] = solved.segment<2>(2 + 2 * k);
      }
      const double least = kShortestArm * length;
      if (!(solved(0) > least) || !(solved(1) > least)) return kFar;
      worst = improve(Bezier{piece}, low, t);
      if (worst <= 0.1 * options_.tolerance) break;
    }
    return strays(Bezier{piece}, low, t) ? kFar : worst;
  }

  /// Moves the parameters to the feet of the points, as far as they keep their order; returns the
  /// largest distance.
  double improve(const Bezier& curve, std::size_t low, std::vector<double>& t) const {
    double worst = 0.0;
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
      const Vec2& p = at(low + i);
      for (int k = 0; k < 2; ++k) {
        const Jet jet = jetAt(curve, t[i]);
        const Vec2 off = jet.p - p;
        const double slope = jet.d1.squaredNorm() + off.dot(jet.d2);
        if (!(slope > 0.0)) break;
        const double moved = t[i] - off.dot(jet.d1) / slope;
        if (!(moved > t[i - 1] && moved < t[i + 1])) break;
        t[i] = moved;
      }
      worst = std::max(worst, (pointAt(curve, t[i]) - p).norm());
    }
    return worst;
  }

  bool strays(const Bezier& curve, std::size_t low, const std::vector<double>& t) const {
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
      const Vec2 a = at(low + i), chord = at(low + i + 1) - a;
      const double allowed = options_.tolerance + kStray * chord.norm();
      for (const double share : {0.25, 0.5, 0.75}) {
        const Vec2 off = pointAt(curve, t[i] + share * (t[i + 1] - t[i])) - a;
        const double along = std::clamp(off.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        if ((off - along * chord).norm() > allowed) return true;
      }
    }
    return false;
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<Vec2> points_;
  bool closed_;
  const FitOptions& options_;
  std::vector<bool> corner_;
  std::vector<Vec2> control_;
  double deviation_ = 0.0;
};

}  // namespace

std::optional<FittedChain> fitBezierChain(const std::vector<Vec2>& points, bool closed,
                                          const FitOptions& options) {
  assert(options.tolerance > 0.0 && options.degree >= 3 && options.degree <= 9);
  std::vector<Vec2> apart;
  for (const Vec2& p : points) {
    if (apart.empty() || p != apart.back()) apart.push_back(p);
  }
  while (closed && apart.size() > 1 && apart.front() == apart.back()) apart.pop_back();
  if (apart.size() < 2) return std::nullopt;
  return Fitter(std::move(apart), closed, options).run();
}

}  // namespace flatland
