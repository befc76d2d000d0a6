// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flatland/scene/scene.h"

namespace flatland::ui {

/// What a window shows when it opens, beyond what the person's settings say.
struct WindowStart {
  std::optional<std::filesystem::path> sceneFile;
  std::optional<Scene> scene;  ///< an unsaved document; without both: the default scene
  std::string language;        ///< a code of language.h, "system"; empty: the one chosen
  bool projector = false;
};

/// Shows the window and runs until it is closed; returns the process's exit code. A file that
/// cannot be read is reported in the window, which then shows the default scene. `argc` and `argv`
/// are Qt's to edit and must outlive the call.
int runWindow(int& argc, char** argv, const WindowStart& start);

/// What a picture of the window shows. Names are those of the View menu's actions and of the
/// panels.
struct Shot {
  std::optional<Scene> scene;
  std::filesystem::path output;
  int width = 1280, height = 800;  ///< pixels
  std::string layout = "work";     ///< "work", "surface", "picture", "projector"; with a
                                   ///< surface in the scene "work" means "surface"
  std::vector<std::string> show;   ///< panels to open and bring to the front
  std::string theme = "light";     ///< see Display::themeNamed()
  std::string language = "en";
  double scale = 0.0;  ///< see Display::uiScale(); 0: the usual one of the layout
  std::optional<std::pair<std::size_t, double>> probe;  ///< curve and parameter
  std::string pick;  ///< "vertex:N" or "triangle:N" of the surface; empty: nothing is picked
};

/// Shows the real window at that size (the window does not get smaller than its contents allow),
/// waits until it is painted and writes a picture of it to `output` as PNG, atomically. Neither
/// reads nor writes the person's settings, so the picture depends on its arguments alone. Works
/// without a display: Qt's offscreen platform is chosen if none of DISPLAY, WAYLAND_DISPLAY and
/// QT_QPA_PLATFORM is set. Returns 0; throws InputError if the file cannot be written, or if there
/// is no panel, theme or layout of a name.
int takeShot(int& argc, char** argv, const Shot& shot);

}  // namespace flatland::ui
