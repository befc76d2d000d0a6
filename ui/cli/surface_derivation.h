// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "ui/cli/mesh_options.h"
#include "ui/cli/result_options.h"

namespace flatland::ui {

/// What `flatland derivation MESH` is told beside the mesh.
struct SurfaceDerivationOptions {
  std::string mesh;
  std::vector<double> point;  ///< 3, or none
  std::optional<std::uint32_t> vertex, triangle;
  double threshold = LineOptions{}.thresholdOf(LineFamily::ApparentRidges);
  Camera camera;
  FieldOptions fields;
};

/// The options, all but the mesh.
void addSurfaceDerivation(CLI::App& command, SurfaceDerivationOptions& options);
/// The names of those options that say nothing of a curve.
const std::vector<std::string>& surfaceDerivationOptionNames();

/// Writes chapter 4 at a vertex, or chapter 5 on a triangle. Throws InputError; UsageError for a
/// place that is not there.
void runSurfaceDerivation(const SurfaceDerivationOptions& options, const ResultOptions& result);

}  // namespace flatland::ui
