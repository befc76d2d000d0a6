// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "flatland/io/svg_file.h"
#include "flatland/scene/scene.h"

namespace flatland::ui {

/// What SCENE means, for the help texts.
inline constexpr const char* kSceneHelp =
    "Scene file, SVG file (.svg), - for standard input, preset:NAME or glyph:FAMILY:CHARACTER";

/// The scene an argument names: a file, "-" for standard input, "preset:" and a preset's id, or
/// "glyph:FAMILY:CHARACTER". A glyph and a name that ends in .svg are imported; what was done and
/// left out is said on standard error. `viewAngleDeg`, of --view-angle, replaces the direction the
/// scene has. Throws InputError; UsageError for a glyph without Qt.
Scene sceneFromArgument(const std::string& argument, std::optional<double> viewAngleDeg = {});

/// The same for what shows scenes: a mesh file or solid:NAME is put beside the curves of the first
/// preset. Whether the mesh can be read is found out by who shows it; a file must be there. Throws
/// InputError.
Scene sceneToShow(const std::string& argument);

/// True if the argument names a built-in solid or, by its extension, a mesh file.
bool namesSurface(const std::string& argument);

/// What SCENE means there, for the help texts.
inline constexpr const char* kShownHelp =
    "Scene file, SVG file (.svg), mesh (.ply .obj .stl .off .gltf .glb), - for standard input, "
    "preset:NAME, solid:NAME or glyph:FAMILY:CHARACTER";

/// Throws UsageError, which says how many curves there are, if the scene has no curve of this
/// number.
void requireCurve(const Scene& scene, std::size_t curve);

/// Throws UsageError unless 0 <= t <= the number of the curve's pieces. For --t.
void requirePlace(const SceneCurve& curve, double t);

/// The scene made from an SVG file or a glyph, to which `options` do not apply. Throws as above.
ImportedScene importFromArgument(const std::string& argument, const SvgOptions& options);

/// "flatland: FILE: what was done; what was left out", one line.
void noteOnStandardError(const std::string& argument, const ImportedScene& imported);

/// True if the argument names a file.
bool namesFile(const std::string& argument);

/// The preset. Throws InputError, which lists the presets, if there is none of that id.
const Preset& presetNamed(const std::string& id);

}  // namespace flatland::ui
