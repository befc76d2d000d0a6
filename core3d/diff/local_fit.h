// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core3d/diff/height_fit.h"
#include "core3d/diff/surface_jet.h"
#include "core3d/diff/vertex_rings.h"

namespace flatland {

/// The surface round one vertex as heights over its tangent plane, ring by ring, in units of the
/// mean length of its edges. Owns buffers: one for each thread, used for one vertex after the
/// other.
///
/// A neighbour counts with the square of the cosine between its normal and that of the vertex, and
/// not at all from 90 degrees on: there the surface is no graph over this plane.
class LocalFit {
 public:
  /// `normals` of the vertices, 0 where there is none. All arguments must outlive the fit.
  LocalFit(const TriangleMesh& mesh, const VertexNeighbours& neighbours,
           const std::vector<Eigen::Vector3d>& normals);

  /// Rings 0 and 1. False if the vertex has no normal or no edge with a length.
  bool startAt(std::uint32_t v);
  /// Adds rings until there are k; false if the surface ends before.
  bool growTo(int k);

  /// The polynomial over all rings up to `size` >= 1, of degree 4 where that can be. Weights fall
  /// towards the rim so that the fit depends on the size continuously: 1 - (k / (size + 1))^2 for
  /// ring k.
  HeightPolynomial over(double size);
  /// startAt(v) and over(size) in one, for who asks nothing else: all rings are summed at once,
  /// which is faster and differs by rounding. Afterwards only pointOf may be asked. nullopt as
  /// startAt.
  std::optional<HeightPolynomial> at(std::uint32_t v, double size);
  /// Root mean square distance of the vertices of rings 1 to k from the polynomial, and the largest
  /// such distance of a single ring.
  struct Misses {
    double all, worstRing;
  };
  Misses misses(const HeightPolynomial& polynomial, int k) const;

  double edge() const { return edge_; }  ///< the unit of the heights, in that of the mesh
  /// How far the rounding of positions to floats moves the vertices along the normal, as a root
  /// mean square, in the mesh's unit. It is less near the middle of the mesh.
  double rounding() const;
  int points(int k) const;  ///< in the rings up to k
  SurfacePoint pointOf(const HeightPolynomial& polynomial) const;

 private:
  bool placeAt(std::uint32_t v);
  void addHeights(int k, double weight);
  void addRing(int k);

  const TriangleMesh& mesh_;
  const std::vector<Eigen::Vector3d>& normals_;
  VertexRings rings_;
  std::vector<HeightSums> sums_;         // of each ring
  std::vector<WeightedHeight> heights_;  // that are added next
  Eigen::Vector3d p_, n_, e1_, e2_;
  double edge_ = 1.0;
};

}  // namespace flatland
