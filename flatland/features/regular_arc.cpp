// SPDX-License-Identifier: MIT
#include "flatland/features/regular_arc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "flatland/features/tolerances.h"
#include "flatland/roots/isolate.h"

namespace flatland {

namespace {

Bernstein zeroPolynomial() { return Bernstein::fromDoubles({0.0}); }

// What an end of an arc is: an end of the piece, where only an exact zero of the derivative counts,
// or a cusp found to the last bits of t, where rounding t leaves a rest.
enum class ArcEnd { OfPiece, AtCusp };

bool vanishes(const Bounded& x, const Bounded& y, ArcEnd end, double reach) {
  constexpr double kCuspRest = 0x1p-40;  // relative to the largest coefficient
  if (end == ArcEnd::OfPiece) return x.isExactZero() && y.isExactZero();
  return std::hypot(x.value(), y.value()) <= kCuspRest * reach;
}

// Largest absolute value of the coefficients: no value of the polynomial exceeds it.
double reachOf(const Bernstein& p) {
  double reach = 0.0;
  for (const Bounded& c : p.coefficients()) reach = std::max(reach, std::abs(c.value()));
  return reach;
}
double reachOf(const Bernstein& x, const Bernstein& y) {
  return std::hypot(reachOf(x), reachOf(y));
}

// A position with its derivative split into end factors and a direction without end zeros.
std::optional<RegularArc> arcFrom(const Bernstein& x, const Bernstein& y, double tLow, double tHigh,
                                  ArcEnd start, ArcEnd end) {
  RegularArc arc{tLow, tHigh, x, y, derivative(x), derivative(y), 0, 0, false};
  const double reach = reachOf(arc.dx, arc.dy);
  while (arc.dx.degree() > 0 && vanishes(arc.dx.first(), arc.dy.first(), start, reach)) {
    arc.dx = arc.dx.dividedByT(1);
    arc.dy = arc.dy.dividedByT(1);
    ++arc.zerosAtStart;
  }
  while (arc.dx.degree() > 0 && vanishes(arc.dx.last(), arc.dy.last(), end, reach)) {
    arc.dx = arc.dx.dividedByOneMinusT(1);
    arc.dy = arc.dy.dividedByOneMinusT(1);
    ++arc.zerosAtEnd;
  }
  if (arc.dx.isZero() && arc.dy.isZero()) return std::nullopt;
  return arc;
}

// On a line to within rounding: the distance of every control point from the line through the first
// and the one farthest from it is below a few units in the last place of the coordinates.
bool isStraight(const Bezier& piece) {
  double size = 0.0;
  for (const Vec2& p : piece.points) size = std::max(size, p.cwiseAbs().maxCoeff());
  const Vec2 first = piece.points.front();
  Vec2 chord = Vec2::Zero();
  for (const Vec2& p : piece.points) {
    if ((p - first).squaredNorm() > chord.squaredNorm()) chord = p - first;
  }
  const double tolerance = kStraightUlps * 0x1p-53 * size;
  return std::all_of(piece.points.begin(), piece.points.end(), [&](const Vec2& p) {
    return std::abs(cross(chord, p - first)) <= tolerance * chord.norm();
  });
}

// Interior parameters where the derivative (dx, dy) vanishes to the last bits of t. Minima of the
// speed are crossings of dx dx' + dy dy'; at each, is the derivative no larger than what
// rounding t by a few units makes of it?
std::vector<double> interiorCusps(const Bernstein& dx, const Bernstein& dy) {
  constexpr double kCuspUlps = 8.0;
  std::vector<double> cusps;
  if (dx.degree() < 1) return cusps;
  const Bernstein ddx = derivative(dx), ddy = derivative(dy);
  const Roots minima = isolateRoots(dx * ddx + dy * ddy);
  const double reach = reachOf(ddx, ddy);
  const auto consider = [&](double t, double width) {
    const double speed = std::hypot(dx.at(t).value(), dy.at(t).value());
    if (t > 0.0 && t < 1.0 && speed <= (kCuspUlps * 0x1p-53 + width) * reach) cusps.push_back(t);
  };
  for (const Root& root : minima.roots) consider(root.t, root.high - root.low);
  for (const RootInterval& open : minima.unresolved) {
    consider(0.5 * (open.low + open.high), open.high - open.low);
  }
  std::sort(cusps.begin(), cusps.end());
  cusps.erase(std::unique(cusps.begin(), cusps.end()), cusps.end());
  return cusps;
}

// Interior parameters where a straight piece turns back: sign changes of the speed along it.
std::vector<double> reversals(const RegularArc& arc) {
  // The coordinate in which it moves most decides.
  std::vector<double> turns;
  for (const Root& root :
       isolateRoots(reachOf(arc.dx) >= reachOf(arc.dy) ? arc.dx : arc.dy).roots) {
    if (root.t > 0.0 && root.t < 1.0) turns.push_back(root.t);
  }
  return turns;
}

Vec2 unit(const Bounded& x, const Bounded& y) {
  const Vec2 v(x.value(), y.value());
  return v / v.norm();
}

// cos and sin of the view applied exactly rounded: component of (x, y) along `direction`.
Bernstein along(const Vec2& direction, const Bernstein& x, const Bernstein& y) {
  return Bounded(direction.x()) * x + Bounded(direction.y()) * y;
}

Bernstein constant(double value) { return Bernstein::fromDoubles({value}); }

// x' z - x z' for the image slope x / z of a piece, z the depth before the viewer.
Bernstein perspectiveSilhouette(const Bernstein& x, const Bernstein& y, const ViewFrame& frame,
                                double distance) {
  const Bernstein across = along(frame.axis, x, y);
  const Bernstein depth = constant(distance) - along(frame.towards, x, y);
  return degreeTimesWronskian(across, depth);
}

std::pair<Bernstein, Bernstein> positionOf(const Bezier& piece, double scale) {
  std::vector<double> x, y;
  for (const Vec2& p : piece.points) {
    x.push_back(scale * p.x());
    y.push_back(scale * p.y());
  }
  return {Bernstein::fromDoubles(x), Bernstein::fromDoubles(y)};
}

const Bernstein kS = Bernstein::fromDoubles({0.0, 1.0});     // s
const Bernstein kRest = Bernstein::fromDoubles({1.0, 0.0});  // 1 - s

// For g = s^m0 (1 - s)^m1: l has a simple zero at each end where g has one, lDot = l g'/g.
struct EndFactors {
  int m0, m1;
  Bernstein l, lDot;

