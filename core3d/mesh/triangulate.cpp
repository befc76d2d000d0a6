// SPDX-License-Identifier: MIT
#include "core3d/mesh/triangulate.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "flatland/curve/vec2.h"

namespace flatland {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Tests of a point against a triangle for one soup: about half a second.
constexpr std::size_t kBudget = 100'000'000;

double doubleArea(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

// The corners of a polygon in the plane across its mean normal (Newell), counter-clockwise, scaled
// to about 1. Empty if the polygon has no mean normal.
std::vector<Vec2> flattened(const PolygonSoup& soup, std::span<const std::uint32_t> polygon) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(polygon.size());
  const Eigen::Map<const Eigen::Matrix3Xd> all(soup.positions.data(), 3,
                                               static_cast<Eigen::Index>(soup.vertexCount()));
  // Halves, because the difference of two coordinates may leave the range of double.
  const Eigen::Vector3d first = 0.5 * all.col(polygon[0]);
  double size = 0.0;
  for (const std::uint32_t v : polygon) {
    points.push_back(0.5 * all.col(v) - first);
    size = std::max(size, points.back().cwiseAbs().maxCoeff());
  }
  if (!(size > 0.0)) return {};
  for (Eigen::Vector3d& p : points) p /= size;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    normal += points[i].cross(points[(i + 1) % points.size()]);
  }
  if (!(normal.norm() > 1e-12)) return {};
  normal.normalize();
  const Eigen::Vector3d e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  std::vector<Vec2> flat;
  flat.reserve(points.size());
  for (const Eigen::Vector3d& p : points) flat.emplace_back(e1.dot(p), e2.dot(p));
  return flat;
}

// Sine of the smallest angle, negative if the triangle is clockwise.
double quality(const Vec2& a, const Vec2& b, const Vec2& c) {
  double sides[3] = {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()};
  std::sort(sides, sides + 3);
  const double scale = std::sqrt(sides[1] * sides[2]);
  return scale > 0.0 ? doubleArea(a, b, c) / scale : 0.0;
}

class EarCutter {
 public:
  EarCutter(const std::vector<Vec2>& points, std::size_t& budget)
      : points_(points), budget_(budget), next_(points.size()), previous_(points.size()) {
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (!isConvex(i)) reflex_.push_back(i);
    }
  }

  /// Corner triples; nullopt when the budget is spent.
  std::optional<std::vector<std::array<std::size_t, 3>>> cut() {
    std::vector<std::array<std::size_t, 3>> ears;
    std::deque<std::size_t> candidates;
    std::vector<char> gone(points_.size(), 0), waiting(points_.size(), 1);
    for (std::size_t i = 0; i < points_.size(); ++i) candidates.push_back(i);
    std::size_t left = points_.size(), anyone = 0;
    while (left > 3) {
      std::size_t ear;
      if (candidates.empty()) {
        // No ear is left, so the polygon crosses or touches itself.
        folded_ = true;
        while (gone[anyone]) anyone = next_[anyone];
        ear = leastBad(anyone, left);
      } else {
        ear = candidates.front();
        candidates.pop_front();
        waiting[ear] = 0;
        if (gone[ear] || !isEar(ear)) {
          if (budget_ == 0) return std::nullopt;
          continue;
        }
      }
      if (budget_ == 0) return std::nullopt;
      const std::size_t before = previous_[ear], after = next_[ear];
      ears.push_back({before, ear, after});
      next_[before] = after;
      previous_[after] = before;
      gone[ear] = 1;
      if (anyone == ear) anyone = after;
      --left;
      for (const std::size_t i : {before, after}) {
        if (!waiting[i]) candidates.push_back(i);
        waiting[i] = 1;
      }
      // Corners become convex as ears go, and hardly ever reflex again; those that are tested in
      // vain cost time only.
      if (ears.size() % 64 == 0) {
        std::erase_if(reflex_, [&](std::size_t i) { return gone[i] || isConvex(i); });
      }
    }
    while (gone[anyone]) anyone = next_[anyone];
    ears.push_back({previous_[anyone], anyone, next_[anyone]});
    if (doubleArea(points_[previous_[anyone]], points_[anyone], points_[next_[anyone]]) < 0.0) {
      folded_ = true;
    }
    return ears;
  }

  bool folded() const { return folded_; }

 private:
  double area(std::size_t i) const {
    return doubleArea(points_[previous_[i]], points_[i], points_[next_[i]]);
  }
  bool isConvex(std::size_t i) const { return area(i) > 0.0; }

  void spend(std::size_t cost) { budget_ -= std::min(budget_, cost); }

  bool isEar(std::size_t i) {
    if (!isConvex(i)) return false;
    const Vec2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
    spend(reflex_.size() + 1);
    // Corners at the place of one of a, b, c touch the ear and do not lie in it (bridges to holes).
    return std::none_of(reflex_.begin(), reflex_.end(), [&](std::size_t j) {
      const Vec2& p = points_[j];
      return doubleArea(a, b, p) >= 0.0 && doubleArea(b, c, p) >= 0.0 &&
             doubleArea(c, a, p) >= 0.0 && p != a && p != b && p != c;
    });
  }

  // Of the corners that are left the one with the largest signed area.
  std::size_t leastBad(std::size_t from, std::size_t left) {
    spend(left);
    std::size_t best = from;
    for (std::size_t i = next_[from]; i != from; i = next_[i]) {
      if (area(i) > area(best)) best = i;
    }
    return best;
  }

  const std::vector<Vec2>& points_;
  std::size_t& budget_;
  std::vector<std::size_t> next_, previous_, reflex_;
  bool folded_ = false;
};

