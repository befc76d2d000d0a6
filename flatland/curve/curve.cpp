// SPDX-License-Identifier: MIT
#include "flatland/curve/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatland {

namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

Jet jetOf(const std::array<Vec2, 5>& d) { return {d[0], d[1], d[2], d[3]}; }

Vec2 pointOn(const Curve& curve, int piece, double t) {
  return std::visit(
      Overloaded{
          [&](const BezierChain& chain) { return pointAt(chain.piece(piece), t); },
          [&](const BSpline& spline) { return pointAt(spline.bezierForm().piece(piece), t); },
          [&](const RationalBezier& rational) { return derivativesAt(rational, piece, t)[0]; },
          [&](const FormulaCurve& formula) { return formula.pointAt(piece, t); }},
      curve);
}

/// Parameters between which the curve is tame: for sampling.
std::vector<double> stretchEnds(const Curve& curve) {
  if (const auto* formula = std::get_if<FormulaCurve>(&curve)) return formula->cuts();
  std::vector<double> ends;
  for (int i = 0; i <= pieceCount(curve); ++i) ends.push_back(i);
  return ends;
}

JetOnPiece jetOnPiece(const Curve& curve) {
  return [&curve](int piece, double t) { return jetAt(curve, piece, t); };
}

/// Nodes and weights of the Gauss rule with 8 points on [-1, 1], the positive half.
constexpr std::array<double, 4> kGaussNodes = {0.1834346424956498, 0.5255324099163290,
                                               0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> kGaussWeights = {0.3626837833783620, 0.3137066458778873,
                                                 0.2223810344533745, 0.1012285362903763};

/// A stretch's integral by the rule, and the largest value seen.
struct GaussSum {
  double value, largest;
};

template <class Integrand>
GaussSum gauss(const Integrand& f, double low, double high) {
  const double centre = 0.5 * (low + high), half = 0.5 * (high - low);
  GaussSum sum{0.0, 0.0};
  for (std::size_t i = 0; i < kGaussNodes.size(); ++i) {
    const double step = half * kGaussNodes[i];
    const double before = f(centre - step), after = f(centre + step);
    sum.value += kGaussWeights[i] * (before + after);
    sum.largest = std::max({sum.largest, std::abs(before), std::abs(after)});
  }
  sum.value *= half;
  return sum;
}

// Halves that agree with the whole to this part of it do so to the rounding of a formula; halving
// on would only halve the rounding, everywhere and to the last bit of the parameter.
constexpr double kRoundOff = 0x1p-42;

// Halvings in a row, which reach the last bits of t, and all told on one stretch: enough for two
// places of infinite speed.
constexpr int kMostHalvings = 50, kMostPanels = 250;

/// The integral over a stretch, halved until halves and whole agree.
template <class Integrand>
ArcLength refined(const Integrand& f, double low, double high, const GaussSum& whole,
                  double accuracy, int depth, int& panels) {
  const double middle = 0.5 * (low + high);
  const GaussSum first = gauss(f, low, middle), second = gauss(f, middle, high);
  const double sum = first.value + second.value;
  const double error = std::abs(sum - whole.value);
  const double roundOff = kRoundOff * (high - low) * std::max(first.largest, second.largest);
  if (error <= std::max(accuracy, roundOff) || depth == 0 || --panels <= 0) {
    return {sum, std::max(error, roundOff), error <= accuracy};
  }
  const ArcLength a = refined(f, low, middle, first, 0.5 * accuracy, depth - 1, panels);
  const ArcLength b = refined(f, middle, high, second, 0.5 * accuracy, depth - 1, panels);
  return {a.value + b.value, a.errorEstimate + b.errorEstimate, a.converged && b.converged};
}

}  // namespace

int pieceCount(const Curve& curve) {
  return std::visit([](const auto& kind) { return kind.pieceCount(); }, curve);
}

bool isClosed(const Curve& curve) {
  return std::visit([](const auto& kind) { return kind.closed(); }, curve);
}

