// SPDX-License-Identifier: GPL-3.0-or-later
// Stands in for qt_parts.cpp in a build without Qt.
#include "ui/cli/command_line.h"
#include "ui/cli/qt_parts.h"

namespace flatland::ui {

namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& instead) {
  throw UsageError(what + " needs Qt, which this build was made without; " + instead);
}

}  // namespace

void requireQt(const std::string& what, const std::string& instead) { refuse(what, instead); }

ImportedScene glyphWithQt(const std::string&) {
  refuse("A glyph", "save its outline as SVG and import that");
}

std::string pdfWithQt(const Figure&, const FigureSource&) { refuse("PDF", "write SVG"); }

std::string pngWithQt(const Figure&, const FigureSource&, double) { refuse("PNG", "write SVG"); }

int windowWithQt(const WindowStart&) { refuse("The window", "use a subcommand"); }

int shotWithQt(const Shot&) { refuse("The window", "use flatland draw"); }

}  // namespace flatland::ui