  bool areTrivial() const { return m0 + m1 == 0; }  // g = 1
};

EndFactors endFactors(int m0, int m1) {
  EndFactors ends{m0, m1, constant(1.0), constant(0.0)};
  if (m0 > 0) ends.l = kS, ends.lDot = constant(m0);
  if (m1 > 0) {
    ends.lDot = ends.lDot * kRest - constant(m1) * ends.l;
    ends.l = ends.l * kRest;
  }
  return ends;
}

// How many exact zeros, at most `most`, p has at its start.
int exactZerosAtStart(const Bernstein& p, int most) {
  int m = 0;
  while (m < std::min(most, p.degree()) && p.scaled()[static_cast<std::size_t>(m)].isExactZero())
    ++m;
  return m;
}

// k = gamma / (m g sigma^(3/2)) up to sign, m the degree of the direction, which the Wronskian
// leaves in.
struct Curvature {
  Bernstein sigma, gamma;
  EndFactors ends;  // those of g

  // m l g sigma^(5/2) times the derivative by s: k'/k = gamma'/gamma - 3/2 sigma'/sigma - g'/g
  Bernstein prime() const {
    const Bernstein p =
        ends.l * (derivative(gamma) * sigma - Bounded(1.5) * (gamma * derivative(sigma)));
    return ends.areTrivial() ? p : p - ends.lDot * (gamma * sigma);
  }
};

// One-sided value at an end, from the values of gamma and sigma and the multiplicity of g there.
std::optional<double> endCurvature(const Bounded& gamma, const Bounded& sigma, int zeros, int m) {
  if (zeros == 0) return gamma.value() / (m * std::pow(sigma.value(), 1.5));
  if (gamma.certainSign() == 0) return std::nullopt;
  return gamma.certainSign() * std::numeric_limits<double>::infinity();
}

Curvature curvatureOf(const RegularArc& arc) {
  return {arc.dx * arc.dx + arc.dy * arc.dy,
          -degreeTimesWronskian(arc.dx, arc.dy),  // m (dx dy' - dx' dy)
          endFactors(arc.zerosAtStart, arc.zerosAtEnd)};
}

// Without the zeros that gamma and g share at the ends. Where they do, curvature is finite there,
// and gamma's zero is no inflection.
Curvature reduced(const Curvature& k) {
  const int atStart = exactZerosAtStart(k.gamma, k.ends.m0);
  const int atEnd = exactZerosAtStart(k.gamma.reversed(), k.ends.m1);
  return {k.sigma, k.gamma.dividedByT(atStart).dividedByOneMinusT(atEnd),
          endFactors(k.ends.m0 - atStart, k.ends.m1 - atEnd)};
}

}  // namespace

Vec2 RegularArc::startDirection() const { return unit(dx.first(), dy.first()); }
Vec2 RegularArc::endDirection() const { return unit(dx.last(), dy.last()); }

double unitScale(double length) {
  if (!(length > 0.0)) return 1.0;
  int exponent = 0;
  std::frexp(length, &exponent);
  return std::ldexp(1.0, -exponent);
}

std::vector<RegularArc> regularArcs(const Bezier& piece, double scale) {
  auto [x, y] = positionOf(piece, scale);
  std::optional<RegularArc> whole = arcFrom(x, y, 0.0, 1.0, ArcEnd::OfPiece, ArcEnd::OfPiece);
  if (!whole) return {};
  whole->straight = isStraight(piece);
  const std::vector<double> cuts =
      whole->straight ? reversals(*whole) : interiorCusps(whole->dx, whole->dy);
  if (cuts.empty()) return {*whole};

  std::vector<RegularArc> arcs;
  double from = 0.0;
  for (std::size_t i = 0; i <= cuts.size(); ++i) {
    const bool last = i == cuts.size();
    const double to = last ? 1.0 : cuts[i];
    Bernstein headX = x, headY = y;
    if (!last) {
      const double local = (to - from) / (1.0 - from);
      std::tie(headX, x) = x.split(local);
      std::tie(headY, y) = y.split(local);
    }
    if (const auto arc = arcFrom(headX, headY, from, to, i > 0 ? ArcEnd::AtCusp : ArcEnd::OfPiece,
                                 last ? ArcEnd::OfPiece : ArcEnd::AtCusp)) {
      arcs.push_back(*arc);
      arcs.back().straight = whole->straight;
    }
    from = to;
  }
  return arcs;
}

Bernstein silhouettePolynomial(const Bezier& piece, const ViewFrame& frame, double scale) {
  const auto [x, y] = positionOf(piece, scale);
  if (frame.distance) return perspectiveSilhouette(x, y, frame, scale * *frame.distance);
  return along(frame.axis, derivative(x), derivative(y));
}

namespace {

// The polynomial with its end values set to exactly zero where they are next to nothing.
Bernstein snapped(const Bernstein& p, bool atStart, bool atEnd) {
  if (!atStart && !atEnd) return p;
  const double tolerance = kEndOnSine * reachOf(p);
  std::vector<Bounded> scaled = p.scaled();
  if (atStart && std::abs(scaled.front().value()) <= tolerance) scaled.front() = {};
  if (atEnd && std::abs(scaled.back().value()) <= tolerance) scaled.back() = {};
  return Bernstein::fromScaled(std::move(scaled));
}

}  // namespace

ArcPolynomials polynomialsOf(const RegularArc& arc, const ViewFrame& frame, double scale) {
  const int m0 = arc.zerosAtStart, m1 = arc.zerosAtEnd;
  const Bernstein xi = along(frame.axis, arc.dx, arc.dy);
  const Bernstein eta = along(frame.towards, arc.dx, arc.dy);

  ArcPolynomials result;
  // n.w up to positive factors: orthographic xi; perspective xi z + x eta, where the free factor
  // s^m0 (1 - s)^m1 has been divided out of x' z - x z'.
  Bernstein across, depth;
  if (frame.distance) {
    across = along(frame.axis, arc.x, arc.y);
    depth = constant(scale * *frame.distance) - along(frame.towards, arc.x, arc.y);
    // Without cusps the Wronskian gives the exact degree; its factor n does not matter.
    result.silhouette =
        (m0 + m1 == 0) ? degreeTimesWronskian(across, depth) : xi * depth + across * eta;
  } else {
    result.silhouette = xi;
  }
  // At a cusp the direction is known to rounding only. Pointing along the line of sight to that
  // accuracy, it does so exactly: the silhouette is then the cusp itself.
  result.silhouette = snapped(result.silhouette, m0 > 0, m1 > 0);
  if (arc.straight) {
    result.curvature = result.curvaturePrime = result.lambdaPrime = zeroPolynomial();
    result.startCurvature = result.endCurvature = 0.0;
    return result;
  }

  const Bernstein& w = result.silhouette;
  const Curvature k = reduced(curvatureOf(arc));
  const Bernstein &sigma = k.sigma, &gamma = k.gamma, &l = k.ends.l, &lDot = k.ends.lDot;
  const Bernstein gammaDot = derivative(gamma), sigmaDot = derivative(sigma), wDot = derivative(w);
  result.curvature = gamma;
  result.curvaturePrime = k.prime();
  const int m = arc.dx.degree();
  result.startCurvature = endCurvature(gamma.first(), sigma.first(), k.ends.m0, m);
  result.endCurvature = endCurvature(gamma.last(), sigma.last(), k.ends.m1, m);

  // lambda = (gamma / (g sigma w))^2, times rho^2 in perspective
  Bernstein a = gammaDot * sigma * w - gamma * (sigmaDot * w + sigma * wDot);
  if (!k.ends.areTrivial()) a = l * a - lDot * (gamma * sigma * w);
  if (frame.distance) {
    const Bernstein rhoSq = across * across + depth * depth;
    // (rho^2)'/2 = g (across xi - depth eta)
    Bernstein g = constant(1.0);
    for (int i = 0; i < m0; ++i) g = g * kS;
    for (int i = 0; i < m1; ++i) g = g * kRest;
    a = rhoSq * a + l * g * (across * xi - depth * eta) * (gamma * sigma * w);
  }
  result.lambdaPrime = a;
  return result;
}

Bernstein foldPolynomial(const RegularArc& arc) {
  const Curvature k = curvatureOf(arc);
  const Bernstein &l = k.ends.l, &lDot = k.ends.lDot;
  const Bernstein prime = k.prime();  // k' = prime / (m l g^2 sigma^3)
  // k'' = second / (m l^2 g^3 sigma^(9/2)), from k' by the quotient rule.
  const Bernstein second = l * k.sigma * derivative(prime) -
                           (derivative(l) + Bounded(2.0) * lDot) * (k.sigma * prime) -
                           Bounded(3.0) * (l * derivative(k.sigma) * prime);
  // All three terms over m^4 l^2 g^4 sigma^6.
  const Bernstein gammaSq = k.gamma * k.gamma;
  const double m = arc.dx.degree();
  return l * l * gammaSq * gammaSq + Bounded(m * m) * (k.gamma * second - prime * prime);
}

Bernstein printedPolynomial(const RegularArc& arc, const ViewFrame& frame, double scale) {
  const Curvature k = curvatureOf(arc);
  const Bernstein xi = along(frame.axis, arc.dx, arc.dy);
  const Bernstein eta = along(frame.towards, arc.dx, arc.dy);
  Bernstein nw = xi, tw = eta;  // up to one positive factor
  if (frame.distance) {
    const Bernstein across = along(frame.axis, arc.x, arc.y);
    const Bernstein depth = constant(scale * *frame.distance) - along(frame.towards, arc.x, arc.y);
    nw = xi * depth + across * eta;
    tw = eta * depth - across * xi;
  }
  // k' = -prime / (m l g^2 sigma^3), k^2 = gamma^2 / (m^2 g^2 sigma^3).
  const double m = arc.dx.degree();
  return Bounded(m) * (nw * k.prime()) - k.ends.l * k.gamma * k.gamma * tw;
}

}  // namespace flatland