ChainParameter locate(const Curve& curve, double t) {
  const int last = pieceCount(curve) - 1;
  const int piece = static_cast<int>(std::clamp(std::floor(t), 0.0, last + 0.0));
  return {piece, std::clamp(t - piece, 0.0, 1.0)};
}

const BezierChain* bezierForm(const Curve& curve) {
  if (const auto* chain = std::get_if<BezierChain>(&curve)) return chain;
  if (const auto* spline = std::get_if<BSpline>(&curve)) return &spline->bezierForm();
  return nullptr;
}

std::array<Vec2, 5> derivativesAt(const Curve& curve, int piece, double t) {
  return std::visit(
      Overloaded{
          [&](const BezierChain& chain) { return derivativesAt(chain.piece(piece), t); },
          [&](const BSpline& spline) { return derivativesAt(spline.bezierForm().piece(piece), t); },
          [&](const RationalBezier& rational) { return derivativesAt(rational, piece, t); },
          [&](const FormulaCurve& formula) { return formula.derivativesAt(piece, t); }},
      curve);
}

Jet jetAt(const Curve& curve, double t) {
  const auto [piece, local] = locate(curve, t);
  return jetAt(curve, piece, local);
}

Jet jetAt(const Curve& curve, int piece, double t) { return jetOf(derivativesAt(curve, piece, t)); }

Vec2 pointAt(const Curve& curve, double t) {
  const auto [piece, local] = locate(curve, t);
  return pointOn(curve, piece, local);
}

ArcLength arcLength(const Curve& curve, double t0, double t1, double accuracy) {
  if (const BezierChain* chain = bezierForm(curve)) return arcLength(*chain, t0, t1, accuracy);
  if (t1 < t0) {
    ArcLength forward = arcLength(curve, t1, t0, accuracy);
    forward.value = -forward.value;
    return forward;
  }
  // A formula has up to thousands of stretches, and is asked for many short lengths.
  const auto* formula = std::get_if<FormulaCurve>(&curve);
  const std::size_t count =
      formula ? formula->cuts().size() - 1 : static_cast<std::size_t>(pieceCount(curve));
  const auto end = [&](std::size_t i) {
    return formula ? formula->cuts()[i] : static_cast<double>(i);
  };
  const double share = accuracy / static_cast<double>(count);
  std::size_t i = 0;
  if (formula) {
    const auto after = std::upper_bound(formula->cuts().begin(), formula->cuts().end(), t0);
    i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - formula->cuts().begin() - 1, 0));
  } else {
    i = static_cast<std::size_t>(locate(curve, t0).piece);
  }
  ArcLength total{0.0, 0.0, true};
  for (; i < count && end(i) < t1; ++i) {
    const double low = std::max(t0, end(i)), high = std::min(t1, end(i + 1));
    if (!(low < high)) continue;
    const int piece = locate(curve, 0.5 * (low + high)).piece;
    const auto speed = [&](double t) { return jetAt(curve, piece, t - piece).d1.norm(); };
    int panels = kMostPanels;
    const ArcLength part =
        refined(speed, low, high, gauss(speed, low, high), share, kMostHalvings, panels);
    total.value += part.value;
    total.errorEstimate += part.errorEstimate;
  }
  total.converged = total.errorEstimate <= accuracy;
  return total;
}

const std::vector<Vec2>& controlPoints(const Curve& curve) {
  static const std::vector<Vec2> none;
  return std::visit(
      Overloaded{[](const FormulaCurve&) -> const std::vector<Vec2>& { return none; },
                 [](const auto& kind) -> const std::vector<Vec2>& { return kind.points(); }},
      curve);
}

int degreeOf(const Curve& curve) {
  return std::visit(Overloaded{[](const FormulaCurve&) { return 0; },
                               [](const auto& kind) { return kind.degree(); }},
                    curve);
}

bool sameTopology(const Curve& a, const Curve& b) {
  return a.index() == b.index() && pieceCount(a) == pieceCount(b) && isClosed(a) == isClosed(b) &&
         controlPoints(a).size() == controlPoints(b).size();
}

