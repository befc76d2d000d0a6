// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "ui/model/display.h"
#include "ui/model/document.h"

namespace flatland::ui {

/// All marks of the document as a table, one row each, in the order of FeatureSet::marks. Holds
/// nothing but the number of rows the views know of; values are read from the document when asked.
class MarksModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column {
    Kind,
    Curve,
    T,
    U,
    Screen,
    Lambda,
    Feature,
    Offset,
    Perspective,
    Residual,
    Visible,
    kColumnCount
  };

  /// Role of the plain number (or rank) to sort by; an invalid QVariant where there is no value.
  static constexpr int kSortRole = Qt::UserRole;

  MarksModel(const Document& document, const Display& display, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void documentChanged(const Change& change);
  void restyle();
  QVariant number(const Mark& mark, int column) const;
  QString text(const Mark& mark, int column) const;

  const Document& document_;
  const Display& display_;
  int rows_ = 0;
};

}  // namespace flatland::ui
