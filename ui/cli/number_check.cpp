// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/number_check.h"

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>

namespace flatland::ui {

namespace {

std::optional<double> finiteNumber(const std::string& text) {
  double value = 0.0;
  const bool is = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
  return is ? std::optional(value) : std::nullopt;
}

/// The shortest that reads back to the same number: 0.000001, 179, 1e+12.
std::string shortText(double value) {
  const double size = std::abs(value);
  const bool plain = size == 0.0 || (size >= 1e-6 && size < 1e7);
  std::array<char, 32> text{};
  char* const last = text.data() + text.size();
  const auto [end, error] = plain
                                ? std::to_chars(text.data(), last, value, std::chars_format::fixed)
                                : std::to_chars(text.data(), last, value);
  return {text.data(), end};
}

/// Digits alone, after a - where negative numbers are taken. What is too large for the type is no
/// number either.
template <typename Whole>
std::optional<Whole> wholeNumber(const std::string& text) {
  Whole value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last ? std::optional(value) : std::nullopt;
}

bool isWholeWithin(const std::string& text, std::int64_t least, std::uint64_t most) {
  if (const auto value = wholeNumber<std::uint64_t>(text)) {
    return *value <= most && (least <= 0 || *value >= static_cast<std::uint64_t>(least));
  }
  const auto negative = wholeNumber<std::int64_t>(text);
  return negative && *negative >= least;
}

CLI::Option* checked(CLI::Option* option, const std::string& wanted,
                     const std::function<bool(const std::string&)>& isGood) {
  return option->check(CLI::Validator(
      [wanted, isGood](const std::string& text) {
        if (isGood(text)) return std::string();
        return "expected " + wanted + ", found " + (text.empty() ? "\"\"" : text);
      },
      ""));
}

void tellRange(CLI::Option* option, const std::string& range) {
  option->description(option->get_description() + "; " + range);
}

/// "a,,b", ",a" or "a,".
bool hasEmptyEntry(std::string_view list) {
  return list.starts_with(',') || list.ends_with(',') || list.find(",,") != std::string_view::npos;
}

}  // namespace

CLI::Option* isNumber(CLI::Option* option) {
  return checked(option, "a number",
                 [](const std::string& text) { return finiteNumber(text).has_value(); });
}

CLI::Option* isNumber(CLI::Option* option, double least, double most) {
  const std::string range = "from " + shortText(least) + " to " + shortText(most);
  tellRange(option, range);
  return checked(option, "a number " + range, [least, most](const std::string& text) {
    const auto value = finiteNumber(text);
    return value && *value >= least && *value <= most;
  });
}

CLI::Option* isWhole(CLI::Option* option, std::int64_t least, std::uint64_t most) {
  std::string range = "from " + std::to_string(least);
  if (most < std::numeric_limits<std::uint64_t>::max()) range += " to " + std::to_string(most);
  if (most < std::numeric_limits<std::int32_t>::max()) tellRange(option, range);
  return checked(option, "a whole number " + range, [least, most](const std::string& text) {
    return isWholeWithin(text, least, most);
  });
}

std::string whyNotLists(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::App* command = &app;  // the innermost that was chosen: "study offset"
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--") return {};
    if (!argument.starts_with("--")) continue;
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const CLI::Option* option = command->get_option_no_throw(name);
    if (option == nullptr || option->get_delimiter() != ',') continue;
    const bool isNext = equals == std::string::npos;
    if (isNext && i + 1 == argc) continue;
    const std::string list = isNext ? argv[i + 1] : argument.substr(equals + 1);
    if (hasEmptyEntry(list)) return name + ": an entry between the commas of " + list + " is empty";
  }
  return {};
}

}  // namespace flatland::ui
