// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "ui/model/plots.h"

class QGridLayout;
class QLabel;
class QLineEdit;

namespace flatland::ui {

/// Everything known at the probe, as numbers to read and to copy; place and arc length can be
/// typed.
class ProbePanel : public QWidget {
  Q_OBJECT

 public:
  ProbePanel(const Document& document, Probe& probe, const Plots& plots, QWidget* parent = nullptr);
  ~ProbePanel() override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  /// What a row says: a value, or why there is none.
  struct Said {
    QString value;   ///< empty: a dash
    QString reason;  ///< then why
  };
  struct Row {
    QLabel* value;
    QString meaning;
    std::function<Said(const Probe::Reading&)> say;
  };

  QLineEdit* addField(QGridLayout& grid, int row, const char* id, const QString& name,
                      const QString& meaning);
  void addRow(QGridLayout& grid, int row, int column, const char* id, const QString& name,
              const QString& meaning, std::function<Said(const Probe::Reading&)> say);
  void addGeometry(QGridLayout& grid);
  void addSeen(QGridLayout& grid);
  void showProbe();
  void typeT();
  void typeU();

  const Document& document_;
  Probe& probe_;
  const Plots& plots_;
  QLineEdit* t_;
  QLineEdit* u_;
  std::vector<Row> rows_;
};

}  // namespace flatland::ui
