// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "flatland/io/scene_json.h"
#include "ui/cli/command_line.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

std::string listOfPresets() {
  std::size_t longest = 0;
  for (const Preset& preset : allPresets()) longest = std::max(longest, preset.id.size());
  std::string list;
  for (const Preset& preset : allPresets()) {
    list += preset.id + std::string(longest + 2 - preset.id.size(), ' ') + preset.name + ". " +
            preset.description + "\n";
  }
  return list;
}

}  // namespace

void addPresetsCommand(CLI::App& app, Action& action) {
  const auto name = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand(
      "presets", "List the built-in scenes, or print one as a scene file to start from.");
  command.add_option("name", *name, "Preset to print")->type_name("NAME");
  command.footer(
      "Examples:\n"
      "  flatland presets                     what there is\n"
      "  flatland presets bump > mine.json    a scene to edit\n");
  command.final_callback([name, &action] {
    action = [name] {
      writeToStandardOutput(name->empty() ? listOfPresets()
                                          : sceneToJson(presetNamed(*name).scene));
      return static_cast<int>(kDone);
    };
  });
}

}  // namespace flatland::ui
