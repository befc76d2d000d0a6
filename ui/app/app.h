// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "flatland/scene/scene.h"

namespace flatland::ui {

/// Shows the window and runs until it is closed; returns the process's exit code. Opens
/// `sceneFile` if given (one that cannot be read is reported in the window, which then shows the
/// default scene), else `scene` as an unsaved document, else the default scene. `argc` and `argv`
/// are Qt's to edit and must outlive the call.
int runWindow(int& argc, char** argv, const std::optional<std::filesystem::path>& sceneFile,
              const std::optional<Scene>& scene);

/// Shows the real window at `width` x `height` pixels (each at least 1; the window does not get
/// smaller than its contents allow), waits until it is painted and writes a picture of it to
/// `output` as PNG, atomically. Neither reads nor writes the person's settings, so the picture
/// depends on its arguments alone. Works without a display: Qt's offscreen platform is chosen if
/// none of DISPLAY, WAYLAND_DISPLAY and QT_QPA_PLATFORM is set. Returns 0; throws InputError if
/// the file cannot be written.
int takeShot(int& argc, char** argv, const std::optional<Scene>& scene,
             const std::filesystem::path& output, int width, int height);

}  // namespace flatland::ui
