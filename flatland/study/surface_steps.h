// SPDX-License-Identifier: MIT
#pragma once

#include "flatland/study/derivation_parts.h"
#include "flatland/view/apparent_curvature.h"

// The steps of chapter 4 at a place of a surface, whatever describes it: a sheet through a curve
// (derivation_sheet.cpp), or the numbers of a vertex (core3d/study/surface_derivation.h). Left
// sides are differentiated along the surface from their definitions, right sides know only K, C and
// the view of the place. Not for others.

namespace flatland::derivation {

template <class S>
using V3 = VectorOf<S, 3>;
template <class S>
using V2 = VectorOf<S, 2>;
/// 2 x 2, row by row.
template <class S>
using M2 = VectorOf<S, 4>;

template <class S>
V3<S> crossed(const V3<S>& a, const V3<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class S>
M2<S> times(const M2<S>& a, const M2<S>& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
          a[2] * b[1] + a[3] * b[3]};
}
template <class S>
V2<S> times(const M2<S>& a, const V2<S>& v) {
  return {a[0] * v[0] + a[1] * v[1], a[2] * v[0] + a[3] * v[1]};
}
template <class S>
M2<S> transposed(const M2<S>& a) {
  return {a[0], a[2], a[1], a[3]};
}
template <class S>
M2<S> inverseOf(const M2<S>& a) {
  const S det = a[0] * a[3] - a[1] * a[2];
  return {a[3] / det, -a[1] / det, -a[2] / det, a[0] / det};
}
template <class S>
V3<S> lifted(const V3<double>& v) {
  return {S(v[0]), S(v[1]), S(v[2])};
}
/// The coefficients of one power.
template <std::size_t N>
VectorOf<Sized, N> coefficient(const VectorOf<Series, N>& v, std::size_t which) {
  VectorOf<Sized, N> c;
  for (std::size_t m = 0; m < N; ++m) c[m] = v[m].c[which];
  return c;
}
inline std::vector<Sized> listed(const M2<Sized>& m) { return {m[0], m[1], m[2], m[3]}; }

/// The place: its orthonormal frame with t1 x t2 = n, the unit vector w towards the viewer.
struct PlaceFrame {
  V3<double> t1, t2, n, w;
};

/// A point of the surface near the place: derivatives by two parameters, and the basis of the
/// screen there, orthonormal and across the line of sight.
template <class S>
struct ChartPoint {
  V3<S> a, b, aa, ab, bb;
  V3<S> ux, uy;
};

/// The surface round the place, walked along a straight line in the parameters that begins in the
/// direction r1 t1 + r2 t2 with the same speed.
class Chart {
 public:
  virtual ~Chart() = default;
  /// As series by the way, in which everything is known to the first order.
  virtual ChartPoint<Series> along(double r1, double r2) const = 0;
  virtual ChartPoint<double> at(double r1, double r2, double way) const = 0;
  /// How far that may go, in speeds: [low, high] around 0.
  struct Room {
    double low, high;
  };
  virtual Room room(double r1, double r2) const = 0;
};

/// A point of the surface in a frame that is carried along without turning in its own plane (the
/// smallest rotation that takes the normal at the place to the normal here).
template <class S>
struct CarriedPoint {
  V3<S> n;
  M2<S> K, P, inverseP;
  S lambda;
};

template <class S>
S largestEigenvalue(const M2<S>& m) {
  using std::sqrt;
  const S half = S(0.5) * (m[0] - m[3]);
  return S(0.5) * (m[0] + m[3]) + sqrt(half * half + m[1] * m[1]);
}

template <class S>
CarriedPoint<S> carriedPoint(const PlaceFrame& place, const ChartPoint<S>& at) {
  using std::sqrt;
  const V3<S> n0 = lifted<S>(place.n);
  CarriedPoint<S> point;
  const V3<S> normal = crossed(at.a, at.b);
  const S length = sqrt(dotOf(normal, normal));
  const S sign(valueOf(dotOf(normal, n0)) < 0.0 ? -1.0 : 1.0);
  point.n = (sign / length) * normal;
  const V3<S>& n = point.n;
  const auto carried = [&](const V3<S>& a) {
    return a + (-(dotOf(a, n) / (S(1.0) + dotOf(n0, n)))) * (n0 + n);
  };
  const V3<S> t1 = carried(lifted<S>(place.t1)), t2 = carried(lifted<S>(place.t2));
  // dn = K: n.X_uv = -(K X_u).X_v. J takes (da, db) to the frame.
  const M2<S> h{-dotOf(n, at.aa), -dotOf(n, at.ab), -dotOf(n, at.ab), -dotOf(n, at.bb)};
  const M2<S> j{dotOf(t1, at.a), dotOf(t1, at.b), dotOf(t2, at.a), dotOf(t2, at.b)};
  const M2<S> back = inverseOf(j);
  point.K = times(transposed(back), times(h, back));
  point.P = {dotOf(at.ux, t1), dotOf(at.ux, t2), dotOf(at.uy, t1), dotOf(at.uy, t2)};
  point.inverseP = inverseOf(point.P);
  const M2<S> q = times(point.K, point.inverseP);
  point.lambda = largestEigenvalue(times(q, transposed(q)));
  return point;
}

/// Everything known at the place.
struct SurfaceAt {
  CarriedPoint<Series> series;  ///< along r
  M2<Sized> K, P, inverseP;
  std::array<Sized, 4> C;                ///< C111, C112, C122, C222
  VectorOf<Sized, 2> r, wT, tA, kr, un;  ///< tA = P r, kr = K r, un = U^T n
  Sized nw;
  ApparentCurvature<2> seen;
  bool first;  ///< which formula for the principal frame is the better one
};

/// K and C of the place, if they are known: else they are differentiated from the chart.
struct KnownCurvature {
  M2<Sized> K;
  std::array<Sized, 4> C;
};

/// Empty where the view grazes the surface: n.w = 0 to rounding. `distance` of the viewer only if
/// the chart's screen turns with the place.
std::optional<SurfaceAt> surfaceAt(const PlaceFrame& place, const Chart& chart,
                                   const std::optional<KnownCurvature>& known = {},
                                   std::optional<double> distance = {});

/// D_r K: C contracted with r once.
M2<Sized> contracted(const std::array<Sized, 4>& c, const V2<Sized>& r);

/// Square or column; every entry of both sides.
SizedSides sidesOf(int rows, int columns, std::vector<Sized> left, std::vector<Sized> right);

/// A step that differentiates along r: its sides, and what is differentiated, for difference
/// quotients of it.
struct SlopeStep {
  Evaluation (*sides)(const SurfaceAt& at);
  Quotient (*before)(const CarriedPoint<double>& point, bool first);
};

// Of the thesis. As printed 4.7 and 4.8 need principal directions and two different view-dependent
// curvatures; where these are equal there is no printed side.
extern const SlopeStep kInverseStep;     ///< footnote: D(P^-1)
extern const SlopeStep kProjectionStep;  ///< (4.7): D P
extern const SlopeStep kLambdaStep;      ///< (4.8): D lambda
extern const SlopeStep kSumStep;         ///< 1/2 D lambda = feature + offset (+ perspective)

/// Difference quotients of a step, see stepSizeSweep(). `reach`: the longest way, a length.
std::vector<StepDifference> sweepSurface(const PlaceFrame& place, const Chart& chart,
                                         const SurfaceAt& at, const SlopeStep& step, double reach);

}  // namespace flatland::derivation
