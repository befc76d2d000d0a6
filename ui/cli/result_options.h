// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ui/cli/command_line.h"

namespace flatland::ui {

/// Where a subcommand's text goes and, if it has both, whether as JSON or CSV.
struct ResultOptions {
  std::string format;  ///< empty: as the output's name says
  std::string output;  ///< empty: standard output
};

/// The option --format json|csv.
void addJsonOrCsv(CLI::App& command, ResultOptions& options);

/// The option -o,--output FILE.
void addOutput(CLI::App& command, ResultOptions& options);

/// --format if it was given; else true for a file that ends in .csv. False means JSON.
bool wantsCsv(const ResultOptions& options);

/// Writes the text to the file, whole or not at all, or to standard output. Throws InputError if it
/// cannot be written.
void writeResult(const ResultOptions& options, const std::string& text);

}  // namespace flatland::ui
