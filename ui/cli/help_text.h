// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace flatland::ui {

/// Help whose lines are at most 100 letters long: what options and lists of subcommands say is
/// broken at spaces, whatever line breaks it came with.
class WrappedHelp : public CLI::Formatter {
 public:
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

/// What a word that is no subcommand, or an option that the chosen subcommand has not, was meant to
/// be, as the end of a message: "; did you mean 'lines'?". Empty if nothing is near, or the first
/// word names a file. `app` has parsed the arguments, or failed to.
std::string likelyMeaning(const CLI::App& app, int argc, const char* const* argv);

}  // namespace flatland::ui
