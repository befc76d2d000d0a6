// SPDX-License-Identifier: MIT
#include "flatland/screen/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <vector>

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

// Samples between two possible changes of visibility, to catch where curves cross.
constexpr int kSamples = 16;

/// A stretch of a piece whose image on the screen does not fold: each line of sight meets it once.
struct Part {
  int curve;
  int piece;
  double low, high;      ///< local parameter
  double atLow, atHigh;  ///< screen coordinate at the ends; infinite where the image runs off
};

}  // namespace

struct Visibility::Parts {
  ViewFrame frame;
  std::vector<Curve> curves;
  std::vector<std::vector<Bezier>> pieces;  ///< of each curve that has a Bezier form
  std::vector<Part> parts;
  double size = 1.0;
  std::mutex mutex;  ///< for the intervals, found when first asked for
  std::vector<std::optional<std::vector<Interval>>> intervals;

  Vec2 point(const Part& part, double t) const {
    const auto curve = static_cast<std::size_t>(part.curve);
    if (pieces[curve].empty()) return pointAt(curves[curve], part.piece + t);
    return pointAt(pieces[curve][static_cast<std::size_t>(part.piece)], t);
  }

  double depth(const Vec2& p) const {
    return frame.distance ? *frame.distance - p.dot(frame.towards) : 1.0;
  }

  // Signed distance, on the screen, of the image of p from the line of sight through q; in
  // perspective multiplied by both (positive) depths, so that it stays finite.
  double beside(const Vec2& p, const Vec2& q) const {
    if (!frame.distance) return (p - q).dot(frame.axis);
    return p.dot(frame.axis) * depth(q) - q.dot(frame.axis) * depth(p);
  }

