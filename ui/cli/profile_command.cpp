// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "flatland/io/profile_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/number_check.h"
#include "ui/cli/result_options.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::optional<double> viewAngleDeg;
  std::optional<int> curve;
  ResultOptions result;
};

int run(const Options& options) {
  const Scene scene = sceneFromArgument(options.scene, options.viewAngleDeg);
  if (options.curve) requireCurve(scene, static_cast<std::size_t>(*options.curve));
  const int count = static_cast<int>(scene.curves.size());
  const FeatureSet features = findFeatures(scene);
  std::vector<Profile> profiles;
  for (int i = 0; i < count; ++i) {
    if (!options.curve || *options.curve == i) profiles.push_back(profileOf(scene, features, i));
  }
  const std::string text = profileToCsv(profiles);
  writeResult(options.result, text);
  return kDone;
}

}  // namespace

void addProfileCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "profile",
      "Tabulate curvature, view-dependent curvature and the terms of the apparent-ridge equation\n"
      "along each curve, as CSV. Samples are dense where a quantity bends or grows without bound,\n"
      "and every mark is one. A new segment begins where something breaks.");
  command.add_option("scene", options->scene, kSceneHelp)->required()->type_name("SCENE");
  addViewAngle(command, options->viewAngleDeg);
  isWhole(command.add_option("--curve", options->curve, "Only this curve, from 0 [all]")
              ->type_name("N"),
          0, std::numeric_limits<std::int32_t>::max());
  addOutput(command, options->result);
  command.footer(
      "Examples:\n"
      "  flatland profile scene.json -o profile.csv\n"
      "  flatland profile preset:thesis --view-angle 30 > profile.csv\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
