// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core3d/study/convergence.h"
#include "ui/export/figure.h"
#include "ui/export/figure_words.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

struct ConvergenceFigureOptions {
  double width = 720.0, height = 480.0;  ///< px
  double textPx = 12.0;
  Palette palette = Palette::Light;
  FigureWords words = {};
};

/// Median distance of the ridges found to the known ones, as a length, against the mesh's edge
/// length, both logarithmic, under the name of the `subject`; one line with symbols for each
/// series, its fitted order in the legend, and a thin line where the distance is one edge.
Figure convergenceFigure(const std::vector<ConvergenceSeries>& all, const std::string& subject,
                         const ConvergenceFigureOptions& options);

}  // namespace flatland::ui