  void add(int index, const Curve& curve) {
    curves.push_back(curve);
    auto& own = pieces.emplace_back();
    if (const BezierChain* chain = bezierForm(curve)) {
      for (int i = 0; i < chain->pieceCount(); ++i) own.push_back(chain->piece(i));
    }
    for (int i = 0; i < pieceCount(curve); ++i) {
      std::vector<double> cuts = foldCuts(curve, i, frame, size);
      cuts.insert(cuts.begin(), 0.0);
      cuts.push_back(1.0);
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        if (cuts[c + 1] > cuts[c]) addPart({index, i, cuts[c], cuts[c + 1], 0.0, 0.0});
      }
    }
  }

  void addPart(Part part) {
    if (!(depth(point(part, 0.5 * (part.low + part.high))) > 0.0)) return;  // behind the viewer
    const auto image = [&](double t, double inwards) {
      if (const auto i = screenCoordinate(frame, point(part, t))) return *i;
      // At the viewer's depth the image runs off the screen, to the side it comes from.
      const auto near =
          screenCoordinate(frame, point(part, t + 1e-3 * inwards * (part.high - part.low)));
      return std::copysign(std::numeric_limits<double>::infinity(), near.value_or(0.0));
    };
    part.atLow = image(part.low, 1.0);
    part.atHigh = image(part.high, -1.0);
    parts.push_back(part);
  }

  // The parameter at which the part meets the line of sight through q; its ends must lie on both
  // sides.
  double crossing(const Part& part, const Vec2& q) const {
    double a = part.low, b = part.high;
    double fa = beside(point(part, a), q), fb = beside(point(part, b), q);
    if (fa == 0.0) return a;
    if (fb == 0.0) return b;
    // Illinois; the image is monotone, so the sign change is the only one.
    int stale = 0;
    for (int i = 0; i < 60 && b - a > 1e-14; ++i) {
      double t = i % 6 == 5 ? 0.5 * (a + b) : a - fa * (b - a) / (fb - fa);
      if (!(t > a && t < b)) t = 0.5 * (a + b);
      const double f = beside(point(part, t), q);
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

  // True if parameter t of `curve` lies on the part or touches it, also across a joint.
  bool isOn(const Part& part, int curve, double t) const {
    if (part.curve != curve) return false;
    const auto near = [&](double x) {
      return x >= part.piece + part.low - kSameParameter &&
             x <= part.piece + part.high + kSameParameter;
    };
    const Curve& shape = curves[static_cast<std::size_t>(curve)];
    const double period = pieceCount(shape);
    return near(t) || (isClosed(shape) && (near(t - period) || near(t + period)));
  }

  // Seen along itself, to within rounding: all of it lies on one line of sight.
  bool isEndOn(const Part& part) const {
    return std::abs(part.atLow - part.atHigh) <= kSameImage * size;
  }

  bool hides(const Part& part, const Vec2& q, double image) const {
    const double slack = isEndOn(part) ? kSameImage * size : 0.0;
    if (image < std::min(part.atLow, part.atHigh) - slack ||
        image > std::max(part.atLow, part.atHigh) + slack) {
      return false;
    }
    const double nearest = nearness(frame, q) + kSameDepth * size;
    const Vec2 low = point(part, part.low), high = point(part, part.high);
    if (isEndOn(part)) {
      return std::max(nearness(frame, low), nearness(frame, high)) > nearest;
    }
    // Points at the viewer's own depth or behind it do not hide anything.
    const Vec2 p = point(part, crossing(part, q));
    return depth(p) > 0.0 && nearness(frame, p) > nearest;
  }
};

Visibility::Visibility(const Scene& scene) : parts_(std::make_unique<Parts>()) {
  parts_->frame = frameOf(scene.view);
  const Bounds bounds = boundsOf(scene);
  if (bounds.diagonal() > 0.0) parts_->size = bounds.diagonal();
  for (std::size_t i = 0; i < scene.curves.size(); ++i) {
    parts_->add(static_cast<int>(i), scene.curves[i].shape);
  }
  parts_->intervals.resize(scene.curves.size());
}

Visibility::~Visibility() = default;
Visibility::Visibility(Visibility&&) noexcept = default;
Visibility& Visibility::operator=(Visibility&&) noexcept = default;

bool Visibility::isVisible(int curve, double t) const {
  const Vec2 q = pointAt(parts_->curves[static_cast<std::size_t>(curve)], t);
  const auto image = screenCoordinate(parts_->frame, q);
  if (!image) return false;
  for (const Part& part : parts_->parts) {
    if (!parts_->isEndOn(part) && parts_->isOn(part, curve, t)) continue;
    if (parts_->hides(part, q, *image)) return false;
  }
  return true;
}

const std::vector<Visibility::Interval>& Visibility::visibleIntervals(int curve) const {
  const std::scoped_lock lock(parts_->mutex);
  auto& known = parts_->intervals[static_cast<std::size_t>(curve)];
  if (!known) known = findVisibleIntervals(curve);
  return *known;
}

std::vector<Visibility::Interval> Visibility::findVisibleIntervals(int curve) const {
  // Visibility changes where the image of a fold or end passes, and where curves cross.
  const Parts& all = *parts_;
  std::vector<Vec2> edges;
  for (const Part& part : all.parts) {
    edges.push_back(all.point(part, part.low));
    edges.push_back(all.point(part, part.high));
  }
  std::vector<double> cuts;
  for (const Part& part : all.parts) {
    if (part.curve != curve) continue;
    cuts.push_back(part.piece + part.low);
    cuts.push_back(part.piece + part.high);
    const double least = std::min(part.atLow, part.atHigh),
                 most = std::max(part.atLow, part.atHigh);
    for (const Vec2& edge : edges) {
      const auto image = screenCoordinate(all.frame, edge);
      if (image && *image > least && *image < most)
        cuts.push_back(part.piece + all.crossing(part, edge));
    }
  }
  std::sort(cuts.begin(), cuts.end());

  std::vector<Interval> visible;
  const auto append = [&](double low, double high) {
    if (!(high > low)) return;
    if (!visible.empty() && visible.back().tHigh == low) {
      visible.back().tHigh = high;
    } else {
      visible.push_back({low, high});
    }
  };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double low = cuts[i], high = cuts[i + 1];
    // The ends themselves are edges, where the answer is about to change: look just inside them.
    constexpr double kHair = 1e-6;
    const auto sample = [&](int k) {
      return low + (high - low) * std::clamp(static_cast<double>(k) / kSamples, kHair, 1.0 - kHair);
    };
    double from = low;
    bool seen = isVisible(curve, sample(0));
    for (int k = 1; k <= kSamples; ++k) {
      const bool next = isVisible(curve, sample(k));
      if (next == seen) continue;
      double a = sample(k - 1), b = sample(k);
      while (b - a > 1e-9) {
        const double mid = 0.5 * (a + b);
        (isVisible(curve, mid) == seen ? a : b) = mid;
      }
      if (seen) append(from, b);
      from = b;
      seen = next;
    }
    if (seen) append(from, high);
  }
  return visible;
}

}  // namespace flatland
