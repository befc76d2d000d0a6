// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/scene_argument.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "flatland/io/scene_json.h"
#include "ui/cli/command_line.h"
#include "ui/cli/qt_parts.h"
#include "ui/import/mesh_name.h"

namespace flatland::ui {

namespace {

constexpr std::string_view kPresetPrefix = "preset:";
constexpr std::string_view kGlyphPrefix = "glyph:";

bool namesPreset(const std::string& argument) { return argument.rfind(kPresetPrefix, 0) == 0; }
bool namesGlyph(const std::string& argument) { return argument.rfind(kGlyphPrefix, 0) == 0; }

Scene sceneAsItIs(const std::string& argument) {
  if (namesPreset(argument)) return presetNamed(argument.substr(kPresetPrefix.size())).scene;
  if (argument == "-") return loadSceneFromStandardInput();
  if (!namesGlyph(argument) && !isSvgName(argument)) return loadScene(argument);
  ImportedScene imported = importFromArgument(argument, {});
  noteOnStandardError(argument, imported);
  return std::move(imported.scene);
}

}  // namespace

Scene sceneFromArgument(const std::string& argument, std::optional<double> viewAngleDeg) {
  Scene scene = sceneAsItIs(argument);
  if (viewAngleDeg) scene.view.angleDeg = *viewAngleDeg;
  return scene;
}

Scene sceneToShow(const std::string& argument) {
  if (!namesSurface(argument)) return sceneFromArgument(argument);
  std::error_code error;
  if (!namesSolid(argument) && !std::filesystem::exists(argument, error)) {
    throw InputError(
        argument, "",
        "cannot be read: " + std::generic_category().message(error ? error.value() : ENOENT));
  }
  Scene scene = defaultScene();
  scene.surface = SurfaceSetting{};
  scene.surface->mesh =
      namesSolid(argument) ? argument : std::filesystem::absolute(argument).string();
  return scene;
}

bool namesSurface(const std::string& argument) {
  return namesSolid(argument) || isMeshName(argument);
}

void requireCurve(const Scene& scene, std::size_t curve) {
  const std::size_t count = scene.curves.size();
  if (curve < count) return;
  throw UsageError("--curve " + std::to_string(curve) + ": the scene has " + std::to_string(count) +
                   (count == 1 ? " curve" : " curves") + ", counted from 0");
}

void requirePlace(const SceneCurve& curve, double t) {
  const int end = pieceCount(curve.shape);
  if (t >= 0.0 && t <= end) return;
  throw UsageError("--t must lie between 0 and " + std::to_string(end) + " on this curve");
}

ImportedScene importFromArgument(const std::string& argument, const SvgOptions& options) {
  return namesGlyph(argument) ? glyphWithQt(argument) : loadSvg(argument, options);
}

void noteOnStandardError(const std::string& argument, const ImportedScene& imported) {
  std::fprintf(stderr, "flatland: %s: %s\n", argument.c_str(), imported.note().c_str());
}

bool namesFile(const std::string& argument) {
  return argument != "-" && !namesPreset(argument) && !namesGlyph(argument) &&
         !namesSolid(argument);
}

const Preset& presetNamed(const std::string& id) {
  std::string known;
  for (const Preset& preset : allPresets()) {
    if (preset.id == id) return preset;
    known += (known.empty() ? "" : ", ") + preset.id;
  }
  throw InputError(std::string(kPresetPrefix) + id, "", "no such preset; there are " + known);
}

}  // namespace flatland::ui
