// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/io/atomic_file.h"
#include "flatland/io/features_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/picture.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::optional<double> viewAngleDeg;
  std::string format;  // empty: as the output's name says, else json
  std::string output;
};

int run(const Options& options) {
  Scene scene = sceneFromArgument(options.scene);
  if (options.viewAngleDeg) scene.view.angleDeg = *options.viewAngleDeg;
  const FeatureSet features = findFeatures(scene);
  const bool csv =
      options.format.empty() ? extensionOf(options.output) == ".csv" : options.format == "csv";
  const std::string text = csv ? featuresToCsv(features) : featuresToJson(features, scene.view);
  if (options.output.empty()) {
    writeToStandardOutput(text);
  } else {
    writeFileAtomically(options.output, text);
  }
  return kDone;
}

}  // namespace

void addFeaturesCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "features",
      "Print every mark of a scene: silhouettes, inflections, ridges, valleys, flat points,\n"
      "corners, apparent ridges and minima, each with its place, the terms of the apparent-ridge\n"
      "equation, a residual, and whether it is seen.");
  command.add_option("scene", options->scene, kSceneHelp)->required()->type_name("SCENE");
  addViewAngle(command, options->viewAngleDeg);
  command
      .add_option("--format", options->format, "json or csv [csv if -o ends in .csv, else json]")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"json", "csv"}).description(""));
  command.add_option("-o,--output", options->output, "Write to this file, not to standard output")
      ->type_name("FILE");
  command.footer(
      "Examples:\n"
      "  flatland features scene.json                           all marks as JSON\n"
      "  flatland features preset:thesis --format csv -o m.csv  a table for a spreadsheet\n"
      "  flatland features scene.json --view-angle 30           seen from another side\n"
      "  flatland presets loop | flatland features -            from standard input\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
