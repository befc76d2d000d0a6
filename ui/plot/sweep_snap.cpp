// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sweep_snap.h"

#include <algorithm>
#include <cmath>

namespace flatland::ui {

namespace {

// An event this near is the one the view is at: a view that was set to it may have been rounded.
constexpr double kSameAngleDeg = 1e-6;

/// `angleDeg` plus whole half turns, into [low, low + 180).
double halfTurnFrom(double low, double angleDeg) {
  return angleDeg + 180.0 * std::ceil((low - angleDeg) / 180.0);
}

/// To a power of ten that no pixel can tell from the exact value: at most a tenth of one.
double rounded(double value, double pixel) {
  const double unit = std::pow(10.0, std::floor(std::log10(pixel)) - 1.0);
  return std::round(value / unit) * unit;
}

}  // namespace

const SweepEvent* foldNear(const SweepData& data, const SweepAxes& axes, const Vec2& px,
                           double reachPx) {
  const SweepEvent* nearest = nullptr;
  double best = reachPx;
  for (const SweepEvent& event : data.sweep.events) {
    if (event.what != SweepEvent::What::Fold) continue;
    const double y = axes.y(event.curve, event.u);
    for (const double turn : {-180.0, 0.0, 180.0}) {
      const double distance = (px - Vec2(axes.x(event.angleDeg + turn), y)).norm();
      if (distance <= best) best = distance, nearest = &event;
    }
  }
  return nearest;
}

std::optional<SweepAxes::Place> snappedPlace(const SweepData& data, const SweepAxes& axes,
                                             const Vec2& px, double reachPx) {
  std::optional<SweepAxes::Place> place = axes.placeAt(px);
  if (!place) return place;
  if (const SweepEvent* fold = foldNear(data, axes, px, reachPx)) {
    return SweepAxes::Place{halfTurnFrom(place->angleDeg - 90.0, fold->angleDeg), fold->curve,
                            fold->u};
  }
  const double pixelDeg =
      (axes.window().angleHigh - axes.window().angleLow) / (axes.box().right - axes.box().left);
  place->angleDeg = rounded(place->angleDeg, pixelDeg);
  double best = reachPx;
  const auto consider = [&](int curve, double u) {
    const double distance = std::abs(axes.y(curve, u) - px.y());
    if (distance <= best) best = distance, place->curve = curve, place->u = u;
  };
  for (const SweepLine& line : data.sweep.lines) consider(line.curve, line.u);
  for (const SweepBranch& branch : data.sweep.branches) {
    for (std::size_t i = 0; i + 1 < branch.points.size(); ++i) {
      const SweepPoint &a = branch.points[i], &b = branch.points[i + 1];
      const double low = std::min(a.angleDeg, b.angleDeg);
      const double angle = halfTurnFrom(low, place->angleDeg);
      if (angle > std::max(a.angleDeg, b.angleDeg)) continue;
      const double share =
          a.angleDeg == b.angleDeg ? 0.0 : (angle - a.angleDeg) / (b.angleDeg - a.angleDeg);
      consider(branch.curve, a.u + share * (b.u - a.u));
    }
  }
  return place;
}

std::optional<double> nextEventDeg(const Sweep& sweep, double nearDeg, int step) {
  std::optional<double> best;
  for (const SweepEvent& event : sweep.events) {
    // How far ahead, in (0, 180].
    double ahead = step * (event.angleDeg - nearDeg);
    ahead -= 180.0 * std::floor(ahead / 180.0);
    if (ahead < kSameAngleDeg || 180.0 - ahead < kSameAngleDeg) continue;
    const double angle = nearDeg + step * ahead;
    if (!best || ahead < std::abs(*best - nearDeg)) best = angle;
  }
  return best;
}

}  // namespace flatland::ui
