// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/marks_model.h"

#include <QGuiApplication>
#include <QPalette>

#include "ui/model/mark_words.h"
#include "ui/panels/mark_icon.h"

namespace flatland::ui {

namespace {

QVariant optionalNumber(const std::optional<double>& value) {
  return value ? QVariant(*value) : QVariant();
}

/// Between text and background, still 4.5 : 1 or better on either theme.
QColor faintText() {
  const QPalette palette = QGuiApplication::palette();
  const QColor text = palette.color(QPalette::Text);
  const QColor base = palette.color(QPalette::Base);
  const auto mix = [](int a, int b) { return (3 * a + 2 * b) / 5; };
  return {mix(text.red(), base.red()), mix(text.green(), base.green()),
          mix(text.blue(), base.blue())};
}

}  // namespace

MarksModel::MarksModel(const Document& document, const Display& display, QObject* parent)
    : QAbstractTableModel(parent),
      document_(document),
      display_(display),
      rows_(static_cast<int>(document.features().marks.size())) {
  connect(&document, &Document::changed, this, &MarksModel::documentChanged);
  connect(&display, &Display::changed, this, &MarksModel::restyle);
}

void MarksModel::documentChanged(const Change& change) {
  if (!change.touchesScene()) return;
  const int rows = static_cast<int>(document_.features().marks.size());
  // Rows come and go at the end: what a row shows follows by dataChanged, and views keep their
  // place.
  if (rows > rows_) {
    beginInsertRows({}, rows_, rows - 1);
    rows_ = rows;
    endInsertRows();
  } else if (rows < rows_) {
    beginRemoveRows({}, rows, rows_ - 1);
    rows_ = rows;
    endRemoveRows();
  }
  if (rows_ > 0) emit dataChanged(index(0, 0), index(rows_ - 1, kColumnCount - 1));
}

void MarksModel::restyle() {
  if (rows_ > 0) {
    emit dataChanged(index(0, 0), index(rows_ - 1, kColumnCount - 1), {Qt::ForegroundRole});
  }
}

int MarksModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : rows_; }

int MarksModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumnCount;
}

QVariant MarksModel::data(const QModelIndex& index, int role) const {
  const auto& marks = document_.features().marks;
  const auto row = static_cast<std::size_t>(index.row());
  if (!index.isValid() || row >= marks.size()) return {};
  const Mark& mark = marks[row];
  switch (role) {
    case Qt::DisplayRole:
      return text(mark, index.column());
    case kSortRole:
      return number(mark, index.column());
    case Qt::DecorationRole:
      return index.column() == Kind ? QVariant(markIcon(mark.kind)) : QVariant();
    case Qt::ToolTipRole: {
      if (index.column() == Kind) return explanation(mark.kind);
      const QVariant value = number(mark, index.column());
      return value.typeId() == QMetaType::Double ? QString::number(value.toDouble(), 'g', 17)
                                                 : QString();
    }
    case Qt::TextAlignmentRole: {
      const bool left = index.column() == Kind || index.column() == Visible;
      return QVariant::fromValue(Qt::AlignVCenter | (left ? Qt::AlignLeft : Qt::AlignRight));
    }
    case Qt::ForegroundRole:
      if (mark.visible && display_.shows(mark.kind)) return {};
      return faintText();
    default:
      return {};
  }
}

QVariant MarksModel::number(const Mark& mark, int column) const {
  switch (column) {
    case Kind:
      return static_cast<int>(mark.kind);
    case Curve:
      return mark.curve;
    case T:
      return mark.t;
    case U:
      return mark.u;
    case Screen:
      return optionalNumber(mark.screen);
    case Lambda:
      return optionalNumber(mark.lambda);
    case Feature:
      return optionalNumber(mark.feature);
    case Offset:
      return optionalNumber(mark.offset);
    case Perspective:
      return optionalNumber(mark.perspective);
    case Residual:
      return mark.residual;
    default:
      return mark.visible ? 1 : 0;
  }
}

QString MarksModel::text(const Mark& mark, int column) const {
  switch (column) {
    case Kind:
      return nameForPeople(mark.kind);
    case Curve:
      return QString::number(mark.curve);
    case Visible:
      return mark.visible ? tr("yes") : tr("no");
    case T:
      return QString::number(mark.t, 'f', 6);
    case Residual:
      return QString::number(mark.residual, 'e', 1);
    default: {
      const QVariant value = number(mark, column);
      return value.isValid()
                 ? QString::number(value.toDouble(), 'g', column == U || column == Screen ? 6 : 5)
                 : QStringLiteral("–");
    }
  }
}

QVariant MarksModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  struct Heading {
    QString title, meaning;
  };
  const Heading headings[kColumnCount] = {
      {tr("Mark"), tr("What kind of mark it is")},
      {tr("Curve"), tr("Number of the curve, from 0")},
      {tr("t"), tr("Parameter on the curve: piece number plus place in the piece")},
      {tr("u"), tr("Arc length from the start of the curve")},
      {tr("Screen"), tr("Coordinate on the screen")},
      {QStringLiteral("\u03bb"), tr("View-dependent curvature squared; none at a silhouette")},
      {tr("Feature"), tr("Feature term of the apparent-ridge equation, (n·w) k k'")},
      {tr("Offset"), tr("Offset term of the apparent-ridge equation, \u2212k\u00b3 (t·w)")},
      {tr("Perspective"), tr("Term added by the perspective view; zero in an orthographic one")},
      {tr("Residual"), tr("How far the mark's equation is from zero there, without dimension")},
      {tr("Visible"), tr("Whether nothing lies between the mark and the viewer")},
  };
  if (role == Qt::DisplayRole) return headings[section].title;
  if (role == Qt::ToolTipRole) return headings[section].meaning;
  if (role == Qt::TextAlignmentRole) {
    const bool left = section == Kind || section == Visible;
    return QVariant::fromValue(Qt::AlignVCenter | (left ? Qt::AlignLeft : Qt::AlignRight));
  }
  return {};
}

}  // namespace flatland::ui
