// SPDX-License-Identifier: MIT
#include "flatland/screen/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "flatland/features/viewed_arc.h"

namespace flatland {

namespace {

// Points of a part within this parameter distance of a mark are the mark's own neighbourhood: near
// a fold the depth changes with the square root of the screen coordinate, so rounding of the latter
// (1e-16) shifts the parameter by 1e-8.
constexpr double kSameParameter = 1e-7;

// Nearer to the viewer by less than this, relative to the scene's size, is the same place.
constexpr double kSameDepth = 1e-9;

// Images nearer than this, relative to the scene's size, are one: the rounding of a view direction.
constexpr double kSameImage = 1e-12;

// Between its cuts a formula is nearly a cubic. So many times as far off as it is where compared,
// and at least this, relative to the scene's size, it may be elsewhere.
constexpr double kSafety = 3.0;
constexpr double kLeastSlack = 1e-9;

}  // namespace

SightCurves::SightCurves(const Scene& scene) {
  const Bounds bounds = boundsOf(scene);
  if (bounds.diagonal() > 0.0) size = bounds.diagonal();
  for (const SceneCurve& each : scene.curves) {
    const Curve& curve = curves.emplace_back(each.shape);
    auto& own = pieces.emplace_back();
    auto& parts = stretches.emplace_back();

    if (const BezierChain* chain = bezierForm(curve)) {
      for (int i = 0; i < chain->pieceCount(); ++i) {
        own.push_back(chain->piece(i));
        parts.push_back({i + 0.0, i + 1.0, own.back().points, 0.0});
      }
    } else if (const auto* formula = std::get_if<FormulaCurve>(&curve)) {
      const std::vector<double>& ends = formula->cuts();
      for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double third = (ends[i + 1] - ends[i]) / 3.0;
        const int piece = locate(curve, 0.5 * (ends[i] + ends[i + 1])).piece;
        const Jet a = jetAt(curve, piece, ends[i] - piece);
        const Jet b = jetAt(curve, piece, ends[i + 1] - piece);
        Bezier cubic{{a.p, a.p + third * a.d1, b.p - third * b.d1, b.p}};
        // Where the speed is infinite there is no cubic; the chord is as good a one as any.
        if (!cubic.points[1].allFinite()) cubic.points[1] = a.p;
        if (!cubic.points[2].allFinite()) cubic.points[2] = b.p;
        double off = kLeastSlack * size;
        for (const double s : {0.15, 0.35, 0.5, 0.65, 0.85}) {
          const double t = ends[i] + s * (ends[i + 1] - ends[i]);
          off = std::max(off, (flatland::pointAt(curve, t) - pointAt(cubic, s)).norm());
        }
        parts.push_back({ends[i], ends[i + 1], std::move(cubic.points), kSafety * off});
      }
    } else {
      // A rational piece lies in the hull of its control points.
      const std::vector<Vec2>& points = controlPoints(curve);
      const auto degree = static_cast<std::size_t>(degreeOf(curve));
      for (int i = 0; i < flatland::pieceCount(curve); ++i) {
        parts.push_back({i + 0.0, i + 1.0, {}, 0.0});
        for (std::size_t k = 0; k <= degree; ++k) {
          parts.back().around.push_back(
              points[(static_cast<std::size_t>(i) * degree + k) % points.size()]);
        }
      }
    }
  }
}

Vec2 SightCurves::point(int curve, int piece, double t) const {
  const auto index = static_cast<std::size_t>(curve);
  if (pieces[index].empty()) return pointAt(curves[index], piece + t);
  return pointAt(pieces[index][static_cast<std::size_t>(piece)], t);
}

CurveSight::CurveSight(const SightCurves& curves, const View& view)
    : curves_(&curves), frame_(frameOf(view)), sameImage_(kSameImage * curves.size) {
  // An angle is rounded against 1, however far the viewer stands.
  if (frame_.distance) sameImage_ = kSameImage * std::max(curves.size / *frame_.distance, 1e-3);
}

double CurveSight::sameDepth() const { return kSameDepth * curves_->size; }

