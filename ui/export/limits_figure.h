// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flatland/study/limits.h"
#include "ui/export/figure.h"
#include "ui/export/figure_words.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

struct LimitsFigureOptions {
  double width = 640.0, height = 420.0;  ///< px
  double textPx = 12.0;
  Palette palette = Palette::Light;
  std::size_t law = 0;            ///< which of the series' laws
  std::optional<double> markedX;  ///< a vertical line, such as the present |n.w|
  std::string xName, yName;       ///< under and beside the axes
  FigureWords words;              ///< of the rest
};

/// One law of a series in log-log axes: what was measured as points, the fitted line over its
/// decade, solid, and the predicted one, dashed, all the way. Slopes stand beside them. The x axis
/// runs towards the silhouette, from large to small.
Figure limitsFigure(const LimitSeries& series, const LimitsFigureOptions& options);

}  // namespace flatland::ui
