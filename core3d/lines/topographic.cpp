// SPDX-License-Identifier: MIT
// Topographic lines: the coordinate along `up` equal to one of the levels evenly between the lowest
// and the highest vertex, both left out.
#include <algorithm>
#include <cmath>

#include "core3d/lines/families.h"

namespace flatland {

Segments findTopographic(const TriangleMesh& mesh, const Eigen::Vector3d& up, int levels) {
  Segments out;
  const std::size_t count = mesh.vertexCount();
  const double length = up.norm();
  if (!(length > 0.0) || count == 0) return out;
  levels = std::max(levels, 1);
  const Eigen::Vector3f axis = (up / length).cast<float>();
  std::vector<float> height(count);
  for (std::uint32_t v = 0; v < count; ++v) height[v] = axis.dot(mesh.position(v));
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  const float bottom = *low, step = (*high - *low) / static_cast<float>(levels + 1);
  if (!(step > 0.0f)) return out;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& v = mesh.triangles[t];
    const float h[3] = {height[v[0]], height[v[1]], height[v[2]]};
    const float least = (std::min({h[0], h[1], h[2]}) - bottom) / step,
                most = (std::max({h[0], h[1], h[2]}) - bottom) / step;
    const int first = std::max(1, static_cast<int>(std::floor(least)));
    const int last = std::min(levels, static_cast<int>(std::ceil(most)));
    for (int level = first; level <= last; ++level) {
      const float at = bottom + step * static_cast<float>(level);
      const Crossings found = zeroCrossings({h[0] - at, h[1] - at, h[2] - at});
      if (found.count == 2)
        addPiece(mesh, t, {found.points[0], found.points[1]}, {1.0f, 1.0f}, 0.0f, nullptr, out,
                 static_cast<std::uint32_t>(level - 1));
    }
  }
  return out;
}

}  // namespace flatland
