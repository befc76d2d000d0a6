// SPDX-License-Identifier: MIT
#include "core3d/draw/stroke_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flatland {
namespace {

using Eigen::Vector2d;

constexpr double kStepPx = 6.0;        // between points where width varies
constexpr double kTaperSteps = 8.0;    // points of a taper
constexpr double kSmoothingPx = 8.0;   // strength is averaged over so much to either side
constexpr double kSharpCosine = 0.5;   // bends by more than 60 degrees get cut corners
constexpr double kSamePlacePx = 1e-9;  // points nearer than that are one

struct Walk {
  std::vector<Vector2d> at;
  std::vector<double> strength, along;  // a closed walk ends where it began
};

Walk walkAlong(const Polyline& line) {
  Walk walk;
  const std::size_t n = line.screen.size();
  for (std::size_t i = 0; i < n + (line.closed ? 1 : 0); ++i) {
    const Vector2d& p = line.screen[i % n];
    const double step = walk.at.empty() ? 0.0 : (p - walk.at.back()).norm();
    if (!walk.at.empty() && step <= kSamePlacePx) continue;
    walk.along.push_back(walk.at.empty() ? 0.0 : walk.along.back() + step);
    walk.at.push_back(p);
    walk.strength.push_back(static_cast<double>(line.strength[i % n]));
  }
  return walk;
}

// A value that is linear between the points of a walk, and its integral from the start.
struct Profile {
  const std::vector<double>& along;
  const std::vector<double>& value;
  std::vector<double> integral = {0.0};

  Profile(const std::vector<double>& places, const std::vector<double>& values)
      : along(places), value(values) {
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      integral.push_back(integral.back() +
                         (along[i + 1] - along[i]) * (value[i] + value[i + 1]) / 2.0);
    }
  }
  double integralTo(double place) const {
    const auto after = std::upper_bound(along.begin(), along.end() - 1, place);
    const auto i = static_cast<std::size_t>(after - along.begin()) - 1;
    if (i + 1 >= along.size()) return integral.back();
    const double size = along[i + 1] - along[i], share = (place - along[i]) / size;
    const double here = value[i] + share * (value[i + 1] - value[i]);
    return integral[i] + share * size * (value[i] + here) / 2.0;
  }
  // Over the window around a place, cut at the ends or continued round.
  double mean(double place, bool closed) const {
    const double length = along.back(), half = std::min(kSmoothingPx, length / 2.0);
    double from = place - half, to = place + half, more = 0.0;
    if (closed && from < 0.0) {
      more = integral.back() - integralTo(from + length);
      from = 0.0;
    } else if (closed && to > length) {
      more = integralTo(to - length);
      to = length;
    } else {
      from = std::max(from, 0.0);
      to = std::min(to, length);
      return (integralTo(to) - integralTo(from)) / (to - from);
    }
    return (integralTo(to) - integralTo(from) + more) / (2.0 * half);
  }
};

// Places of a walk, its points among them, none farther apart than asked for there.
std::vector<double> placesOf(const Walk& walk, double taper) {
  const double length = walk.along.back();
  std::vector<double> places = {0.0};
  for (std::size_t i = 1; i < walk.along.size(); ++i) {
    while (true) {
      const double now = places.back();
      const bool tapers = now < taper || now + taper / kTaperSteps > length - taper;
      const double step = taper > 0.0 && tapers ? std::min(kStepPx, taper / kTaperSteps) : kStepPx;
      if (walk.along[i] - now <= 1.25 * step) break;
      places.push_back(now + step);
    }
    places.push_back(walk.along[i]);
  }
  return places;
}

Vector2d unitStep(const Vector2d& from, const Vector2d& to) {
  return (to - from).stableNormalized();
}

Vector2d leftOf(const Vector2d& t) { return {t.y(), -t.x()}; }  // px run down

}  // namespace

StrokeShape shapeOf(const Polyline& line, const StrokeStyle& style, double weak, double strong) {
  StrokeShape shape;
  shape.closed = line.closed;
  const Walk walk = walkAlong(line);
  const bool varies = weak < strong && (style.leastWidth < 1.0 || style.leastDarkness < 1.0);
  const bool tapers = style.taperPx > 0.0 && !line.closed;
  if (walk.at.size() < 2 || !(varies || tapers)) {
    shape.centre = line.screen;
    shape.widthPx.assign(line.screen.size(), style.widthPx);
    shape.darkness.assign(line.screen.size(), 1.0);
    return shape;
  }
  shape.uniform = false;
  const double length = walk.along.back();
  const double taper = tapers ? std::min(style.taperPx, length / 3.0) : 0.0;
  const Profile strength(walk.along, walk.strength);
  std::size_t i = 0;
  for (const double place : placesOf(walk, taper)) {
    if (line.closed && place >= length) break;
    while (i + 2 < walk.along.size() && walk.along[i + 1] <= place) ++i;
    const double share = (place - walk.along[i]) / (walk.along[i + 1] - walk.along[i]);
    shape.centre.push_back(walk.at[i] + share * (walk.at[i + 1] - walk.at[i]));
    double level = 1.0;
    if (varies) {
      const double root = std::sqrt(std::max(strength.mean(place, line.closed), 0.0));
      const double low = std::sqrt(std::max(weak, 0.0)), high = std::sqrt(strong);
      level = std::clamp((root - low) / (high - low), 0.0, 1.0);
    }
    const double end = std::min(place, length - place);
    const double rest = tapers && end < taper ? 1.0 - end / taper : 0.0;
    shape.widthPx.push_back(style.widthPx * (1.0 - rest * rest) *
                            (style.leastWidth + (1.0 - style.leastWidth) * level));
    shape.darkness.push_back(style.leastDarkness + (1.0 - style.leastDarkness) * level);
  }
  return shape;
}

std::vector<std::vector<Vector2d>> outlineOf(const StrokeShape& shape) {
  const std::size_t n = shape.centre.size();
  if (n < 2) return {};
  std::vector<Vector2d> left, right;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d& p = shape.centre[i];
    const bool first = !shape.closed && i == 0, last = !shape.closed && i + 1 == n;
    const Vector2d before =
        first ? unitStep(p, shape.centre[i + 1]) : unitStep(shape.centre[(i + n - 1) % n], p);
    const Vector2d after = last ? before : unitStep(p, shape.centre[(i + 1) % n]);
    const double half = shape.widthPx[i] / 2.0;
    if (before.dot(after) > kSharpCosine) {
      const Vector2d side = leftOf((before + after).normalized());
      const double mitre = half / side.dot(leftOf(after));
      left.push_back(p + mitre * side);
      right.push_back(p - mitre * side);
    } else {
      for (const Vector2d& t : {before, after}) {
        left.push_back(p + half * leftOf(t));
        right.push_back(p - half * leftOf(t));
      }
    }
  }
  std::reverse(right.begin(), right.end());
  if (shape.closed) return {left, right};
  left.insert(left.end(), right.begin(), right.end());
  return {left};
}

}  // namespace flatland
