// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "flatland/io/input_error.h"
#include "flatland/scene/scene.h"

namespace flatland {

/// The limits of the format, which are those of the program: beyond them a file is refused.
inline constexpr int kHighestDegree = 64;
inline constexpr double kLargestLength =
    1e50;  ///< of coordinates and the distance: powers up to the sixth stay finite
inline constexpr std::size_t kLargestSceneBytes = 64U * 1024U * 1024U;

/// Reads the scene format of docs/user/scene-format.md, versions 1 to 4. `source` names the text
/// in errors. Throws InputError; nothing is guessed or dropped: an unknown key is an error too.
Scene sceneFromJson(const std::string& text, const std::string& source);

/// The scene as JSON, of version 1 if it needs nothing newer; numbers are written so that they read
/// back to the same double. Throws InputError for a scene the format cannot hold: a number that is
/// not finite, a length above kLargestLength, a degree above kHighestDegree.
std::string sceneToJson(const Scene& scene);

/// Reads a file. The mesh of a surface becomes an absolute path; whether it is there is not looked
/// at. Throws InputError, also when the file cannot be read.
Scene loadScene(const std::filesystem::path& file);

/// Reads standard input to its end; "standard input" is its name in errors. Throws InputError.
Scene loadSceneFromStandardInput();

/// Writes a file atomically: a temporary beside it, flushed to disk, then renamed over it, so a
/// crash leaves the old file or the new one. The mesh of a surface is written relative to it.
/// Throws InputError if it cannot be written; the old file is then untouched.
void saveScene(const Scene& scene, const std::filesystem::path& file);

}  // namespace flatland
