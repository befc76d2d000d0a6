// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ui/cli/command_line.h"
#include "ui/export/figure.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

/// The file's extension in lower case, with its dot.
std::string extensionOf(const std::string& file);

/// True for .svg, .pdf, .png and .tex.
bool isPicture(const std::string& file);

/// Throws UsageError if the picture's format needs Qt and this build has none.
void requireQtFor(const std::string& file);

/// Writes the figure atomically in the format of the file's extension. `dpi` is for PNG.
/// Precondition: isPicture(file). Throws InputError if it cannot be written.
void writePicture(const std::string& file, const Figure& figure, const FigureSource& source,
                  double dpi = 96.0);

/// The option --kinds LIST: names of kinds, all or none. `usual` says what is shown without it.
void addKinds(CLI::App& command, std::vector<std::string>& names, const std::string& usual);

/// The kinds that --kinds named; the usual ones if it named nothing.
MarkKinds kindsNamed(const std::vector<std::string>& names);

}  // namespace flatland::ui
