// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/command_line.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>

#include "flatland/io/input_error.h"
#include "ui/export/plain_text.h"

namespace flatland::ui {

namespace {

constexpr int kSmallestSide = 16;
constexpr int kLargestSide = 32768;

std::optional<PixelSize> parsedSize(std::string_view text) {
  const std::size_t x = text.find('x');
  if (x == std::string_view::npos) return std::nullopt;
  PixelSize size{};
  const auto read = [](std::string_view part, int& number) {
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
    return error == std::errc() && end == part.data() + part.size() && number >= kSmallestSide &&
           number <= kLargestSide;
  };
  if (!read(text.substr(0, x), size.width) || !read(text.substr(x + 1), size.height)) {
    return std::nullopt;
  }
  return size;
}

std::string sizeText(const PixelSize& size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

}  // namespace

void addViewAngle(CLI::App& command, std::optional<double>& angleDeg) {
  command
      .add_option_function<double>(
          "--view-angle", [&angleDeg](const double& value) { angleDeg = value; },
          "See the scene from this direction instead of its own: degrees counter-clockwise "
          "from +x, from the scene to the viewer")
      ->type_name("DEG")
      ->check(CLI::Validator(
          [](const std::string& text) {
            double value = 0.0;
            const bool isFinite = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
            return isFinite ? std::string() : "expected a number of degrees, found " + text;
          },
          ""));
}

void addSize(CLI::App& command, PixelSize& size) {
  command
      .add_option_function<std::string>(
          "--size", [&size](const std::string& text) { size = *parsedSize(text); },
          "Width and height in pixels [" + sizeText(size) + "]")
      ->type_name("WxH")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return parsedSize(text)
                       ? std::string()
                       : "expected WxH in pixels from " + std::to_string(kSmallestSide) + " to " +
                             std::to_string(kLargestSide) + ", for example 800x600, found " + text;
          },
          ""));
}

void addLanguage(CLI::App& command, std::string& language, const std::string& help) {
  command.add_option("--language", language, help)
      ->type_name("CODE")
      ->check(CLI::IsMember({"en", "de", "system"}).description(""));
}

std::string withoutFolders(const std::string& file) {
  return file.substr(file.rfind('/') + 1);  // from 0 if there is none
}

std::string commandWithoutFolders(int argc, const char* const* argv) {
  std::string line = "flatland";  // wherever it was started from
  for (int i = 1; i < argc; ++i) {
    std::string argument = argv[i];
    std::size_t file = 0;  // where it may begin; no argument but files has a slash
    if (argument.starts_with("--")) {
      file = argument.find('=') + 1;
    } else if (argument.starts_with('-')) {
      file = std::min<std::size_t>(2, argument.size());
    }
    argument.replace(file, std::string::npos, withoutFolders(argument.substr(file)));
    line += " " + shellWord(argument);
  }
  return line;
}

void writeToStandardOutput(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) {
    throw InputError("standard output", "",
                     "cannot be written: " + std::generic_category().message(errno));
  }
}

}  // namespace flatland::ui
