// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace flatland::ui {

/// What the process returns; docs/user/command-line.md promises these.
enum ExitCode { kDone = 0, kBadInput = 1, kBadUsage = 2, kInternalError = 3 };

/// The command line asks for something that cannot be: exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What the command line chose to do, run after it was read as a whole.
using Action = std::function<int()>;

/// Each adds its subcommand (the last: the options of the bare program) to `app` and sets `action`
/// when it is the one chosen. `action` must outlive `app`'s parsing.
void addFeaturesCommand(CLI::App& app, Action& action);
void addDrawCommand(CLI::App& app, Action& action, const std::string& commandLine);
void addShotCommand(CLI::App& app, Action& action);
void addPresetsCommand(CLI::App& app, Action& action);
void addProfileCommand(CLI::App& app, Action& action);
void addImportCommand(CLI::App& app, Action& action);
void addSweepCommand(CLI::App& app, Action& action, const std::string& commandLine);
void addStudyCommand(CLI::App& app, Action& action);
void addLimitsCommand(CLI::App& study, Action& action);  ///< below `flatland study`
void addDerivationCommand(CLI::App& app, Action& action);
void addWindowCommand(CLI::App& app, Action& action);

/// The option --view-angle DEG, any finite number of degrees.
void addViewAngle(CLI::App& command, std::optional<double>& angleDeg);

/// "640x480": two whole numbers of pixels from 16 to 32768. For --size.
struct PixelSize {
  int width, height;
};
void addSize(CLI::App& command, PixelSize& size);

/// The option --language CODE.
void addLanguage(CLI::App& command, std::string& language, const std::string& help);

/// What a written file may tell of where it was made: of the path of a file its name, other
/// references (preset:NAME, solid:NAME) as they are.
std::string withoutFolders(const std::string& file);

/// The arguments as one line that a POSIX shell reads back, files without their folders, also in
/// "-oFILE" and "--output=FILE".
std::string commandWithoutFolders(int argc, const char* const* argv);

/// Writes a result to standard output. Throws InputError if that fails.
void writeToStandardOutput(const std::string& text);

}  // namespace flatland::ui
