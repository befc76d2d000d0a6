// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "flatland/io/svg_file.h"
#include "ui/app/app.h"
#include "ui/export/figure.h"

// What the command line needs Qt for. Built from qt_parts.cpp, or without Qt from
// qt_parts_missing.cpp, where the first call for any of it throws UsageError.
namespace flatland::ui {

/// Throws UsageError ("<what> needs Qt, which this build was made without; <instead>") in a build
/// without Qt.
void requireQt(const std::string& what, const std::string& instead);

/// See ui/import/glyph.h. No display is needed or used.
ImportedScene glyphWithQt(const std::string& argument);

/// See ui/export/figure_qt.h. No display is needed or used.
std::string pdfWithQt(const Figure& figure, const FigureSource& source);
std::string pngWithQt(const Figure& figure, const FigureSource& source, double dpi);

/// See ui/app/app.h.
int windowWithQt(const WindowStart& start);
int shotWithQt(const Shot& shot);

}  // namespace flatland::ui
