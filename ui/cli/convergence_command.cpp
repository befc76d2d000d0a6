// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include "core3d/io/convergence_text.h"
#include "core3d/study/convergence.h"
#include "flatland/io/atomic_file.h"
#include "ui/cli/mesh_commands.h"
#include "ui/cli/number_check.h"
#include "ui/cli/picture.h"
#include "ui/cli/progress.h"
#include "ui/cli/suggestion.h"
#include "ui/export/convergence_figure.h"

namespace flatland::ui {

namespace {

constexpr int kFewestCells = 10, kMostCells = 2000;

struct Options {
  ConvergenceOptions study;
  std::string output;
  PixelSize size{720, 480};
  bool regular = false;
};

std::string whyNotOutput(const std::string& file) {
  const std::string extension = extensionOf(file);
  if (isPicture(file) || extension == ".csv" || extension == ".json") return {};
  return "the name " + file + " should end in .csv, .json, .svg, .pdf, .png or .tex";
}

void write(const Options& options, const std::vector<ConvergenceSeries>& all,
           const std::string& commandLine) {
  const std::string extension = extensionOf(options.output);
  if (extension == ".csv") {
    writeFileAtomically(options.output, convergenceCsv(all));
  } else if (extension == ".json") {
    writeFileAtomically(options.output, convergenceJson(all, options.study));
  } else {
    ConvergenceFigureOptions figure;
    figure.width = options.size.width;
    figure.height = options.size.height;
    const KnownCase subject = options.study.subject;
    writePicture(options.output, convergenceFigure(all, std::string(nameOf(subject)), figure),
                 {.title = "Flatland, convergence: " + std::string(nameOf(subject)),
                  .program = "flatland " FLATLAND_VERSION,
                  .command = commandLine,
                  .sceneJson = convergenceJson(all, options.study),
                  .sceneName = "convergence"});
  }
}

int run(const Options& given, const std::string& commandLine) {
  Options options = given;
  options.study.irregular = !options.regular;
  if (!options.output.empty()) requireQtFor(options.output);
  std::vector<ConvergenceSeries> all;
  {
    Progress progress;
    options.study.progress = [&progress](double share) {
      progress.say(std::to_string(std::lround(100.0 * share)) + " %");
    };
    all = measureConvergence(options.study);
  }
  writeToStandardOutput(convergenceTable(all));
  if (!options.output.empty()) write(options, all, commandLine);
  return kDone;
}

}  // namespace

void addConvergenceCommand(CLI::App& app, Action& action, const std::string& commandLine) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "convergence",
      "How far are apparent ridges of a mesh from the exact ones, and do they come nearer when "
      "the\n"
      "mesh is refined? Surfaces whose ridges are known from flatland; both estimators of\n"
      "curvature, both ways to the derivative. The table goes to standard output; a mesh of which\n"
      "more than a tenth is stray or missed takes no part in the order.");
  command
      .add_option_function<std::string>(
          "case",
          [options](const std::string& name) { options->study.subject = *knownCaseNamed(name); },
          "sine-sheet, gaussian-bump, extrusion or revolution")
      ->required()
      ->type_name("CASE")
      ->check(oneOf("case", knownCaseNames()));
  command
      .add_option("-o,--output", options->output,
                  "File to write too: .csv or .json, or a diagram (.svg, .pdf, .png, .tex)")
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  isWhole(command
              .add_option("--cells", options->study.cells,
                          "Resolutions n, separated by commas: meshes of n x n cells [50,100,200]")
              ->type_name("LIST")
              ->delimiter(','),
          kFewestCells, kMostCells);
  command.add_flag("--regular", options->regular,
                   "Regular meshes; without it vertices are moved by up to a quarter of a cell");
  isWhole(command
              .add_option("--seed", options->study.seed,
                          "Of these moves, and of the random curve of extrusion and revolution [1]")
              ->type_name("S"),
          0);
  isNumber(
      command
          .add_option("--threshold", options->study.threshold,
                      "Of the apparent ridges, as in flatland lines [0, to look at weak ones too]")
          ->type_name("V"),
      0.0, 1e6);
  addSize(command, options->size);
  command.footer(
      "Examples:\n"
      "  flatland convergence sine-sheet\n"
      "  flatland convergence gaussian-bump -o bump.svg --cells 50,100,200,400\n"
      "  flatland convergence revolution --seed 7 --regular -o revolution.csv\n");
  command.final_callback([options, &action, commandLine] {
    action = [options, commandLine] { return run(*options, commandLine); };
  });
}

}  // namespace flatland::ui