class Triangulator {
 public:
  explicit Triangulator(const PolygonSoup& soup) : soup_(soup) {}

  void add(std::span<const std::uint32_t> polygon, std::uint32_t number) {
    number_ = number;
    if (polygon.size() == 3) return emit(polygon[0], polygon[1], polygon[2]);
    const std::vector<Vec2> points = flattened(soup_, polygon);
    if (points.empty()) return fan(polygon);
    if (polygon.size() == 4) return quadrilateral(polygon, points);
    EarCutter cutter(points, budget_);
    const auto ears = cutter.cut();
    if (!ears) {
      ++result.huge;
      return fan(polygon);
    }
    if (cutter.folded()) ++result.folded;
    for (const auto& [a, b, c] : *ears) emit(polygon[a], polygon[b], polygon[c]);
  }

  Triangulation result;

 private:
  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    result.triangles.push_back({a, b, c});
    result.polygonOf.push_back(number_);
  }

  void fan(std::span<const std::uint32_t> p) {
    for (std::size_t i = 1; i + 1 < p.size(); ++i) emit(p[0], p[i], p[i + 1]);
  }

  void quadrilateral(std::span<const std::uint32_t> p, const std::vector<Vec2>& q) {
    const double through0 = std::min(quality(q[0], q[1], q[2]), quality(q[0], q[2], q[3]));
    const double through1 = std::min(quality(q[1], q[2], q[3]), quality(q[1], q[3], q[0]));
    if (std::max(through0, through1) < 0.0) ++result.folded;
    // Of two equally good diagonals the one at the first corner by place, so that the order of the
    // file does not matter.
    const auto before = [this](std::uint32_t a, std::uint32_t b) {
      const double *x = &soup_.positions[3 * std::size_t{a}],
                   *y = &soup_.positions[3 * std::size_t{b}];
      return std::lexicographical_compare(x, x + 3, y, y + 3);
    };
    const std::uint32_t of0 = before(p[0], p[2]) ? p[0] : p[2],
                        of1 = before(p[1], p[3]) ? p[1] : p[3];
    const bool first = through0 > through1 || (through0 == through1 && before(of0, of1));
    if (first) {
      emit(p[0], p[1], p[2]);
      emit(p[0], p[2], p[3]);
    } else {
      emit(p[1], p[2], p[3]);
      emit(p[1], p[3], p[0]);
    }
  }

  const PolygonSoup& soup_;
  std::size_t budget_ = kBudget;
  std::uint32_t number_ = 0;
};

}  // namespace

Triangulation triangulate(const PolygonSoup& soup) {
  Triangulator triangulator(soup);
  const std::size_t polygons = soup.polygonCount();
  triangulator.result.triangles.reserve(polygons);
  triangulator.result.polygonOf.reserve(polygons);
  for (std::size_t i = 0; i < polygons; ++i) {
    triangulator.add(soup.polygon(i), static_cast<std::uint32_t>(i));
  }
  return std::move(triangulator.result);
}

}  // namespace flatland
