// SPDX-License-Identifier: MIT
#include "core3d/draw/look_at.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>

#include "core3d/draw/ink.h"
#include "core3d/run_on_threads.h"

namespace flatland {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// How far off the surface rays start: a dense mesh's roughness is smaller than half a pixel. At
// least some roundings of float, at most what is small against the mesh.
constexpr double kOffsetPx = 0.5;
constexpr double kLeastOffset = 1e-5, kLargestOffset = 0.02;
// Beside an outline there is background at this distance.
constexpr double kBesidePx = 1.5;
// Beside a contour that is hidden by a facet of the very outline there is background at this one.
constexpr double kCoveredPx = 4.0;
// Lines longer than so many px of a usual picture (pictureScale) would cover most of it, and of
// messy files there are such: they are looked at less often, so many times in all.
constexpr double kMostSamples = 3e5;
// How densely gaps of outlines are looked for.
constexpr double kGapStepPx = 0.5;

// Lines whose place on the mesh is combinatorial, not interpolated from quantities of vertices.
bool followsTheMesh(LineFamily family) {
  return family == LineFamily::Creases || family == LineFamily::Boundaries ||
         family == LineFamily::SelfIntersections || family == LineFamily::Topographic;
}

bool mayBeOutline(LineFamily family) {
  return family == LineFamily::OccludingContours || family == LineFamily::Boundaries;
}

// What is seen at the places of one chain.
class Looker {
 public:
  Looker(const Sight& sight, const Projection& projection, bool outlines)
      : sight_(sight), projection_(projection), view_(projection.view()), outlines_(outlines) {}

  Seen look(const ScreenChain& line, const ScreenChain::Point& p) {
    const SightPoint point = pointOf(line, p);
    const double px = unitsPerPx(p.at);
    ++rays_;
    const bool hidden =
        sight_.hidden(point, view_, std::clamp(kOffsetPx * px, kLeastOffset, kLargestOffset));
    const bool mayBe = mayBeOutline(line.chain.family) && (hidden || outlines_);
    const bool outline = mayBe && isOutline(line, p, point, (hidden ? kCoveredPx : kBesidePx) * px);
    if (hidden) return outline ? Seen::Covered : Seen::Hidden;
    return outline ? Seen::Outline : Seen::Visible;
  }

  // True if there is background beside every place of a loop.
  bool isWholeOutline(const ScreenChain& line) {
    for (double place = 0.5; place < line.length() + 0.5; place += 1.0) {
      const ScreenChain::Point p = line.at(place);
      if (!isOutline(line, p, pointOf(line, p), kBesidePx * unitsPerPx(p.at))) return false;
    }
    return true;
  }

  std::size_t rays() const { return rays_; }

 private:
  static SightPoint pointOf(const ScreenChain& line, const ScreenChain::Point& p) {
    return {p.at, line.chain.triangles[p.piece], !followsTheMesh(line.chain.family),
            line.chain.otherOf(p.piece), line.chain.family == LineFamily::OccludingContours};
  }

  double unitsPerPx(const Vector3d& at) const {
    double scale = projection_.pxPerUnit;
    if (projection_.distance) {
      const double depth =
          *projection_.distance - projection_.axes.row(2).dot(at - projection_.centre);
      scale *= *projection_.distance / std::max(depth, 1e-12);
    }
    return 1.0 / scale;
  }

  bool emptyBeside(const SightPoint& point, const Vector3d& step) {
    ++rays_;
    return sight_.empty(point, point.at + step, view_);
  }

  // A contour has the surface on one side, so background can only be where its normal points. Along
  // a sharp edge that says nothing; there it is where neither triangle is, if both are on one side.
  // A boundary may have it on either side.
  bool isOutline(const ScreenChain& line, const ScreenChain::Point& p, const SightPoint& point,
                 double distance) {
    const Vector3d w = view_.towardsViewer(p.at);
    if (point.contour && point.other == TriangleMesh::kNone) {
      const Vector3d n = sight_.outwardAt(point, view_);
      return emptyBeside(point, distance * (n - n.dot(w) * w).stableNormalized());
    }
    const auto& points = line.chain.points;
    const Vector3d along = (points[(p.piece + 1) % points.size()] - points[p.piece]).cast<double>();
    const Vector3d across = distance * along.cross(w).stableNormalized();
    if (point.other != TriangleMesh::kNone) {
      const double side = across.dot(sight_.middleOf(point.triangle) - p.at);
      if (side * across.dot(sight_.middleOf(point.other) - p.at) > 0.0)
        return emptyBeside(point, side > 0.0 ? -across : across);
    }
    return emptyBeside(point, across) || emptyBeside(point, -across);
  }

