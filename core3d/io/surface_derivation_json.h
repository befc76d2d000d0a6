// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core3d/io/surface_derivation_text.h"

namespace flatland {

/// "place", "matrices" (row by row) and "steps", as derivationToJson. null: has no finite value.
std::string surfaceDerivationToJson(const SurfaceDerivation& derivation);

/// Chapter 5 on a triangle: corners, crossings, pieces with their tests, and the verdict. Places
/// are those of the file.
std::string triangleLessonToJson(const TriangleMesh& mesh, const TriangleLesson& lesson);

}  // namespace flatland
