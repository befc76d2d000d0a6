// SPDX-License-Identifier: MIT
#include "core3d/draw/stroke_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core3d/draw/bridges.h"
#include "core3d/draw/chains.h"
#include "core3d/draw/compose.h"
#include "core3d/draw/look_at.h"

namespace flatland {
namespace {

// Where thresholds fall for ink, the unit of weight falls more slowly, as the mean of the given and
// the used one: what is fainter has to be longer, or short strokes would come before long ones. It
// stays at this share of the given threshold at least: ink that no lines are left for is not made
// up of crumbs.
constexpr double kLeastUnit = 0.3;

// Where a threshold is lowered to 0 the definition still asks for more than nothing: a curvature
// that grows, a maximum that is one.
constexpr double kAnyStrength = std::numeric_limits<double>::min();

std::size_t indexOf(LineFamily family) { return static_cast<std::size_t>(family); }

// Families that are judged by how strong they are. Angles of creases are no strength to weigh with.
bool isWeighed(LineFamily family) {
  static const auto kUsual = LineOptions::defaultThresholds();
  return movesWithInk(family) && kUsual[indexOf(family)] > 0.0;
}

}  // namespace

Projection usualSize(Projection projection) {
  const double scale = pictureScale(projection.width, projection.height);
  projection.pxPerUnit /= scale;
  projection.width /= scale;
  projection.height /= scale;
  return projection;
}

StrokeSet::StrokeSet(const FeatureLines& found, const Projection& projection,
                     const LineOptions& lines, const StrokeOptions& options)
    : projection_(projection), lines_(lines), options_(options) {
  for (const LineFamily family : allLineFamilies()) {
    // The outline is picked from contours and boundaries, where it is told from what is inside.
    if (family == LineFamily::ExteriorSilhouette) continue;
    segments_ += found.of(family).size();
    const double least = strokeThreshold(family, options.ink ? 0.0 : 1.0);
    std::vector<ScreenChain> chained;
    for (LineChain& chain : chainSegments(family, found.of(family))) {
      for (ScreenChain& line : onScreen(std::move(chain), projection)) {
        chained.push_back(std::move(line));
      }
    }
    if (isBridged(family) && !lines.unfiltered) {
      chained = bridged(std::move(chained), projection, options.largestGapPx);
    }
    for (ScreenChain& line : chained) {
      // What cannot become a stroke need not be looked at.
      if (strongStretches(line, least, options.hysteresis).empty()) continue;
      chains_.push_back({std::move(line), {}});
    }
    if (options.stop.stop_requested()) return;
  }
}

std::size_t StrokeSet::look(const Sight& sight) {
  return lookAt(chains_, sight, projection_, lines_, options_);
}

void StrokeSet::lookThrough() {
  for (SeenChain& chain : chains_) {
    const bool outline = chain.line.chain.family == LineFamily::OccludingContours &&
                         lines_[LineFamily::ExteriorSilhouette];
    chain.stretches = {{0.0, chain.line.length(), outline ? Seen::Outline : Seen::Visible}};
  }
}

double StrokeSet::threshold(LineFamily family) const {
  return lines_.unfiltered ? 0.0 : lines_.threshold[indexOf(family)];
}

double StrokeSet::strokeThreshold(LineFamily family, double factor) const {
  if (lines_.unfiltered) return 0.0;
  const double used = (movesWithInk(family) ? factor : 1.0) * threshold(family);
  return isWeighed(family) ? std::max(used, kAnyStrength) : used;
}

double StrokeSet::weak(LineFamily family, double factor) const {
  const double given = lines_.threshold[indexOf(family)];
  if (!movesWithInk(family)) return given;
  return given * (factor > 1.0 ? factor : std::max(std::sqrt(factor), kLeastUnit));
}

std::vector<StrokePart> StrokeSet::parts(double factor) const {
  std::vector<StrokePart> all;
  for (std::size_t i = 0; i < chains_.size(); ++i) {
    const LineFamily family = chains_[i].line.chain.family;
    StrokeFilter filter;
    filter.threshold = strokeThreshold(family, factor);
    if (!lines_.unfiltered) {
      filter.minLengthPx = options_.minLengthPx;
      filter.minHolePx = options_.minWeightPx;
      if (isWeighed(family)) {
        filter.minWeightPx = options_.minWeightPx;
        filter.unitStrength = weak(family, factor);
      }
    }
    for (const StrokePart& part : strokeParts(chains_[i], i, filter, options_.hysteresis)) {
      if (isDrawn(family, part.seen)) all.push_back(part);
    }
  }
  return all;
}

bool StrokeSet::isDrawn(LineFamily family, Seen seen) const {
  return lines_[familyOf(family, seen)] && (seen != Seen::Hidden || options_.hidden);
}

}  // namespace flatland
