// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/help_text.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <vector>

#include "ui/cli/suggestion.h"

namespace flatland::ui {

namespace {

constexpr std::size_t kLongestLine = 100;

/// The names that options are given by: "--view", not "-o" and not what stands at a place. Without
/// "--help", which the message names anyway.
std::vector<std::string> longNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      if (name != "help") names.push_back("--" + name);
    }
  }
  return names;
}

std::string likelySubcommand(const CLI::App& app, const std::string& word) {
  constexpr std::size_t kMostEdits = 2;
  std::error_code ignored;
  if (word.size() <= kMostEdits || std::filesystem::exists(word, ignored)) return {};
  std::string nearest;
  std::size_t least = kMostEdits + 1;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::size_t edits = changesBetween(word, command->get_name());
    if (edits < least) least = edits, nearest = command->get_name();
  }
  return least == 0 ? std::string() : nearest;
}

std::string likelyOption(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* command = &app;  // the innermost that was chosen: "study limits"
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  const std::vector<std::string> names = longNames(*command);
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--") return {};  // no options after it
    if (!argument.starts_with("--")) continue;
    const std::string word = argument.substr(0, argument.find('='));
    if (std::find(names.begin(), names.end(), word) != names.end()) continue;
    return nearestName(word, names);
  }
  return {};
}

/// The words of a text in lines of at most `room` letters.
std::string broken(const std::string& description, std::size_t room) {
  std::istringstream words(description);
  std::string text;
  std::size_t inLine = 0;
  for (std::string word; words >> word;) {
    if (inLine > 0 && inLine + 1 + word.size() > room) {
      text += "\n";
      inLine = 0;
    } else if (inLine > 0) {
      text += " ";
      ++inLine;
    }
    text += word;
    inLine += word.size();
  }
  return text;
}

}  // namespace

std::string WrappedHelp::make_option_desc(const CLI::Option* option) const {
  return broken(option->get_description(), kLongestLine - get_column_width() - 1);
}

std::string WrappedHelp::make_subcommand(const CLI::App* command) const {
  std::ostringstream out;
  CLI::detail::format_help(out, command->get_display_name(true),
                           broken(command->get_description(), kLongestLine - get_column_width()),
                           get_column_width());
  return out.str();
}

std::string likelyMeaning(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2) return {};
  const bool hasSubcommand = !app.get_subcommands().empty();
  std::string meant = hasSubcommand ? std::string() : likelySubcommand(app, argv[1]);
  if (meant.empty()) meant = likelyOption(app, argc, argv);
  return meant.empty() ? "" : "; did you mean '" + meant + "'?";
}

}  // namespace flatland::ui
