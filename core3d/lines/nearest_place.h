// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "core3d/lines/vertex_terms.h"

namespace flatland {

/// The place of a mesh that is nearest to a point, in coordinates of the mesh; of places equally
/// near that of the first triangle. nullopt for a mesh without triangles. Tries every triangle:
/// for a place that a person picked and not for many.
std::optional<SurfaceHit> nearestPlace(const TriangleMesh& mesh, const Eigen::Vector3d& p);

}  // namespace flatland
