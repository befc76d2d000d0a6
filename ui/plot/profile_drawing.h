// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>
#include <QString>
#include <map>
#include <vector>

#include "ui/model/plots.h"
#include "ui/plot/plot_style.h"

class QCPCurve;
class QCPGraph;
class QCPItemStraightLine;
class QCPItemText;
class QCustomPlot;

namespace flatland::ui {

/// The colour of a quantity's line, the same in every plot and its legend.
QColor colourOf(ProfileQuantity quantity, Palette palette);

/// One plot along the curve, drawn on a QCustomPlot: on screen and on paper the same. Shows a
/// Plots and keeps no state of its own but what QCustomPlot needs; replots nothing by itself.
class ProfileDrawing {
 public:
  struct Look {
    Palette palette = Palette::Light;
    double scale = 1.0;    ///< of lines and symbols
    bool onPaper = false;  ///< with title, legend and axis labels, without the probe
    bool xTicks = true;    ///< numbers at the abscissa, which plots above others do without
  };

  ProfileDrawing(QCustomPlot& plot, PlotKind kind);

  void setLook(const Look& look);

  /// Lines, marks, ranges and probe.
  void show(const Plots& plots);
  /// Only what follows from the range shown.
  void showRange(const Plots& plots);
  /// Only the probe.
  void showProbe(const Plots& plots);

  /// Every line as it was handed to the plot, by quantity: polylines of (abscissa, position on the
  /// y axis).
  std::vector<std::vector<QPointF>> linesOf(ProfileQuantity quantity) const;
  /// The marks as they stand on the plot: line and symbol.
  int markCount() const { return static_cast<int>(markLines_.size()); }
  /// The roots of the misprinted (3.13) as they stand on the plot: (abscissa, position on the y
  /// axis).
  std::vector<QPointF> printedRoots() const;
  /// What is drawn, and how its axis is divided where that is not evenly.
  QString heading() const;
  /// In the abscissa; nullopt where it is not shown.
  std::optional<double> probeX() const;

 private:
  double onAxis(double value) const;
  void showLines(const Plots& plots);
  void showMarks(const Plots& plots);
  void resizeLines(std::vector<QCPItemStraightLine*>& lines, std::size_t count);
  void placeSymbols(const Plots& plots);
  void showPrintedRoots(const Plots& plots);
  void showTicks();
  void setMargins();
  QCPCurve& curveOf(ProfileQuantity quantity);
  QCPGraph& symbolsOf(MarkKind kind, bool visible);

  QCustomPlot& plot_;
  PlotKind kind_;
  Look look_;
  PlotAxis axis_{PlotAxis::Scale::Linear, 0.0, 1.0, 1.0};
  std::map<ProfileQuantity, QCPCurve*> curves_;
  std::vector<QCPItemStraightLine*> markLines_;
  std::map<std::pair<MarkKind, bool>, QCPGraph*> symbols_;
  std::vector<QCPItemStraightLine*> printedLines_;
  QCPGraph* printedDots_;
  QCPItemStraightLine* unity_ = nullptr;
  QCPItemStraightLine* probeLine_;
  QCPGraph* probeDots_;
};

}  // namespace flatland::ui
