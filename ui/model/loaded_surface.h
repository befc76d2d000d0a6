// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/mesh/mesh_report.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland::ui {

/// A surface ready to be shown: never changed once it is there, so that jobs and widgets share it.
struct LoadedSurface {
  std::string reference;  ///< as in SurfaceSetting::mesh
  std::shared_ptr<const TriangleMesh> mesh;
  MeshReport report;
  std::vector<Eigen::Vector3f> normals;  ///< per vertex, by area of the triangles; for shading
  double ballRadius = 1.0;               ///< of the ball about 0 that holds the mesh
  double loadMs = 0.0;

  std::shared_ptr<const SurfaceFields> fields;  ///< null until they are estimated
  double fitScale = 1.0;                        ///< FieldOptions::scale of them
  double fieldMs = 0.0;
};

/// Reads and mends the mesh that a reference names (named_mesh.h). Throws as loadNamedMesh.
LoadedSurface loadSurface(const std::string& reference);

/// The same surface with its fields. `progress` gets the share done and says whether to go on;
/// null if it said no. Minutes for millions of triangles.
std::shared_ptr<const LoadedSurface> withFields(const LoadedSurface& surface, double fitScale,
                                                const std::function<bool(double)>& progress);

/// What a person calls it: the file without its folder, or the solid.
std::string surfaceName(const std::string& reference);

}  // namespace flatland::ui
