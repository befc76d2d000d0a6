// SPDX-License-Identifier: GPL-3.0-or-later
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "flatland/io/input_error.h"
#include "ui/cli/command_line.h"
#include "ui/cli/qt_parts.h"
#include "ui/cli/scene_argument.h"

namespace flatland::ui {

namespace {

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

/// Asked before Qt is, which ends the process when it finds no display.
bool hasDisplay() {
#if defined(__unix__) && !defined(__APPLE__)
  return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY") || isSet("QT_QPA_PLATFORM");
#else
  return true;
#endif
}

struct Options {
  std::string scene;
  std::string language;
  bool projector = false;
};

int run(const Options& options) {
  const std::string& argument = options.scene;
  requireQt("The window", "use a subcommand; see flatland --help");
  if (!hasDisplay()) {
    throw UsageError(
        "no display to show the window on (DISPLAY and WAYLAND_DISPLAY are not set); "
        "flatland draw and flatland shot work without one");
  }
  WindowStart start{
      .sceneFile = {}, .scene = {}, .language = options.language, .projector = options.projector};
  if (argument.empty()) return windowWithQt(start);
  if (!namesFile(argument)) {
    start.scene = sceneToShow(argument);
    return windowWithQt(start);
  }
  // A file that cannot be understood is reported in the window; a mistyped name is better
  // reported where it was typed.
  std::error_code error;
  if (!std::filesystem::exists(argument, error)) {
    const int reason = error ? error.value() : ENOENT;
    throw InputError(argument, "", "cannot be read: " + std::generic_category().message(reason));
  }
  start.sceneFile = argument;
  return windowWithQt(start);
}

}  // namespace

void addWindowCommand(CLI::App& app, Action& action) {
  const auto options = std::make_shared<Options>();
  app.add_option("scene", options->scene, std::string(kShownHelp) + "; shown in the window")
      ->type_name("SCENE");
  addLanguage(app, options->language,
              "Language of the window: en, de, or system [the one chosen there]");
  app.add_flag("--projector", options->projector, "Open the window in projector mode");
  app.final_callback([&app, options, &action] {
    if (app.get_subcommands().empty()) action = [options] { return run(*options); };
  });
}

}  // namespace flatland::ui
