// SPDX-License-Identifier: MIT
// Lines that are edges of the mesh: creases and boundaries.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core3d/lines/families.h"
#include "core3d/mesh/triangle_cross.h"

namespace flatland {
namespace {

LineSegment edgeOf(const TriangleMesh& mesh, std::uint32_t halfEdge, float strength) {
  const std::uint32_t a = mesh.vertexOf(halfEdge),
                      b = mesh.vertexOf(TriangleMesh::nextCorner(halfEdge));
  return {{mesh.position(a), strength, vertexNode(a)},
          {mesh.position(b), strength, vertexNode(b)},
          halfEdge / 3,
          0,
          true,
          mesh.hasOpposite(halfEdge) ? mesh.opposite[halfEdge] / 3 : TriangleMesh::kNone};
}

}  // namespace

Segments findCreases(const TriangleMesh& mesh, double leastDeg) {
  Segments out;
  for (std::uint32_t h = 0; h < mesh.opposite.size(); ++h) {
    if (!mesh.hasOpposite(h) || mesh.opposite[h] < h) continue;
    const Eigen::Vector3d a = crossOf(mesh, h / 3), b = crossOf(mesh, mesh.opposite[h] / 3);
    // 0 where one of them is flat: it has no direction.
    const double angleRad = std::atan2(a.cross(b).norm(), a.dot(b));
    const double angleDeg = angleRad * 180.0 / std::numbers::pi;
    if (angleDeg > 0.0 && angleDeg >= leastDeg)
      out.push_back(edgeOf(mesh, h, static_cast<float>(angleDeg)));
  }
  return out;
}

Segments findSharpEdges(const TriangleMesh& mesh, const SharpEdges& sharp, bool convex) {
  Segments out;
  for (const SharpEdge& edge : sharp.edges()) {
    if (edge.convex == convex) out.push_back(edgeOf(mesh, edge.halfEdge, kSharpStrength));
  }
  return out;
}

Segments findBoundaries(const TriangleMesh& mesh) {
  Segments out;
  for (std::uint32_t h = 0; h < mesh.opposite.size(); ++h) {
    if (mesh.opposite[h] == TriangleMesh::kBorder) out.push_back(edgeOf(mesh, h, 1.0f));
  }
  return out;
}

}  // namespace flatland
