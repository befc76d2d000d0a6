// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core3d/lines/vertex_terms.h"
#include "ui/model/loaded_surface.h"
#include "ui/model/orbit.h"

namespace flatland::ui {

/// What is under a pixel: the place, and what a view makes of the vertex nearest to it.
struct SurfaceReading {
  SurfaceHit hit;
  std::uint32_t vertex;      ///< of the mesh
  std::uint32_t fileVertex;  ///< the same in the file, from 0
  Eigen::Vector3d inFile;    ///< the place in the file's coordinates
  /// Towards growing lambda; empty before fields are there, or without a normal.
  std::optional<SurfaceTerms> terms;
};

/// The place of the surface under a pixel; nothing where the background is seen.
std::optional<SurfaceHit> hitAt(const LoadedSurface& surface, const Projection& projection,
                                const Eigen::Vector2d& px);

/// The same with what `view` makes of it, which may be another than the picture is of.
std::optional<SurfaceReading> readingAt(const LoadedSurface& surface, const Projection& projection,
                                        const Eigen::Vector2d& px, const SurfaceView& view);

}  // namespace flatland::ui
