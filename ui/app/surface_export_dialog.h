// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "ui/app/export_settings.h"

namespace flatland::ui {

class ExportFields;

/// Asks as what, how large and in which colours the surface is exported. Writes nothing.
class SurfaceExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `suffix` of the format chosen at first.
  SurfaceExportDialog(const ExportSettings& settings, const QString& suffix, QWidget* parent);

  /// Size, unit, dots per inch and palette; the rest is as it was given.
  ExportSettings settings() const;

  /// "svg", "pdf", "tex" for the lines, "png", "ply", "csv" or "json".
  QString suffix() const;

 private:
  ExportSettings settings_;
  ExportFields* fields_;
};

}  // namespace flatland::ui
