// SPDX-License-Identifier: MIT
// The derivation on a surface: the footnote of chapter 4, (4.7), (4.8) and the form without
// dimension, on a sheet through the curve.
#include <algorithm>

#include "flatland/study/derivation_parts.h"
#include "flatland/view/apparent_curvature.h"

namespace flatland::derivation {

namespace {

template <class S>
using V3 = VectorOf<S, 3>;
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
VectorOf<S, 2> times(const M2<S>& a, const VectorOf<S, 2>& v) {
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

/// The sheet: the curve carried along b, which stands up from its plane, and bent so that none of
/// the quantities of chapter 4 is zero by accident:
///   X(t, s) = alpha(t) + s b + f(x, s) n0,   x = (alpha(t) - alpha(t0)).t0,
///   f = (p s^2 / 2 + q s x) / L + (a s^3 / 6 + b s^2 x / 2 + c s x^2 / 2) / L^2.
/// It holds the curve (s = 0), and at the place the curve's normal, tangent and curvature. L is the
/// size of the curve. It is seen from w, the line of sight raised out of the plane.
struct Sheet {
  const DerivationPlace& place;
  LocalPlace local;
  Vec2 origin;
  double walk, length;
  V3<double> t0, n0, b, w, ux, uy;
};

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

Sheet sheetAt(const DerivationPlace& place, const Jet& jet) {
  const double walk = -place.side;
  const Vec2 t = walk * jet.d1.normalized(), n = -rotateCcw(t);
  const ViewFrame ij = frozenView(place, jet.p);
  const Vec2 &i = ij.axis, &j = ij.towards;
  const V3<double> w{kRaisedCosine * j.x(), kRaisedCosine * j.y(), kRaisedSine};
  const V3<double> uy{-kRaisedSine * j.x(), -kRaisedSine * j.y(), kRaisedCosine};
  return {place,
          localPlace(place),
          jet.p,
          walk,
          sizeOf(place.curve),
          {t.x(), t.y(), 0.0},
          {n.x(), n.y(), 0.0},
          {0.0, 0.0, 1.0},
          w,
          {i.x(), i.y(), 0.0},
          uy};
}

/// A point of the sheet in a frame T that is carried along without turning in its own plane (the
/// smallest rotation that takes the normal at the place to the normal here).
template <class S>
struct SheetPoint {
  V3<S> n;
  M2<S> K, P, inverseP;
  S lambda;
};

/// The curve's point and derivatives there, lifted into space, with the second coordinate s.
template <class S>
struct CurvePoint {
  V3<S> p, d1, d2;
  S s;
};

template <class S>
S largestEigenvalue(const M2<S>& m) {
  using std::sqrt;
  const S half = S(0.5) * (m[0] - m[3]);
  return S(0.5) * (m[0] + m[3]) + sqrt(half * half + m[1] * m[1]);
}

template <class S>
SheetPoint<S> sheetPoint(const Sheet& sheet, const CurvePoint<S>& at) {
  using std::sqrt;
  const V3<S> t0 = lifted<S>(sheet.t0), n0 = lifted<S>(sheet.n0), b = lifted<S>(sheet.b);
  const S x = dotOf(at.p, t0) - S(sheet.origin.x() * sheet.t0[0] + sheet.origin.y() * sheet.t0[1]);
  const S x1 = dotOf(at.d1, t0), x2 = dotOf(at.d2, t0), s = at.s;
  const double l = sheet.length, ll = l * l;
  // Derivatives of f by x and s.
  const S fx = S(kQ / l) * s + S(kB / (2.0 * ll)) * s * s + S(kC / ll) * s * x;
  const S fs = S(kP / l) * s + S(kQ / l) * x + S(kA / (2.0 * ll)) * s * s + S(kB / ll) * s * x +
               S(kC / (2.0 * ll)) * x * x;
  const S fxx = S(kC / ll) * s;
  const S fxs = S(kQ / l) + S(kB / ll) * s + S(kC / ll) * x;
  const S fss = S(kP / l) + S(kA / ll) * s + S(kB / ll) * x;
  // Of the sheet by t and s.
  const V3<S> xt = at.d1 + (fx * x1) * n0, xs = b + fs * n0;
  const V3<S> xtt = at.d2 + (fxx * x1 * x1 + fx * x2) * n0;
  const V3<S> xts = (fxs * x1) * n0, xss = fss * n0;

  SheetPoint<S> point;
  V3<S> normal = crossed(xt, xs);
  const S length = sqrt(dotOf(normal, normal));
  const S sign(valueOf(dotOf(normal, n0)) < 0.0 ? -1.0 : 1.0);
  point.n = (sign / length) * normal;
  const V3<S>& n = point.n;
  const auto carried = [&](const V3<S>& a) {
    return a + (-(dotOf(a, n) / (S(1.0) + dotOf(n0, n)))) * (n0 + n);
  };
  const V3<S> t1 = carried(t0), t2 = carried(b);
  // dn = K: n.X_uv = -(K X_u).X_v. J takes (dt, ds) to the frame.
  const M2<S> h{-dotOf(n, xtt), -dotOf(n, xts), -dotOf(n, xts), -dotOf(n, xss)};
  const M2<S> j{dotOf(t1, xt), dotOf(t1, xs), dotOf(t2, xt), dotOf(t2, xs)};
  const M2<S> back = inverseOf(j);
  point.K = times(transposed(back), times(h, back));
  const V3<S> ux = lifted<S>(sheet.ux), uy = lifted<S>(sheet.uy);
  point.P = {dotOf(ux, t1), dotOf(ux, t2), dotOf(uy, t1), dotOf(uy, t2)};
  point.inverseP = inverseOf(point.P);
  const M2<S> q = times(point.K, point.inverseP);
  point.lambda = largestEigenvalue(times(q, transposed(q)));
  return point;
}

/// The principal frame of K, as a rotation of T: its first column is the direction of the larger
/// curvature. `first` picks the better of two proportional formulas and must not change underway.
template <class S>
M2<S> principalTurn(const M2<S>& k, bool first) {
  using std::sqrt;
  const S half = S(0.5) * (k[0] - k[3]), mixed = S(0.5) * (k[1] + k[2]);
  const S radius = sqrt(half * half + mixed * mixed);
  VectorOf<S, 2> v{first ? radius + half : mixed, first ? mixed : radius - half};
  const S length = sqrt(dotOf(v, v));
  v = (S(1.0) / length) * v;
  return {v[0], -v[1], v[1], v[0]};
}

/// A straight path in (t, s) through the place, in the tangent direction (r1, r2) of T.
struct Path {
  double a, b;  // dt and ds per step
};
Path pathAlong(const Sheet& sheet, const Jet& jet, double r1, double r2) {
  return {sheet.walk * r1 / jet.d1.norm(), r2};
}

SheetPoint<Series> seriesAlong(const Sheet& sheet, const Jet& jet, const Path& path) {
  CurvePoint<Series> at;
  const double a = path.a;
  for (int c = 0; c < 2; ++c) {
    const auto m = static_cast<std::size_t>(c);
    at.p[m] = {jet.p(c), a * jet.d1(c), 0.5 * a * a * jet.d2(c)};
    at.d1[m] = {jet.d1(c), a * jet.d2(c), 0.5 * a * a * jet.d3(c)};
    at.d2[m] = {jet.d2(c), a * jet.d3(c), 0.0};
  }
  at.s = {Sized(0.0), Sized(path.b), Sized(0.0)};
  return sheetPoint(sheet, at);
}

SheetPoint<double> plainAlong(const Sheet& sheet, const Path& path, double step) {
  const LocalPlace& local = sheet.local;
  const Jet jet = jetAt(sheet.place.curve, local.piece, local.t + path.a * step);
  const auto plain = [](const Vec2& v) { return V3<double>{v.x(), v.y(), 0.0}; };
  return sheetPoint<double>(sheet, {plain(jet.p), plain(jet.d1), plain(jet.d2), path.b * step});
}

template <std::size_t N>
VectorOf<Sized, N> coefficient(const VectorOf<Series, N>& v, std::size_t which) {
  VectorOf<Sized, N> c;
  for (std::size_t m = 0; m < N; ++m) c[m] = v[m].c[which];
  return c;
}
M2<Sized> coefficient(const M2<Series>& v, std::size_t which) { return coefficient<4>(v, which); }

Eigen::Matrix2d plainMatrix(const M2<Sized>& m) {
  Eigen::Matrix2d plain;
  plain << m[0].value, m[1].value, m[2].value, m[3].value;
  return plain;
}

/// Everything known at the place.
struct AtPlace {
  Sheet sheet;
  Path path;                  // along r
  SheetPoint<Series> series;  // along r
  M2<Sized> K, P, inverseP;
  std::array<Sized, 4> C;                // C111, C112, C122, C222 in T
  VectorOf<Sized, 2> r, wT, tA, kr, un;  // tA = P r, kr = K r, un = U^T n
  Sized nw;
  ApparentCurvature<2> seen;
};

/// D_r K, C contracted with r once.
M2<Sized> contracted(const std::array<Sized, 4>& c, const VectorOf<Sized, 2>& r) {
  const Sized a = c[0] * r[0] + c[1] * r[1], m = c[1] * r[0] + c[2] * r[1];
  return {a, m, m, c[2] * r[0] + c[3] * r[1]};
}

std::optional<AtPlace> knownAt(const DerivationPlace& place, const Jet& jet) {
  const Sheet sheet = sheetAt(place, jet);
  const SheetPoint<Series> along1 = seriesAlong(sheet, jet, pathAlong(sheet, jet, 1.0, 0.0));
  const SheetPoint<Series> along2 = seriesAlong(sheet, jet, pathAlong(sheet, jet, 0.0, 1.0));
  const V3<Sized> w = lifted<Sized>(sheet.w);
  const Sized nw = dotOf(coefficient(along1.n, 0), w);
  if (vanishes(nw)) return std::nullopt;
  const M2<Sized> k = coefficient(along1.K, 0);
  // C is the derivative of K in a frame that does not turn in its plane.
  const std::array<Sized, 4> c{along1.K[0].c[1], along2.K[0].c[1], along1.K[3].c[1],
                               along2.K[3].c[1]};
  const VectorOf<Sized, 2> wT{dotOf(lifted<Sized>(sheet.t0), w), dotOf(lifted<Sized>(sheet.b), w)};
  SeenPoint<2> point{plainMatrix(k),
                     {{c[0].value, c[1].value, c[2].value, c[3].value}},
                     {wT[0].value, wT[1].value},
                     nw.value,
                     std::nullopt};
  const auto seen = apparentCurvature(point);
  if (!seen) return std::nullopt;
  const Path path = pathAlong(sheet, jet, seen->r(0), seen->r(1));
  const SheetPoint<Series> series = seriesAlong(sheet, jet, path);
  const VectorOf<Sized, 2> r{Sized(seen->r(0)), Sized(seen->r(1))};
  const M2<Sized> p = coefficient(series.P, 0);
  const V3<Sized> n = coefficient(series.n, 0);
  return AtPlace{
      sheet,       path,
      series,      k,
      p,           coefficient(series.inverseP, 0),
      c,           r,
      wT,          times(p, r),
      times(k, r), {dotOf(lifted<Sized>(sheet.ux), n), dotOf(lifted<Sized>(sheet.uy), n)},
      nw,          *seen};
}

/// -(U^T n)(K r)^T: the frame turns out of its plane, and by nothing else.
M2<Sized> outOfPlane(const AtPlace& at) {
  return {-at.un[0] * at.kr[0], -at.un[0] * at.kr[1], -at.un[1] * at.kr[0], -at.un[1] * at.kr[1]};
}

/// Which formula of principalTurn() is the better one.
bool firstFormula(const AtPlace& at) { return at.K[0].value >= at.K[3].value; }

/// What the thesis needs besides: its frame of principal directions, and its (4.7) there.
struct Principal {
  bool first;
  M2<Sized> turn, K, P, inverseP;
  std::array<Sized, 4> C;
  VectorOf<Sized, 2> r;
  M2<Sized> printedDP;
};

/// There is one at every place: K12 = -q/L, so the two curvatures differ.
Principal principalAt(const AtPlace& at) {
  Principal own;
  own.first = firstFormula(at);
  own.turn = principalTurn(at.K, own.first);
  const M2<Sized> back = transposed(own.turn);
  own.K = times(back, times(at.K, own.turn));
  own.P = times(at.P, own.turn);
  own.inverseP = times(back, at.inverseP);
  own.r = times(back, at.r);
  // C(T_a, T_b, T_c) for the turned frame, by contracting with its directions.
  const VectorOf<Sized, 2> t1{own.turn[0], own.turn[2]}, t2{own.turn[1], own.turn[3]};
  const M2<Sized> d1 = contracted(at.C, t1), d2 = contracted(at.C, t2);
  own.C = {dotOf(t1, times(d1, t1)), dotOf(t1, times(d1, t2)), dotOf(t2, times(d1, t2)),
           dotOf(t2, times(d2, t2))};
  // (4.7): the columns of U^T (t2, -t1) times C(t1, t2, r) over the difference of the two
  // view-dependent curvatures. The columns of P are U^T t1 and U^T t2.
  const Sized gap(at.seen.lambda * at.seen.relativeGap);
  const Sized turning = (own.C[1] * own.r[0] + own.C[2] * own.r[1]) / gap;
  own.printedDP = {turning * own.P[1], -turning * own.P[0], turning * own.P[3],
                   -turning * own.P[2]};
  return own;
}

/// P in the frame of principal directions, wherever on the path.
template <class S>
M2<S> principalP(const SheetPoint<S>& point, bool first) {
  return times(point.P, principalTurn(point.K, first));
}

/// (4.8) with either sign of the footnote.
Sized derivativeOfLambda(const M2<Sized>& k, const M2<Sized>& inverseP,
                         const std::array<Sized, 4>& c, const VectorOf<Sized, 2>& r,
                         const VectorOf<Sized, 2>& tA, const M2<Sized>& dp, double sign) {
  const VectorOf<Sized, 2> turning = times(k, times(inverseP, times(dp, times(inverseP, tA))));
  const VectorOf<Sized, 2> changing = times(contracted(c, r), r);
  const VectorOf<Sized, 2> both = changing + Sized(sign) * turning;
  return Sized(2.0) * dotOf(times(k, times(inverseP, tA)), both);
}

std::vector<Sized> listed(const M2<Sized>& m) { return {m[0], m[1], m[2], m[3]}; }

SizedSides sides(int rows, std::vector<Sized> left, std::vector<Sized> right) {
  return {rows, rows, std::move(left), std::move(right)};
}

/// The value is that of the program's own formula, which is what the step puts to the test; only
/// the size of what it adds up is found here.
Sized closedForm(const AtPlace& at) {
  const double feature = dotOf(at.kr, times(contracted(at.C, at.r), at.r)).size;
  const double offset = (dotOf(at.r, at.kr) * dotOf(at.kr, times(at.K, at.wT)) / at.nw).size;
  return {at.seen.sum(), feature + offset};
}

Evaluation evaluateAt(DerivationStep step, const AtPlace& at) {
  using Step = DerivationStep;
  const Sized half(0.5);
  const M2<Sized> dp = coefficient(at.series.P, 1);
  const Sized slope = at.series.lambda.c[1];
  if (step == Step::SheetForm) {
    return {StepAnswer::Evaluated, sides(1, {half * slope}, {closedForm(at)}), std::nullopt};
  }
  if (step == Step::Footnote) {
    const M2<Sized> product = times(at.inverseP, times(dp, at.inverseP));
    const std::vector<Sized> left = listed(coefficient(at.series.inverseP, 1));
    return {StepAnswer::Evaluated, sides(2, left, listed(-product)),
            sides(2, left, listed(product))};
  }
  const Principal own = principalAt(at);
  Evaluation found;
  if (step == Step::Eq4_7) {
    found.corrected = sides(2, listed(dp), listed(outOfPlane(at)));
    const M2<Series> p = principalP(at.series, own.first);
    found.printed = sides(2, listed(coefficient(p, 1)), listed(own.printedDP));
  } else {
    found.corrected =
        sides(1, {slope},
              {derivativeOfLambda(at.K, at.inverseP, at.C, at.r, at.tA, outOfPlane(at), -1.0)});
    found.printed =
        sides(1, {slope},
              {derivativeOfLambda(own.K, own.inverseP, own.C, own.r, at.tA, own.printedDP, 1.0)});
  }
  return found;
}

/// The left sides of a step at a point of the path, before differentiation.
Quotient definedAt(DerivationStep step, const SheetPoint<double>& point, bool first) {
  using Step = DerivationStep;
  const auto list = [](const M2<double>& m) { return std::vector<double>(m.begin(), m.end()); };
  switch (step) {
    case Step::Footnote:
      return {list(point.inverseP), list(point.inverseP)};
    case Step::Eq4_7:
      return {list(point.P), list(principalP(point, first))};
    case Step::Eq4_8:
      return {{point.lambda}, {point.lambda}};
    default:
      return {{0.5 * point.lambda}, {0.5 * point.lambda}};
  }
}

std::optional<AtPlace> knownAt(const DerivationPlace& place, StepAnswer& answer) {
  const LocalPlace local = localPlace(place);
  const Jet jet = jetAt(place.curve, local.piece, local.t);
  answer = StepAnswer::NoTangent;
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  answer = StepAnswer::Silhouette;
  if (towardsViewer(place.view, jet.p).isZero()) return std::nullopt;
  const auto at = knownAt(place, jet);
  if (at) answer = StepAnswer::Evaluated;
  return at;
}

}  // namespace

Evaluation evaluateSheet(DerivationStep step, const DerivationPlace& place) {
  StepAnswer answer{};
  const auto at = knownAt(place, answer);
  if (!at) return {answer, std::nullopt, std::nullopt};
  return evaluateAt(step, *at);
}

std::vector<StepDifference> sweepSheet(DerivationStep step, const DerivationPlace& place) {
  StepAnswer answer{};
  const auto at = knownAt(place, answer);
  if (!at) return {};
  const Evaluation found = evaluateAt(step, *at);
  const bool first = firstFormula(*at);
  // How far the path may go: a tenth of the sheet's size, and within the piece of the curve.
  constexpr double kReach = 0.1, kNever = 1e300;
  const double r = std::hypot(at->seen.r(0), at->seen.r(1));
  if (!(r > 0.0)) return {};
  const double largest = kReach * at->sheet.length / r;
  const double a = at->path.a, t = at->sheet.local.t;
  const double back = a > 0.0 ? -t / a : a < 0.0 ? (1.0 - t) / a : -kNever;
  const double ahead = a > 0.0 ? (1.0 - t) / a : a < 0.0 ? -t / a : kNever;
  std::vector<StepDifference> sweep;
  for (const double h : stepSizes(largest, back, ahead)) {
    const Stencil stencil = stencilFor(h, back, ahead);
    Quotient rise;
    double run = 0.0;
    for (std::size_t m = 0; m < static_cast<std::size_t>(stencil.count); ++m) {
      const Quotient here =
          definedAt(step, plainAlong(at->sheet, at->path, stencil.offsets[m]), first);
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
