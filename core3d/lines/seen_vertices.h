// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// Normals are unit vectors or, where unknown, 0: halfway between, squared.
inline constexpr float kKnownNormalSq = 0.25f;

/// What a face asks of its vertices before it looks closer, in one byte for each.
struct VertexFlag {
  /// Signs of the components of SeenVertices::r. Two directions that disagree (negative product)
  /// differ in one of them at least.
  static constexpr std::uint8_t kOctant = 1 | 2 | 4;
  static constexpr std::uint8_t kStrong = 8;     ///< sqrt(lambda) reaches the asked bound
  static constexpr std::uint8_t kFront = 16;     ///< n.w > 0
  static constexpr std::uint8_t kRadial = 32;    ///< radial > 0
  static constexpr std::uint8_t kKnown = 64;     ///< the normal is not 0
  static constexpr std::uint8_t kSkipped = 128;  ///< culled: nothing but flags is written
};

/// What is asked of the vertices.
struct VertexNeeds {
  bool ridges = false;      ///< view-dependent curvature and its derivative
  bool radial = false;      ///< radial curvature
  bool facing = false;      ///< n.w everywhere, also where no silhouette can be near
  float minRoot = -1.0f;    ///< bound for kStrong, 1/length; negative: all are strong
  bool everywhere = false;  ///< no cluster may be passed over
};

/// The quantities of one view, per vertex: the closed form of view-dependent curvature
/// (docs/math/lines.md) multiplied with powers of n.w, so that all stay finite up to and across the
/// silhouette, where lambda itself is infinite. With lambda, r and 1/2 D_tA lambda as in
/// flatland/view/apparent_curvature.h:
///
///   root  = |n.w| sqrt(lambda)          slope = (n.w)^4 |1/2 D_tA lambda|
///   r     = |n.w| r, as a vector of space, turned so that lambda grows along it
///
/// Degenerate answers: K = 0, an unknown normal and numbers beyond the range of float give root,
/// slope and r 0. Vertices that a culled cluster skips keep whatever stood there (see
/// VertexClusters); their flags say that nothing is to be found near them.
struct SeenVertices {
  std::vector<float> nw;
  std::vector<float> root, slope, rx, ry, rz;
  std::vector<float> radial;  ///< K(w_T, w_T); above 0 wherever k2 is, also head on
  std::vector<std::uint8_t> flags;

  /// Makes room for what is needed; keeps the memory of the last view.
  void resize(std::size_t vertices, const VertexNeeds& needs);
  Eigen::Vector3f r(std::uint32_t v) const { return {rx[v], ry[v], rz[v]}; }
};

/// A run of vertices, all of which need the same.
struct VertexRun {
  std::uint32_t begin, end;
  bool nw, ridges, radial;  ///< to be computed; where all are false only flags are written
  std::uint8_t flags = 0;   ///< where all are false; kRadial of it wherever `radial` is false
};

/// Computes the runs, in SIMD with whatever the processor offers (Highway, chosen at run time). No
/// allocation; reads each field once. Sizes of `out` must fit.
void seeVertices(const TriangleMesh& mesh, const SurfaceFields& fields, const SurfaceView& view,
                 float minRoot, std::span<const VertexRun> runs, SeenVertices& out);

}  // namespace flatland
