// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/command_line.h"
#include "ui/cli/qt_parts.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::string output;
  std::optional<double> viewAngleDeg;
  PixelSize size{1280, 800};
};

std::string whyNotOutput(const std::string& file) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".png" || extension == ".PNG") return {};
  return "the name " + file + " should end in .png";
}

int run(const Options& options) {
  requireQt("The window", "draw the scene with flatland draw");
  std::optional<Scene> scene;
  if (!options.scene.empty()) scene = sceneFromArgument(options.scene);
  if (options.viewAngleDeg) {
    if (!scene) scene = defaultScene();
    scene->view.angleDeg = *options.viewAngleDeg;
  }
  return shotWithQt(scene, options.output, options.size.width, options.size.height);
}

}  // namespace

void addShotCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand(
      "shot", "Take a picture of the window as it opens on a scene. Works without a display.");
  command.add_option("scene", options->scene, std::string(kSceneHelp) + " [preset:thesis]")
      ->type_name("SCENE");
  command.add_option("-o,--output", options->output, "File to write: .png")
      ->required()
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  addViewAngle(command, options->viewAngleDeg);
  addSize(command, options->size);
  command.footer(
      "Examples:\n"
      "  flatland shot -o window.png\n"
      "  flatland shot scene.json -o window.png --size 1920x1080\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
