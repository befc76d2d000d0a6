// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flatland/scene/scene.h"

namespace flatland::ui {

/// What SCENE means, for the help texts.
inline constexpr const char* kSceneHelp = "Scene file, - for standard input, or preset:NAME";

/// The scene an argument names: a file, "-" for standard input, or "preset:" and a preset's id.
/// Throws InputError.
Scene sceneFromArgument(const std::string& argument);

/// True if the argument names a file.
bool namesFile(const std::string& argument);

/// The preset. Throws InputError, which lists the presets, if there is none of that id.
const Preset& presetNamed(const std::string& id);

}  // namespace flatland::ui
