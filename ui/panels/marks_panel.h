// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/flat/canvas_models.h"

class QSortFilterProxyModel;
class QTableView;

namespace flatland::ui {

class MarksModel;

/// The table of all marks: sortable, linked with the canvas both ways. Selecting a row highlights
/// the mark, Enter or a double-click brings it to the middle of the canvas.
class MarksPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MarksPanel(const CanvasModels& models, QWidget* parent = nullptr);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rowPicked();
  void showSelection();
  void centreOn(const QModelIndex& row);
  void documentChanged(const Change& change);

  CanvasModels models_;
  MarksModel* marks_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
};

}  // namespace flatland::ui
