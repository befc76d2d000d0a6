// SPDX-License-Identifier: MIT
#include "flatland/study/surface_steps.h"

#include <algorithm>

namespace flatland::derivation {

namespace {

Eigen::Matrix2d plainMatrix(const M2<Sized>& m) {
  Eigen::Matrix2d plain;
  plain << m[0].value, m[1].value, m[2].value, m[3].value;
  return plain;
}

/// The principal frame of K, as a rotation of T: its first column is the direction of the larger
/// curvature. `first` picks the better of two proportional formulas and must not change underway.
template <class S>
M2<S> principalTurn(const M2<S>& k, bool first) {
  using std::sqrt;
  const S half = S(0.5) * (k[0] - k[3]), mixed = S(0.5) * (k[1] + k[2]);
  const S radius = sqrt(half * half + mixed * mixed);
  V2<S> v{first ? radius + half : mixed, first ? mixed : radius - half};
  const S length = sqrt(dotOf(v, v));
  v = (S(1.0) / length) * v;
  return {v[0], -v[1], v[1], v[0]};
}

/// P in the frame of principal directions, wherever on the path.
template <class S>
M2<S> principalP(const CarriedPoint<S>& point, bool first) {
  return times(point.P, principalTurn(point.K, first));
}

/// -(U^T n)(K r)^T: the frame turns out of its plane, and by nothing else.
M2<Sized> outOfPlane(const SurfaceAt& at) {
  return {-at.un[0] * at.kr[0], -at.un[0] * at.kr[1], -at.un[1] * at.kr[0], -at.un[1] * at.kr[1]};
}

/// What the thesis needs besides: its frame of principal directions, and its (4.7) there.
struct Principal {
  M2<Sized> turn, K, P, inverseP;
  std::array<Sized, 4> C;
  V2<Sized> r;
  M2<Sized> printedDP;
};

/// Empty at an umbilic and where all view-dependent curvatures are equal.
std::optional<Principal> principalAt(const SurfaceAt& at) {
  const Sized half = at.K[0] - at.K[3];
  if (vanishes(half) && vanishes(at.K[1])) return std::nullopt;
  const Sized gap(at.seen.lambda * at.seen.relativeGap);
  if (!(gap.value > 0.0)) return std::nullopt;
  Principal own;
  own.turn = principalTurn(at.K, at.first);
  const M2<Sized> back = transposed(own.turn);
  own.K = times(back, times(at.K, own.turn));
  own.P = times(at.P, own.turn);
  own.inverseP = times(back, at.inverseP);
  own.r = times(back, at.r);
  // C(T_a, T_b, T_c) for the turned frame, by contracting with its directions.
  const V2<Sized> t1{own.turn[0], own.turn[2]}, t2{own.turn[1], own.turn[3]};
  const M2<Sized> d1 = contracted(at.C, t1), d2 = contracted(at.C, t2);
  own.C = {dotOf(t1, times(d1, t1)), dotOf(t1, times(d1, t2)), dotOf(t2, times(d1, t2)),
           dotOf(t2, times(d2, t2))};
  // (4.7): the columns of U^T (t2, -t1) times C(t1, t2, r) over the difference of the two
  // view-dependent curvatures. The columns of P are U^T t1 and U^T t2.
  const Sized turning = (own.C[1] * own.r[0] + own.C[2] * own.r[1]) / gap;
  own.printedDP = {turning * own.P[1], -turning * own.P[0], turning * own.P[3],
                   -turning * own.P[2]};
  return own;
}

/// (4.8) with either sign of the footnote.
Sized derivativeOfLambda(const M2<Sized>& k, const M2<Sized>& inverseP,
                         const std::array<Sized, 4>& c, const V2<Sized>& r, const V2<Sized>& tA,
                         const M2<Sized>& dp, double sign) {
  const V2<Sized> turning = times(k, times(inverseP, times(dp, times(inverseP, tA))));
  const V2<Sized> changing = times(contracted(c, r), r);
  const V2<Sized> both = changing + Sized(sign) * turning;
  return Sized(2.0) * dotOf(times(k, times(inverseP, tA)), both);
}

/// The value is that of the program's own formula, which is what the step puts to the test; only
/// the size of what it adds up is found here.
Sized closedForm(const SurfaceAt& at) {
  const double feature = dotOf(at.kr, times(contracted(at.C, at.r), at.r)).size;
  const double offset = (dotOf(at.r, at.kr) * dotOf(at.kr, times(at.K, at.wT)) / at.nw).size;
  return {at.seen.sum(), feature + offset + std::abs(at.seen.perspective)};
}

Evaluation inverseSides(const SurfaceAt& at) {
  const M2<Sized> dp = coefficient(at.series.P, 1);
  const M2<Sized> product = times(at.inverseP, times(dp, at.inverseP));
  const std::vector<Sized> left = listed(coefficient(at.series.inverseP, 1));
  return {StepAnswer::Evaluated, sidesOf(2, 2, left, listed(-product)),
          sidesOf(2, 2, left, listed(product))};
}

Evaluation projectionSides(const SurfaceAt& at) {
  Evaluation found;
  found.corrected = sidesOf(2, 2, listed(coefficient(at.series.P, 1)), listed(outOfPlane(at)));
  if (const auto own = principalAt(at)) {
    const M2<Series> p = principalP(at.series, at.first);
    found.printed = sidesOf(2, 2, listed(coefficient(p, 1)), listed(own->printedDP));
  }
  return found;
}

Evaluation lambdaSides(const SurfaceAt& at) {
  const Sized slope = at.series.lambda.c[1];
  Evaluation found;
  found.corrected =
      sidesOf(1, 1, {slope},
              {derivativeOfLambda(at.K, at.inverseP, at.C, at.r, at.tA, outOfPlane(at), -1.0)});
  if (const auto own = principalAt(at)) {
    found.printed = sidesOf(
        1, 1, {slope},
        {derivativeOfLambda(own->K, own->inverseP, own->C, own->r, at.tA, own->printedDP, 1.0)});
  }
  return found;
}

Evaluation sumSides(const SurfaceAt& at) {
  return {StepAnswer::Evaluated,
          sidesOf(1, 1, {Sized(0.5) * at.series.lambda.c[1]}, {closedForm(at)}), std::nullopt};
}

std::vector<double> plainList(const M2<double>& m) { return {m.begin(), m.end()}; }

Quotient inverseBefore(const CarriedPoint<double>& point, bool) {
  return {plainList(point.inverseP), plainList(point.inverseP)};
}
Quotient projectionBefore(const CarriedPoint<double>& point, bool first) {
  return {plainList(point.P), plainList(principalP(point, first))};
}
Quotient lambdaBefore(const CarriedPoint<double>& point, bool) {
  return {{point.lambda}, {point.lambda}};
}
Quotient halfLambdaBefore(const CarriedPoint<double>& point, bool) {
  return {{0.5 * point.lambda}, {0.5 * point.lambda}};
}

}  // namespace

const SlopeStep kInverseStep{inverseSides, inverseBefore};
const SlopeStep kProjectionStep{projectionSides, projectionBefore};
const SlopeStep kLambdaStep{lambdaSides, lambdaBefore};
const SlopeStep kSumStep{sumSides, halfLambdaBefore};

M2<Sized> contracted(const std::array<Sized, 4>& c, const V2<Sized>& r) {
  const Sized a = c[0] * r[0] + c[1] * r[1], m = c[1] * r[0] + c[2] * r[1];
  return {a, m, m, c[2] * r[0] + c[3] * r[1]};
}

SizedSides sidesOf(int rows, int columns, std::vector<Sized> left, std::vector<Sized> right) {
  return {rows, columns, std::move(left), std::move(right)};
}

std::optional<SurfaceAt> surfaceAt(const PlaceFrame& place, const Chart& chart,
                                   const std::optional<KnownCurvature>& known,
                                   std::optional<double> distance) {
  const CarriedPoint<Series> along1 = carriedPoint(place, chart.along(1.0, 0.0));
  const V3<Sized> w = lifted<Sized>(place.w);
  const Sized nw = dotOf(coefficient(along1.n, 0), w);
  if (vanishes(nw)) return std::nullopt;
  SurfaceAt at;
  if (known) {
    at.K = known->K;
    at.C = known->C;
  } else {
    // C is the derivative of K in a frame that does not turn in its plane.
    const CarriedPoint<Series> along2 = carriedPoint(place, chart.along(0.0, 1.0));
    at.K = coefficient(along1.K, 0);
    at.C = {along1.K[0].c[1], along2.K[0].c[1], along1.K[3].c[1], along2.K[3].c[1]};
  }
  at.nw = nw;
  at.wT = {dotOf(lifted<Sized>(place.t1), w), dotOf(lifted<Sized>(place.t2), w)};
  const SeenPoint<2> point{plainMatrix(at.K),
                           {{at.C[0].value, at.C[1].value, at.C[2].value, at.C[3].value}},
                           {at.wT[0].value, at.wT[1].value},
                           nw.value,
                           distance};
  const auto seen = apparentCurvature(point);
  if (!seen) return std::nullopt;
  at.seen = *seen;
  at.r = {Sized(seen->r(0)), Sized(seen->r(1))};
  const ChartPoint<Series> way = chart.along(seen->r(0), seen->r(1));
  at.series = carriedPoint(place, way);
  at.P = coefficient(at.series.P, 0);
  at.inverseP = coefficient(at.series.inverseP, 0);
  at.tA = times(at.P, at.r);
  at.kr = times(at.K, at.r);
  const V3<Sized> n = coefficient(at.series.n, 0);
  at.un = {dotOf(coefficient(way.ux, 0), n), dotOf(coefficient(way.uy, 0), n)};
  at.first = at.K[0].value >= at.K[3].value;
  return at;
}

std::vector<StepDifference> sweepSurface(const PlaceFrame& place, const Chart& chart,
                                         const SurfaceAt& at, const SlopeStep& step, double reach) {
  const Evaluation found = step.sides(at);
  const double r1 = at.seen.r(0), r2 = at.seen.r(1), r = std::hypot(r1, r2);
  if (!(r > 0.0)) return {};
  const auto [back, ahead] = chart.room(r1, r2);
  std::vector<StepDifference> sweep;
  for (const double h : stepSizes(reach / r, back, ahead)) {
    const Stencil stencil = stencilFor(h, back, ahead);
    Quotient rise;
    double run = 0.0;
    for (std::size_t m = 0; m < static_cast<std::size_t>(stencil.count); ++m) {
      const Quotient here =
          step.before(carriedPoint(place, chart.at(r1, r2, stencil.offsets[m])), at.first);
      rise.corrected.resize(here.corrected.size(), 0.0);
      rise.printed.resize(here.printed.size(), 0.0);
      for (std::size_t c = 0; c < here.corrected.size(); ++c) {
        rise.corrected[c] += stencil.weights[m] * here.corrected[c];
        rise.printed[c] += stencil.weights[m] * here.printed[c];
      }
      run += stencil.weights[m] * stencil.offsets[m];
    }
    for (double& value : rise.corrected) value /= run;
    for (double& value : rise.printed) value /= run;
    StepDifference difference{h, distanceFrom(rise.corrected, *found.corrected), std::nullopt};
    if (found.printed) difference.printed = distanceFrom(rise.printed, *found.printed);
    sweep.push_back(difference);
  }
  return sweep;
}

}  // namespace flatland::derivation
