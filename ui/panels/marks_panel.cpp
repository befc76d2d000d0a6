// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/marks_panel.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/model/mark_words.h"
#include "ui/panels/marks_model.h"

namespace flatland::ui {

namespace {

/// A table that shows the order of the document until the person asks for another.
constexpr int kUnsorted = -1;

/// As wide as the content of the column gets, with a margin.
QString widestText(int column) {
  switch (column) {
    case MarksModel::Kind:
      return nameForPeople(MarkKind::ApparentMinimum) + "MMM";
    case MarksModel::Curve:
      return QStringLiteral("CurveM");
    case MarksModel::T:
    case MarksModel::U:
    case MarksModel::Screen:
      return QStringLiteral("-0.01234567M");
    case MarksModel::Residual:
      return QStringLiteral("ResidualMM");
    default:
      return QStringLiteral("-1.2346e-12M");
  }
}

void setUpTable(QTableView& table) {
  table.setObjectName("marks.table");
  table.setAccessibleName(MarksPanel::tr("Marks"));
  table.setToolTip(
      MarksPanel::tr("Select a row to highlight the mark; Enter or a double-click centres it."));
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setAlternatingRowColors(true);
  table.setShowGrid(false);
  table.setWordWrap(false);
  table.setTabKeyNavigation(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 6);
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::Interactive);
  table.horizontalHeader()->setStretchLastSection(true);
}

}  // namespace

MarksPanel::MarksPanel(const CanvasModels& models, QWidget* parent)
    : QWidget(parent),
      models_(models),
      marks_(new MarksModel(models.document, models.display, this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView(this)) {
  sorted_->setSourceModel(marks_);
  sorted_->setSortRole(MarksModel::kSortRole);
  setUpTable(*table_);
  // Before the table hears of it: it would select a neighbour of the row that goes, but a mark
  // that vanished has none.
  connect(sorted_, &QAbstractItemModel::rowsAboutToBeRemoved, this,
          [this] { table_->selectionModel()->clear(); });
  table_->setModel(sorted_);
  table_->horizontalHeader()->setSortIndicator(kUnsorted, Qt::AscendingOrder);
  table_->setSortingEnabled(true);
  table_->horizontalHeader()->setSortIndicatorClearable(true);
  // Widths for the widest content, so that columns do not move while numbers change.
  const QFontMetrics metrics = table_->fontMetrics();
  for (int c = 0; c < MarksModel::kColumnCount; ++c) {
    table_->setColumnWidth(c, metrics.horizontalAdvance(widestText(c)));
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->addWidget(table_);
  setFocusProxy(table_);
  table_->installEventFilter(this);

  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &MarksPanel::rowPicked);
  connect(table_, &QTableView::doubleClicked, this, &MarksPanel::centreOn);
  connect(&models_.selection, &Selection::changed, this, &MarksPanel::showSelection);
  connect(&models_.document, &Document::changed, this, &MarksPanel::documentChanged);
  documentChanged({Change::What::View});
}

void MarksPanel::documentChanged(const Change& change) {
  if (!change.touchesScene()) return;
  table_->setColumnHidden(MarksModel::Perspective,
                          !models_.document.scene().view.distance.has_value());
  showSelection();
}

bool MarksPanel::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
      centreOn(table_->currentIndex());
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void MarksPanel::rowPicked() {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (rows.isEmpty()) return;
  const auto row = static_cast<std::size_t>(sorted_->mapToSource(rows.front()).row());
  models_.selection.setMark(keyOf(models_.document.features(), row));
}

void MarksPanel::showSelection() {
  const auto& mark = models_.selection.mark();
  const auto index = mark ? indexOf(models_.document.features(), *mark) : std::nullopt;
  if (!index) {
    table_->selectionModel()->clear();
    return;
  }
  const QModelIndex row = sorted_->mapFromSource(marks_->index(static_cast<int>(*index), 0));
  if (table_->selectionModel()->isRowSelected(row.row(), {})) return;
  table_->setCurrentIndex(row);
  table_->scrollTo(row);
}

void MarksPanel::centreOn(const QModelIndex& row) {
  if (!row.isValid()) return;
  const auto source = static_cast<std::size_t>(sorted_->mapToSource(row).row());
  models_.viewport.centreOn(models_.document.features().marks[source].point);
}

}  // namespace flatland::ui
