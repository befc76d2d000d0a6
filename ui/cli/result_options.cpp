// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/result_options.h"

#include "flatland/io/atomic_file.h"
#include "ui/cli/picture.h"

namespace flatland::ui {

void addJsonOrCsv(CLI::App& command, ResultOptions& options) {
  command
      .add_option("--format", options.format,
                  "json or csv [csv if the output's name ends in .csv, else json]")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"json", "csv"}).description(""));
}

void addOutput(CLI::App& command, ResultOptions& options) {
  command.add_option("-o,--output", options.output, "Write to this file, not to standard output")
      ->type_name("FILE");
}

bool wantsCsv(const ResultOptions& options) {
  return options.format.empty() ? extensionOf(options.output) == ".csv" : options.format == "csv";
}

void writeResult(const ResultOptions& options, const std::string& text) {
  if (options.output.empty()) {
    writeToStandardOutput(text);
  } else {
    writeFileAtomically(options.output, text);
  }
}

}  // namespace flatland::ui
