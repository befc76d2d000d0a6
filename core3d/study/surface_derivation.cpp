// SPDX-License-Identifier: MIT
#include "core3d/study/surface_derivation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core3d/study/cubic_graph.h"

namespace flatland {

namespace {

using derivation::CubicGraph;
using derivation::Evaluation;
using derivation::M2;
using derivation::PlaceFrame;
using derivation::Quotient;
using derivation::SlopeStep;
using derivation::SurfaceAt;
using derivation::times;
using derivation::V2;
using derivation::V3;

constexpr std::string_view kOnScreen = "step on the screen";

// In the order of SurfaceStep; what the steps of flatland say too is taken from there.
const std::array<DerivationStepText, kSurfaceStepCount>& texts() {
  static const std::array<DerivationStepText, kSurfaceStepCount> kTexts{{
      {"view", "The line of sight, in the frame of the place", "w", "T w_T + (n·w) n", "", "", ""},
      {"4.1", "Curvature", "t_a·D_b n", "K", "", "", ""},
      {"4.2", "The derivative of curvature", "D_c K_ab", "C", "", "", ""},
      {"foreshortening", "Foreshortening", "det P", "n·w", "", "", ""},
      {"projection", "The projection", "PᵀP", "1 − w_T w_Tᵀ", "", "", ""},
      {"inverse", "Back from the screen", "P⁻¹P", "1", "", "", ""},
      {"metric", "Lengths on the screen, back on the surface", "(PᵀP)⁻¹", "1 + w_T w_Tᵀ/(n·w)²", "",
       "", ""},
      {"4.3", "View-dependent curvature", "D_s n", "Q = K P⁻¹", "", "", ""},
      {"lambda", "Where the normal turns most", "max |Q s|²", "λ", "", "", ""},
      {"direction", "The direction of it", "QᵀQ t_A", "λ t_A", "", "", ""},
      {"unit", "A direction on the screen", "t_A·t_A", "1", "", "", ""},
      {"turn", "How the normal turns along it", "D n", "K r = √λ v", "", "", ""},
      {"4.4", "What a unit vector cannot change", "(D t_A)·QᵀQ t_A", "0", "", "", ""},
      {"4.5", "What is left", "D λ", "2 t_A·Qᵀ (D Q) t_A", "", "", kOnScreen},
      {"4.6", "The derivative of K", "D K", "C r", "", "", kOnScreen},
      textOf(DerivationStep::Footnote),
      textOf(DerivationStep::Eq4_7),
      textOf(DerivationStep::Eq4_8),
      {"terms", "Feature plus offset", "½ D λ", "C(r,r,Kr) − K(r,r) K(Kr,w)/(n·w)", "", "",
       kOnScreen},
      {"perspective", "Seen from nearby", "½ D λ, w turning", "feature + offset − (w·r) λ/d", "",
       "", kOnScreen},
  }};
  return kTexts;
}

derivation::KnownCurvature knownOf(const SurfacePlace& place) {
  const Eigen::Matrix2d& K = place.point.K;
  const auto& c = place.point.C.coefficients;
  return {{Sized(K(0, 0)), Sized(K(0, 1)), Sized(K(1, 0)), Sized(K(1, 1))},
          {Sized(c[0]), Sized(c[1]), Sized(c[2]), Sized(c[3])}};
}

/// What steps look at. `at` only where something is seen and not grazed.
struct Known {
  const CubicGraph& chart;
  derivation::KnownCurvature curvature;
  V2<Sized> wT;
  Sized nw;
  M2<Sized> P;
  std::optional<SurfaceAt> at;
};

Known knownAt(const CubicGraph& chart, const SurfacePlace& place) {
  using derivation::lifted;
  const PlaceFrame& f = chart.frame();
  const V3<Sized> w = lifted<Sized>(f.w), t1 = lifted<Sized>(f.t1), t2 = lifted<Sized>(f.t2);
  const V3<Sized> ux = lifted<Sized>(derivation::plainList(place.ux)),
                  uy = lifted<Sized>(derivation::plainList(place.uy));
  const derivation::KnownCurvature curvature = knownOf(place);
  return {chart,
          curvature,
          {dotOf(t1, w), dotOf(t2, w)},
          dotOf(lifted<Sized>(f.n), w),
          {dotOf(ux, t1), dotOf(ux, t2), dotOf(uy, t1), dotOf(uy, t2)},
          derivation::surfaceAt(f, chart, curvature, chart.distance())};
}

Evaluation evaluated(int rows, int columns, std::vector<Sized> left, std::vector<Sized> right) {
  return {StepAnswer::Evaluated,
          derivation::sidesOf(rows, columns, std::move(left), std::move(right)), std::nullopt};
}
std::vector<Sized> listed(const V2<Sized>& v) { return {v[0], v[1]}; }
std::vector<Sized> listed(const V3<Sized>& v) { return {v[0], v[1], v[2]}; }
using derivation::listed;

// --- The steps ----------------------------------------------------------------------------------

Evaluation viewSides(const Known& known) {
  const PlaceFrame& f = known.chart.frame();
  using derivation::lifted;
  return evaluated(3, 1, listed(lifted<Sized>(f.w)),
                   listed(known.wT[0] * lifted<Sized>(f.t1) + known.wT[1] * lifted<Sized>(f.t2) +
                          known.nw * lifted<Sized>(f.n)));
}

/// How n turns for a step in the direction r, in (t1, t2).
V2<Sized> turnAlong(const Known& known, double r1, double r2) {
  const PlaceFrame& f = known.chart.frame();
  const auto point = derivation::carriedPoint(f, known.chart.along(r1, r2));
  const V3<Sized> dn = derivation::coefficient(point.n, 1);
  return {dotOf(derivation::lifted<Sized>(f.t1), dn), dotOf(derivation::lifted<Sized>(f.t2), dn)};
}

Evaluation curvatureSides(const Known& known) {
  const V2<Sized> first = turnAlong(known, 1.0, 0.0), second = turnAlong(known, 0.0, 1.0);
  return evaluated(2, 2, {first[0], second[0], first[1], second[1]}, listed(known.curvature.K));
}

Evaluation derivativeSides(const Known& known) {
  const PlaceFrame& f = known.chart.frame();
  const auto first = derivation::carriedPoint(f, known.chart.along(1.0, 0.0));
  const auto second = derivation::carriedPoint(f, known.chart.along(0.0, 1.0));
  // P' = D_1 k1, Q' = D_2 k1, S' = D_1 k2, T' = D_2 k2.
  const auto& c = known.curvature.C;
  return evaluated(4, 1, {first.K[0].c[1], second.K[0].c[1], first.K[3].c[1], second.K[3].c[1]},
                   {c[0], c[1], c[2], c[3]});
}

Evaluation foreshorteningSides(const Known& known) {
  const M2<Sized>& p = known.P;
  return evaluated(1, 1, {p[0] * p[3] - p[1] * p[2]}, {known.nw});
}

/// 1 + factor w_T w_T^T
std::vector<Sized> onePlus(const Known& known, const Sized& factor) {
  const V2<Sized>& w = known.wT;
  return {Sized(1.0) + factor * (w[0] * w[0]), factor * (w[0] * w[1]), factor * (w[1] * w[0]),
          Sized(1.0) + factor * (w[1] * w[1])};
}

Evaluation projectionSides(const Known& known) {
  const M2<Sized>& p = known.P;
  return evaluated(2, 2, listed(times(derivation::transposed(p), p)), onePlus(known, Sized(-1.0)));
}

Evaluation inverseSides(const Known& known) {
  return evaluated(2, 2, listed(times(known.at->inverseP, known.P)),
                   {Sized(1.0), Sized(0.0), Sized(0.0), Sized(1.0)});
}

Evaluation metricSides(const Known& known) {
  const M2<Sized>& back = known.at->inverseP;
  const Sized one(1.0), &nw = known.nw;
  return evaluated(2, 2, listed(times(back, derivation::transposed(back))),
                   onePlus(known, one / (nw * nw)));
}

M2<Sized> viewDependent(const SurfaceAt& at) { return times(at.K, at.inverseP); }

Evaluation viewDependentSides(const Known& known) {
  const M2<Sized>& back = known.at->inverseP;
  // One step on the screen to the right and one upward, taken on the surface.
  const V2<Sized> right = turnAlong(known, back[0].value, back[2].value);
  const V2<Sized> up = turnAlong(known, back[1].value, back[3].value);
  return evaluated(2, 2, {right[0], up[0], right[1], up[1]}, listed(viewDependent(*known.at)));
}

/// The largest |Q s|^2 over unit vectors s, by looking: a coarse scan and a golden section.
Sized largestTurn(const M2<Sized>& q) {
  const auto turnAt = [&q](double angle) {
    const V2<Sized> s{Sized(std::cos(angle)), Sized(std::sin(angle))};
    const V2<Sized> turn = times(q, s);
    return dotOf(turn, turn);
  };
  constexpr int kScan = 64, kHalvings = 60;
  constexpr double kStep = std::numbers::pi / kScan;
  double best = 0.0;
  for (int i = 1; i < kScan; ++i) {
    if (turnAt(i * kStep).value > turnAt(best).value) best = i * kStep;
  }
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double low = best - kStep, high = best + kStep;
  for (int i = 0; i < kHalvings; ++i) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (turnAt(a).value > turnAt(b).value ? high : low) = turnAt(a).value > turnAt(b).value ? b : a;
  }
  return turnAt(0.5 * (low + high));
}

Evaluation lambdaSides(const Known& known) {
  return evaluated(1, 1, {largestTurn(viewDependent(*known.at))}, {Sized(known.at->seen.lambda)});
}

Evaluation directionSides(const Known& known) {
  const M2<Sized> q = viewDependent(*known.at);
  const V2<Sized>& tA = known.at->tA;
  return evaluated(2, 1, listed(times(derivation::transposed(q), times(q, tA))),
                   listed(Sized(known.at->seen.lambda) * tA));
}

Evaluation unitSides(const Known& known) {
  return evaluated(1, 1, {dotOf(known.at->tA, known.at->tA)}, {Sized(1.0)});
}

Evaluation turnSides(const Known& known) {
  const SurfaceAt& at = *known.at;
  const Sized root(std::sqrt(at.seen.lambda));
  return evaluated(2, 1, listed(turnAlong(known, at.seen.r(0), at.seen.r(1))),
                   {root * Sized(at.seen.v(0)), root * Sized(at.seen.v(1))});
}

// --- Steps that differentiate along r -----------------------------------------------------------

template <class S>
M2<S> viewDependent(const derivation::CarriedPoint<S>& point) {
  return times(point.K, point.inverseP);
}

/// The unit eigenvector of Q^T Q, by the formula that is the better one for the direction at the
/// place, so that it does not change underway.
template <class S>
V2<S> screenDirection(const derivation::CarriedPoint<S>& point, const V2<Sized>& atPlace) {
  using std::sqrt;
  const M2<S> q = viewDependent(point), m = times(derivation::transposed(q), q);
  const S half = S(0.5) * (m[0] - m[3]);
  const S radius = sqrt(half * half + m[1] * m[1]);
  V2<S> v = valueOf(half) >= 0.0 ? V2<S>{radius + half, m[1]} : V2<S>{m[1], radius - half};
  const S length = sqrt(dotOf(v, v));
  const double along = valueOf(v[0]) * atPlace[0].value + valueOf(v[1]) * atPlace[1].value;
  return (S(along < 0.0 ? -1.0 : 1.0) / length) * v;
}

Evaluation vanishingSides(const SurfaceAt& at) {
  const V2<Sized> turning = derivation::coefficient(screenDirection(at.series, at.tA), 1);
  const M2<Sized> q = viewDependent(at);
  const V2<Sized> bend = times(derivation::transposed(q), times(q, at.tA));
  return evaluated(1, 1, {dotOf(turning, bend)}, {Sized(0.0)});
}

Evaluation productSides(const SurfaceAt& at) {
  const M2<Sized> q = viewDependent(at);
  const M2<Sized> dq = derivation::coefficient(viewDependent(at.series), 1);
  return evaluated(1, 1, {at.series.lambda.c[1]},
                   {Sized(2.0) * dotOf(times(q, at.tA), times(dq, at.tA))});
}
Quotient lambdaBefore(const derivation::CarriedPoint<double>& point, bool) {
  return {{point.lambda}, {point.lambda}};
}

Evaluation tensorSides(const SurfaceAt& at) {
  return evaluated(2, 2, listed(derivation::coefficient(at.series.K, 1)),
                   listed(derivation::contracted(at.C, at.r)));
}
Quotient curvatureBefore(const derivation::CarriedPoint<double>& point, bool) {
  const std::vector<double> k(point.K.begin(), point.K.end());
  return {k, k};
}

const SlopeStep kProductStep{productSides, lambdaBefore};
const SlopeStep kTensorStep{tensorSides, curvatureBefore};

/// nullptr for steps that differentiate nothing along r, or whose left side is no derivative of one
/// quantity.
const SlopeStep* slopeStepOf(SurfaceStep step) {
  switch (step) {
    case SurfaceStep::Eq4_5:
      return &kProductStep;
    case SurfaceStep::Eq4_6:
      return &kTensorStep;
    case SurfaceStep::Footnote:
      return &derivation::kInverseStep;
    case SurfaceStep::Eq4_7:
      return &derivation::kProjectionStep;
    case SurfaceStep::Eq4_8:
      return &derivation::kLambdaStep;
    case SurfaceStep::Terms:
    case SurfaceStep::Perspective:
      return &derivation::kSumStep;
    default:
      return nullptr;
  }
}

Evaluation evaluate(SurfaceStep step, const Known& known) {
  if (const SlopeStep* slope = slopeStepOf(step)) return slope->sides(*known.at);
  switch (step) {
    case SurfaceStep::View:
      return viewSides(known);
    case SurfaceStep::Eq4_1:
      return curvatureSides(known);
    case SurfaceStep::Eq4_2:
      return derivativeSides(known);
    case SurfaceStep::Foreshortening:
      return foreshorteningSides(known);
    case SurfaceStep::Projection:
      return projectionSides(known);
    case SurfaceStep::Inverse:
      return inverseSides(known);
    case SurfaceStep::Metric:
      return metricSides(known);
    case SurfaceStep::Eq4_3:
      return viewDependentSides(known);
    case SurfaceStep::Lambda:
      return lambdaSides(known);
    case SurfaceStep::Direction:
      return directionSides(known);
    case SurfaceStep::UnitDirection:
      return unitSides(known);
    case SurfaceStep::Turn:
      return turnSides(known);
    default:
      return vanishingSides(*known.at);
  }
}

/// True for what divides by n.w.
bool needsSight(SurfaceStep step) { return step >= SurfaceStep::Inverse; }
/// True for what needs t_A to exist; lambda itself is as it is.
bool needsDirection(SurfaceStep step) { return step > SurfaceStep::Lambda; }

/// Two eigenvalues so near each other that which direction is which is rounding.
bool hasDirection(const ApparentCurvature<2>& seen) {
  constexpr double kLeastGap = 1e-9;
  return seen.lambda > 0.0 && seen.relativeGap > kLeastGap;
}

}  // namespace

