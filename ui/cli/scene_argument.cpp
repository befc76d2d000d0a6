// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/scene_argument.h"

#include <string_view>

#include "flatland/io/scene_json.h"

namespace flatland::ui {

namespace {

constexpr std::string_view kPresetPrefix = "preset:";

bool namesPreset(const std::string& argument) { return argument.rfind(kPresetPrefix, 0) == 0; }

}  // namespace

Scene sceneFromArgument(const std::string& argument) {
  if (namesPreset(argument)) return presetNamed(argument.substr(kPresetPrefix.size())).scene;
  if (argument == "-") return loadSceneFromStandardInput();
  return loadScene(argument);
}

bool namesFile(const std::string& argument) { return argument != "-" && !namesPreset(argument); }

const Preset& presetNamed(const std::string& id) {
  std::string known;
  for (const Preset& preset : presets()) {
    if (preset.id == id) return preset;
    known += (known.empty() ? "" : ", ") + preset.id;
  }
  throw InputError(std::string(kPresetPrefix) + id, "", "no such preset; there are " + known);
}

}  // namespace flatland::ui
