// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <cmath>

#include "flatland/io/input_error.h"
#include "ui/cli/command_line.h"
#include "ui/cli/number_check.h"
#include "ui/cli/picture.h"
#include "ui/cli/qt_parts.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

struct Options {
  std::string scene;
  std::string output;
  std::optional<double> viewAngleDeg;
  PixelSize size{1280, 800};
  bool projector = false;
  std::string probe, pick;
  Shot shot;
};

std::string whyNotOutput(const std::string& file) {
  if (extensionOf(file) == ".png") return {};
  return "the name " + file + " should end in .png";
}

/// "CURVE:T" as the two numbers; nullopt if it is not that.
std::optional<std::pair<std::size_t, double>> parsedProbe(const std::string& text) {
  std::pair<std::size_t, double> probe{};
  const char* end = text.data() + text.size();
  const auto curve = std::from_chars(text.data(), end, probe.first);
  if (curve.ec != std::errc() || curve.ptr == end || *curve.ptr != ':') return std::nullopt;
  const auto place = std::from_chars(curve.ptr + 1, end, probe.second);
  if (place.ec != std::errc() || place.ptr != end) return std::nullopt;
  if (!std::isfinite(probe.second)) return std::nullopt;
  return probe;
}

std::string whyNotProbe(const std::string& text) {
  if (parsedProbe(text)) return {};
  return "expected a curve's number and a parameter, for example 0:0.25, found " + text;
}

/// Why a text does not say what to pick; empty: it does.
std::string whyNotPick(const std::string& text) {
  constexpr std::size_t kMostDigits = 9;
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string number = colon == std::string::npos ? "" : text.substr(colon + 1);
  const bool digits = !number.empty() && number.size() <= kMostDigits &&
                      number.find_first_not_of("0123456789") == std::string::npos;
  if (digits && (kind == "vertex" || kind == "triangle")) return {};
  return "expected vertex:N or triangle:N, found " + text;
}

/// Throws InputError if the scene has no such place.
void requireProbe(const Scene& scene, const std::pair<std::size_t, double>& probe) {
  const auto fail = [&](const std::string& why) { throw InputError("--probe", "", why); };
  const std::size_t count = scene.curves.size();
  if (probe.first >= count) {
    fail("the scene has " + std::to_string(count) + (count == 1 ? " curve" : " curves") +
         ", counted from 0; there is no curve " + std::to_string(probe.first));
  }
  const int end = pieceCount(scene.curves[probe.first].shape);
  if (probe.second < 0.0 || probe.second > end) {
    fail("the parameter must lie between 0 and " + std::to_string(end) + " on this curve");
  }
}

int run(const Options& options) {
  requireQt("The window", "draw the scene with flatland draw");
  Shot shot = options.shot;
  shot.output = options.output;
  shot.width = options.size.width;
  shot.height = options.size.height;
  if (options.projector) shot.layout = "projector";
  shot.pick = options.pick;
  if (!options.probe.empty()) shot.probe = parsedProbe(options.probe);
  if (!options.scene.empty()) shot.scene = sceneToShow(options.scene);
  if (options.viewAngleDeg) {
    if (!shot.scene) shot.scene = defaultScene();
    shot.scene->view.angleDeg = *options.viewAngleDeg;
  }
  if (shot.probe) requireProbe(shot.scene ? *shot.scene : defaultScene(), *shot.probe);
  return shotWithQt(shot);
}

}  // namespace

void addShotCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  Shot& shot = options->shot;
  CLI::App& command = *app.add_subcommand(
      "shot", "Take a picture of the window as it opens on a scene. Works without a display.");
  command.add_option("scene", options->scene, std::string(kShownHelp) + " [preset:thesis]")
      ->type_name("SCENE");
  command.add_option("-o,--output", options->output, "File to write: .png")
      ->required()
      ->type_name("FILE")
      ->check(CLI::Validator(whyNotOutput, ""));
  addViewAngle(command, options->viewAngleDeg);
  addSize(command, options->size);
  command
      .add_option("--layout", shot.layout,
                  "Layout: work, surface, picture or projector [work; surface if there is one]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"work", "surface", "picture", "projector"}).description(""));
  command.add_flag("--projector", options->projector, "The same as --layout projector");
  command
      .add_option("--show", shot.show,
                  "Panels to open and bring to the front, by name, separated by commas; a name "
                  "that is none lists them")
      ->type_name("LIST")
      ->delimiter(',');
  command.add_option("--theme", shot.theme, "Theme: light, dark, high-contrast or system [light]")
      ->type_name("NAME")
      ->check(CLI::IsMember({"light", "dark", "high-contrast", "system"}).description(""));
  addLanguage(command, shot.language, "Language of the window: en or de [en]");
  isNumber(
      command
          .add_option("--scale", shot.scale, "How much larger than usual type and marks are [1]")
          ->type_name("FACTOR"),
      1.0, 2.5);
  command.add_option("--probe", options->probe, "Put the probe on a curve, at a parameter")
      ->type_name("CURVE:T")
      ->check(CLI::Validator(whyNotProbe, ""));
  command
      .add_option("--pick", options->pick, "Pick a point of the surface: vertex:N or triangle:N")
      ->type_name("WHAT")
      ->check(CLI::Validator(whyNotPick, ""));
  command.footer(
      "Examples:\n"
      "  flatland shot -o window.png\n"
      "  flatland shot scene.json -o window.png --size 1920x1080\n"
      "  flatland shot -o window.png --projector --theme dark --language de\n");
  command.final_callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace flatland::ui
