// SPDX-License-Identifier: MIT
#include "core3d/lines/families.h"

#include <algorithm>

namespace flatland {

LineEnd endAt(const TriangleMesh& mesh, std::uint32_t triangle, const EdgePoint& point,
              float strength) {
  const auto& v = mesh.triangles[triangle];
  const auto corner = static_cast<std::uint32_t>(point.corner);
  const Eigen::Vector3f a = mesh.position(v[corner]), b = mesh.position(v[(corner + 1) % 3]);
  return {a + point.t * (b - a), strength, edgeNode(mesh, 3 * triangle + corner)};
}

void addPiece(const TriangleMesh& mesh, std::uint32_t triangle, const EdgePoint (&points)[2],
              const float (&strength)[2], float threshold, const float* nw, Segments& out,
              std::uint32_t level, float side) {
  if (!(std::max(strength[0], strength[1]) >= threshold)) return;
  LineEnd ends[2] = {endAt(mesh, triangle, points[0], strength[0]),
                     endAt(mesh, triangle, points[1], strength[1])};
  if (nw) {
    const auto& v = mesh.triangles[triangle];
    float facing[2];
    for (int i = 0; i < 2; ++i) {
      const auto corner = static_cast<std::size_t>(points[i].corner);
      facing[i] = side * points[i].between(nw[v[corner]], nw[v[(corner + 1) % 3]]);
    }
    if (!(facing[0] > 0.0f) && !(facing[1] > 0.0f)) return;
    for (int i = 0; i < 2; ++i) {
      if (facing[i] > 0.0f) continue;
      const LineEnd& other = ends[1 - i];
      const float t = facing[1 - i] / (facing[1 - i] - facing[i]);
      ends[i] = {other.at + t * (ends[i].at - other.at),
                 other.strength + t * (ends[i].strength - other.strength),
                 innerNode(mesh, triangle)};
    }
  }
  out.push_back({ends[0], ends[1], triangle, level});
}

}  // namespace flatland
