// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// An edge at which the surface that a mesh stands for is creased.
struct SharpEdge {
  std::uint32_t halfEdge;  ///< the smaller of the two
  bool convex;             ///< as on a cube; else as inside of a box
};

/// A triangle with a vertex at which sharp edges part the surface: the normals of its corners, each
/// of the part of the surface that the corner belongs to.
struct SplitTriangle {
  std::uint32_t triangle;
  Eigen::Vector3f normal[3];  ///< unit; 0: unknown
  bool own[3];                ///< false: the corner's vertex is whole and has its normal of always
};

/// Where normals and curvatures of vertices say nothing, because the surface is creased.
///
/// An edge is **sharp** if its triangles turn by 30 degrees at least and by more than twice of what
/// the surface bends in the same direction at the triangles' other edges, or by 70 degrees. Edges
/// of a coarse round surface turn by as much as their neighbours and are not sharp; what stands
/// alone is. Up to 50 degrees the next edge of a flat quadrilateral is a neighbour too: a prism of
/// eight sides counts as round, one of six does not. An edge is not sharp if the surface turns back
/// to within 30 degrees at another edge of one of its triangles: a sliver may point anywhere.
///
/// Where two sharp edges in a row end, the edge that goes on in their direction is sharp too if it
/// turns by more than the surface beside it. Fewer than four edges that hang together, with no
/// border and no turn of 70 degrees among them, are not sharp: noise.
///
/// A vertex is **split** if its sharp edges (and border) part the triangles round it into two
/// sectors or more; a sector's normal is the mean of its triangles' normals, weighted by their
/// angles there. Sharp edges without a split end are not kept: nothing is parted there.
///
/// Degenerate answers: a triangle without area has no normal, and none of its edges is sharp.
class SharpEdges {
 public:
  /// One pass over the edges and one over the vertices of sharp ones.
  SharpEdges(const TriangleMesh& mesh, const SurfaceFields& fields);

  std::span<const SharpEdge> edges() const { return edges_; }
  std::span<const SplitTriangle> triangles() const { return triangles_; }  ///< by number

  /// True if a corner of the triangle is at a split vertex.
  bool splits(std::uint32_t triangle) const {
    return !places_.empty() && places_[triangle] != TriangleMesh::kNone;
  }
  /// Precondition: splits(triangle).
  const SplitTriangle& at(std::uint32_t triangle) const { return triangles_[places_[triangle]]; }

 private:
  std::vector<SharpEdge> edges_;
  std::vector<SplitTriangle> triangles_;
  std::vector<std::uint32_t> places_;  // in triangles_; empty if there are none
};

}  // namespace flatland