  const Sight& sight_;
  const Projection& projection_;
  SurfaceView view_;
  bool outlines_;
  std::size_t rays_ = 0;
};

std::vector<Vector2d> screenOf(const ScreenChain& line, const Stretch& s) {
  return flatland::screenOf(line, {0, s.from, s.to, s.seen, false});
}

// True if no line is drawn at a piece nor beside it, as far as background may be.
bool isBare(const Vector2d& from, const Vector2d& to, const InkRaster& drawn) {
  const Vector2d middle = (from + to) / 2.0, along = (to - from).stableNormalized();
  if (!drawn.holds(middle)) return false;
  for (double beside = -kCoveredPx; beside <= kCoveredPx; beside += 1.0) {
    if (drawn.isCovered(middle + beside * Vector2d(-along.y(), along.x()))) return false;
  }
  return true;
}

// The parts of a covered stretch along which no outline is drawn yet, a little longer than that, so
// that they meet what is drawn.
std::vector<Stretch> gapsAlong(const ScreenChain& line, const Stretch& covered,
                               const InkRaster& drawn, Seen as) {
  std::vector<Stretch> gaps;
  const double length = covered.to - covered.from;
  const auto samples = std::max<std::size_t>(1, static_cast<std::size_t>(length / kGapStepPx));
  const double step = length / static_cast<double>(samples);
  for (std::size_t k = 0; k < samples; ++k) {
    const double from = covered.from + static_cast<double>(k) * step;
    const std::vector<Vector2d> piece = screenOf(line, {from, from + step, as});
    if (!isBare(piece.front(), piece.back(), drawn)) continue;
    const double low = std::max(from - kBesidePx, covered.from);
    const double high = std::min(from + step + kBesidePx, covered.to);
    if (!gaps.empty() && low <= gaps.back().to) {
      gaps.back().to = high;
    } else {
      gaps.push_back({low, high, as});
    }
  }
  return gaps;
}

// Where a mesh is rough or coarse, facets stick out over the interpolated contour that is its
// outline, and hide it. Where no other line is drawn along the outline, what is covered is taken
// `as` seen, the longest first; the rest is hidden.
void closeOutlines(std::vector<SeenChain>& chains, const Projection& projection,
                   const LineOptions& lines, double smallestGapPx) {
  struct Covered {
    std::size_t chain;
    Stretch stretch;
    std::vector<Stretch> gaps = {};
  };
  const Seen as = lines[LineFamily::ExteriorSilhouette] ? Seen::Outline : Seen::Visible;
  InkRaster drawn(projection.width, projection.height);
  std::vector<Covered> all;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const ScreenChain& line = chains[i].line;
    if (!mayBeOutline(line.chain.family)) continue;
    for (const Stretch& s : chains[i].stretches) {
      if (s.seen == Seen::Covered) all.push_back({i, s});
      if (s.seen == Seen::Outline || (s.seen == Seen::Visible && lines[line.chain.family]))
        drawn.add(screenOf(line, s), false, 2.0 * kBesidePx);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Covered& a, const Covered& b) {
    return a.stretch.to - a.stretch.from > b.stretch.to - b.stretch.from;
  });
  for (Covered& covered : all) {
    const ScreenChain& line = chains[covered.chain].line;
    covered.gaps = gapsAlong(line, covered.stretch, drawn, as);
    for (const Stretch& gap : covered.gaps) drawn.add(screenOf(line, gap), false, 2.0 * kBesidePx);
  }
  std::vector<std::vector<Stretch>> added(chains.size());
  for (const Covered& covered : all) {
    auto& to = added[covered.chain];
    double place = covered.stretch.from;
    for (const Stretch& gap : covered.gaps) {
      if (gap.from > place) to.push_back({place, gap.from, Seen::Hidden});
      to.push_back(gap);
      place = gap.to;
    }
    if (covered.stretch.to > place) to.push_back({place, covered.stretch.to, Seen::Hidden});
  }
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (added[i].empty()) continue;
    auto& stretches = chains[i].stretches;
    std::erase_if(stretches, [](const Stretch& s) { return s.seen == Seen::Covered; });
    stretches.insert(stretches.end(), added[i].begin(), added[i].end());
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
    smoothStretches(stretches, chains[i].line, smallestGapPx);
  }
}

}  // namespace

std::size_t lookAt(std::vector<SeenChain>& chains, const Sight& sight, const Projection& projection,
                   const LineOptions& lines, const StrokeOptions& strokes) {
  double length = 0.0;
  for (const SeenChain& chain : chains) length += chain.line.length();
  const double samplePx =
      std::max(1.0, length / (kMostSamples * pictureScale(projection.width, projection.height)));
  // Every chain is looked at by one thread, whichever is free.
  std::atomic<std::size_t> next = 0, rays = 0;
  const auto work = [&] {
    const FlushDenormals flush;
    Looker looker(sight, projection, lines[LineFamily::ExteriorSilhouette]);
    for (std::size_t i = next++; i < chains.size(); i = next++) {
      if (strokes.stop.stop_requested()) break;
      const ScreenChain& line = chains[i].line;
      chains[i].stretches = stretchesOf(
          line, strokes.smallestGapPx,
          [&](const ScreenChain::Point& p) { return looker.look(line, p); }, samplePx);
      chains[i].outlineOfPart = line.chain.family == LineFamily::OccludingContours &&
                                line.chain.closed && line.length() < strokes.minLengthPx &&
                                looker.isWholeOutline(line);
    }
    rays += looker.rays();
  };
  runOnThreads(std::min(threadsFor(0), chains.size()), work);
  closeOutlines(chains, projection, lines, strokes.smallestGapPx);
  return rays;
}

}  // namespace flatland
