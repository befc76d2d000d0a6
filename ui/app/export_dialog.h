// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>

#include "ui/app/export_settings.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace flatland::ui {

/// Asks how to export the picture, and shows it meanwhile. The dialog itself writes nothing.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(const Document& document, const ExportSettings& settings, QWidget* parent);

  const ExportSettings& settings() const { return settings_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buildSize();
  QWidget* buildContents();
  QCheckBox* addSwitch(const char* id, const QString& text, const QString& tip);
  void read();      ///< the fields into the settings
  void showUnit();  ///< the sizes in the chosen unit
  void showPreview();

  const Document& document_;
  ExportSettings settings_;
  QComboBox* format_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
  QComboBox* unit_;
  QDoubleSpinBox* dpi_;
  QComboBox* colours_;
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
