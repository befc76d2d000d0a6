// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>

#include "ui/app/export_settings.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;

namespace flatland::ui {

class ExportFields;

/// Asks how to export the picture, and shows it meanwhile. The dialog itself writes nothing.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(const Document& document, const ExportSettings& settings, QWidget* parent);

  const ExportSettings& settings() const { return settings_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildScale();
  QWidget* buildContents();
  QCheckBox* addSwitch(const char* id, const QString& text, const QString& tip);
  void read();  ///< the fields into the settings
  void showPreview();

  const Document& document_;
  ExportSettings settings_;
  ExportFields* fields_;
  QDoubleSpinBox* scale_;
  QCheckBox* transparent_;
  QCheckBox* letters_;
  QCheckBox* legend_;
  QCheckBox* controlPolygon_;
  QCheckBox* hidden_;
  std::array<QCheckBox*, kMarkKindCount> kinds_{};
  QLabel* preview_;
};

}  // namespace flatland::ui
