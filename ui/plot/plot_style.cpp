// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_style.h"

#include <qcustomplot.h>

#include "ui/export/figure_qt.h"

namespace flatland::ui {

namespace {

void styleAxis(QCPAxis& axis, const PlotColours& colours, const QFont& font) {
  const QPen ink(colours.text, 1.0);
  axis.setBasePen(ink);
  axis.setTickPen(ink);
  axis.setSubTickPen(ink);
  axis.setTickLabelColor(colours.text);
  axis.setLabelColor(colours.text);
  axis.setTickLabelFont(font);
  axis.setLabelFont(font);
  axis.setSelectedBasePen(ink);
  axis.setSelectedTickPen(ink);
  axis.setSelectedSubTickPen(ink);
  axis.grid()->setPen(QPen(colours.grid, 1.0, Qt::SolidLine));
  axis.grid()->setZeroLinePen(QPen(colours.text, 1.0, Qt::SolidLine));
  axis.grid()->setSubGridVisible(false);
}

}  // namespace

PlotColours plotColours(Palette palette) {
  const SceneColours& scene = sceneColours(palette);
  const bool dark = palette != Palette::Light;
  return {.background = toQColor(scene.background),
          .text = toQColor(scene.text),
          .grid = toQColor(paler(scene.faint, scene.background)),
          .line = toQColor(scene.curve),
          .feature = dark ? QColor(0x56, 0xB4, 0xE9) : QColor(0x00, 0x72, 0xB2),
          .offset = QColor(0xD5, 0x5E, 0x00),
          .probe = toQColor(scene.screen)};
}

void stylePlot(QCustomPlot& plot, Palette palette) {
  const PlotColours colours = plotColours(palette);
  plot.setBackground(colours.background);
  for (QCPAxisRect* rect : plot.axisRects()) {
    for (QCPAxis* axis : rect->axes()) styleAxis(*axis, colours, plot.font());
  }
  if (plot.legend) {
    plot.legend->setBrush(colours.background);
    plot.legend->setBorderPen(QPen(colours.grid, 1.0));
    plot.legend->setTextColor(colours.text);
    plot.legend->setFont(plot.font());
  }
}

}  // namespace flatland::ui
