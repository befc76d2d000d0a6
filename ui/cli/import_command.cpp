// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/io/scene_json.h"
#include "ui/cli/command_line.h"
#include "ui/cli/result_options.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string source;
  ResultOptions result;
  bool keepSize = false;
};

int run(const Options& options) {
  const ImportedScene imported =
      importFromArgument(options.source, {.comfortable = !options.keepSize});
  const std::string text = sceneToJson(imported.scene);
  writeResult(options.result, text);
  noteOnStandardError(options.source, imported);
  return kDone;
}

}  // namespace

void addImportCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "import",
      "Make a scene file from the outlines of an SVG drawing or of a letter of a font. What was\n"
      "done and what was left out is said on standard error.");
  command.add_option("source", options->source, "SVG file, or glyph:FAMILY:CHARACTER")
      ->required()
      ->type_name("SOURCE");
  addOutput(command, options->result);
  command.add_flag(
      "--keep-size", options->keepSize,
      "Lengths in pixels as in the drawing; without it the scene is scaled by a power\n"
      "of two to be 2 to 4 units across, and centred");
  command.footer(
      "Examples:\n"
      "  flatland import drawing.svg -o scene.json\n"
      "  flatland import drawing.svg --keep-size | flatland features -\n"
      "  flatland import \"glyph:DejaVu Sans:a\" -o a.json\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
