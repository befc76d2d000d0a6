// SPDX-License-Identifier: MIT
// The derivation in flatland, (3.1) to (3.13), and its last form for curves.
#include <algorithm>

#include "flatland/study/derivation_parts.h"
#include "flatland/view/apparent_curvature.h"

namespace flatland::derivation {

namespace {

template <class S>
using V2 = VectorOf<S, 2>;

template <class S>
V2<S> constant(const Vec2& v) {
  return {S(v.x()), S(v.y())};
}

/// The quantities of the thesis at one parameter, over any kind of number.
template <class S>
struct Plane {
  V2<S> t, n;  // unit tangent in the walking direction, unit normal
  S k;         // dn/du = k t
  V2<S> kVec;  // the thesis's k
  S nj;        // n.j
  S i;         // screen coordinate
  S u;         // arc length from the place, in the walking direction
  S lambda;    // k^2 / (n.w)^2 with the true line of sight
};

/// Walked with the parameter (+1) or against it (-1) so that the normal lies to the right.
int walkOf(const DerivationPlace& place) { return -place.side; }

template <class S>
Plane<S> planeFrom(const DerivationPlace& place, const ViewFrame& ij, const V2<S>& p,
                   const V2<S>& d1, const V2<S>& d2, const S& u) {
  using std::sqrt;
  Plane<S> q;
  const S speedSq = dotOf(d1, d1);
  const S speed = sqrt(speedSq);
  const S side(static_cast<double>(place.side));
  const S walk(static_cast<double>(walkOf(place)));
  q.t = (walk / speed) * d1;
  q.n = (side / speed) * V2<S>{-d1[1], d1[0]};
  q.k = -side * (d1[0] * d2[1] - d1[1] * d2[0]) / (speedSq * speed);
  q.kVec = q.k * q.t;
  q.nj = dotOf(q.n, constant<S>(ij.towards));
  q.i = dotOf(p, constant<S>(ij.axis));
  q.u = u;
  S nw = q.nj;
  if (place.view.distance) {
    const V2<S> sight = constant<S>(place.view.eye()) + (-p);
    nw = dotOf(q.n, sight) / sqrt(dotOf(sight, sight));
  }
  q.lambda = q.k * q.k / (nw * nw);
  return q;
}

/// As series in the parameter. t and n are good to the square, k and what has it to the first
/// power: the third derivative is the last there is.
Plane<Series> planeSeries(const DerivationPlace& place, const ViewFrame& ij, const Jet& jet) {
  V2<Series> p, d1, d2;
  for (int c = 0; c < 2; ++c) {
    const auto at = static_cast<std::size_t>(c);
    p[at] = {jet.p(c), jet.d1(c), 0.5 * jet.d2(c)};
    d1[at] = {jet.d1(c), jet.d2(c), 0.5 * jet.d3(c)};
    d2[at] = {jet.d2(c), jet.d3(c), 0.0};
  }
  const Series speed = sqrt(dotOf(d1, d1));
  const Sized walk(static_cast<double>(walkOf(place)));
  const Series u{Sized(0.0), walk * speed.c[0], Sized(0.5) * walk * speed.c[1]};
  return planeFrom(place, ij, p, d1, d2, u);
}

/// The same by plain evaluation, `offset` of the parameter away from the place.
Plane<double> planeAt(const DerivationPlace& place, const ViewFrame& ij, const LocalPlace& local,
                      double offset) {
  const Jet jet = jetAt(place.curve, local.piece, local.t + offset);
  const auto plain = [](const Vec2& v) { return V2<double>{v.x(), v.y()}; };
  return planeFrom(place, ij, plain(jet.p), plain(jet.d1), plain(jet.d2), 0.0);
}

/// What the left side of a step is the derivative of, and by what.
template <class S>
struct Defining {
  std::vector<S> of;
  S by;
};

template <class S>
Defining<S> definingOf(DerivationStep step, const Plane<S>& q) {
  using Step = DerivationStep;
  const S half(0.5);
  const V2<S> v = (S(-1.0) / q.nj) * q.kVec;  // dn/di, by (3.7)
  switch (step) {
    case Step::Eq3_1:
    case Step::Eq3_4:
    case Step::Eq3_7:
      return {{q.n[0], q.n[1]}, q.i};
    case Step::Eq3_5:
      return {{q.n[0], q.n[1]}, q.u};
    case Step::Eq3_6:
      return {{q.u}, q.i};
    case Step::Eq3_3:
      return {{dotOf(v, v)}, q.i};
    case Step::Eq3_8:
    case Step::Eq3_11:
      return {{v[0], v[1]}, q.i};
    case Step::Eq3_9:
      return {{-q.kVec[0], -q.kVec[1]}, q.i};
    case Step::Eq3_10:
      return {{q.nj}, q.i};
    case Step::Eq3_12:
    case Step::Eq3_13:
      return {{half * dotOf(v, v)}, q.i};
    case Step::CurveForm:
      return {{half * q.lambda}, q.u};
    default:
      return {};
  }
}

std::vector<Sized> listed(const V2<Sized>& v) { return {v[0], v[1]}; }

Sized power(const Sized& a, int n) { return n == 0 ? Sized(1.0) : a * power(a, n - 1); }

/// Everything the right sides are made of, by the formulas of the curve's frame.
struct Ingredients {
  V2<Sized> t, n, kVec, dk;  // dk = dk/du = k' t - k^2 n
  Sized k, kPrime, nj, kj;
  Plane<Series> series;
};

Ingredients ingredientsAt(const DerivationPlace& place, const ViewFrame& ij, const Jet& jet) {
  Ingredients g;
  g.series = planeSeries(place, ij, jet);
  const auto first = [](const V2<Series>& v) { return V2<Sized>{v[0].c[0], v[1].c[0]}; };
  g.t = first(g.series.t);
  g.n = first(g.series.n);
  g.k = g.series.k.c[0];
  g.kVec = first(g.series.kVec);
  g.nj = g.series.nj.c[0];
  // k' by the formula of the frame (curve/jet.h), not from the series.
  const Sized x1(jet.d1.x()), y1(jet.d1.y()), x2(jet.d2.x()), y2(jet.d2.y());
  const Sized x3(jet.d3.x()), y3(jet.d3.y());
  const Sized s2 = x1 * x1 + y1 * y1, c = x1 * y2 - y1 * x2, cPrime = x1 * y3 - y1 * x3;
  const Sized h = x1 * x2 + y1 * y2;
  const Sized turn(static_cast<double>(-place.side * walkOf(place)));
  g.kPrime = turn * (cPrime * s2 - Sized(3.0) * c * h) / power(s2, 3);
  g.dk = g.kPrime * g.t + (-(g.k * g.k)) * g.n;
  g.kj = dotOf(g.kVec, V2<Sized>{Sized(ij.towards.x()), Sized(ij.towards.y())});
  return g;
}

/// The left side: the derivative of the definition, from the series.
std::vector<Sized> leftOf(const Defining<Series>& defining) {
  std::vector<Sized> left;
  for (const Series& f : defining.of) left.push_back(f.c[1] / defining.by.c[1]);
  return left;
}

/// d^2n/di^2 from the normal alone, without (3.7).
V2<Sized> secondDerivativeOfNormal(const Plane<Series>& q) {
  V2<Sized> second;
  for (std::size_t c = 0; c < 2; ++c) {
    const Series slope = derivative(q.n[c]) / derivative(q.i);
    second[c] = slope.c[1] / q.i.c[1];
  }
  return second;
}
V2<Sized> firstDerivativeOfNormal(const Plane<Series>& q) {
  return {q.n[0].c[1] / q.i.c[1], q.n[1].c[1] / q.i.c[1]};
}

/// u = g^-1(i): the screen coordinate of a neighbour, the neighbour found from it by Newton's
/// method, and its coordinate again.
SizedSides inverse(const DerivationPlace& place, const ViewFrame& ij, const LocalPlace& local) {
  constexpr double kNeighbour = 1e-4;
  constexpr int kMost = 20;
  const auto at = [&](double offset) { return jetAt(place.curve, local.piece, local.t + offset); };
  // g has an inverse between silhouettes only: the neighbour must be on this side of the next, and
  // near enough for Newton's method not to stray.
  const double slopeHere = at(0.0).d1.dot(ij.axis);
  double step = local.t < 0.5 ? kNeighbour : -kNeighbour;
  for (int n = 0; n < kMost; ++n) {
    const double ratio = at(step).d1.dot(ij.axis) / slopeHere;
    if (ratio > 0.5 && ratio < 2.0) break;
    step *= 0.5;
  }
  const double wanted = at(step).p.dot(ij.axis);
  double offset = 0.0;
  for (int n = 0; n < kMost; ++n) {
    const Jet jet = at(offset);
    const double slope = jet.d1.dot(ij.axis);
    const double change = (wanted - jet.p.dot(ij.axis)) / slope;
    if (!(std::abs(change) > 0.0)) break;
    offset = std::clamp(offset + change, -local.t, 1.0 - local.t);
  }
  const Vec2 p = at(offset).p;
  // Rounding t moves the point by a rounding of the curve's size, wherever its coordinates stand.
  const Sized found(p.dot(ij.axis), p.cwiseAbs().dot(ij.axis.cwiseAbs()) + at(offset).d1.norm());
  return {1, 1, {found}, {Sized(wanted, found.size)}};
}

/// The step's last form, D = 1, with the terms of view/apparent_curvature.h.
SizedSides curveForm(const DerivationPlace& place, const Ingredients& g, const Jet& jet,
                     const ViewFrame& ij) {
  SeenPoint<1> seen{};
  seen.K(0) = g.k.value;
  seen.C.coefficients[0] = g.kPrime.value;
  seen.wT(0) = g.t[0].value * ij.towards.x() + g.t[1].value * ij.towards.y();
  seen.nw = g.nj.value;
  if (place.view.distance) seen.distance = (place.view.eye() - jet.p).norm();
  const auto found = apparentCurvature(seen);
  const double r = found ? found->r(0) : 0.0;
  // Sizes of the products: k and k' with what cancelled in them, 1/(n.w) likewise.
  const double seenSize = g.nj.size / (g.nj.value * g.nj.value);
  const double step = std::abs(r) * g.nj.size / std::abs(g.nj.value);
  const double size = step * step * step * g.k.size * g.kPrime.size +
                      step * step * step * power(g.k, 3).size * seenSize +
                      (found ? std::abs(found->perspective) : 0.0);
  const std::vector<Sized> slope = leftOf(definingOf(DerivationStep::CurveForm, g.series));
  return {1, 1, {Sized(r) * slope[0]}, {Sized(found ? found->sum() : 0.0, size)}};
}

Evaluation identity(const std::vector<Sized>& left, const std::vector<Sized>& right) {
  return {StepAnswer::Evaluated, SizedSides{static_cast<int>(left.size()), 1, left, right},
          std::nullopt};
}

Evaluation misprint(const std::vector<Sized>& left, const std::vector<Sized>& right,
                    const std::vector<Sized>& printed) {
  Evaluation found = identity(left, right);
  found.printed = SizedSides{found.corrected->rows, 1, left, printed};
  return found;
}

Evaluation evaluateAt(DerivationStep step, const DerivationPlace& place, const ViewFrame& ij,
                      const Jet& jet) {
  using Step = DerivationStep;
  const Ingredients g = ingredientsAt(place, ij, jet);
  if (step != Step::Eq3_5 && vanishes(g.nj)) return {StepAnswer::Silhouette, {}, {}};
  const Plane<Series>& q = g.series;
  const Sized one(1.0), two(2.0);
  const V2<Sized> j{Sized(ij.towards.x()), Sized(ij.towards.y())};
  const std::vector<Sized> left = leftOf(definingOf(step, q));
  const Sized kSq = dotOf(g.kVec, g.kVec);
  const Sized kdk = dotOf(g.dk, g.kVec);
  switch (step) {
    case Step::Eq3_1: {
      const V2<Sized> slope = firstDerivativeOfNormal(q);
      return identity({dotOf(g.n, slope)}, {Sized(0.0)});
    }
    case Step::Eq3_2:
      return {StepAnswer::Evaluated, inverse(place, ij, localPlace(place)), std::nullopt};
    case Step::Eq3_3:
      return identity(left, {two * dotOf(firstDerivativeOfNormal(q), secondDerivativeOfNormal(q))});
    case Step::Eq3_4: {
      const Sized dudi = q.u.c[1] / q.i.c[1];
      return identity(left, {q.n[0].c[1] / q.u.c[1] * dudi, q.n[1].c[1] / q.u.c[1] * dudi});
    }
    case Step::Eq3_5:
      return identity(left, listed(g.kVec));
    case Step::Eq3_6:
      return identity(left, {-one / g.nj});
    case Step::Eq3_7:
      return identity(left, listed((-one / g.nj) * g.kVec));
    case Step::Eq3_8:
      return identity(listed(secondDerivativeOfNormal(q)), left);
    case Step::Eq3_9:
      return identity(left, listed((one / g.nj) * g.dk));
    case Step::Eq3_10:
      return misprint(left, {-g.kj / g.nj}, {g.kj / g.nj});
    case Step::Eq3_11: {
      const Sized front = one / (g.nj * g.nj);
      return misprint(listed(secondDerivativeOfNormal(q)),
                      listed(front * (g.dk + (-g.kj / g.nj) * g.kVec)),
                      listed(front * (g.dk + (kSq / g.nj) * j)));
    }
    case Step::Eq3_12: {
      const Sized front = -one / power(g.nj, 3), rest = kSq / g.nj * g.kj;
      return misprint({dotOf(firstDerivativeOfNormal(q), secondDerivativeOfNormal(q))},
                      {front * (kdk - rest)}, {front * (kdk + rest)});
    }
    case Step::Eq3_13: {
      const Sized slope = power(g.nj, 4) * left[0];
      Evaluation found = identity({-slope}, {g.nj * kdk - kSq * g.kj});
      found.printed = SizedSides{1, 1, {slope}, {-g.nj * kdk - kSq * g.kj}};
      return found;
    }
    default:
      return {StepAnswer::Evaluated, curveForm(place, g, jet, ij), std::nullopt};
  }
}

/// Turns the plain quotient of the definition into the left sides of a step.
Quotient leftSides(DerivationStep step, const Ingredients& g, std::vector<double> slope) {
  using Step = DerivationStep;
  if (step == Step::Eq3_1) {
    return {{g.n[0].value * slope[0] + g.n[1].value * slope[1]}, {}};
  }
  if (step == Step::Eq3_13) {
    const double left = power(g.nj, 4).value * slope[0];
    return {{-left}, {left}};
  }
  if (step == Step::CurveForm) {
    const double r = g.k.value < 0.0 ? -1.0 : 1.0;
    return {{r / std::abs(g.nj.value) * slope[0]}, {}};
  }
  return {slope, slope};
}

/// Arc length from the place: exact to rounding however short.
double walkedLength(const DerivationPlace& place, const LocalPlace& local, double offset,
                    double speed) {
  if (offset == 0.0) return 0.0;
  const double from = local.piece + local.t;
  constexpr double kAccuracy = 1e-15;
  return walkOf(place) *
         arcLength(place.curve, from, from + offset, kAccuracy * speed * std::abs(offset)).value;
}

}  // namespace

Evaluation evaluatePlane(DerivationStep step, const DerivationPlace& place) {
  const LocalPlace local = localPlace(place);
  const Jet jet = jetAt(place.curve, local.piece, local.t);
  if (!(jet.d1.squaredNorm() > 0.0)) return {StepAnswer::NoTangent, {}, {}};
  const ViewFrame ij = frozenView(place, jet.p);
  if (ij.towards.isZero()) return {StepAnswer::Silhouette, {}, {}};
  return evaluateAt(step, place, ij, jet);
}

std::vector<StepDifference> sweepPlane(DerivationStep step, const DerivationPlace& place) {
  if (step == DerivationStep::Eq3_2) return {};
  const Evaluation found = evaluatePlane(step, place);
  if (!found.corrected) return {};
  const LocalPlace local = localPlace(place);
  const Jet jet = jetAt(place.curve, local.piece, local.t);
  const ViewFrame ij = frozenView(place, jet.p);
  const Ingredients g = ingredientsAt(place, ij, jet);
  const bool byLength = step == DerivationStep::Eq3_5 || step == DerivationStep::Eq3_6 ||
                        step == DerivationStep::CurveForm;
  constexpr double kLargest = 0.1;
  std::vector<StepDifference> sweep;
  for (const double h : stepSizes(kLargest, -local.t, 1.0 - local.t)) {
    const Stencil stencil = stencilFor(h, -local.t, 1.0 - local.t);
    std::vector<double> rise(found.corrected->left.size(), 0.0);
    if (step == DerivationStep::Eq3_1) rise.assign(2, 0.0);
    double run = 0.0;
    for (std::size_t m = 0; m < static_cast<std::size_t>(stencil.count); ++m) {
      Plane<double> q = planeAt(place, ij, local, stencil.offsets[m]);
      if (byLength) q.u = walkedLength(place, local, stencil.offsets[m], jet.d1.norm());
      const Defining<double> defining = definingOf(step, q);
      for (std::size_t c = 0; c < rise.size(); ++c) {
        rise[c] += stencil.weights[m] * defining.of[c];
      }
      run += stencil.weights[m] * defining.by;
    }
    for (double& r : rise) r /= run;
    const Quotient sides = leftSides(step, g, rise);
    StepDifference difference{h, distanceFrom(sides.corrected, *found.corrected), std::nullopt};
    if (found.printed) difference.printed = distanceFrom(sides.printed, *found.printed);
    sweep.push_back(difference);
  }
  return sweep;
}

}  // namespace flatland::derivation