const DerivationStepText& textOf(SurfaceStep step) {
  return texts()[static_cast<std::size_t>(step)];
}

std::optional<SurfaceStep> surfaceStepNamed(std::string_view id) {
  for (std::size_t i = 0; i < texts().size(); ++i) {
    if (texts()[i].id == id) return static_cast<SurfaceStep>(i);
  }
  return std::nullopt;
}

std::optional<SurfacePlace> surfacePlaceAt(const TriangleMesh& mesh, const SurfaceFields& fields,
                                           const SurfaceView& view, const Eigen::Vector3d& right,
                                           std::uint32_t vertex) {
  SurfacePoint point = fields.at(mesh, vertex);
  if (point.n.isZero()) return std::nullopt;
  const Eigen::Vector3d w = view.towardsViewer(point.p);
  if (w.isZero()) return std::nullopt;
  // The fields are rounded to float; the identities of the steps ask for more.
  point.n.normalize();
  const Eigen::Vector3d e1 = point.frame.col(0);
  point.frame.col(0) = (e1 - e1.dot(point.n) * point.n).normalized();
  point.frame.col(1) = point.n.cross(Eigen::Vector3d(point.frame.col(0)));
  point.K *= fields.size;
  for (double& c : point.C.coefficients) c *= fields.size * fields.size;
  SurfacePlace place{point, w.normalized(), {}, {}, std::nullopt};
  const Eigen::Vector3d across = right - right.dot(place.w) * place.w;
  constexpr double kAlongSight = 1e-12;
  place.ux = across.squaredNorm() > kAlongSight * right.squaredNorm()
                 ? Eigen::Vector3d(across.normalized())
                 : place.w.unitOrthogonal();
  place.uy = place.w.cross(place.ux);
  if (const auto distance = view.distanceTo(point.p)) place.distance = *distance / fields.size;
  return place;
}

