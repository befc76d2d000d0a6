// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "ui/model/selection.h"

namespace flatland::ui {

/// The control points of all curves as a table whose coordinates can be typed. An edit is a
/// command; text that is no number, or one beyond what a scene file can hold, is refused and
/// nothing changes.
class PointsModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Curve, Point, X, Y, kColumnCount };

  explicit PointsModel(Document& document, QObject* parent = nullptr);

  PointRef refOf(int row) const;         ///< Precondition: 0 <= row < rowCount().
  int rowOf(const PointRef& ref) const;  ///< Precondition: the point exists.

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 signals:
  /// Why a typed coordinate was not taken, for the status line.
  void refused(const QString& why);

 private:
  void documentChanged(const Change& change);

  Document& document_;
};

}  // namespace flatland::ui
