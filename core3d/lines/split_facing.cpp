// SPDX-License-Identifier: MIT
#include "core3d/lines/split_facing.h"

#include <cmath>

namespace flatland {

std::array<float, 3> facingOf(const SeenMesh& sight, const SplitTriangle& split) {
  std::array<float, 3> facing{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = sight.mesh.triangles[split.triangle][k];
    if (!split.own[k] && !(sight.seen.flags[v] & VertexFlag::kSkipped)) {
      facing[k] = sight.seen.nw[v];
      continue;
    }
    const Eigen::Vector3d w = sight.view.towardsViewer(sight.mesh.position(v).cast<double>());
    const float nw = split.normal[k].dot(w.cast<float>());
    facing[k] = split.own[k] && std::abs(nw) <= kFlatFacing ? 0.0f : nw;
  }
  return facing;
}

bool isKnown(const SplitTriangle& split) {
  for (const auto& normal : split.normal) {
    if (normal.isZero(0.0f)) return false;
  }
  return true;
}

bool sidesOf(const SeenMesh& sight, const SharpEdges& sharp, std::uint32_t halfEdge,
             TwoSides& sides) {
  if (!sight.mesh.hasOpposite(halfEdge)) return false;
  const std::uint32_t other = sight.mesh.opposite[halfEdge];
  if (!sharp.splits(halfEdge / 3) || !sharp.splits(other / 3)) return false;
  const SplitTriangle &a = sharp.at(halfEdge / 3), &b = sharp.at(other / 3);
  if (!isKnown(a) || !isKnown(b)) return false;
  const auto facing = facingOf(sight, a), beyond = facingOf(sight, b);
  const auto next = [](std::uint32_t h) { return TriangleMesh::nextCorner(h) % 3; };
  sides = {halfEdge,
           {facing[halfEdge % 3], facing[next(halfEdge)]},
           {beyond[next(other)], beyond[other % 3]}};
  return true;
}

LineEnd endOnSide(const SeenMesh& sight, const SharpEdges& sharp, std::uint32_t triangle,
                  const EdgePoint& point) {
  LineEnd end = endAt(sight.mesh, triangle, point, 1.0f);
  const std::uint32_t h = 3 * triangle + static_cast<std::uint32_t>(point.corner);
  TwoSides sides;
  if (sidesOf(sight, sharp, h, sides) && sides.jumps()) end.node = sideNode(h);
  return end;
}

}  // namespace flatland
