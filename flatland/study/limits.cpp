// SPDX-License-Identifier: MIT
#include "flatland/study/limits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "flatland/features/features.h"
#include "flatland/features/terms.h"

namespace flatland {

namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr int kPerDecade = 10;
constexpr int kWalkPerDecade = 20;  // of the parameter, whose square the length is at a cusp

// How far each way goes. Below, rounding (1e-16 of n.w or of the curve's length) would be seen in
// the slope.
constexpr double kSmallestNw = 1e-6;
constexpr double kLeastNw = 1e-9;        // Walk: smaller ones have lost half their digits
constexpr double kLeastLength = 1e-7;    // Walk: of the curve's length
constexpr double kLongestWalk = 0.25;    // of the curve's length
constexpr double kLargestSlide = 0.2;    // radians
constexpr double kSmallestSlide = 1e-9;  // radians

// Without dimension, by the curve's length: smaller ones are zeros that rounding moved.
constexpr double kZeroCurvature = 1e-7;
constexpr double kSeenAlong = 1e-7;
constexpr double kCuspTurnDeg = 179.999;

double crossOf(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

const Curve& shapeOf(const Scene& scene, int curve) {
  return scene.curves[static_cast<std::size_t>(curve)].shape;
}

double lengthOf(const Curve& shape) {
  double polygon = 0.0;
  constexpr int kSteps = 64;
  const double end = pieceCount(shape);
  Vec2 last = pointAt(shape, 0.0);
  for (int i = 1; i <= kSteps; ++i) {
    const Vec2 next = pointAt(shape, end * i / kSteps);
    polygon += (next - last).norm();
    last = next;
  }
  return polygon > 0.0 ? arcLength(shape, 0.0, end, 1e-10 * polygon).value : 0.0;
}

// Arc length between near parameters, to a relative accuracy that arcLength, which is absolute,
// does not promise: Gauss with five points, exact for a speed that is linear as at a cusp.
double shortLength(const Curve& shape, int piece, double a, double b) {
  constexpr std::array<double, 3> kNodes = {0.0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> kWeights = {0.5688888888888889, 0.4786286704993665,
                                              0.2369268850561891};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = kWeights[0] * jetAt(shape, piece, middle).d1.norm();
  for (std::size_t i = 1; i < kNodes.size(); ++i) {
    sum += kWeights[i] * (jetAt(shape, piece, middle - half * kNodes[i]).d1.norm() +
                          jetAt(shape, piece, middle + half * kNodes[i]).d1.norm());
  }
  return std::abs(half * sum);
}

std::vector<double> logSteps(double from, double to, int perDecade = kPerDecade) {
  std::vector<double> steps;
  const int count = static_cast<int>(std::floor(std::log10(from / to) * perDecade + 1e-9));
  for (int i = 0; i <= count; ++i) {
    steps.push_back(from * std::pow(10.0, -static_cast<double>(i) / perDecade));
  }
  return steps;
}

// What the searches of a slide may cost in evaluations of formulas: over the whole curve, and where
// that is too dear near its end. There the marks stand so close that an evaluation comes with ten
// times its own work.
constexpr std::uint64_t kMostForWhole = 2'000'000, kMostForNear = 600'000;

// The angles of a slide, two searches each, when one search costs so much: all of them, or fewer
// and not so far down.
std::vector<double> slideSteps(std::uint64_t cost, std::uint64_t most) {
  constexpr int kFewestPerDecade = 4;  // what a fit needs
  constexpr double kFewestDecades = 1.5;
  std::vector<double> all = logSteps(kLargestSlide, kSmallestSlide);
  if (2 * all.size() * cost <= most) return all;
  const double decades = static_cast<double>(most / cost) / (2.0 * kFewestPerDecade);
  const double smallest = kLargestSlide * std::pow(10.0, -std::max(decades, kFewestDecades));
  return logSteps(kLargestSlide, std::max(smallest, kSmallestSlide), kFewestPerDecade);
}

LimitLaw law(LimitQuantity quantity, std::optional<double> order,
             std::optional<double> coefficient) {
  return {quantity, order, coefficient, {}, std::nullopt};
}

// Values of the four laws of a way on which the terms are read.
void addTerms(LimitSeries& series, double x, const Terms& terms) {
  series.x.push_back(x);
  const double feature = std::abs(terms.feature), offset = std::abs(terms.offset);
  // With the common factor k divided out, so that an inflection is no 0 / 0.
  const double ratio = std::abs(terms.k * terms.k * terms.tw) / std::abs(terms.nw * terms.kPrime);
  for (LimitLaw& each : series.laws) {
    switch (each.quantity) {
      case LimitQuantity::Lambda:
        each.values.push_back(terms.lambda.value_or(kNone));
        break;
      case LimitQuantity::Feature:
        each.values.push_back(feature);
        break;
      case LimitQuantity::Offset:
        each.values.push_back(offset);
        break;
      default:
        each.values.push_back(std::isfinite(ratio) ? ratio : kNone);
    }
  }
}

void fitLastDecade(LimitSeries& series) {
  if (series.x.empty()) return;
  const double low = series.x.back();
  for (LimitLaw& each : series.laws) {
    each.fit = fitLogLog(series.x, each.values, low * (1.0 - 1e-9), 10.0 * low * (1.0 + 1e-9));
  }
}

// A coefficient that is zero is no law.
LimitLaw lawUnlessZero(LimitQuantity quantity, double order, double coefficient) {
  const bool isLaw = coefficient > 0.0 && std::isfinite(coefficient);
  return isLaw ? law(quantity, order, coefficient) : law(quantity, std::nullopt, std::nullopt);
}

std::vector<LimitLaw> laws(double lambdaOrder, double lambda, double featureOrder, double feature,
                           double offsetOrder, double offset) {
  return {lawUnlessZero(LimitQuantity::Lambda, lambdaOrder, lambda),
          lawUnlessZero(LimitQuantity::Feature, featureOrder, feature),
          lawUnlessZero(LimitQuantity::Offset, offsetOrder, offset),
          lawUnlessZero(LimitQuantity::Ratio, offsetOrder - featureOrder, offset / feature)};
}

/// The end of a walk, and the laws that hold there (docs/math/limits.md).
struct End {
  int piece;
  double t;  // of the piece
  LimitCase limitCase;
  std::vector<LimitLaw> laws;
};

End cuspEnd(const Jet& jet, const ViewFrame& frame) {
  End end{};
  // k = a s^(-1/2) with the tangent along the second derivative.
  const double d2 = jet.d2.norm();
  const double a =
      std::abs(crossOf(jet.d2, jet.d3)) / (2.0 * std::numbers::sqrt2 * d2 * d2 * std::sqrt(d2));
  const double nw = std::abs(crossOf(jet.d2, frame.towards)) / d2;
  const double tw = std::abs(jet.d2.dot(frame.towards)) / d2;
  if (nw < kSeenAlong) {
    end.limitCase = LimitCase::CuspSeenAlong;
    end.laws = laws(-2.0, 0.25, -1.5, a * a * a, -1.5, a * a * a);
  } else {
    end.limitCase = LimitCase::CuspSeenAcross;
    end.laws = laws(-1.0, a * a / (nw * nw), -2.0, 0.5 * nw * a * a, -1.5, a * a * a * tw);
  }
  return end;
}

End endAt(const Curve& shape, int piece, double t, const ViewFrame& frame, double length) {
  const Jet jet = jetAt(shape, piece, t);
  End end{};
  const double size = jet.d2.norm() + jet.d3.norm();
  if (jet.d1.norm() <= 1e-7 * size) {
    end = cuspEnd(jet, frame);
  } else {
    const Frame f = frameOf(jet);
    const double k = std::abs(f.k), c = std::abs(f.kPrime);
    if (k * length > kZeroCurvature) {
      end.limitCase = LimitCase::OrdinarySilhouette;
      end.laws = laws(-2.0, 1.0, 1.0, k * k * c, 0.0, k * k * k);
    } else if (c * length * length > kZeroCurvature) {
      end.limitCase = LimitCase::SilhouetteAtInflection;
      end.laws = laws(-2.0, 4.0, 3.0, 0.5 * c * c * c, 3.0, c * c * c);
    } else {
      end.limitCase = LimitCase::HigherContact;
      end.laws = {law(LimitQuantity::Lambda, -2.0, std::nullopt),
                  law(LimitQuantity::Feature, std::nullopt, std::nullopt),
                  law(LimitQuantity::Offset, std::nullopt, std::nullopt),
                  law(LimitQuantity::Ratio, 0.0, std::nullopt)};
    }
  }
  end.piece = piece;
  end.t = t;
  return end;
}

/// Where a way begins: the curve alone, seen from infinitely far away, and the point's place.
struct Start {
  Scene seen;
  Curve shape;
  double length, u;

  /// Arc length along the curve, on a closed one the shorter way around.
  double between(double u1, double u2) const {
    const double gap = std::abs(u1 - u2);
    return isClosed(shape) ? std::min(gap, length - gap) : gap;
  }
  double wayTo(const Mark& mark) const { return between(u, mark.u); }
};

// The mark to walk to. At an inflection seen along its tangent the image does not fold, so the
// silhouette there is known by the inflection.
const Mark* nearestEnd(const Start& start, const std::vector<Mark>& marks,
                       const std::vector<Terms>& terms) {
  const Mark* best = nullptr;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const Mark& mark = marks[i];
    const bool cusp = mark.kind == MarkKind::Corner && std::abs(mark.turnDeg) > kCuspTurnDeg;
    const bool alongInflection =
        mark.kind == MarkKind::Inflection && std::abs(terms[i].nw) < kSeenAlong;
    if (mark.kind != MarkKind::Silhouette && !cusp && !alongInflection) continue;
    if (!best || start.wayTo(mark) < start.wayTo(*best)) best = &mark;
  }
  return best;
}

std::optional<Terms> termsIfRegular(const Jet& jet, const ViewFrame& frame) {
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  return termsAt(jet, frame, 1);
}

// nullopt if the curve is a point.
std::optional<Start> startAt(const Scene& scene, int curve, double t) {
  Start start{scene, shapeOf(scene, curve), 0.0, 0.0};
  start.seen.view.distance.reset();
  start.seen.curves = {scene.curves[static_cast<std::size_t>(curve)]};
  start.length = lengthOf(start.shape);
  if (!(start.length > 0.0)) return std::nullopt;
  start.u = arcLength(start.shape, 0.0, t, 1e-10 * start.length).value;
  return start;
}

// The shortest text that is read as this number again.
std::string textOf(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// What a slide searches: the whole curve, or what is near its end.
struct SlideField {
  Scene seen;
  double u;  ///< where the slide ends
};

// A typed formula alone from nearly the second inflection before the mark to the second after it.
// `inflections` are in order of t, the mark among them.
std::optional<SlideField> fieldAround(const Start& start, const std::vector<Mark>& inflections,
                                      const Mark& mark) {
  const auto* formula = std::get_if<FormulaCurve>(&start.shape);
  if (!formula || !formula->typed()) return std::nullopt;
  const auto here = std::find_if(inflections.begin(), inflections.end(),
                                 [&](const Mark& each) { return each.t == mark.t; });
  const bool first = here - inflections.begin() < 2;
  const bool last = inflections.end() - here <= 2;
  if (isClosed(start.shape) && (first || last)) return std::nullopt;  // the way may cross the seam
  // Neither to the very inflection nor as far to both sides: a zero at an end, or in the middle
  // where stretches are halved, is dear.
  const auto towards = [&](std::ptrdiff_t side, double share) {
    return (here + side)->t + share * ((here + 2 * side)->t - (here + side)->t);
  };
  const double low = first ? 0.0 : towards(-1, 0.7), high = last ? 1.0 : towards(1, 0.8);

  TypedFormula part = *formula->typed();
  const auto valueOf = [&](const std::string& text) {
    const auto parsed = Expression::parse(text, part.constants, false);
    return parsed.expression ? parsed.expression->at(Taylor<0>(0.0)).value() : kNone;
  };
  const double from = valueOf(part.from), to = valueOf(part.to);
  part.from = textOf(from + low * (to - from));
  part.to = textOf(from + high * (to - from));
  const auto made = FormulaCurve::make(part, formula->at());
  if (!made.curve) return std::nullopt;
  SlideField field{start.seen, arcLength(start.shape, low, mark.t, 1e-12 * start.length).value};
  field.seen.curves[0].shape = *made.curve;
  return field;
}

}  // namespace

std::string_view nameOf(LimitExperiment experiment) {
  constexpr std::array<std::string_view, 3> kNames = {"turn", "walk", "slide"};
  return kNames[static_cast<std::size_t>(experiment)];
}

std::string_view nameOf(LimitCase limitCase) {
  constexpr std::array<std::string_view, 7> kNames = {
      "fixed-point",    "ordinary-silhouette", "silhouette-at-inflection",
      "higher-contact", "cusp-seen-across",    "cusp-seen-along",
      "merging"};
  return kNames[static_cast<std::size_t>(limitCase)];
}

std::string_view nameOf(LimitQuantity quantity) {
  constexpr std::array<std::string_view, 6> kNames = {
      "lambda", "feature", "offset", "ratio", "ridge-distance", "silhouette-distance"};
  return kNames[static_cast<std::size_t>(quantity)];
}

std::optional<LogLogFit> fitLogLog(const std::vector<double>& x, const std::vector<double>& y,
                                   double xLow, double xHigh) {
  std::vector<Vec2> points;
  LogLogFit fit{0.0, 0.0, 0.0, xHigh, xLow, 0};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < xLow || x[i] > xHigh || !(y[i] > 0.0) || !std::isfinite(y[i])) continue;
    points.emplace_back(std::log(x[i]), std::log(y[i]));
    fit.xLow = std::min(fit.xLow, x[i]);
    fit.xHigh = std::max(fit.xHigh, x[i]);
  }
  fit.points = static_cast<int>(points.size());
  if (fit.points < 4) return std::nullopt;
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p / fit.points;
  double xx = 0.0, xy = 0.0, residual = 0.0;
  for (const Vec2& p : points) {
    xx += (p.x() - mean.x()) * (p.x() - mean.x());
    xy += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  fit.slope = xy / xx;
  for (const Vec2& p : points) {
    const double miss = p.y() - mean.y() - fit.slope * (p.x() - mean.x());
    residual += miss * miss;
  }
  fit.slopeError = std::sqrt(residual / (fit.points - 2) / xx);
  fit.coefficient = std::exp(mean.y() - fit.slope * mean.x());
  return fit;
}

std::optional<LimitSeries> turnToSilhouette(const Scene& scene, int curve, double t) {
  const Curve& shape = shapeOf(scene, curve);
  const Jet jet = jetAt(shape, t);
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  const Frame f = frameOf(jet);
  LimitSeries series{LimitExperiment::Turn, LimitCase::FixedPoint, curve, t, 0.0, 0.0, {}, {}};
  series.u = arcLength(shape, 0.0, t, 1e-10 * std::max(lengthOf(shape), 1e-300)).value;
  series.angleDeg = std::atan2(f.tangent.y(), f.tangent.x()) * kDegPerRad;
  const double k = std::abs(f.k), c = std::abs(f.kPrime);
  series.laws = laws(-2.0, k * k, 1.0, k * c, 0.0, k * k * k);
  for (const double nw : logSteps(1.0, kSmallestNw)) {
    const Vec2 w = nw * f.normal + std::sqrt((1.0 - nw) * (1.0 + nw)) * f.tangent;
    addTerms(series, nw, termsAt(jet, ViewFrame{-rotateCcw(w), w, std::nullopt}, 1));
  }
  fitLastDecade(series);
  return series;
}

std::optional<LimitSeries> walkToSilhouette(const Scene& scene, int curve, double t) {
  const auto start = startAt(scene, curve, t);
  if (!start) return std::nullopt;
  const Scene& seen = start->seen;
  const Curve& shape = start->shape;
  const double length = start->length;
  const ViewFrame frame = frameOf(seen.view);
  const FeatureSet features = findFeatures(seen);
  std::vector<Terms> terms;
  for (const Mark& mark : features.marks) {
    const Jet jet = jetAt(shapeOf(seen, mark.curve), mark.t);
    terms.push_back(termsIfRegular(jet, frame).value_or(Terms{}));
  }
  const Mark* mark = nearestEnd(*start, features.marks, terms);
  if (!mark) return std::nullopt;
  // The side from which the point comes, on the piece that lies there.
  const bool before = t < mark->t || (t == mark->t && mark->t >= pieceCount(shape));
  const bool overSeam = isClosed(shape) && std::abs(mark->u - start->u) > 0.5 * length;
  const double side = before != overSeam ? -1.0 : 1.0;
  double markT = mark->t;
  if (overSeam && side < 0.0 && markT == 0.0) markT = pieceCount(shape);
  if (overSeam && side > 0.0 && markT == pieceCount(shape)) markT = 0.0;
  int piece = static_cast<int>(std::floor(markT));
  if (piece > 0 && markT == piece && (side < 0.0 || piece == pieceCount(shape))) --piece;
  const double end = markT - piece;
  const End target = endAt(shape, piece, end, frame, length);
  const double room = side < 0.0 ? end : 1.0 - end;
  if (!(room > 0.0)) return std::nullopt;
  LimitSeries series{LimitExperiment::Walk,
                     target.limitCase,
                     curve,
                     mark->t,
                     mark->u,
                     seen.view.angleDeg,
                     {},
                     target.laws};
  for (const double step : logSteps(room, 1e-9 * room, kWalkPerDecade)) {
    const double at = end + side * step;
    const double s = step > 1e-3
                         ? std::abs(arcLength(shape, piece + end, piece + at, 1e-12 * length).value)
                         : shortLength(shape, piece, end, at);
    if (s > kLongestWalk * length) continue;
    if (s < kLeastLength * length) break;
    const auto here = termsIfRegular(jetAt(shape, piece, at), frame);
    if (!here) continue;
    if (std::abs(here->nw) < kLeastNw) break;
    addTerms(series, s, *here);
  }
  if (series.x.empty()) return std::nullopt;
  fitLastDecade(series);
  return series;
}

std::optional<LimitSeries> slideIntoSilhouette(const Scene& scene, int curve, double t,
                                               const std::function<bool()>& goOn) {
  auto start = startAt(scene, curve, t);
  if (!start) return std::nullopt;
  Scene& seen = start->seen;
  const Curve& shape = start->shape;
  const double length = start->length;
  std::optional<Mark> at;
  std::vector<Mark> inflections;
  std::uint64_t cost = FormulaCurve::evaluations();
  for (const Mark& mark : findFeatures(seen).marks) {
    if (mark.kind != MarkKind::Inflection) continue;
    inflections.push_back(mark);
    if (!at || start->wayTo(mark) < start->wayTo(*at)) at = mark;
  }
  cost = FormulaCurve::evaluations() - cost;
  if (!at) return std::nullopt;
  const Jet jet = jetAt(shape, at->t);
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  const Frame f = frameOf(jet);
  const double c = std::abs(f.kPrime);
  if (!(c * length * length > kZeroCurvature)) return std::nullopt;
  const double along = std::atan2(f.tangent.y(), f.tangent.x()) * kDegPerRad;
  LimitSeries series{
      LimitExperiment::Slide, LimitCase::Merging, curve, at->t, at->u, along, {}, {}};
  series.laws = {law(LimitQuantity::RidgeDistance, 0.5, std::sqrt(2.0 / c)),
                 law(LimitQuantity::SilhouetteDistance, 0.5, std::sqrt(2.0 / c))};
  // With the left normal, the branch turns counter-clockwise by k' s^2 / 2 (docs/math/limits.md).
  const double turn = f.kPrime > 0.0 ? 1.0 : -1.0;
  SlideField field{seen, at->u};
  std::vector<double> angles = slideSteps(cost, kMostForWhole);
  bool whole = true;
  if (angles.size() < slideSteps(0, kMostForWhole).size()) {
    if (auto near = fieldAround(*start, inflections, *at)) {
      field = std::move(*near);
      whole = false;
      cost = FormulaCurve::evaluations();
      findFeatures(field.seen);
      angles = slideSteps(FormulaCurve::evaluations() - cost, kMostForNear);
    }
  }
  const auto nearest = [&](MarkKind kind, double angleDeg) {
    field.seen.view.angleDeg = normalizedDeg(angleDeg);
    double best = kNone;
    for (const Mark& mark : findFeatures(field.seen).marks) {
      if (mark.kind != kind) continue;
      const double way = whole ? start->between(mark.u, field.u) : std::abs(mark.u - field.u);
      if (!(way >= best)) best = way;
    }
    return best;
  };
  for (const double angle : angles) {
    if (goOn && !goOn()) return std::nullopt;
    series.x.push_back(angle);
    const double step = turn * angle * kDegPerRad;
    series.laws[0].values.push_back(nearest(MarkKind::ApparentRidge, along + step));
    series.laws[1].values.push_back(nearest(MarkKind::Silhouette, along - step));
  }
  fitLastDecade(series);
  return series;
}

std::optional<ForeshortenedTerms> foreshortenedTerms(const Scene& scene, int curve, double t) {
  constexpr double kAtSilhouette = 1e-12;
  const Jet jet = jetAt(shapeOf(scene, curve), t);
  if (!(jet.d1.squaredNorm() > 0.0)) return std::nullopt;
  const Terms terms = termsAt(jet, frameOf(scene.view), 1);
  const double nw = std::abs(terms.nw);
  return ForeshortenedTerms{nw, std::abs(terms.feature), std::abs(terms.offset),
                            nw < kAtSilhouette ? std::nullopt : terms.lambda};
}

double angleDegWithForeshortening(const Vec2& tangent, double nw, double nearDeg) {
  const Vec2 w = frameOf(View{nearDeg, std::nullopt}).towards;
  const Vec2 left = rotateCcw(tangent);
  const Vec2 normal = left.dot(w) < 0.0 ? Vec2(-left) : left;
  const Vec2 along = tangent.dot(w) < 0.0 ? Vec2(-tangent) : tangent;
  const Vec2 wanted = nw * normal + std::sqrt((1.0 - nw) * (1.0 + nw)) * along;
  return std::atan2(wanted.y(), wanted.x()) * kDegPerRad;
}

}  // namespace flatland
