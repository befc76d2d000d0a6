// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "flatland/study/offset_study.h"
#include "ui/export/figure.h"
#include "ui/export/figure_words.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

/// What of an offset study a diagram shows.
enum class StudyDiagram {
  Ratio,         ///< |offset| / |feature| under the chosen convention
  Displacement,  ///< apparent ridges to their partners, on the screen, over the curve's length
  Conventions,   ///< the ratio under all three conventions, at any scale
};

struct StudyFigureOptions {
  double width = 640.0, height = 400.0;  ///< px
  double textPx = 12.0;
  StudyDiagram diagram = StudyDiagram::Ratio;
  Palette palette = Palette::Light;
  double scale = 1.0;  ///< Conventions: the side of the square
  FigureWords words;
  std::optional<std::size_t> selectedBin;  ///< drawn stronger; not for Conventions
};

/// Histograms over a logarithmic axis, in bins of a tenth of a decade, with median (solid) and
/// quartiles (dashed). Under Conventions the bins are those of the study, moved by scaleFactor(),
/// and a line stands at 1/100,000, the ratio of the thesis.
Figure studyFigure(const OffsetSummary& summary, const OffsetStudyOptions& study,
                   const StudyFigureOptions& options);

/// The bin at a horizontal position of the figure; nullopt beside the diagram and for Conventions.
std::optional<std::size_t> studyBinAt(double xPx, const StudyFigureOptions& options);

/// The middle of a bin, px.
double studyBinX(std::size_t bin, const StudyFigureOptions& options);

/// "0.2102", "1.47e-5": three or four digits, for people.
std::string shortNumber(double value);

}  // namespace flatland::ui