Curve translated(const Curve& curve, const Vec2& delta) {
  return std::visit(Overloaded{[&](const FormulaCurve& formula) -> Curve {
                                 return formula.movedTo(formula.at() + delta);
                               },
                               [&](auto kind) -> Curve {
                                 for (std::size_t i = 0; i < kind.points().size(); ++i) {
                                   kind.setPoint(i, kind.points()[i] + delta);
                                 }
                                 return kind;
                               }},
                    curve);
}

Bounds boundsOf(const Curve& curve) {
  const auto boxOf = [](const std::vector<Vec2>& points) {
    Bounds box{points.front(), points.front()};
    for (const Vec2& p : points) box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
    return box;
  };
  constexpr int kPerPiece = 64;
  const std::vector<Vec2>& points = controlPoints(curve);
  return boxOf(points.empty() ? sampledPoints(curve, kPerPiece) : points);
}

double lengthScale(const Curve& curve) {
  constexpr int kPerPiece = 32;
  const bool sampled = controlPoints(curve).empty();
  std::vector<Vec2> points = sampled ? sampledPoints(curve, kPerPiece) : controlPoints(curve);
  if (!sampled && isClosed(curve)) points.push_back(points.front());
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 side = points[i + 1] - points[i];
    length += std::hypot(side.x(), side.y());  // squares could vanish or overflow
  }
  return length;
}

double twiceSignedArea(const Curve& curve) {
  if (const BezierChain* chain = bezierForm(curve)) return twiceSignedArea(*chain);
  const Vec2 origin = pointAt(curve, 0.0);
  const std::vector<double> ends = stretchEnds(curve);
  constexpr int kParts = 4;
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const int piece = locate(curve, 0.5 * (ends[i] + ends[i + 1])).piece;
    const auto swept = [&](double t) {
      const Jet jet = jetAt(curve, piece, t - piece);
      return cross(jet.p - origin, jet.d1);
    };
    const double step = (ends[i + 1] - ends[i]) / kParts;
    for (int k = 0; k < kParts; ++k) {
      area += gauss(swept, ends[i] + k * step, ends[i] + (k + 1) * step).value;
    }
  }
  return area;
}

std::vector<CubicStretch> cubicsWithin(const Curve& curve, double tLow, double tHigh,
                                       double tolerance) {
  std::vector<CubicStretch> cubics;
  const std::vector<double> ends = stretchEnds(curve);
  const BezierChain* chain = bezierForm(curve);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double low = std::max(tLow, ends[i]), high = std::min(tHigh, ends[i + 1]);
    if (!(low < high)) continue;
    const int piece = locate(curve, 0.5 * (ends[i] + ends[i + 1])).piece;
    const double a = low - piece, b = high - piece;
    if (chain && chain->degree() <= 3) {
      Bezier part = chain->piece(piece);
      if (b < 1.0) part = splitAt(part, b).first;
      if (a > 0.0) part = splitAt(part, a / b).second;
      cubics.push_back({low, high, toCubics(part, tolerance).front()});
    } else {
      appendCubics(jetOnPiece(curve), piece, a, b, 1, tolerance, cubics);
    }
  }
  return cubics;
}

BezierChain drawnAs(const Curve& curve, double tolerance) {
  std::vector<Vec2> points;
  Vec2 last = Vec2::Zero();
  for (const CubicStretch& stretch : cubicsWithin(curve, 0.0, pieceCount(curve), tolerance)) {
    const std::vector<Vec2>& p = stretch.cubic.points;
    points.insert(points.end(), p.begin(), p.end() - 1);
    last = p.back();
  }
  if (!isClosed(curve)) points.push_back(last);
  return BezierChain(3, isClosed(curve), std::move(points));
}

