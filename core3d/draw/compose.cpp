// SPDX-License-Identifier: MIT
#include "core3d/draw/compose.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "core3d/draw/ink.h"
#include "core3d/draw/stroke_set.h"

namespace flatland {
namespace {

using Eigen::Vector2d;

// A stroke longer than this share of the picture's diagonal is no crumb.
constexpr double kLongShare = 0.02;
// Ink that is closer to what was asked for counts as reached.
constexpr double kInkTolerance = 0.01;

class Clock {
 public:
  double ms() const {
    const std::chrono::duration<double, std::milli> d = std::chrono::steady_clock::now() - start_;
    return d.count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::size_t indexOf(LineFamily family) { return static_cast<std::size_t>(family); }

class InkSolver {
 public:
  InkSolver(const StrokeSet& strokes, const Projection& projection, const StrokeOptions& options)
      : strokes_(strokes), raster_(projection.width, projection.height), options_(options) {}

  // The factor whose ink is nearest to `asked`. Ink never grows with the factor, so the interval
  // that holds the answer is halved.
  double solve(double asked) {
    // Below the first no factor draws more than 0 does, but for points without strength; above the
    // second no line with a threshold is left.
    auto [low, high] = factors();
    if (high == 0.0) return 1.0;  // nothing has a threshold
    double best = 0.0, miss = std::numeric_limits<double>::infinity();
    const auto consider = [&](double factor) {
      const double ink = inkOf(factor);
      if (std::abs(ink - asked) < miss) {
        miss = std::abs(ink - asked);
        best = factor;
      }
      return ink;
    };
    if (consider(0.0) <= asked) return 0.0;
    if (consider(high) >= asked) return high;
    while (high / low > 1.0 + kFactorPrecision && miss > kCloseEnough * asked &&
           !options_.stop.stop_requested()) {
      const double middle = std::sqrt(low) * std::sqrt(high);
      (consider(middle) > asked ? low : high) = middle;
    }
    return best;
  }

 private:
  static constexpr double kFactorPrecision = 1e-7;
  static constexpr double kCloseEnough = 1e-3;  // a tenth of kInkTolerance

  // The smallest and the largest strength, as shares of their thresholds; both 0 if no line has a
  // threshold. Near silhouettes strengths have no bound, so neither says anything about the other.
  std::pair<double, double> factors() const {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const SeenChain& chain : strokes_.chains()) {
      const double threshold = strokes_.threshold(chain.line.chain.family);
      if (!(threshold > 0.0) || !movesWithInk(chain.line.chain.family)) continue;
      for (const float strength : chain.line.judged) {
        const double share = static_cast<double>(strength) / threshold;
        if (!(share > 0.0) || !std::isfinite(share)) continue;
        least = std::min(least, share);
        most = std::max(most, share);
      }
    }
    if (most == 0.0) return {0.0, 0.0};
    return {least, most * (1.0 + kFactorPrecision)};
  }

  double inkOf(double factor) {
    raster_.clear();
    for (const StrokePart& part : strokes_.parts(factor)) {
      if (part.seen == Seen::Hidden) continue;
      raster_.add(screenOf(strokes_.chains()[part.chain].line, part), part.closed,
                  options_.inkWidthPx);
    }
    return raster_.share();
  }

  const StrokeSet& strokes_;
  InkRaster raster_;
  const StrokeOptions& options_;
};

double lengthOf(const Polyline& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.screen.size(); ++i) {
    length += (line.screen[i + 1] - line.screen[i]).norm();
  }
  if (line.closed) length += (line.screen.front() - line.screen.back()).norm();
  return length;
}

void measure(Drawing& drawing, const StrokeOptions& options) {
  const Projection& projection = drawing.projection;
  InkRaster raster(projection.width, projection.height);
  const double longPx = kLongShare * std::hypot(projection.width, projection.height);
  double total = 0.0, inLong = 0.0;
  for (const Polyline& line : drawing.polylines) {
    if (!line.visible) continue;
    raster.add(line.screen, line.closed, options.inkWidthPx);
    const double length = lengthOf(line);
    total += length;
    if (length > longPx) inLong += length;
  }
  drawing.stats.ink = raster.share();
  drawing.stats.share = total > 0.0 ? inLong / total : 1.0;
  drawing.stats.inkReached =
      !options.ink || std::abs(raster.share() - *options.ink) <= kInkTolerance * *options.ink;
}

// On a picture of the usual size.
Drawing composeNominal(const FeatureLines& found, const Sight& sight, const Projection& projection,
                       const LineOptions& lines, const StrokeOptions& strokes) {
  Drawing drawing;
  drawing.projection = projection;
  const auto stopped = [&strokes] { return strokes.stop.stop_requested(); };

  const Clock chainClock;
  StrokeSet all(found, projection, lines, strokes);
  if (stopped()) return drawing;
  drawing.stats.segments = all.segmentCount();
  drawing.stats.chainMs = chainClock.ms();

  const Clock sightClock;
  drawing.stats.rays = all.look(sight);
  drawing.stats.visibilityMs = sightClock.ms();
  if (stopped()) return drawing;

  const Clock strokeClock;
  if (strokes.ink) {
    drawing.stats.thresholdFactor = InkSolver(all, projection, strokes).solve(*strokes.ink);
  }
  if (stopped()) return drawing;
  for (const LineFamily family : allLineFamilies()) {
    drawing.weak[indexOf(family)] = all.weak(family, drawing.stats.thresholdFactor);
  }
  for (const StrokePart& part : all.parts(drawing.stats.thresholdFactor)) {
    Polyline line = polylineOf(all.chains()[part.chain], part, projection, strokes.tolerancePx);
    if (line.points.size() < 2) continue;
    line.family = StrokeSet::familyOf(line.family, part.seen);
    drawing.polylines.push_back(std::move(line));
  }
  std::stable_sort(drawing.polylines.begin(), drawing.polylines.end(),
                   [](const Polyline& a, const Polyline& b) { return a.family < b.family; });
  measure(drawing, strokes);
  drawing.stats.strokeMs = strokeClock.ms();
  return drawing;
}

}  // namespace

bool movesWithInk(LineFamily family) { return family != LineFamily::Creases; }

LineOptions linesToFind(const LineOptions& lines, const StrokeOptions& strokes) {
  LineOptions asked = lines;
  asked.flatToo = true;
  for (const LineFamily family : allLineFamilies()) {
    asked.threshold[indexOf(family)] *=
        strokes.ink && movesWithInk(family) ? 0.0 : strokes.hysteresis;
  }
  if (lines[LineFamily::ExteriorSilhouette]) {
    asked[LineFamily::OccludingContours] = true;
    asked[LineFamily::Boundaries] = true;
  }
  return asked;
}

Drawing composeDrawing(const FeatureLines& found, const Sight& sight, const Projection& projection,
                       const LineOptions& lines, const StrokeOptions& strokes) {
  const double scale = pictureScale(projection.width, projection.height);
  StrokeOptions options = strokes;
  options.tolerancePx /= scale;
  Drawing drawing = composeNominal(found, sight, usualSize(projection), lines, options);
  drawing.projection = projection;
  for (Polyline& line : drawing.polylines) {
    for (Vector2d& p : line.screen) p *= scale;
  }
  return drawing;
}

StrokeLines strokeLines(const FeatureLines& found, const Sight* sight, const Projection& projection,
                        const LineOptions& lines, const StrokeOptions& strokes, double factor) {
  // A picture so large that nothing is cut off at its sides.
  constexpr double kEndlessPx = 1e8;
  Projection usual = usualSize(projection);
  if (!sight) usual.width = usual.height = kEndlessPx;
  StrokeSet all(found, usual, lines, strokes);
  if (sight) {
    all.look(*sight);
  } else {
    all.lookThrough();
  }
  StrokeLines result;
  std::uint64_t node = 0;
  for (const StrokePart& part : all.parts(factor)) {
    const SeenChain& chain = all.chains()[part.chain];
    FeatureLines& of = part.seen == Seen::Hidden ? result.hidden : result.visible;
    appendSegments(chain.line, part, node,
                   of.of(StrokeSet::familyOf(chain.line.chain.family, part.seen)));
  }
  return result;
}

}  // namespace flatland
