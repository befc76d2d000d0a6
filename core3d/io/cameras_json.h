// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core3d/draw/camera.h"

namespace flatland {

/// A camera of a list, with the name that tells its picture from the others.
struct NamedCamera {
  std::string name;  ///< letters, digits, "-" and "_"; empty: it goes by its number
  Camera camera;
};

inline constexpr std::size_t kMostCameras = 100000;

/// Reads a list of cameras (docs/user/lines.md). What a camera does not say it has from `usual`.
/// `source` names the text in errors. Throws InputError with the place in the file: for an unknown
/// key, a direction without length, an angle out of range, a name that stands twice, an empty list.
std::vector<NamedCamera> camerasFromJson(const std::string& text, const std::string& source,
                                         const Camera& usual);

/// Reads a file. Throws InputError, also when the file cannot be read.
std::vector<NamedCamera> loadCameras(const std::filesystem::path& file, const Camera& usual);

/// "view", "up", "perspectiveDeg", "zoom" and, if it has one, "centre" of one camera as the object
/// that the list has of it.
std::string cameraToJson(const Camera& camera);

/// A list that camerasFromJson reads. Precondition: names as it asks for, none twice.
std::string camerasToJson(const std::vector<NamedCamera>& cameras);

}  // namespace flatland
