// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "core3d/diff/estimate_fields.h"
#include "core3d/draw/camera.h"
#include "core3d/lines/feature_lines.h"
#include "core3d/mesh/build_mesh.h"
#include "ui/cli/command_line.h"

namespace flatland::ui {

/// What MESH means, for the help texts.
inline constexpr const char* kMeshHelp =
    "Mesh file (PLY, OBJ, STL, OFF, glTF, GLB), or solid:NAME[:CELLS[:irregular]]";

/// The argument MESH.
void addMesh(CLI::App& command, std::string& mesh);

/// An option whose value is a direction x,y,z, stored as a unit vector.
void addDirection(CLI::App& command, const std::string& name, Eigen::Vector3d& direction,
                  const std::string& help);

/// The options --view, --up and --perspective.
void addCamera(CLI::App& command, Camera& camera);

/// --zoom and --centre: what of the mesh the picture shows.
void addFraming(CLI::App& command, Camera& camera);

/// The options --estimator, --scale and --threads.
void addFields(CLI::App& command, FieldOptions& fields);

/// The options --lines, --threshold, --unfiltered, --derivative, --isophotes, --topographic and
/// --topographic-up. Call setUsualLines before.
void addLineFamilies(CLI::App& command, LineOptions& lines);

/// Throws CLI::ValidationError for an option of a family that is not drawn: it would do nothing.
/// To be called when `command` was read, with the lines that it was read into.
void refuseIdleOptions(const CLI::App& command, const LineOptions& lines);

/// Contours, apparent ridges and boundaries.
void setUsualLines(LineOptions& lines);

/// A mesh with its fields, and what they took.
struct PreparedMesh {
  BuiltMesh built;
  SurfaceFields fields;
  double readMs = 0.0, fieldsMs = 0.0;  ///< wall clock
};

/// Reads the mesh and estimates its fields, with progress. What was mended is told on standard
/// error, in one line. Throws InputError; UsageError for a scale that one-ring cannot take.
PreparedMesh preparedMesh(const std::string& mesh, const FieldOptions& fields);

/// Throws UsageError if `output` is the file of the mesh, also by another path or a link.
void refuseToOverwrite(const std::string& mesh, const std::string& output);

/// Milliseconds since `start`, wall clock.
double millisecondsSince(std::chrono::steady_clock::time_point start);

}  // namespace flatland::ui
