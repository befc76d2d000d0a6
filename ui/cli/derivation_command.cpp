// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/features/orientation.h"
#include "flatland/io/derivation_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/result_options.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::size_t curve = 0;
  double t = 0.5;
  std::optional<double> viewAngleDeg;
  ResultOptions result{.format = "text", .output = {}};
};

int run(const Options& options) {
  const Scene scene = sceneFromArgument(options.scene, options.viewAngleDeg);
  requireCurve(scene, options.curve);
  const SceneCurve& curve = scene.curves[options.curve];
  requirePlace(curve, options.t);
  const ViewFrame frame = frameOf(scene.view);
  const auto rows = derivationRows({curve.shape, options.t, frame, normalSide(curve, frame)});
  const std::string text = options.result.format == "json"  ? derivationToJson(rows)
                           : options.result.format == "csv" ? derivationToCsv(rows)
                                                            : derivationToText(rows);
  writeResult(options.result, text);
  return kDone;
}

}  // namespace

void addDerivationCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "derivation",
      "Check the derivation of the apparent-ridge equation at a place of a curve: for each "
      "equation\n"
      "of the thesis both sides, the residual, the same as printed where the print is wrong, and\n"
      "difference quotients over a range of step sizes.");
  command.add_option("scene", options->scene, kSceneHelp)->required()->type_name("SCENE");
  command.add_option("--curve", options->curve, "Which curve, from 0 [0]")->type_name("N");
  command.add_option("--t", options->t, "Where on it: piece number plus parameter, from 0 [0.5]")
      ->type_name("T");
  addViewAngle(command, options->viewAngleDeg);
  command.add_option("--format", options->result.format, "text, json or csv [text]")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"text", "json", "csv"}).description(""));
  addOutput(command, options->result);
  command.footer(
      "Examples:\n"
      "  flatland derivation preset:thesis --t 0.3\n"
      "  flatland derivation scene.json --curve 1 --t 2.5 --format json -o check.json\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
