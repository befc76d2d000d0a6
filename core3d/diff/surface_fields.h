// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core3d/diff/surface_jet.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// What every view needs of a surface, per vertex of a TriangleMesh and in its coordinates: normal,
/// shape operator K and its covariant derivative C (signs as in SurfacePoint: a sphere with its
/// normal outward has k1 = k2 = 1/R > 0). Arrays of equal length, in the order of the vertices, so
/// that a view reads each of them once from front to back.
///
/// The frame of a vertex is principal: e1 belongs to k1, e2 = n x e1 to k2, k1 >= k2. Its sign is
/// arbitrary, and at an umbilic its direction too: compare frames of neighbours only through what
/// they describe. C is in this frame: C(e1, e1, e1) = c111 and so on.
///
/// Degenerate answer: where the normal is unknown (all triangles of the vertex are flat) n, e1, K
/// and C are 0; where only curvature is unknown, or one of its values beyond the range of float, K
/// and C are 0.
struct SurfaceFields {
  std::vector<float> nx, ny, nz;              ///< unit normal
  std::vector<float> e1x, e1y, e1z;           ///< unit tangent, principal direction of k1
  std::vector<float> k1, k2;                  ///< 1/length, k1 >= k2
  std::vector<float> c111, c112, c122, c222;  ///< 1/length^2

  /// Root mean square distance of the surface (weighted by area) from its centre of area: a length
  /// that neither rotation nor resolution changes, R for a sphere. Thresholds are made
  /// dimensionless with it.
  double size = 1.0;

  std::size_t vertexCount() const { return nx.size(); }
  Eigen::Vector3f normal(std::uint32_t v) const { return {nx[v], ny[v], nz[v]}; }
  Eigen::Vector3f e1(std::uint32_t v) const { return {e1x[v], e1y[v], e1z[v]}; }
  Eigen::Vector3f e2(std::uint32_t v) const { return normal(v).cross(e1(v)); }

  void resize(std::size_t vertices);
  /// Writes a vertex, turning the frame until it is principal. K need not be diagonal before.
  void set(std::uint32_t v, const SurfacePoint& point);
  /// Vertex v in double precision, at the position it has in the mesh.
  SurfacePoint at(const TriangleMesh& mesh, std::uint32_t v) const;
};

/// See SurfaceFields::size. One pass over the triangles, in double.
double surfaceSize(const TriangleMesh& mesh);

}  // namespace flatland
