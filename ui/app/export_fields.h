// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QString>
#include <vector>

#include "ui/app/export_settings.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace flatland::ui {

/// A kind of file to choose from.
struct ExportFormat {
  QString words;   ///< for people
  QString suffix;  ///< "svg"; each once
  bool isPicture = true;
};

/// As what, how large and for which background something is exported: the part that dialogs of
/// exports have in common.
class ExportFields : public QGroupBox {
  Q_OBJECT

 public:
  /// `suffix` of the format chosen at first; size, unit, dots per inch and palette of `settings`.
  ExportFields(const std::vector<ExportFormat>& formats, const QString& suffix,
               const ExportSettings& settings, QWidget* parent);

  /// Adds a field of the dialog's own below the others.
  void addRow(const QString& label, QWidget* field);

  /// Of the chosen format.
  QString suffix() const;

  /// Puts size, unit, dots per inch and palette into `settings`.
  void readInto(ExportSettings& settings) const;

 signals:
  void changed();

 private:
  void read();
  void showUnit();  ///< the size in the chosen unit

  std::vector<ExportFormat> formats_;
  ExportSettings settings_;  ///< as the fields say
  QComboBox* format_;
  QDoubleSpinBox* width_;
  QDoubleSpinBox* height_;
  QComboBox* unit_;
  QDoubleSpinBox* dpi_;
  QComboBox* colours_;
  QFormLayout* form_;
};

}  // namespace flatland::ui
