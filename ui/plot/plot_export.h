// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QObject>
#include <filesystem>

#include "ui/model/plots.h"
#include "ui/plot/plot_picture.h"

class QComboBox;
class QDoubleSpinBox;
class QSettings;

namespace flatland::ui {

/// How plots are written; remembered from one time to the next.
struct PlotExportSettings {
  QString suffix = QStringLiteral("svg");  ///< svg, pdf, png or csv
  double widthCm = 12.0;
  double heightCm = 6.0;
  double dpi = 300.0;  ///< PNG only

  void restore(const QSettings& settings);
  void save(QSettings& settings) const;
};

/// Asks for format and size.
class PlotExportDialog : public QDialog {
  Q_OBJECT

 public:
  PlotExportDialog(const QString& title, const PlotExportSettings& settings, QWidget* parent);
  PlotExportSettings settings() const;

 private:
  void showFormat();

  QComboBox* format_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
  QDoubleSpinBox* dpi_;
};

/// Copies plots and writes them to files, in the colours for paper whatever the theme.
class PlotExporter : public QObject {
  Q_OBJECT

 public:
  /// `settings` remembers size, format and folder; null: nothing is remembered.
  PlotExporter(const Plots& plots, QSettings* settings, QWidget* parent);

  void copyPicture(PlotKind kind);
  void copyTable(PlotKind kind);
  /// Asks how and where.
  void exportPlot(PlotKind kind);
  /// Writes atomically in the format of `how`. Throws InputError.
  void write(PlotKind kind, const std::filesystem::path& file, const PlotExportSettings& how) const;

 signals:
  void said(const QString& text);
  void failed(const QString& text);

 private:
  std::string pictureOf(PlotKind kind, PictureFormat format, const PlotExportSettings& how) const;
  std::string tableOf(PlotKind kind) const;

  const Plots& plots_;
  QSettings* settings_;
  QWidget* parent_;
};

}  // namespace flatland::ui
