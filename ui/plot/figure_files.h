// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <functional>
#include <string>

#include "ui/export/figure.h"

class QWidget;

namespace flatland::ui {

/// Something a panel can write to a file: as a picture, as a table, or both.
struct FigureFile {
  QString suggestedName;                    ///< without suffix
  std::string title, sceneJson;             ///< for the file's account of itself
  std::string command = {};                 ///< that makes it again; may be empty
  std::function<Figure()> figure = {};      ///< as it goes to paper; may be empty
  std::function<std::string()> table = {};  ///< CSV; may be empty
};

/// Writes it atomically in the format of the suffix: .svg, .pdf, .png, .tex or .csv. Throws
/// InputError, also for a suffix it does not know.
void writeFigureFile(const std::filesystem::path& file, const FigureFile& contents);

/// Asks for a file name and writes. Returns what to say in the status line: where it went, or
/// why it could not be written; empty if the person thought better of it.
QString exportFigureFile(QWidget* parent, const FigureFile& contents);

}  // namespace flatland::ui
