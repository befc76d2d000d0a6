// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/points_panel.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/panels/points_model.h"

namespace flatland::ui {

namespace {

/// Edits a coordinate as text: a spin box would round it.
class CoordinateDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                        const QModelIndex&) const override {
    auto* editor = new QLineEdit(parent);
    editor->setObjectName("points.editor");
    editor->setAccessibleName(PointsPanel::tr("Coordinate"));
    editor->setFrame(false);
    return editor;
  }
};

}  // namespace

PointsPanel::PointsPanel(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      selection_(selection),
      points_(new PointsModel(document, this)),
      table_(new QTableView(this)) {
  connect(points_, &PointsModel::refused, this, &PointsPanel::refused);
  table_->setObjectName("points.table");
  table_->setAccessibleName(tr("Control points"));
  table_->setToolTip(tr("Double-click a coordinate, or press F2, to type it."));
  table_->setModel(points_);
  table_->setItemDelegate(new CoordinateDelegate(this));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setAlternatingRowColors(true);
  table_->setShowGrid(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  for (const int column : {PointsModel::Curve, PointsModel::Point}) {
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->addWidget(table_);
  setFocusProxy(table_);

  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &PointsPanel::rowsPicked);
  connect(&selection_, &Selection::changed, this, &PointsPanel::showSelection);
  connect(points_, &QAbstractItemModel::modelReset, this, &PointsPanel::showSelection);
}

void PointsPanel::rowsPicked() {
  std::set<PointRef> points;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
    points.insert(points_->refOf(row.row()));
  }
  selection_.setPoints(std::move(points));
}

void PointsPanel::showSelection() {
  QItemSelection rows;
  for (const PointRef& ref : selection_.points()) {
    if (points_->rowCount() <= points_->rowOf(ref)) continue;
    const QModelIndex index = points_->index(points_->rowOf(ref), 0);
    rows.select(index, index.siblingAtColumn(PointsModel::kColumnCount - 1));
  }
  QItemSelection now = table_->selectionModel()->selection();
  now.merge(rows, QItemSelectionModel::Toggle);
  if (now.isEmpty()) return;  // shown already
  table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (!rows.isEmpty()) table_->scrollTo(rows.indexes().front());
}

}  // namespace flatland::ui
