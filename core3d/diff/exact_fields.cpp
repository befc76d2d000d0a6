// SPDX-License-Identifier: MIT
#include "core3d/diff/exact_fields.h"

#include <Eigen/Geometry>
#include <cassert>

namespace flatland {

namespace {

// Sum of the triangles' area vectors round a vertex.
Eigen::Vector3d facing(const TriangleMesh& mesh, std::uint32_t v) {
  const Eigen::Vector3d p = mesh.position(v).cast<double>();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t i = mesh.cornerStart[v]; i < mesh.cornerStart[v + 1]; ++i) {
    const std::uint32_t c = mesh.cornersAt[i], onward = TriangleMesh::nextCorner(c);
    const Eigen::Vector3d a = mesh.position(mesh.vertexOf(onward)).cast<double>() - p;
    const Eigen::Vector3d b =
        mesh.position(mesh.vertexOf(TriangleMesh::nextCorner(onward))).cast<double>() - p;
    sum += a.cross(b);
  }
  return sum;
}

}  // namespace

SurfaceFields exactFields(const Solid& solid, const std::vector<Eigen::Vector3d>& places,
                          const TriangleMesh& mesh) {
  SurfaceFields fields;
  fields.resize(mesh.vertexCount());
  fields.size = surfaceSize(mesh);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    assert(mesh.fileVertex[v] < places.size());
    SurfacePoint point = pointAt(solid, places[mesh.fileVertex[v]]);
    point.K *= mesh.unit;
    for (double& c : point.C.coefficients) c *= mesh.unit * mesh.unit;
    fields.set(v, facing(mesh, v).dot(point.n) < 0.0 ? turnedRound(point) : point);
  }
  return fields;
}

}  // namespace flatland
