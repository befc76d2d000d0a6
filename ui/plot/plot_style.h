// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

#include "ui/export/mark_style.h"
#include "ui/model/theme.h"

class QCustomPlot;

namespace flatland::ui {

/// The line colours of a plot beside the families of marks: Okabe-Ito, told apart by dash as well.
struct PlotColours {
  QColor background, text, grid, line, feature, offset, probe;
};
PlotColours plotColours(Palette palette);

/// Background, axes, ticks, grid, labels and legend in the colours of `palette`, the font that of
/// the plot widget. Call it again when palette or font change; it does not replot.
void stylePlot(QCustomPlot& plot, Palette palette);

}  // namespace flatland::ui