double CurveSight::depth(const Vec2& p) const {
  return frame_.distance ? *frame_.distance - p.dot(frame_.towards) : 1.0;
}

double CurveSight::image(const Vec2& p) const {
  return frame_.distance ? std::atan2(p.dot(frame_.axis), depth(p)) : p.dot(frame_.axis);
}

SightLine CurveSight::lineThrough(const Vec2& q) const {
  return {image(q), depth(q), q.dot(frame_.axis)};
}

SightLine CurveSight::lineAt(double image) const {
  if (!frame_.distance) return {image, 1.0, image};
  return {image, std::cos(image), std::sin(image)};
}

// Signed distance, on the screen, of the image of p from the line; in perspective multiplied by
// positive factors, so that it stays finite.
double CurveSight::beside(const Vec2& p, const SightLine& line) const {
  const double across = p.dot(frame_.axis);
  return frame_.distance ? across * line.along - line.up * depth(p) : across - line.up;
}

double CurveSight::nearestOf(int curve, int piece, double low, double high) const {
  const auto index = static_cast<std::size_t>(curve);
  double most = -std::numeric_limits<double>::infinity();
  const auto take = [&](const std::vector<Vec2>& points) {
    for (const Vec2& p : points) most = std::max(most, nearness(frame_, p));
  };
  const auto& own = curves_->pieces[index];
  if (!own.empty()) {
    const Bezier& whole = own[static_cast<std::size_t>(piece)];
    if (low == 0.0 && high == 1.0) {
      take(whole.points);
    } else {
      const Bezier start = high < 1.0 ? splitAt(whole, high).first : whole;
      take(low > 0.0 ? splitAt(start, low / high).second.points : start.points);
    }
    return most;
  }
  const auto& stretches = curves_->stretches[index];
  auto at = std::lower_bound(
      stretches.begin(), stretches.end(), piece + low,
      [](const SightCurves::Stretch& stretch, double t) { return stretch.high < t; });
  for (; at != stretches.end() && at->low <= piece + high; ++at) {
    double furthest = -std::numeric_limits<double>::infinity();
    for (const Vec2& p : at->around) furthest = std::max(furthest, nearness(frame_, p));
    most = std::max(most, furthest + at->slack);
  }
  return most;
}

void CurveSight::cut(int curve, int piece, std::vector<SightPart>& to) const {
  std::vector<double> cuts =
      foldCuts(curves_->curves[static_cast<std::size_t>(curve)], piece, frame_, curves_->size);
  cuts.insert(cuts.begin(), 0.0);
  cuts.push_back(1.0);
  const auto& stretches = curves_->stretches[static_cast<std::size_t>(curve)];
  auto next = std::upper_bound(
      stretches.begin(), stretches.end(), piece + 0.0,
      [](double t, const SightCurves::Stretch& stretch) { return t < stretch.high; });
  for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
    bool goesOn = false;
    for (double low = cuts[c]; low < cuts[c + 1];) {
      while (std::next(next) != stretches.end() && next->high - piece <= low) ++next;
      double high = std::min(cuts[c + 1], next->high - piece);
      if (!(high > low)) high = cuts[c + 1];
      const double nearest = nearestOf(curve, piece, low, high);
      const bool added = add(*next, curve, piece, low, high, nearest, to);
      if (added) to.back().goesOn = goesOn;
      goesOn = added;
      low = high;
    }
  }
}

bool CurveSight::add(const SightCurves::Stretch& stretch, int curve, int piece, double low,
                     double high, double nearest, std::vector<SightPart>& to) const {
  if (!(depth(curves_->point(curve, piece, 0.5 * (low + high))) > 0.0)) return false;  // behind
  const Vec2 atLow = curves_->point(curve, piece, low), atHigh = curves_->point(curve, piece, high);
  const auto imageAt = [&](const Vec2& p, double t, double inwards) {
    if (depth(p) > 0.0) return image(p);
    // Beside the viewer, to the side it comes from; at the viewer only its neighbours tell which.
    const Vec2 near = curves_->point(curve, piece, t + 1e-3 * inwards * (high - low));
    return std::copysign(0.5 * std::numbers::pi, near.dot(frame_.axis));
  };
  to.push_back({curve, piece, low, high, atLow, atHigh, imageAt(atLow, low, 1.0),
                imageAt(atHigh, high, -1.0), nearest, &stretch});
  return true;
}

