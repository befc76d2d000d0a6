// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/picture.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <filesystem>

#include "flatland/io/atomic_file.h"
#include "ui/cli/qt_parts.h"
#include "ui/export/figure_writers.h"

namespace flatland::ui {

namespace {

std::string allKindNames() {
  std::string names;
  for (int i = 0; i < kMarkKindCount; ++i) {
    names += (names.empty() ? "" : ", ") + std::string(nameOf(static_cast<MarkKind>(i)));
  }
  return names;
}

std::string whyNotKind(const std::string& name) {
  if (name == "all" || name == "none" || markKindNamed(name)) return {};
  return "unknown kind " + name + "; there are " + allKindNames() + ", all, none";
}

}  // namespace

std::string extensionOf(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool isPicture(const std::string& file) {
  const std::string extension = extensionOf(file);
  return extension == ".svg" || extension == ".pdf" || extension == ".png" || extension == ".tex";
}

void requireQtFor(const std::string& file) {
  if (extensionOf(file) == ".pdf" || extensionOf(file) == ".png") {
    requireQt("A PDF or PNG file", "write .svg or .tex");
  }
}

void writePicture(const std::string& file, const Figure& figure, const FigureSource& source,
                  double dpi) {
  assert(isPicture(file));
  const std::string extension = extensionOf(file);
  std::string contents;
  if (extension == ".svg") contents = figureToSvg(figure, source);
  if (extension == ".tex") contents = figureToTikz(figure, source);
  if (extension == ".pdf") contents = pdfWithQt(figure, source);
  if (extension == ".png") contents = pngWithQt(figure, source, dpi);
  writeFileAtomically(file, contents);
}

void addKinds(CLI::App& command, std::vector<std::string>& names, const std::string& usual) {
  command
      .add_option(
          "--kinds", names,
          "Marks to show, separated by commas: " + allKindNames() + ", all, none [" + usual + "]")
      ->type_name("LIST")
      ->delimiter(',')
      ->check(CLI::Validator(whyNotKind, ""));
}

MarkKinds kindsNamed(const std::vector<std::string>& names) {
  if (names.empty()) return defaultMarkKinds();
  MarkKinds kinds;
  for (const std::string& name : names) {
    if (name == "all") kinds.set();
    if (const auto kind = markKindNamed(name)) kinds.set(static_cast<std::size_t>(*kind));
  }
  return kinds;
}

}  // namespace flatland::ui
