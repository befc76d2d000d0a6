// SPDX-License-Identifier: MIT
#include "flatland/curve/arc_length.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace flatland {

namespace {

// Gauss-Kronrod 7-15 (QUADPACK, Piessens et al. 1983): nodes on [0, 1) of [-1, 1], the centre last.
constexpr std::array<double, 8> kNodes = {
    0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
    0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
    0.586087235467691130294144691693459, 0.405845151377397166906606412076961,
    0.207784955007898467600689403773245, 0.0};
constexpr std::array<double, 8> kKronrod = {
    0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
    0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
    0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
    0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
// Gauss weights for the odd entries of kNodes and the centre.
constexpr std::array<double, 4> kGauss = {
    0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
    0.381830050505118944950369775488975, 0.417959183673469387755102040816327};

struct Panel {
  double value, error;
};

Panel integrate(const Bezier& hodograph, double t0, double t1) {
  const double centre = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
  const auto speed = [&](double t) { return pointAt(hodograph, t).norm(); };
  const double middle = speed(centre);
  double kronrod = kKronrod[7] * middle, gauss = kGauss[3] * middle;
  for (std::size_t i = 0; i < 7; ++i) {
    const double pair = speed(centre - half * kNodes[i]) + speed(centre + half * kNodes[i]);
    kronrod += kKronrod[i] * pair;
    if (i % 2 == 1) gauss += kGauss[i / 2] * pair;
  }
  return {kronrod * half, std::abs(kronrod - gauss) * half};
}

// Halves until Gauss and Kronrod agree, and also the whole with its halves, to a quarter of
// `accuracy`: either difference alone can be small by chance where the speed has a narrow dip, as
// it has near a cusp. 50 halvings reach the last bits of t.
constexpr int kMaxDepth = 50;
constexpr double kSafety = 4.0;

// Below this part of (largest speed times panel width) the difference of the two sums is rounding:
// the speed itself is rounded relative to its largest value, also near a cusp. Halving would not
// help, and halving everywhere would never end.
constexpr double kRoundOff = 0x1p-46;

struct Quadrature {
  const Bezier& hodograph;
  double largestSpeed;

  // `whole` is the panel [t0, t1].
  ArcLength operator()(double t0, double t1, const Panel& whole, double accuracy, int depth) const {
    const double mid = 0.5 * (t0 + t1);
    const Panel low = integrate(hodograph, t0, mid), high = integrate(hodograph, mid, t1);
    const double value = low.value + high.value;
    const double error = std::max(low.error + high.error, std::abs(whole.value - value));
    const double roundOff = kRoundOff * largestSpeed * (t1 - t0);
    if (kSafety * error <= std::max(accuracy, roundOff) || depth == kMaxDepth) {
      return {value, std::max(error, roundOff), true};
    }
    const ArcLength a = (*this)(t0, mid, low, 0.5 * accuracy, depth + 1);
    const ArcLength b = (*this)(mid, t1, high, 0.5 * accuracy, depth + 1);
    return {a.value + b.value, a.errorEstimate + b.errorEstimate, true};
  }
};

}  // namespace

ArcLength arcLength(const Bezier& curve, double t0, double t1, double accuracy) {
  assert(accuracy > 0.0);
  if (t1 < t0) {
    ArcLength forward = arcLength(curve, t1, t0, accuracy);
    forward.value = -forward.value;
    return forward;
  }
  if (t0 == t1 || curve.degree() < 1) return {0.0, 0.0, true};
  Bezier hodograph;
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
    hodograph.points.push_back(curve.degree() * (curve.points[i + 1] - curve.points[i]));
  }
  double largestSpeed = 0.0;
  for (const Vec2& v : hodograph.points) largestSpeed = std::max(largestSpeed, v.norm());
  ArcLength length =
      Quadrature{hodograph, largestSpeed}(t0, t1, integrate(hodograph, t0, t1), accuracy, 0);
  length.converged = length.errorEstimate <= accuracy;
  return length;
}

ArcLength arcLength(const BezierChain& chain, double t0, double t1, double accuracy) {
  if (t1 < t0) {
    ArcLength forward = arcLength(chain, t1, t0, accuracy);
    forward.value = -forward.value;
    return forward;
  }
  const ChainParameter from = chain.locate(t0), to = chain.locate(t1);
  const double share = accuracy / (to.piece - from.piece + 1);
  ArcLength total{0.0, 0.0, true};
  for (int m = from.piece; m <= to.piece; ++m) {
    const ArcLength part = arcLength(chain.piece(m), m == from.piece ? from.t : 0.0,
                                     m == to.piece ? to.t : 1.0, share);
    total.value += part.value;
    total.errorEstimate += part.errorEstimate;
  }
  total.converged = total.errorEstimate <= accuracy;
  return total;
}

}  // namespace flatland
