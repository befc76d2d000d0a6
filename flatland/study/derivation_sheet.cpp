// SPDX-License-Identifier: MIT
// The derivation on a surface: the footnote of chapter 4, (4.7), (4.8) and the form without
// dimension, on a sheet through the curve.
#include <algorithm>

#include "flatland/study/surface_steps.h"

namespace flatland::derivation {

namespace {

constexpr double kP = 0.8, kQ = 0.5, kA = 0.7, kB = -0.9, kC = 1.1;
constexpr double kRaisedSine = 0.34202014332566873, kRaisedCosine = 0.93969262078590838;  // 20 deg

double sizeOf(const Curve& curve) {
  constexpr int kSamples = 64;
  Vec2 low = pointAt(curve, 0.0), high = low;
  const double end = pieceCount(curve);
  for (int i = 1; i <= kSamples; ++i) {
    const Vec2 p = pointAt(curve, end * i / kSamples);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// The curve's point and derivatives, lifted into space, with the second coordinate s.
template <class S>
struct CurvePoint {
  V3<S> p, d1, d2;
  S s;
};

/// The sheet: the curve carried along b, which stands up from its plane, and bent so that none of
/// the quantities of chapter 4 is zero by accident:
///   X(t, s) = alpha(t) + s b + f(x, s) n0,   x = (alpha(t) - alpha(t0)).t0,
///   f = (p s^2 / 2 + q s x) / L + (a s^3 / 6 + b s^2 x / 2 + c s x^2 / 2) / L^2.
/// It holds the curve (s = 0), and at the place the curve's normal, tangent and curvature. L is the
/// size of the curve. It is seen from w, the line of sight raised out of the plane.
class Sheet : public Chart {
 public:
  Sheet(const DerivationPlace& place, const Jet& jet)
      : place_(place),
        jet_(jet),
        local_(localPlace(place)),
        walk_(-place.side),
        length_(sizeOf(place.curve)) {
    const Vec2 t = walk_ * jet.d1.normalized(), n = -rotateCcw(t);
    const ViewFrame ij = frozenView(place, jet.p);
    const Vec2 &i = ij.axis, &j = ij.towards;
    frame_ = {{t.x(), t.y(), 0.0},
              {0.0, 0.0, 1.0},
              {n.x(), n.y(), 0.0},
              {kRaisedCosine * j.x(), kRaisedCosine * j.y(), kRaisedSine}};
    ux_ = {i.x(), i.y(), 0.0};
    uy_ = {-kRaisedSine * j.x(), -kRaisedSine * j.y(), kRaisedCosine};
  }

  const PlaceFrame& frame() const { return frame_; }
  double length() const { return length_; }

  ChartPoint<Series> along(double r1, double r2) const override {
    CurvePoint<Series> at;
    const double a = rateOf(r1);
    for (int c = 0; c < 2; ++c) {
      const auto m = static_cast<std::size_t>(c);
      at.p[m] = {jet_.p(c), a * jet_.d1(c), 0.5 * a * a * jet_.d2(c)};
      at.d1[m] = {jet_.d1(c), a * jet_.d2(c), 0.5 * a * a * jet_.d3(c)};
      at.d2[m] = {jet_.d2(c), a * jet_.d3(c), 0.0};
    }
    at.s = {Sized(0.0), Sized(r2), Sized(0.0)};
    return pointOf(at);
  }

  ChartPoint<double> at(double r1, double r2, double way) const override {
    const Jet jet = jetAt(place_.curve, local_.piece, local_.t + rateOf(r1) * way);
    const auto plain = [](const Vec2& v) { return V3<double>{v.x(), v.y(), 0.0}; };
    return pointOf<double>({plain(jet.p), plain(jet.d1), plain(jet.d2), r2 * way});
  }

  /// Within the piece of the curve.
  Room room(double r1, double) const override {
    constexpr double kNever = 1e300;
    const double a = rateOf(r1), t = local_.t;
    return {a > 0.0   ? -t / a
            : a < 0.0 ? (1.0 - t) / a
                      : -kNever,
            a > 0.0   ? (1.0 - t) / a
            : a < 0.0 ? -t / a
                      : kNever};
  }

 private:
  /// dt for a step in the direction r1 t1 + r2 t2; ds is r2.
  double rateOf(double r1) const { return walk_ * r1 / jet_.d1.norm(); }

  template <class S>
  ChartPoint<S> pointOf(const CurvePoint<S>& at) const {
    const V3<S> t0 = lifted<S>(frame_.t1), n0 = lifted<S>(frame_.n), b = lifted<S>(frame_.t2);
    const S x = dotOf(at.p, t0) - S(jet_.p.x() * frame_.t1[0] + jet_.p.y() * frame_.t1[1]);
    const S x1 = dotOf(at.d1, t0), x2 = dotOf(at.d2, t0), s = at.s;
    const double l = length_, ll = l * l;
    // Derivatives of f by x and s.
    const S fx = S(kQ / l) * s + S(kB / (2.0 * ll)) * s * s + S(kC / ll) * s * x;
    const S fs = S(kP / l) * s + S(kQ / l) * x + S(kA / (2.0 * ll)) * s * s + S(kB / ll) * s * x +
                 S(kC / (2.0 * ll)) * x * x;
    const S fxx = S(kC / ll) * s;
    const S fxs = S(kQ / l) + S(kB / ll) * s + S(kC / ll) * x;
    const S fss = S(kP / l) + S(kA / ll) * s + S(kB / ll) * x;
    return {at.d1 + (fx * x1) * n0, b + fs * n0, at.d2 + (fxx * x1 * x1 + fx * x2) * n0,
            (fxs * x1) * n0,        fss * n0,    lifted<S>(ux_),
            lifted<S>(uy_)};
  }

  const DerivationPlace& place_;
  Jet jet_;
  LocalPlace local_;
  double walk_, length_;
  PlaceFrame frame_;
  V3<double> ux_, uy_;
};

const SlopeStep& slopeStepOf(DerivationStep step) {
  switch (step) {
    case DerivationStep::Footnote:
      return kInverseStep;
    case DerivationStep::Eq4_7:
      return kProjectionStep;
    case DerivationStep::Eq4_8:
      return kLambdaStep;
    default:
      return kSumStep;
  }
}

/// The sheet and what is known at the place, or why nothing is.
struct Known {
  StepAnswer answer = StepAnswer::NoTangent;
  std::optional<Sheet> sheet;
  std::optional<SurfaceAt> at;
};

Known knownAt(const DerivationPlace& place) {
  Known known;
  const LocalPlace local = localPlace(place);
  const Jet jet = jetAt(place.curve, local.piece, local.t);
  if (!(jet.d1.squaredNorm() > 0.0)) return known;
  known.answer = StepAnswer::Silhouette;
  if (towardsViewer(place.view, jet.p).isZero()) return known;
  known.sheet.emplace(place, jet);
  known.at = surfaceAt(known.sheet->frame(), *known.sheet);
  if (known.at) known.answer = StepAnswer::Evaluated;
  return known;
}

}  // namespace

Evaluation evaluateSheet(DerivationStep step, const DerivationPlace& place) {
  const Known known = knownAt(place);
  if (!known.at) return {known.answer, std::nullopt, std::nullopt};
  return slopeStepOf(step).sides(*known.at);
}

std::vector<StepDifference> sweepSheet(DerivationStep step, const DerivationPlace& place) {
  constexpr double kReach = 0.1;  // of the sheet's size
  const Known known = knownAt(place);
  if (!known.at) return {};
  return sweepSurface(known.sheet->frame(), *known.sheet, *known.at, slopeStepOf(step),
                      kReach * known.sheet->length());
}

}  // namespace flatland::derivation
