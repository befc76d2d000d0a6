// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core3d/lines/feature_lines.h"

namespace flatland {

/// The lines of a mesh, view after view. Lines that do not depend on the view are found when they
/// are first asked for and kept; what a view needs per vertex is kept in buffers that the next view
/// uses again. `mesh` and `fields` must outlive the finder and stay unchanged.
///
/// Not for several threads at once; several finders may share a mesh.
class LineFinder {
 public:
  /// With `cull` = false every vertex is computed in every view, also where nothing can be found:
  /// the same lines, slower. For tests and measurements.
  LineFinder(const TriangleMesh& mesh, const SurfaceFields& fields, bool cull = true);
  ~LineFinder();
  LineFinder(LineFinder&&) noexcept;
  LineFinder& operator=(LineFinder&&) noexcept;

  /// All families that are on, in one walk over the mesh.
  FeatureLines find(const SurfaceView& view, const LineOptions& options);

  /// What the last find() took, wall clock.
  struct Times {
    double vertexMs = 0.0;   ///< quantities of the view per vertex
    double segmentMs = 0.0;  ///< the walk over the triangles
    double fixedMs = 0.0;    ///< lines that do not depend on the view; 0 when they were kept
  };
  const Times& times() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace flatland
