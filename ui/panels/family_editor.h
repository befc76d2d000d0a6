// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "ui/model/document.h"

class QDoubleSpinBox;
class QLabel;

namespace flatland::ui {

class MarkedSlider;

/// The parameters of a curve of a family: a slider and a number for each. The canvas follows while
/// a slider moves; each drag is one step of undo.
class FamilyEditor : public QWidget {
  Q_OBJECT

 public:
  /// Precondition: the curve is one of a family, and stays one of the same while the editor lives.
  FamilyEditor(Document& document, std::size_t curve, QWidget* parent = nullptr);

  /// Shows what the document holds.
  void refresh();

 signals:
  void refused(const QString& why);

 private:
  struct Row {
    MarkedSlider* slider;
    QDoubleSpinBox* number;
  };
  const FormulaCurve& shape() const;
  void addRow(std::size_t index);
  void set(std::size_t index, double value, int gesture);
  void showNote();

  Document& document_;
  std::size_t curve_;
  std::vector<Row> rows_;
  QLabel* note_;
  int gesture_ = 0;
};

}  // namespace flatland::ui
