// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>

#include "ui/export/flat_figure.h"
#include "ui/model/document.h"

class QSettings;

namespace flatland::ui {

/// How a picture is exported; remembered from one time to the next.
struct ExportSettings {
  enum class Format { Svg, Pdf, Png, Tikz };
  enum class Unit { Centimetres, Pixels };

  Format format = Format::Svg;
  Unit unit = Unit::Centimetres;  ///< in which the person gives the size
  double widthPx = 12.0 * kPxPerCm;
  double heightPx = 9.0 * kPxPerCm;
  double dpi = 300.0;        ///< PNG only
  FlatFigureOptions figure;  ///< its size is set from the above

  static constexpr double kPxPerCm = 96.0 / 2.54;
  static constexpr double kSmallestScale = 0.5, kLargestScale = 4.0;  ///< of marks and lines

  void restore(const QSettings& settings);
  void save(QSettings& settings) const;
};

/// "svg", "pdf", "png", "tex"
QString suffixOf(ExportSettings::Format format);

/// The picture of the document as it would be exported.
Figure exportedFigure(const Document& document, const ExportSettings& settings);

/// Writes it, atomically. Throws InputError.
void exportTo(const std::filesystem::path& file, const Document& document,
              const ExportSettings& settings);

}  // namespace flatland::ui
