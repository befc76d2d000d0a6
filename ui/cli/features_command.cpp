// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/io/features_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/result_options.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::optional<double> viewAngleDeg;
  ResultOptions result;
};

int run(const Options& options) {
  const Scene scene = sceneFromArgument(options.scene, options.viewAngleDeg);
  const FeatureSet features = findFeatures(scene);
  const std::string text =
      wantsCsv(options.result) ? featuresToCsv(features) : featuresToJson(features, scene.view);
  writeResult(options.result, text);
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
  addJsonOrCsv(command, options->result);
  addOutput(command, options->result);
  command.footer(
      "Examples:\n"
      "  flatland features scene.json                           all marks as JSON\n"
      "  flatland features preset:thesis --format csv -o m.csv  a table for a spreadsheet\n"
      "  flatland features scene.json --view-angle 30           seen from another side\n"
      "  flatland presets loop | flatland features -            from standard input\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
