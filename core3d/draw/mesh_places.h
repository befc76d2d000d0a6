// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "core3d/lines/vertex_terms.h"
#include "core3d/mesh/triangle_mesh.h"

struct RTCSceneTy;

namespace flatland {

/// Answers which place of a mesh a line meets first, and which is nearest to a point, by a
/// structure for rays (wald2014, Embree): microseconds each, whatever the number of triangles.
/// Building it takes 0.1 to 1 microseconds and some 100 bytes a triangle. `mesh` must outlive it.
/// Asking is const and may be done by several threads.
class MeshPlaces {
 public:
  /// Throws std::bad_alloc, or std::runtime_error if Embree does not start.
  explicit MeshPlaces(const TriangleMesh& mesh);
  ~MeshPlaces();
  MeshPlaces(MeshPlaces&&) noexcept;
  MeshPlaces& operator=(MeshPlaces&&) noexcept;

  const TriangleMesh& mesh() const;

  /// The nearest hit in front of `from` along the unit vector `along`; for an orthographic view,
  /// from where `from` is any point of the line, give `wholeLine`. All in coordinates of the mesh.
  /// Found by floats and then set exactly; where the line passes within 1e-6 of a rim or an
  /// outline, a neighbouring triangle may be taken for the one that it meets. nullopt if none.
  std::optional<SurfaceHit> firstHit(const Eigen::Vector3d& from, const Eigen::Vector3d& along,
                                     bool wholeLine) const;

  /// The place that is nearest to a point; of places equally near that of the first triangle.
  /// nullopt for a mesh without triangles. Slower far from the mesh, where all is equally near.
  std::optional<SurfaceHit> nearest(const Eigen::Vector3d& p) const;

  /// For rays that are judged otherwise (Sight): filters of the context are asked.
  RTCSceneTy* scene() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The place of one triangle that is nearest to a point, in coordinates of the mesh.
SurfaceHit nearestInTriangle(const TriangleMesh& mesh, std::uint32_t triangle,
                             const Eigen::Vector3d& p);

/// Makes the processor treat the smallest numbers as 0 in this thread while it lives, as Embree
/// asks for.
class FlushDenormals {
 public:
  FlushDenormals();
  ~FlushDenormals();
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_ = 0;
};

}  // namespace flatland
