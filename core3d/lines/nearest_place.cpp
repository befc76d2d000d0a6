// SPDX-License-Identifier: MIT
#include "core3d/lines/nearest_place.h"

#include <algorithm>
#include <limits>

namespace flatland {

namespace {

using Eigen::Vector3d;

/// Weights of the corners at the foot of the perpendicular; nullopt if it is not within the
/// triangle, or this has no area.
std::optional<std::array<double, 3>> footWithin(const std::array<Vector3d, 3>& corners,
                                                const Vector3d& p) {
  const Vector3d a = corners[1] - corners[0], b = corners[2] - corners[0], c = p - corners[0];
  const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), ac = a.dot(c), bc = b.dot(c);
  const double det = aa * bb - ab * ab;
  if (!(det > 0.0)) return std::nullopt;
  const double u = (bb * ac - ab * bc) / det, v = (aa * bc - ab * ac) / det;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return std::nullopt;
  return std::array<double, 3>{1.0 - u - v, u, v};
}

/// Weights at the nearest place of the side that is opposite to a corner.
std::array<double, 3> onSide(const std::array<Vector3d, 3>& corners, std::size_t opposite,
                             const Vector3d& p) {
  const std::size_t i = (opposite + 1) % 3, j = (opposite + 2) % 3;
  const Vector3d side = corners[j] - corners[i];
  const double squared = side.squaredNorm();
  const double share =
      squared > 0.0 ? std::clamp(side.dot(p - corners[i]) / squared, 0.0, 1.0) : 0.0;
  std::array<double, 3> weights{};
  weights[i] = 1.0 - share;
  weights[j] = share;
  return weights;
}

}  // namespace

std::optional<SurfaceHit> nearestPlace(const TriangleMesh& mesh, const Vector3d& p) {
  std::optional<SurfaceHit> nearest;
  double leastSq = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    std::array<Vector3d, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = mesh.position(mesh.triangles[t][k]).cast<double>();
    }
    const auto consider = [&](const std::array<double, 3>& weights) {
      const Vector3d at =
          weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
      const double distanceSq = (at - p).squaredNorm();
      if (!(distanceSq < leastSq)) return;
      leastSq = distanceSq;
      nearest = SurfaceHit{t, weights, at};
    };
    if (const auto foot = footWithin(corners, p)) {
      consider(*foot);
    } else {
      for (std::size_t k = 0; k < 3; ++k) consider(onSide(corners, k, p));
    }
  }
  return nearest;
}

}  // namespace flatland
