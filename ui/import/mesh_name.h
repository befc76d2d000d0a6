// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string>

namespace flatland::ui {

/// The extensions of mesh files that can be read, without the dot.
inline constexpr std::array<const char*, 6> kMeshExtensions = {"ply", "obj",  "stl",
                                                               "off", "gltf", "glb"};

/// True if the name ends like a mesh file, in letters of either case.
inline bool isMeshName(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(kMeshExtensions.begin(), kMeshExtensions.end(),
                     [&](const char* known) { return extension == std::string(".") + known; });
}

}  // namespace flatland::ui
