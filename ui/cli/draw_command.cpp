// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/command_line.h"
#include "ui/cli/number_check.h"
#include "ui/cli/picture.h"
#include "ui/cli/scene_argument.h"
#include "ui/export/flat_figure.h"
#include "ui/export/scene_record.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::string output;
  std::optional<double> viewAngleDeg;
  PixelSize size{640, 480};
  double dpi = 96.0;
  std::vector<std::string> kinds;
  std::string hidden = "pale";
  bool controlPolygon = false;
  bool noLegend = false;
  bool noLetters = false;
  bool transparent = false;
  bool dark = false;
};

std::string whyNotOutput(const std::string& file) {
  if (isPicture(file)) return {};
  return "the name " + file + " should end in .svg, .pdf, .png or .tex";
}

FlatFigureOptions figureOptions(const Options& options) {
  FlatFigureOptions figure;
  figure.width = options.size.width;
  figure.height = options.size.height;
  figure.kinds = kindsNamed(options.kinds);
  figure.palette = options.dark ? Palette::Dark : Palette::Light;
  figure.hidden = options.hidden == "pale" ? FlatFigureOptions::Hidden::Pale
                                           : FlatFigureOptions::Hidden::Remove;
  figure.controlPolygon = options.controlPolygon;
  figure.letters = !options.noLetters;
  figure.legend = !options.noLegend;
  figure.transparent = options.transparent;
  return figure;
}

int run(const Options& options, const std::string& commandLine) {
  requireQtFor(options.output);
  const Scene scene = sceneFromArgument(options.scene, options.viewAngleDeg);
  const Figure figure =
      flatFigure(scene, findFeatures(scene), Visibility(scene), figureOptions(options));
  const FigureSource source{.title = "Flatland: " + withoutFolders(options.scene),
                            .program = "flatland " FLATLAND_VERSION,
                            .command = commandLine,
                            .sceneJson = sceneRecord(scene)};
  writePicture(options.output, figure, source, options.dpi);
  return kDone;
}

}  // namespace

void addDrawCommand(CLI::App& app, Action& action, const std::string& commandLine) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "draw",
      "Draw a scene with its screen and marks. The name of the output says the format: SVG, PDF\n"
      "or PNG, or TikZ for .tex. SVG and TikZ carry the scene and this command within them.");
  command.add_option("scene", options->scene, kSceneHelp)->required()->type_name("SCENE");
  command.add_option("-o,--output", options->output, "File to write: .svg, .pdf, .png or .tex")
      ->required()
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  addViewAngle(command, options->viewAngleDeg);
  addSize(command, options->size);
  isNumber(command
               .add_option(
                   "--dpi", options->dpi,
                   "PNG: pixels per inch; a pixel of --size is 1/96 inch, so 192 doubles it [96]")
               ->type_name("DPI"),
           8.0, 4800.0);
  addKinds(command, options->kinds, "all but flat and apparent-minimum");
  command
      .add_option("--hidden", options->hidden, "What the viewer cannot see: pale or remove [pale]")
      ->type_name("HOW")
      ->check(CLI::IsMember({"pale", "remove"}).description(""));
  command.add_flag("--control-polygon", options->controlPolygon, "Draw the control points too");
  command.add_flag("--no-legend", options->noLegend, "Leave out the legend");
  command.add_flag("--no-letters", options->noLetters, "Leave out the letters beside the marks");
  command.add_flag("--transparent", options->transparent, "No background");
  command.add_flag("--dark", options->dark, "Colours for a dark background");
  command.footer(
      "Examples:\n"
      "  flatland draw scene.json -o scene.svg\n"
      "  flatland draw preset:loop -o loop.pdf --view-angle 30 --control-polygon\n"
      "  flatland draw scene.json -o scene.png --size 800x600 --dpi 300 --transparent\n"
      "  flatland draw preset:bump -o bump.tex --kinds ridge,apparent-ridge --no-legend\n");
  command.final_callback([options, &action, commandLine] {
    action = [options, commandLine] { return run(*options, commandLine); };
  });
}

}  // namespace flatland::ui
