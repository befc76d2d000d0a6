// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "core3d/study/surface_derivation.h"
#include "flatland/study/surface_steps.h"

namespace flatland::derivation {

// The surface that the steps of core3d/study/surface_derivation.h walk on. Not for others.

inline V3<double> plainList(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// The surface that has K and C at the place and no more, as a graph over its tangent plane:
///   X(x, y) = x t1 + y t2 + h n,   h = -K(x, x) / 2 - C(x, x, x) / 6.
/// With its slope 0 there, K = -h_ij and C = -h_ijk.
class CubicGraph : public Chart {
 public:
  CubicGraph(const SurfacePlace& place, bool turning)
      : place_(place), turning_(turning && place.distance.has_value()) {
    frame_ = {plainList(place.point.frame.col(0)), plainList(place.point.frame.col(1)),
              plainList(place.point.n), plainList(place.w)};
    const double bend = place.point.K.cwiseAbs().maxCoeff();
    double change = 0.0;
    for (const double c : place.point.C.coefficients) change = std::max(change, std::abs(c));
    const double largest = std::max(bend, std::sqrt(change));
    reach_ = largest > 0.0 ? kReach / largest : kReach;
  }

  const PlaceFrame& frame() const { return frame_; }
  /// How far a difference quotient may reach: to where the graph is a different surface.
  double reach() const { return reach_; }
  std::optional<double> distance() const {
    return turning_ ? place_.distance : std::optional<double>();
  }

  ChartPoint<Series> along(double r1, double r2) const override {
    return pointAt(Series(Sized(0.0), Sized(r1), Sized(0.0)),
                   Series(Sized(0.0), Sized(r2), Sized(0.0)));
  }
  ChartPoint<double> at(double r1, double r2, double way) const override {
    return pointAt(r1 * way, r2 * way);
  }
  Room room(double, double) const override {
    constexpr double kNever = 1e300;
    return {-kNever, kNever};
  }

 private:
  static constexpr double kReach = 0.1;  ///< of the radius of the strongest curvature

  template <class S>
  ChartPoint<S> pointAt(const S& x, const S& y) const {
    const auto [c111, c112, c122, c222] = place_.point.C.coefficients;
    const S k1(place_.point.K(0, 0)), k2(place_.point.K(1, 1)), half(0.5);
    // C contracted with (x, y) once and twice.
    const S xx = S(c111) * x + S(c112) * y, xy = S(c112) * x + S(c122) * y,
            yy = S(c122) * x + S(c222) * y;
    const S cx = xx * x + xy * y, cy = xy * x + yy * y;
    const S hx = -(k1 * x) - half * cx, hy = -(k2 * y) - half * cy;
    const V3<S> t1 = lifted<S>(frame_.t1), t2 = lifted<S>(frame_.t2), n = lifted<S>(frame_.n);
    ChartPoint<S> point{t1 + hx * n,
                        t2 + hy * n,
                        (-k1 - xx) * n,
                        (-xy) * n,
                        (-k2 - yy) * n,
                        lifted<S>(plainList(place_.ux)),
                        lifted<S>(plainList(place_.uy))};
    if (turning_) {
      const S h = -(half * (k1 * x * x + k2 * y * y)) - S(1.0 / 6.0) * (cx * x + cy * y);
      turnScreen(x * t1 + y * t2 + h * n, point);
    }
    return point;
  }

  /// The screen across the line of sight through a point, which is given from the place.
  template <class S>
  void turnScreen(const V3<S>& offset, ChartPoint<S>& point) const {
    using std::sqrt;
    const auto unit = [](const V3<S>& v) {
      const S length = sqrt(dotOf(v, v));
      return (S(1.0) / length) * v;
    };
    const V3<S> w = unit(S(*place_.distance) * lifted<S>(frame_.w) + (-offset));
    point.ux = unit(point.ux + (-dotOf(point.ux, w)) * w);
    point.uy = crossed(w, point.ux);
  }

  const SurfacePlace& place_;
  bool turning_;
  PlaceFrame frame_;
  double reach_;
};

}  // namespace flatland::derivation
