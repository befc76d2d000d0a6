// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// What a view makes of a place of a surface, dimensionless: lengths are in units of
/// SurfaceFields::size. Signs of the terms as in ApparentCurvature: feature and offset share one
/// sign that is a matter of choice, their sizes and ratio are not.
struct SurfaceTerms {
  double k1, k2;                       ///< curvatures, k1 >= k2
  double nw;                           ///< n.w: 1 facing the viewer, 0 on a contour
  std::optional<double> lambda;        ///< view-dependent curvature; empty on a contour
  double feature = 0.0, offset = 0.0;  ///< of 1/2 D_tA lambda; 0 without lambda
  double perspective = 0.0;            ///< the third term; 0 when orthographic
  Eigen::Vector3d n;                   ///< unit normal
  Eigen::Vector3d r =
      Eigen::Vector3d::Zero();  ///< tangent, projects to t_A; coordinates of the mesh

  /// The same with r turned to where lambda grows, so that the sum of the terms is >= 0: what is
  /// positive makes lambda grow, what is negative works against it. The choice of r itself has no
  /// meaning, and from vertex to vertex no order.
  SurfaceTerms towardsGrowth() const;

  /// |offset| / |feature|; empty where both vanish, infinite where only the feature term does.
  std::optional<double> offsetShare() const;
};

/// The terms at a vertex; nullopt where the normal is unknown. In double; some 100 operations.
std::optional<SurfaceTerms> termsAt(const TriangleMesh& mesh, const SurfaceFields& fields,
                                    const SurfaceView& view, std::uint32_t vertex);

/// Where a line of sight meets a mesh first.
struct SurfaceHit {
  std::uint32_t triangle;
  std::array<double, 3> weights;  ///< of its corners, >= 0, sum 1
  Eigen::Vector3d at;             ///< coordinates of the mesh

  /// The corner with the largest weight.
  std::uint32_t nearestVertex(const TriangleMesh& mesh) const;
};

}  // namespace flatland