std::vector<Vec2> sampledPoints(const Curve& curve, int perPiece) {
  const bool formula = std::holds_alternative<FormulaCurve>(curve);
  const int perStretch = formula ? std::max(perPiece / 8, 1) : perPiece;
  std::vector<Vec2> points;
  const std::vector<double> ends = stretchEnds(curve);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const int piece = locate(curve, 0.5 * (ends[i] + ends[i + 1])).piece;
    for (int k = i == 0 ? 0 : 1; k <= perStretch; ++k) {
      const double s = static_cast<double>(k) / perStretch;
      points.push_back(
          pointOn(curve, piece, (1.0 - s) * (ends[i] - piece) + s * (ends[i + 1] - piece)));
    }
  }
  return points;
}

namespace {

/// Bisects for (curve - p) . derivative = 0 between two parameters of one piece.
double perpendicularFoot(const Curve& curve, int piece, double low, double high, const Vec2& p) {
  const auto slope = [&](double t) {
    const Jet jet = jetAt(curve, piece, t);
    return (jet.p - p).dot(jet.d1);
  };
  constexpr int kHalvings = 52;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Between `at`, from where the distance to p falls towards `other`, and `other`, which is farther:
// a foot no farther than `at`, or what comes nearest to one.
double hiddenFoot(const Curve& curve, int piece, double at, double other, const Vec2& p) {
  constexpr int kHalvings = 52;
  double nearest = (pointOn(curve, piece, at) - p).norm();
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (at + other);
    const Jet jet = jetAt(curve, piece, middle);
    const double distance = (jet.p - p).norm(), slope = (jet.p - p).dot(jet.d1);
    if (distance <= nearest && (slope < 0.0) == (other < at)) {
      return perpendicularFoot(curve, piece, std::min(at, middle), std::max(at, middle), p);
    }
    if (distance < nearest) {
      at = middle;
      nearest = distance;
    } else {
      other = middle;
    }
  }
  return at;
}

}  // namespace

Nearest nearestPoint(const Curve& curve, const Vec2& p) {
  if (const BezierChain* chain = bezierForm(curve)) return nearestPoint(*chain, p);
  const int perStretch = std::holds_alternative<FormulaCurve>(curve) ? 4 : 32;
  const std::vector<double> ends = stretchEnds(curve);
  Nearest best{0.0, std::numeric_limits<double>::infinity()};
  const auto consider = [&](int piece, double t) {
    const double distance = (pointOn(curve, piece, t) - p).norm();
    if (distance < best.distance) best = {piece + t, distance};
  };
  struct Sample {
    double t, distance, slope;  // slope: sign of the distance's derivative by t
  };
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const int piece = locate(curve, 0.5 * (ends[i] + ends[i + 1])).piece;
    Sample before{};
    for (int k = 0; k <= perStretch; ++k) {
      const double s = static_cast<double>(k) / perStretch;
      const double t = (1.0 - s) * ends[i] + s * ends[i + 1] - piece;
      const Jet jet = jetAt(curve, piece, t);
      const Sample here{t, (jet.p - p).norm(), (jet.p - p).dot(jet.d1)};
      consider(piece, t);
      if (k > 0) {
        if (before.slope < 0.0 && here.slope >= 0.0) {
          consider(piece, perpendicularFoot(curve, piece, before.t, t, p));
        } else if (before.slope < 0.0 && here.distance >= before.distance) {
          consider(piece, hiddenFoot(curve, piece, before.t, t, p));
        } else if (here.slope > 0.0 && before.distance >= here.distance) {
          consider(piece, hiddenFoot(curve, piece, t, before.t, p));
        }
      }
      before = here;
    }
  }
  return best;
}

std::string kindName(const Curve& curve) {
  return std::visit(
      Overloaded{[](const BezierChain& chain) -> std::string {
                   return chain.pieceCount() == 1 && !chain.closed() ? "Bezier curve"
                                                                     : "Bezier chain";
                 },
                 [](const BSpline&) -> std::string { return "B-spline"; },
                 [](const RationalBezier&) -> std::string { return "rational Bezier"; },
                 [](const FormulaCurve& formula) -> std::string {
                   return formula.family() ? familyOf(*formula.family()).title : "formula";
                 }},
      curve);
}

}  // namespace flatland
