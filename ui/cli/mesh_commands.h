// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ui/cli/command_line.h"

namespace flatland::ui {

/// The subcommands of meshes, as those in command_line.h.
void addLinesCommand(CLI::App& app, Action& action, const std::string& commandLine);
void addFieldsCommand(CLI::App& app, Action& action);
void addBridgeCommand(CLI::App& app, Action& action, const std::string& commandLine);
void addSliceCommand(CLI::App& app, Action& action);
void addConvergenceCommand(CLI::App& app, Action& action, const std::string& commandLine);

}  // namespace flatland::ui