bool CurveSight::isEndOn(const SightPart& part) const {
  return std::abs(part.atLow - part.atHigh) <= sameImage_;
}

double CurveSight::crossing(const SightPart& part, const SightLine& line) const {
  double a = part.low, b = part.high;
  double fa = beside(part.pointLow, line), fb = beside(part.pointHigh, line);
  if (fa == 0.0) return a;
  if (fb == 0.0) return b;
  // Illinois; the image is monotone, so the sign change is the only one.
  int stale = 0;
  for (int i = 0; i < 60 && b - a > 1e-14; ++i) {
    double t = i % 6 == 5 ? 0.5 * (a + b) : a - fa * (b - a) / (fb - fa);
    if (!(t > a && t < b)) t = 0.5 * (a + b);
    const double f = beside(point(part, t), line);
    if (f == 0.0) return t;
    if ((f > 0.0) == (fa > 0.0)) {
      if (t - a < 1e-15) return t;
      a = t, fa = f;
      if (stale == -1) fb *= 0.5;
      stale = -1;
    } else {
      if (b - t < 1e-15) return t;
      b = t, fb = f;
      if (stale == 1) fa *= 0.5;
      stale = 1;
    }
  }
  return 0.5 * (a + b);
}

double CurveSight::nearestOn(const SightPart& part, const SightLine& line) const {
  // The line cuts the hull between two of its points. Slack shifts them both ways.
  constexpr std::size_t kMost = 16;
  const std::vector<Vec2>& points = part.stretch->around;
  if (points.size() > kMost) return part.nearest;
  const double slack = part.stretch->slack;
  std::array<double, kMost> aside, near;
  for (std::size_t i = 0; i < points.size(); ++i) {
    aside[i] = beside(points[i], line);
    near[i] = nearness(frame_, points[i]);
  }
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(aside[i]) <= slack + sameImage_) most = std::max(most, near[i]);
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      if (aside[i] * aside[k] > 0.0 || aside[i] == aside[k]) continue;
      const double slope = (near[k] - near[i]) / (aside[k] - aside[i]);
      most = std::max(most, near[i] - aside[i] * slope + slack * std::abs(slope));
    }
  }
  // Perspective scales `aside`, and with it the slope the other way, but not the slack.
  if (frame_.distance && (slack > 0.0 || !std::isfinite(most))) return part.nearest;
  return std::min(part.nearest, most + slack);
}

bool CurveSight::hides(const SightPart& part, const Vec2& q, const SightLine& line) const {
  const double nearest = nearness(frame_, q) + sameDepth();
  if (!(part.nearest > nearest)) return false;
  const double slack = isEndOn(part) ? sameImage_ : 0.0;
  if (line.image < std::min(part.atLow, part.atHigh) - slack ||
      line.image > std::max(part.atLow, part.atHigh) + slack) {
    return false;
  }
  if (isEndOn(part)) {
    return std::max(nearness(frame_, part.pointLow), nearness(frame_, part.pointHigh)) > nearest;
  }
  // Points at the viewer's own depth or behind it do not hide anything.
  if (!(nearestOn(part, line) > nearest)) return false;
  const Vec2 p = point(part, crossing(part, line));
  return depth(p) > 0.0 && nearness(frame_, p) > nearest;
}

bool CurveSight::isOn(const SightPart& part, int curve, double t) const {
  if (part.curve != curve) return false;
  const auto near = [&](double x) {
    return x >= part.piece + part.low - kSameParameter &&
           x <= part.piece + part.high + kSameParameter;
  };
  const Curve& shape = curves_->curves[static_cast<std::size_t>(curve)];
  const double period = pieceCount(shape);
  return near(t) || (isClosed(shape) && (near(t - period) || near(t + period)));
}

}  // namespace flatland
