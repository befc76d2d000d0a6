// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "ui/plot/plot_export.h"
#include "ui/plot/profile_plot.h"

class QComboBox;
class QToolButton;

namespace flatland::ui {

/// The plots along the curve, one above the other, sharing range and probe; and what they show:
/// which of them, of which curve, against what.
class PlotsPanel : public QWidget {
  Q_OBJECT

 public:
  /// See PlotExporter for `settings`.
  PlotsPanel(Plots& plots, Display& display, QSettings* settings, QWidget* parent = nullptr);

  ProfilePlot& plot(PlotKind kind) { return *plotWidgets_[static_cast<std::size_t>(kind)]; }
  PlotExporter& exporter() { return *exporter_; }

 signals:
  /// For the status line.
  void said(const QString& text);
  /// For the message bar.
  void failed(const QString& text);

 private:
  QLayout* buildTools();
  QToolButton* buildChooser();
  void showChoices();
  void showMenu(PlotKind kind, const QPoint& globalPos);

  Plots& plots_;
  Display& display_;
  PlotExporter* exporter_;
  std::array<ProfilePlot*, kPlotKindCount> plotWidgets_{};
  std::array<QAction*, kPlotKindCount> shown_{};
  QComboBox* against_;
  QComboBox* curve_;
};

}  // namespace flatland::ui
