// SPDX-License-Identifier: MIT
#include "core3d/draw/look_at.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>

#include "core3d/run_on_threads.h"

namespace flatland {
namespace {

using Eigen::Vector3d;

// How far off the surface rays start: a dense mesh's roughness is smaller than half a pixel. At
// least some roundings of float, at most what is small against the mesh.
constexpr double kOffsetPx = 0.5;
constexpr double kLeastOffset = 1e-5, kLargestOffset = 0.02;
// Beside an outline there is background at this distance.
constexpr double kBesidePx = 1.5;

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
    const SightPoint point{p.at, line.chain.triangles[p.piece], !followsTheMesh(line.chain.family),
                           line.chain.family == LineFamily::Creases};
    const double px = unitsPerPx(p.at);
    ++rays_;
    if (sight_.hidden(point, view_, std::clamp(kOffsetPx * px, kLeastOffset, kLargestOffset))) {
      return Seen::Hidden;
    }
    if (!outlines_ || !mayBeOutline(line.chain.family)) return Seen::Visible;
    return isOutline(line, p, point, kBesidePx * px) ? Seen::Outline : Seen::Visible;
  }

  std::size_t rays() const { return rays_; }

 private:
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

  // A contour has the surface on one side, so background can only be where its normal points; a
  // boundary may have it on either side.
  bool isOutline(const ScreenChain& line, const ScreenChain::Point& p, const SightPoint& point,
                 double distance) {
    const Vector3d w = view_.towardsViewer(p.at);
    if (line.chain.family == LineFamily::OccludingContours) {
      const Vector3d n = sight_.normalAt(point);
      return emptyBeside(point, distance * (n - n.dot(w) * w).stableNormalized());
    }
    const auto& points = line.chain.points;
    const Vector3d along = (points[(p.piece + 1) % points.size()] - points[p.piece]).cast<double>();
    const Vector3d across = distance * along.cross(w).stableNormalized();
    return emptyBeside(point, across) || emptyBeside(point, -across);
  }

  const Sight& sight_;
  const Projection& projection_;
  SurfaceView view_;
  bool outlines_;
  std::size_t rays_ = 0;
};

}  // namespace

std::size_t lookAt(std::vector<SeenChain>& chains, const Sight& sight, const Projection& projection,
                   const LineOptions& lines, const StrokeOptions& strokes) {
  // Every chain is looked at by one thread, whichever is free.
  std::atomic<std::size_t> next = 0, rays = 0;
  const auto work = [&] {
    const FlushDenormals flush;
    Looker looker(sight, projection, lines[LineFamily::ExteriorSilhouette]);
    for (std::size_t i = next++; i < chains.size(); i = next++) {
      if (strokes.stop.stop_requested()) break;
      const ScreenChain& line = chains[i].line;
      chains[i].stretches =
          stretchesOf(line, strokes.smallestGapPx,
                      [&](const ScreenChain::Point& p) { return looker.look(line, p); });
    }
    rays += looker.rays();
  };
  runOnThreads(std::min(threadsFor(0), chains.size()), work);
  return rays;
}

}  // namespace flatland
