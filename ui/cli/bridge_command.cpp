// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include "core3d/io/bridge_json.h"
#include "core3d/io/bridge_text.h"
#include "core3d/io/convergence_text.h"
#include "flatland/io/atomic_file.h"
#include "ui/cli/mesh_commands.h"
#include "ui/cli/mesh_options.h"
#include "ui/cli/number_check.h"
#include "ui/cli/picture.h"
#include "ui/cli/progress.h"
#include "ui/cli/scene_argument.h"
#include "ui/cli/suggestion.h"
#include "ui/export/convergence_figure.h"

namespace flatland::ui {

namespace {

constexpr int kFewestCells = 8, kMostCells = 2000;
constexpr double kAbovePlane = 0.5;  // of the view of an extrusion, if it is not given

struct Options {
  std::string scene, output;
  std::string command;  ///< for the file's account of itself
  std::size_t curve = 0;
  double height = 2.0, axis = 0.0;
  bool extrude = false, revolve = false, viewGiven = false;
  Eigen::Vector3d towards = Eigen::Vector3d::UnitY();
  BridgeOptions study;
  BridgeTrialOptions trials{.count = 0};
  bool cellsGiven = false;
  PixelSize size{720, 480};
};

std::string whyNotOutput(const std::string& file) {
  const std::string extension = extensionOf(file);
  if (isPicture(file) || extension == ".csv" || extension == ".json") return {};
  return "the name " + file + " should end in .csv, .json, .svg, .pdf, .png or .tex";
}

int runTrials(const Options& options) {
  if (!options.scene.empty() || options.extrude || options.revolve || options.viewGiven) {
    throw UsageError("--random draws its own curves and views; give no scene, sweep or view");
  }
  const std::string extension = extensionOf(options.output);
  if (isPicture(options.output)) {
    throw UsageError("--random writes .csv or .json; a diagram is of one surface");
  }
  BridgeTrialOptions study = options.trials;
  if (options.cellsGiven) study.cells = options.study.cells.back();
  study.threshold = options.study.threshold;
  BridgeTrials trials;
  {
    Progress progress;
    study.progress = [&progress](double share) {
      progress.say(std::to_string(std::lround(100.0 * share)) + " %");
    };
    trials = measureRandomBridges(study);
  }
  writeToStandardOutput(bridgeTable(trials, study));
  if (extension == ".csv") writeFileAtomically(options.output, bridgeCsv(trials));
  if (extension == ".json") writeFileAtomically(options.output, bridgeJson(trials, study));
  return kDone;
}

void write(const Options& options, const BridgePrediction& prediction,
           const std::vector<BridgeSeries>& all) {
  const std::string extension = extensionOf(options.output);
  if (extension == ".csv") {
    writeFileAtomically(options.output, bridgeCsv(all));
    return;
  }
  const std::string json = bridgeJson(prediction, all);
  if (extension == ".json") {
    writeFileAtomically(options.output, json);
    return;
  }
  ConvergenceFigureOptions figure;
  figure.width = options.size.width;
  figure.height = options.size.height;
  std::vector<ConvergenceSeries> shown;
  for (const BridgeSeries& series : all) shown.push_back(convergenceOf(series));
  writePicture(options.output, convergenceFigure(shown, "bridge", figure),
               {.title = "Flatland, bridge: " + withoutFolders(options.scene),
                .program = "flatland " FLATLAND_VERSION,
                .command = options.command,
                .sceneJson = json,
                .sceneName = "bridge"});
}

int runScene(const Options& options) {
  if (options.scene.empty()) throw UsageError("a scene or --random is needed");
  if (options.extrude && options.revolve) {
    throw UsageError("--extrude and --revolve exclude each other");
  }
  if (!options.output.empty()) requireQtFor(options.output);
  const Scene scene = sceneFromArgument(options.scene);
  requireCurve(scene, options.curve);
  const SceneCurve& curve = scene.curves[options.curve];
  const SweptSurface surface{
      curve.shape, options.revolve ? SweptSurface::Kind::Revolution : SweptSurface::Kind::Extrusion,
      options.revolve ? options.axis : options.height};
  Eigen::Vector3d towards = options.towards;
  if (!options.viewGiven && !options.revolve) {
    const Vec2 w = frameOf(scene.view).towards;
    towards = Eigen::Vector3d(w.x(), w.y(), kAbovePlane).normalized();
  }
  const SurfaceView view{.towards = towards, .eye = {}};
  const BridgePrediction prediction(turnedLike(curve, surface, view), view);
  if (!prediction.flat().view) throw UsageError(prediction.flat().whyNot);
  std::vector<BridgeSeries> all;
  {
    Progress progress;
    BridgeOptions study = options.study;
    study.progress = [&progress](double share) {
      progress.say(std::to_string(std::lround(100.0 * share)) + " %");
    };
    all = measureBridge(prediction, study);
  }
  writeToStandardOutput(bridgeTable(prediction, all));
  if (!options.output.empty()) write(options, prediction, all);
  return kDone;
}

}  // namespace

void addBridgeCommand(CLI::App& app, Action& action, const std::string& commandLine) {
  const auto options = std::make_shared<Options>();
  options->command = commandLine;
  CLI::App& command = *app.add_subcommand(
      "bridge",
      "A curve swept into a surface: where flatland says its lines are, where they are found on\n"
      "meshes of it, and how far these are apart. The table goes to standard output.");
  command.add_option("scene", options->scene, kSceneHelp)->type_name("SCENE");
  isWhole(command.add_option("--curve", options->curve, "Which curve, from 0 [0]")->type_name("N"),
          0);
  isNumber(command
               .add_option_function<double>(
                   "--extrude",
                   [options](const double& height) {
                     options->extrude = true, options->height = height;
                   },
                   "Move the curve across its plane, over this height [2]")
               ->type_name("HEIGHT"),
           1e-6, 1e6);
  isNumber(command
               .add_option_function<double>(
                   "--revolve",
                   [options](const double& axis) { options->revolve = true, options->axis = axis; },
                   "Turn the curve about the line x = AXIS")
               ->type_name("AXIS"),
           -1e6, 1e6);
  addDirection(command, "--view", options->towards,
               "From the surface towards the viewer; the curve's plane is x, y. Else the scene's\n"
               "view raised from the plane, or 0,1,0 of a revolution, which can be seen from its\n"
               "ends alone");
  isWhole(command
              .add_option(
                  "--resolutions", options->study.cells,
                  "Cells along the curve, separated by commas [16,32,64,128]; with --random the\n"
                  "last one [256]")
              ->type_name("LIST")
              ->delimiter(','),
          kFewestCells, kMostCells);
  isWhole(command
              .add_option("--random", options->trials.count,
                          "No scene: extrusions of N random curves from random directions")
              ->type_name("N"),
          1, 100000);
  isWhole(command.add_option("--seed", options->trials.seed, "Of --random [1]")->type_name("S"), 0);
  isNumber(command
               .add_option("--threshold", options->study.threshold,
                           "Of the apparent ridges, as in flatland lines [0]")
               ->type_name("V"),
           0.0, 1e6);
  command
      .add_option("-o,--output", options->output,
                  "File to write too: .csv or .json, or a diagram (.svg, .pdf, .png, .tex)")
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  addSize(command, options->size);
  command.footer(
      "Examples:\n"
      "  flatland bridge preset:thesis --extrude 2 --view 0.3,1,0.8\n"
      "  flatland bridge scene.json --revolve 0 --resolutions 32,64,128,256 -o bridge.svg\n"
      "  flatland bridge --random 100 --seed 1 -o random.csv\n");
  const CLI::App* self = &command;
  command.final_callback([options, &action, self] {
    options->viewGiven = self->count("--view") > 0;
    options->cellsGiven = self->count("--resolutions") > 0;
    const bool random = self->count("--random") > 0;
    action = [options, random] { return random ? runTrials(*options) : runScene(*options); };
  });
}

}  // namespace flatland::ui
