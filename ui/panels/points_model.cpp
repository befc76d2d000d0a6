// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/points_model.h"

#include <QLocale>
#include <cmath>

#include "flatland/curve/curve_editing.h"
#include "flatland/io/scene_json.h"
#include "ui/commands/curve_commands.h"

namespace flatland::ui {

PointsModel::PointsModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
  connect(&document, &Document::changed, this, &PointsModel::documentChanged);
}

void PointsModel::documentChanged(const Change& change) {
  if (change.what == Change::What::Topology || change.what == Change::What::Scene) {
    beginResetModel();
    endResetModel();
  } else if (change.what == Change::What::Points && rowCount() > 0) {
    emit dataChanged(index(0, X), index(rowCount() - 1, Y));
  }
}

PointRef PointsModel::refOf(int row) const {
  auto left = static_cast<std::size_t>(row);
  std::size_t curve = 0;
  while (left >= controlPoints(document_.scene().curves[curve].shape).size()) {
    left -= controlPoints(document_.scene().curves[curve].shape).size();
    ++curve;
  }
  return {curve, left};
}

int PointsModel::rowOf(const PointRef& ref) const {
  std::size_t row = ref.point;
  for (std::size_t c = 0; c < ref.curve; ++c)
    row += controlPoints(document_.scene().curves[c].shape).size();
  return static_cast<int>(row);
}

int PointsModel::rowCount(const QModelIndex& parent) const {
  std::size_t rows = 0;
  if (parent.isValid()) return 0;
  for (const SceneCurve& curve : document_.scene().curves)
    rows += controlPoints(curve.shape).size();
  return static_cast<int>(rows);
}

int PointsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

QVariant PointsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const PointRef ref = refOf(index.row());
  const flatland::Curve& curve = document_.scene().curves[ref.curve].shape;
  const Vec2& p = controlPoints(curve)[ref.point];
  if (role == Qt::TextAlignmentRole) {
    return QVariant::fromValue(Qt::AlignVCenter | Qt::AlignRight);
  }
  if (role == Qt::ToolTipRole && index.column() == Point) {
    return isJoint(curve, ref.point) ? tr("The curve passes through this point.")
                                     : tr("This point pulls the curve towards itself.");
  }
  if (role != Qt::DisplayRole && role != Qt::EditRole) return {};
  switch (index.column()) {
    case Curve:
      return QString::number(ref.curve);
    case Point:
      return QString::number(ref.point);
    default: {
      const double value = index.column() == X ? p.x() : p.y();
      // For reading few digits will do; an editor gets the very number, so that leaving it
      // unchanged changes nothing.
      return role == Qt::EditRole ? QString::number(value, 'g', QLocale::FloatingPointShortest)
                                  : QString::number(value, 'g', 6);
    }
  }
}

bool PointsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !flags(index).testFlag(Qt::ItemIsEditable)) return false;
  bool isNumber = false;
  // A decimal comma is taken as one: coordinates have no thousands to group.
  const double typed = value.toString().trimmed().replace(',', '.').toDouble(&isNumber);
  if (!isNumber || !std::isfinite(typed)) {
    emit refused(tr("\u201c%1\u201d is not a number; the coordinate stays.").arg(value.toString()));
    return false;
  }
  if (std::abs(typed) > kLargestLength) {
    emit refused(tr("Coordinates lie within %1; the coordinate stays.").arg(kLargestLength));
    return false;
  }
  const PointRef ref = refOf(index.row());
  Vec2 target = controlPoints(document_.scene().curves[ref.curve].shape)[ref.point];
  (index.column() == X ? target.x() : target.y()) = typed;
  document_.push(std::make_unique<PlacePoint>(document_, ref, target));
  return true;
}

Qt::ItemFlags PointsModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags base = QAbstractTableModel::flags(index);
  const bool coordinate = index.column() == X || index.column() == Y;
  return index.isValid() && coordinate ? base | Qt::ItemIsEditable : base;
}

QVariant PointsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString titles[kColumnCount] = {tr("Curve"), tr("Point"), tr("x"), tr("y")};
  return titles[section];
}

}  // namespace flatland::ui
