// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/draw/mesh_places.h"
#include "core3d/mesh/mesh_report.h"
#include "core3d/mesh/triangle_mesh.h"
#include "core3d/study/bridge_lines.h"

namespace flatland::ui {

/// What a swept mesh was made from: so that its lines can be held against those that flatland
/// knows.
struct SweptOrigin {
  SweptSurface surface;
  SweptMesh mesh;
  int cells;
};

/// A surface ready to be shown: never changed once it is there, so that jobs and widgets share it.
struct LoadedSurface {
  std::string reference;  ///< as in SurfaceSetting::mesh
  std::shared_ptr<const TriangleMesh> mesh;
  std::shared_ptr<const MeshPlaces> places;  ///< of `mesh`, which lives as long
  MeshReport report;
  std::vector<Eigen::Vector3f> normals;  ///< per vertex, by area of the triangles; for shading
  double ballRadius = 1.0;               ///< of the ball about 0 that holds the mesh
  double loadMs = 0.0;

  std::shared_ptr<const SurfaceFields> fields;  ///< null until they are estimated
  double fitScale = 1.0;                        ///< FieldOptions::scale of them
  double fieldMs = 0.0;

  std::shared_ptr<const SweptOrigin> swept;  ///< null unless it is swept from a curve
};

/// True if lines of one may be shown on the other: they share a mesh, or are swept both.
inline bool isSameSurface(const LoadedSurface& a, const LoadedSurface& b) {
  return a.mesh == b.mesh || (a.swept && b.swept);
}

/// Reads and mends the mesh that a reference names (named_mesh.h). Throws as loadNamedMesh, and as
/// MeshPlaces, without which nothing of it could be picked nor told to be hidden.
LoadedSurface loadSurface(const std::string& reference);

/// A mesh of a swept surface, under the reference kSweptMesh. Throws InputError if it has no area,
/// and as MeshPlaces.
LoadedSurface loadSwept(const SweptSurface& surface, int cells);

/// The same surface with its fields. `progress` gets the share done and says whether to go on;
/// null if it said no. Minutes for millions of triangles.
std::shared_ptr<const LoadedSurface> withFields(const LoadedSurface& surface, double fitScale,
                                                const std::function<bool(double)>& progress);

/// What a person calls it: the file without its folder, the solid, or "swept curve".
std::string surfaceName(const std::string& reference);

}  // namespace flatland::ui
