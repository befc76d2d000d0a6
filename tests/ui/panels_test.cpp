// SPDX-License-Identifier: GPL-3.0-or-later
// Panels and canvas show one state: what is done in one is seen in the other.
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>

#include "tests/ui/support_window.h"
#include "ui/commands/scene_commands.h"
#include "ui/panels/marks_model.h"
#include "ui/panels/points_model.h"

using namespace flatland;
using namespace flatland::ui;

class PanelsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  void legendSwitchesFamilies() {
    WindowDriver& d = *driver_;
    QVERIFY(!d.window().display().shows(MarkKind::Flat));
    QVERIFY(!d.window().display().shows(MarkKind::ApparentMinimum));
    QVERIFY(d.window().display().shows(MarkKind::Ridge));
    const QImage with = d.canvas().grab().toImage();
    auto& box = d.child<QAbstractButton>("legend.ridge");
    QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(8, box.height() / 2));
    d.settle();
    QVERIFY(!d.window().display().shows(MarkKind::Ridge));
    QVERIFY2(d.canvas().grab().toImage() != with, "the marks are gone from the canvas");
    QVERIFY(!d.document().isModified());
    QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(8, box.height() / 2));
    d.settle();
    QVERIFY(d.canvas().grab().toImage() == with);
  }

  void legendCounts() {
    WindowDriver& d = *driver_;
    const auto count = [&d](MarkKind kind) {
      const auto& marks = d.document().features().marks;
      return std::count_if(marks.begin(), marks.end(),
                           [kind](const Mark& m) { return m.kind == kind; });
    };
    QCOMPARE(d.child<QLabel>("legend.count.inflection").text(),
             QString::number(count(MarkKind::Inflection)));
    QVERIFY(count(MarkKind::Inflection) > 0);
    d.document().start(presets()[1].scene, "circle");
    QCOMPARE(d.child<QLabel>("legend.count.inflection").text(),
             QString::number(count(MarkKind::Inflection)));
  }

  void tableRowsAreTheMarks() {
    WindowDriver& d = *driver_;
    auto& table = d.child<QTableView>("marks.table");
    const auto& marks = d.document().features().marks;
    QCOMPARE(table.model()->rowCount(), static_cast<int>(marks.size()));
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const QModelIndex t = table.model()->index(static_cast<int>(i), MarksModel::T);
      QCOMPARE(t.data(MarksModel::kSortRole).toDouble(), marks[i].t);
    }
  }

  void tableAndCanvasSelectTheSameMark() {
    WindowDriver& d = *driver_;
    auto& table = d.child<QTableView>("marks.table");
    const int row = 4;
    const QPoint cell = table.visualRect(table.model()->index(row, 1)).center();
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, cell);
    d.settle();
    QVERIFY(d.window().selection().mark() == keyOf(d.document().features(), row));

    // A visible mark whose neighbourhood is free, picked on the screen line.
    const auto& marks = d.document().features().marks;
    std::size_t silhouette = 0;
    while (marks[silhouette].kind != MarkKind::Silhouette) ++silhouette;
    const CanvasModels models{d.document(),         d.window().selection(), d.window().viewport(),
                              d.window().display(), d.window().stage(),     d.window().probe()};
    d.click(markOnScreen(models, marks[silhouette])->toPoint());
    QVERIFY(d.window().selection().mark() == keyOf(d.document().features(), silhouette));
    QCOMPARE(table.currentIndex().row(), static_cast<int>(silhouette));
    d.canvasKey(Qt::Key_Escape);
    QVERIFY(!d.window().selection().mark());
    QVERIFY(!table.selectionModel()->hasSelection());
  }

  void enterCentresTheMark() {
    WindowDriver& d = *driver_;
    auto& table = d.child<QTableView>("marks.table");
    table.setFocus();
    table.setCurrentIndex(table.model()->index(2, 0));
    QTest::keyClick(&table, Qt::Key_Return);
    QVERIFY((d.window().viewport().centre() - d.document().features().marks[2].point).norm() <
            1e-12);
  }

  void sortingKeepsRowsAndMarksTogether() {
    WindowDriver& d = *driver_;
    auto& table = d.child<QTableView>("marks.table");
    table.sortByColumn(MarksModel::Screen, Qt::DescendingOrder);
    double last = std::numeric_limits<double>::infinity();
    for (int row = 0; row < table.model()->rowCount(); ++row) {
      const double screen =
          table.model()->index(row, MarksModel::Screen).data(MarksModel::kSortRole).toDouble();
      QVERIFY(screen <= last);
      last = screen;
    }
    table.setCurrentIndex(table.model()->index(0, 0));
    const auto index = indexOf(d.document().features(), *d.window().selection().mark());
    for (const Mark& mark : d.document().features().marks) {
      QVERIFY(*mark.screen <= *d.document().features().marks[*index].screen);
    }
  }

  void aVanishedMarkSelectsNoOther() {
    WindowDriver& d = *driver_;
    auto& table = d.child<QTableView>("marks.table");
    const int rows = table.model()->rowCount();
    table.setCurrentIndex(table.model()->index(rows - 1, 0));
    QVERIFY(d.window().selection().mark());
    const MarkKey key = *d.window().selection().mark();
    int fewest = rows;
    for (int angle = 5; angle < 360; angle += 5) {
      d.document().push(
          std::make_unique<SetView>(d.document(), View{normalizedDeg(angle), std::nullopt}));
      fewest = std::min(fewest, table.model()->rowCount());
      QVERIFY(d.window().selection().mark() == key);
      const bool exists = indexOf(d.document().features(), key).has_value();
      QCOMPARE(table.selectionModel()->hasSelection(), exists);
    }
    QVERIFY2(fewest < rows, "marks did vanish");
  }

  void typedCoordinatesMoveThePoint() {
    WindowDriver& d = *driver_;
    auto& table = d.child<QTableView>("points.table");
    const QModelIndex cell = table.model()->index(3, PointsModel::Y);
    table.setFocus();
    table.setCurrentIndex(cell);
    table.edit(cell);
    auto& editor = d.child<QLineEdit>("points.editor");
    editor.selectAll();
    QTest::keyClicks(&editor, "0.123456789012345");
    QTest::keyClick(&editor, Qt::Key_Return);
    d.settle();
    QCOMPARE(d.chain().points()[3].y(), 0.123456789012345);
    QCOMPARE(d.document().undoStack().count(), 1);
    const Scene typed = d.scene();
    for (const char* nonsense : {"", "abc", "1e999", "nan"}) {
      QVERIFY(!table.model()->setData(cell, nonsense));
    }
    QVERIFY(d.scene() == typed);
  }

  void pointsTableAndCanvasSelectTheSamePoints() {
    WindowDriver& d = *driver_;
    auto& table = d.child<QTableView>("points.table");
    d.click(d.atPoint(2));
    QCOMPARE(table.selectionModel()->selectedRows().size(), 1);
    QCOMPARE(table.selectionModel()->selectedRows().front().row(), 2);
    table.selectRow(4);
    QVERIFY((d.window().selection().points() == std::set<PointRef>{{0, 4}}));
  }

  void statusTellsWhatADragWouldDo() {
    WindowDriver& d = *driver_;
    auto& hint = d.child<QLabel>("status.hint");
    const auto hover = [&](const QPoint& p) {
      d.move(p, {}, Qt::NoButton);
      return hint.text();
    };
    const QString nothing = hover(d.nowhere());
    const QString point = hover(d.atPoint(1));
    const QString handle = hover(d.atHandle());
    QVERIFY(nothing != point && point != handle && handle != nothing);
    QVERIFY(d.child<QAbstractButton>("status.marks")
                .text()
                .contains(QString::number(d.document().features().marks.size())));
  }

  void docksCloseAndComeBack() {
    WindowDriver& d = *driver_;
    auto& dock = d.child<QDockWidget>("legend");
    d.trigger("view.dock.legend");
    QVERIFY(!dock.isVisible());
    d.trigger("view.dock.legend");
    QVERIFY(dock.isVisible());
    dock.close();
    d.trigger("view.restore-layout");
    QVERIFY(dock.isVisible());
  }

  void nextPaneMovesTheFocus() {
    WindowDriver& d = *driver_;
    d.canvasKey(Qt::Key_F6);
    QVERIFY(!d.canvas().hasFocus());
    d.key(Qt::Key_F6, Qt::ShiftModifier);
    QVERIFY(d.canvas().hasFocus());
  }

  void everythingClickableIsNamed() {
    WindowDriver& d = *driver_;
    for (const QAction* action : d.window().findChildren<QAction*>()) {
      if (action->isSeparator() || action->menu() || !action->objectName().contains('.')) continue;
      QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->objectName()));
    }
    for (QMenu* menu : d.window().findChildren<QMenu*>()) {
      if (!menu->objectName().startsWith("menu.")) continue;
      for (const QAction* action : menu->actions()) {
        if (action->isSeparator()) continue;
        QVERIFY2(action->menu() || !action->objectName().isEmpty(), qPrintable(action->text()));
      }
    }
    for (const QWidget* widget : d.window().findChildren<QWidget*>()) {
      QVERIFY2(QFontInfo(widget->font()).pointSizeF() >= 8.99 || !widget->isVisible(),
               qPrintable(widget->objectName()));
    }
  }

 private:
  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(PanelsTest)
#include "panels_test.moc"
