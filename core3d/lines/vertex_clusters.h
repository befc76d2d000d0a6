// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core3d/lines/seen_vertices.h"
#include "core3d/mesh/pieces.h"

namespace flatland {

/// Vertices in clusters that lie together (they are in Hilbert order), each with bounds on what it
/// and its neighbours can show: which way the normals point and how large the curvatures are. A
/// view passes over clusters near which nothing can be found, so that its cost follows the lines
/// and not the mesh.
class VertexClusters {
 public:
  /// One pass over vertices and triangles, on all cores.
  VertexClusters(const TriangleMesh& mesh, const SurfaceFields& fields, const Sheets& sheets);

  /// The runs of vertices that a view has to compute, in order, covering all. A run is passed over
  /// only if that changes no face: all vertices of all faces at it face away and none is a sheet's,
  /// or they face one way with sqrt(lambda) below needs.minRoot and radial curvature of one sign.
  void runsFor(const SurfaceView& view, const VertexNeeds& needs,
               std::vector<VertexRun>& runs) const;

 private:
  static constexpr std::uint32_t kSize = 64;  // a few cells across on either side
  struct Cluster {
    Eigen::Vector3f axis, centre;
    float cosCone, sinCone;  ///< half-angle of the cone about the normals; cosCone < 0: unknown
    float radius;            ///< of a ball around the vertices
    float k1Max, k2Min;
    bool sheet;  ///< both sides may be seen
  };
  /// `around` is room for the vertices of its faces.
  Cluster clusterOf(const TriangleMesh& mesh, const SurfaceFields& fields, const Sheets& sheets,
                    std::uint32_t c, std::vector<std::uint32_t>& around) const;

  std::vector<Cluster> clusters_;
  std::uint32_t vertices_;
};

}  // namespace flatland
