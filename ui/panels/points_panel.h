// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/model/selection.h"

class QTableView;

namespace flatland::ui {

class PointsModel;

/// The control points with coordinates to type, linked with the selection on the canvas both ways.
class PointsPanel : public QWidget {
  Q_OBJECT

 public:
  PointsPanel(Document& document, Selection& selection, QWidget* parent = nullptr);

 signals:
  /// See PointsModel::refused().
  void refused(const QString& why);

 private:
  void rowsPicked();
  void showSelection();

  Selection& selection_;
  PointsModel* points_;
  QTableView* table_;
};

}  // namespace flatland::ui
