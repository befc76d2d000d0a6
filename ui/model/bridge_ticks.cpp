// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/bridge_ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flatland::ui {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double distanceToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (a + share * along - p).norm();
}

}  // namespace

std::vector<EdgeTick> edgeTicks(const BridgeView& bridge, const Projection& projection) {
  constexpr double kEndOn = 1e-3;  // px for a length of the mesh's coordinates
  std::vector<EdgeTick> ticks;
  const TriangleMesh& mesh = *bridge.seen->surface->mesh;
  const std::vector<PredictedLine>& lines = bridge.prediction.lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Vec2& mark = lines[i].mark;
    const Vector3d p = (Vector3d(mark.x(), mark.y(), 0.0) - mesh.origin) / mesh.unit;
    const auto at = projection.toScreen(p), beside = projection.toScreen(p + Vector3d::UnitZ());
    if (!at || !beside || (*beside - *at).norm() < kEndOn) continue;
    Vector2d down = (*beside - *at).normalized();
    if (down.y() < 0.0 || (down.y() == 0.0 && down.x() < 0.0)) down = -down;
    const Vector2d size(projection.width, projection.height);
    if ((at->array() < 0.0).any() || (at->array() > size.array()).any()) continue;
    double reach = std::numeric_limits<double>::infinity();
    for (const int k : {0, 1}) {
      if (down[k] > 0.0) reach = std::min(reach, (size[k] - (*at)[k]) / down[k]);
      if (down[k] < 0.0) reach = std::min(reach, -(*at)[k] / down[k]);
    }
    ticks.push_back({*at + reach * down, -down, i});
  }
  return ticks;
}

std::optional<std::size_t> predictedLineAt(const BridgeView& bridge, const Projection& projection,
                                           const Vector2d& px, double reachPx) {
  std::optional<std::size_t> nearest;
  double least = reachPx;
  const std::vector<PredictedLine>& lines = bridge.prediction.lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<Eigen::Vector3f> points =
        inMeshCoordinates(lines[i].points, *bridge.seen->surface->mesh);
    if (lines[i].closed) points.push_back(points.front());
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      const auto a = projection.toScreen(points[k].cast<double>()),
                 b = projection.toScreen(points[k + 1].cast<double>());
      if (!a || !b) continue;
      const double distance = distanceToSegment(px, *a, *b);
      if (distance > least) continue;
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace flatland::ui