SurfaceMatrices surfaceMatrices(const SurfacePlace& place) {
  SurfaceMatrices m{};
  const SurfacePoint& point = place.point;
  m.K = point.K;
  m.P << place.ux.transpose() * point.frame, place.uy.transpose() * point.frame;
  const SeenPoint<2> seen = seenFrom(point, place.w, place.distance);
  m.wT = seen.wT;
  m.nw = seen.nw;
  m.seen = apparentCurvature(seen);
  if (!m.seen) return m;
  m.inverseP = m.P.inverse();
  m.Q = m.K * m.inverseP;
  m.QtQ = m.Q.transpose() * m.Q;
  m.otherLambda = m.seen->lambda * (1.0 - m.seen->relativeGap);
  m.tA = m.P * m.seen->r;
  return m;
}

namespace {

/// The step with its surroundings, or why not.
template <typename Use>
StepAnswer withKnown(SurfaceStep step, const SurfacePlace& place, const Use& use) {
  const CubicGraph chart(place, step == SurfaceStep::Perspective);
  const Known known = knownAt(chart, place);
  if (needsSight(step) && !known.at) return StepAnswer::Silhouette;
  if (needsDirection(step) && !hasDirection(known.at->seen)) return StepAnswer::NoDirection;
  use(known);
  return StepAnswer::Evaluated;
}

}  // namespace

StepReading readStep(SurfaceStep step, const SurfacePlace& place) {
  StepReading reading;
  const StepAnswer answer = withKnown(step, place, [&](const Known& known) {
    reading = derivation::readingFrom(evaluate(step, known));
  });
  reading.answer = answer;
  return reading;
}

std::vector<StepDifference> stepSizeSweep(SurfaceStep step, const SurfacePlace& place) {
  std::vector<StepDifference> sweep;
  const SlopeStep* slope = slopeStepOf(step);
  if (!slope) return sweep;
  withKnown(step, place, [&](const Known& known) {
    sweep = derivation::sweepSurface(known.chart.frame(), known.chart, *known.at, *slope,
                                     known.chart.reach());
  });
  return sweep;
}

}  // namespace flatland
