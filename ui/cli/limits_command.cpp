// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "flatland/io/limits_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/number_check.h"
#include "ui/cli/result_options.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::size_t curve = 0;
  std::optional<double> t;  ///< none: the middle of the curve
  std::optional<double> viewAngleDeg;
  ResultOptions result;
};

int run(const Options& options) {
  const Scene scene = sceneFromArgument(options.scene, options.viewAngleDeg);
  requireCurve(scene, options.curve);
  const SceneCurve& shape = scene.curves[options.curve];
  const double t = options.t.value_or(0.5 * pieceCount(shape.shape));
  requirePlace(shape, t);
  const int curve = static_cast<int>(options.curve);
  std::vector<LimitSeries> series;
  for (auto& found : {turnToSilhouette(scene, curve, t), walkToSilhouette(scene, curve, t),
                      slideIntoSilhouette(scene, curve, t)}) {
    if (found) series.push_back(*found);
  }
  const std::string text = wantsCsv(options.result) ? limitsToCsv(series) : limitsToJson(series);
  writeResult(options.result, text);
  return kDone;
}

}  // namespace

void addLimitsCommand(CLI::App& study, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *study.add_subcommand(
      "limits",
      "How lambda and the two terms grow or vanish on the way to a silhouette: turning the view "
      "at\n"
      "a point, walking along the curve, and an apparent ridge that slides into a silhouette. "
      "Each\n"
      "power law is predicted, and fitted to the last decade that rounding leaves alone.");
  command.add_option("scene", options->scene, kSceneHelp)->required()->type_name("SCENE");
  isWhole(command.add_option("--curve", options->curve, "Which curve, from 0 [0]")->type_name("N"),
          0, std::numeric_limits<std::int32_t>::max());
  isNumber(
      command
          .add_option("--t", options->t, "The point: piece plus parameter [middle of the curve]")
          ->type_name("T"));
  addViewAngle(command, options->viewAngleDeg);
  addJsonOrCsv(command, options->result);
  addOutput(command, options->result);
  command.footer(
      "Examples:\n"
      "  flatland study limits preset:thesis --curve 0 --t 0.4\n"
      "  flatland study limits scene.json --t 0.4 -o limits.csv\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
