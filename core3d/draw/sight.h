// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "core3d/diff/surface_fields.h"
#include "core3d/draw/mesh_places.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// A point of a line, to be looked at.
struct SightPoint {
  Eigen::Vector3d at;      ///< coordinates of the mesh
  std::uint32_t triangle;  ///< it lies in, or on the rim of
  /// The line was found by interpolation and lies on the smooth surface that the mesh stands for:
  /// where that surface does not turn away, neighbouring triangles do not hide the point.
  bool interpolated;
  /// The second triangle that it lies in, if any: beyond an edge that it lies on, or of the sheet
  /// that crosses the first one there. It is looked at from the viewer's side of both, and if the
  /// line is interpolated elsewhere, also as there from the triangle that is turned to him.
  std::uint32_t other = TriangleMesh::kNone;
  bool contour = false;  ///< of an occluding contour: the smooth surface folds over there
};

/// Answers what a mesh hides, by casting rays (wald2014, Embree). A line lies on the very surface
/// that may hide it, so a hit does not count
/// - on a triangle that the point lies in,
/// - within a hundredth of a per cent of the mesh's size, or a tenth of a per cent on a triangle
///   that has a vertex in common with one of its own;
/// - if the line is interpolated and the smooth normal there does not face away: on a triangle of
///   the same fold, one or two steps over common vertices away, each bent by less than 70 degrees,
///   and within about twice the triangle's size. A contour lies between front and back, and the
///   facets beside it stick out over the smooth outline.
/// Besides, the ray starts a little off the surface, on the viewer's side: by `offset` along its
/// normal, or by a fifth of it off both triangles, as nothing has to be allowed for there.
///
/// The structure for rays is built once (MeshPlaces), or lent. Whatever is given must outlive it.
/// Asking is const and may be done by several threads, each with a FlushDenormals.
class Sight {
 public:
  Sight(const TriangleMesh& mesh, const SurfaceFields& fields);
  Sight(const MeshPlaces& places, const SurfaceFields& fields);
  ~Sight();
  Sight(Sight&&) noexcept;
  Sight& operator=(Sight&&) noexcept;

  /// True if something stands between the point and the viewer.
  bool hidden(const SightPoint& point, const SurfaceView& view, double offset) const;

  /// True if the whole line of sight through a point beside the line, off the surface, meets
  /// nothing; hits near `point` are judged as for an interpolated line, at any distance.
  bool empty(const SightPoint& point, const Eigen::Vector3d& beside, const SurfaceView& view) const;

  /// Interpolated from the vertices; the triangle's own where they have none. Unit, or 0.
  Eigen::Vector3d normalAt(const SightPoint& point) const;

  /// That normal on the viewer's side. Sheets may be seen from behind: there it is turned round if
  /// it faces away, and at a contour, where it does neither, if the surface is concave along the
  /// view. Elsewhere it points out of the body as it is.
  Eigen::Vector3d outwardAt(const SightPoint& point, const SurfaceView& view) const;

  Eigen::Vector3d middleOf(std::uint32_t triangle) const;  ///< its centroid

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace flatland
