// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core3d/draw/drawing.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// A drawing as JSON (docs/user/lines.md): {"polylines": [{"family", "visible", "closed", "points",
/// "screen", "strength"}], "stats"}, with "level" on lines that have levels. "points" are in the
/// coordinates of the mesh's file, "screen" in px (x right, y down). Numbers read back to the same
/// double. `statsJson` is an object that is put in as it is.
std::string drawingToJson(const Drawing& drawing, const TriangleMesh& mesh,
                          const std::string& statsJson);

}  // namespace flatland
