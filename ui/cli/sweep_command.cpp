// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "flatland/io/atomic_file.h"
#include "flatland/io/sweep_text.h"
#include "ui/cli/command_line.h"
#include "ui/cli/picture.h"
#include "ui/cli/scene_argument.h"
#include "ui/export/scene_record.h"
#include "ui/export/sweep_figure.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::string output;
  PixelSize size{960, 600};
  std::vector<std::string> kinds;
  bool dark = false;
};

bool isTable(const std::string& file) { return extensionOf(file) == ".csv"; }

std::string whyNotOutput(const std::string& file) {
  if (isTable(file) || isPicture(file)) return {};
  return "the name " + file + " should end in .csv, .svg, .pdf, .png or .tex";
}

void note(const std::string& text) { std::fprintf(stderr, "flatland: %s\n", text.c_str()); }

int run(const Options& options, const std::string& commandLine) {
  if (!isTable(options.output)) requireQtFor(options.output);
  const Scene scene = sceneFromArgument(options.scene);
  Sweep sweep = sweepOf(scene);
  if (!sweep.fine) {
    note(
        "the scene has so many branches that their points are coarser than usual: the angle may "
        "turn unseen between two of them");
  }
  if (!sweep.complete) note("not complete: some events could not be told apart");
  // Without --kinds a picture shows where ridges are born too, and a table everything.
  MarkKinds kinds = kindsNamed(options.kinds);
  if (options.kinds.empty()) kinds.set(static_cast<std::size_t>(MarkKind::ApparentMinimum));
  if (!options.kinds.empty()) {
    const auto unwanted = [&](const auto& item) { return !contains(kinds, item.kind); };
    std::erase_if(sweep.lines, unwanted);
    std::erase_if(sweep.branches, unwanted);
    if (!contains(kinds, MarkKind::ApparentRidge)) sweep.events.clear();
  }
  if (isTable(options.output)) {
    writeFileAtomically(options.output, sweepToCsv(sweep));
    return kDone;
  }
  SweepFigureOptions figure;
  figure.width = options.size.width;
  figure.height = options.size.height;
  figure.kinds = kinds;
  figure.palette = options.dark ? Palette::Dark : Palette::Light;
  figure.viewAngleDeg = scene.view.angleDeg;
  const SweepVisibility visibility = visibilityOf(sweep, scene);
  if (visibility.marked) {
    figure.visibility = &visibility;
  } else {
    note("what is hidden is not marked: more than " + std::to_string(SweepVisibility::kMostRays) +
         " lines of sight would have to be followed");
  }
  writePicture(options.output, sweepFigure(sweep, curveLengths(scene), figure),
               {.title = "Flatland, view sweep: " + withoutFolders(options.scene),
                .program = "flatland " FLATLAND_VERSION,
                .command = commandLine,
                .sceneJson = sceneRecord(scene)});
  return kDone;
}

}  // namespace

void addSweepCommand(CLI::App& app, Action& action, const std::string& commandLine) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "sweep",
      "Draw or tabulate where every mark lies for every view direction: arc length against angle.\n"
      "Ridges and inflections are level lines, apparent ridges slide, silhouettes are what they "
      "run\n"
      "into; rings show where an apparent ridge is born or merges. Views are orthographic.");
  command.add_option("scene", options->scene, kSceneHelp)->required()->type_name("SCENE");
  command
      .add_option("-o,--output", options->output,
                  "File to write: a table (.csv) or a picture (.svg, .pdf, .png, .tex)")
      ->required()
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  addSize(command, options->size);
  addKinds(command, options->kinds, "all but flat; a table: all");
  command.add_flag("--dark", options->dark, "Colours for a dark background");
  command.footer(
      "Examples:\n"
      "  flatland sweep scene.json -o sweep.svg\n"
      "  flatland sweep preset:thesis -o sweep.csv\n");
  command.final_callback([options, &action, commandLine] {
    action = [options, commandLine] { return run(*options, commandLine); };
  });
}

}  // namespace flatland::ui
