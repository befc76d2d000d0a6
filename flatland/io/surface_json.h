// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "flatland/io/json_node.h"
#include "flatland/scene/surface_setting.h"

namespace flatland {

/// The "surface" of a scene file of version 3 or later; the mesh as it stands there. Throws
/// InputError. Names of styles, quantities and families are checked by who knows them.
SurfaceSetting surfaceFrom(const JsonNode& node);

/// True if version 3 cannot hold it: it has further views, ink, a swept surface or a plane.
bool needsVersion4(const SurfaceSetting& surface);

/// The surface as the value of that key; `path` is its place, for errors. Throws InputError for
/// what the format cannot hold.
std::string surfaceText(const SurfaceSetting& surface, const std::string& path);

}  // namespace flatland
