// SPDX-License-Identifier: GPL-3.0-or-later
// The canvas, driven by mouse and keys as a person drives it.
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QWheelEvent>
#include <algorithm>

#include "tests/ui/support_window.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

double shapeDistance(const BezierChain& a, const BezierChain& b) {
  double worst = 0.0;
  for (int i = 0; i <= 200; ++i) {
    worst = std::max(worst, nearestPoint(b, pointAt(a, a.pieceCount() * i / 200.0)).distance);
  }
  return worst;
}

}  // namespace

class EditingTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    before_ = driver_->scene();
  }
  void cleanup() { driver_.reset(); }

  void dragMovesThePointUnderThePointer() {
    WindowDriver& d = *driver_;
    const auto marks = d.document().features().marks;
    const QPoint from = d.atPoint(1);
    const QPoint to = from + QPoint(-60, 45);
    d.drag(from, to);
    QVERIFY((d.atPoint(1) - to).manhattanLength() <= 1);
    for (const std::size_t other : {0, 2, 3, 4}) {
      QVERIFY(d.chain().points()[other] == before_.curves[0].chain().points()[other]);
    }
    QVERIFY2(d.document().features().marks.front().t != marks.front().t, "the marks followed");
    QCOMPARE(d.document().undoStack().count(), 1);
    QVERIFY(d.window().isWindowModified());
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(d.scene() == before_);
    QVERIFY(!d.window().isWindowModified());
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY((d.atPoint(1) - to).manhattanLength() <= 1);
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    d.canvasKey(Qt::Key_Y, Qt::ControlModifier);
    QVERIFY((d.atPoint(1) - to).manhattanLength() <= 1);
  }

  void escTakesADragBack() {
    WindowDriver& d = *driver_;
    const QPoint from = d.atPoint(2);
    d.press(from);
    d.move(from + QPoint(30, 30));
    d.settle();
    QVERIFY(!(d.scene() == before_));
    d.key(Qt::Key_Escape);
    QVERIFY(d.scene() == before_);
    QCOMPARE(d.document().undoStack().count(), 0);
    d.move(from + QPoint(80, 10));
    d.release(from + QPoint(80, 10));
    QVERIFY2(d.scene() == before_, "what follows of a cancelled drag does nothing");
  }

  void aClickMovesNothing() {
    WindowDriver& d = *driver_;
    d.click(d.atPoint(3) + QPoint(2, 1));
    QVERIFY(d.scene() == before_);
    QCOMPARE(d.document().undoStack().count(), 0);
    QVERIFY((d.window().selection().points() == std::set<PointRef>{{0, 3}}));
    d.click(d.atPoint(1), Qt::ShiftModifier);
    QCOMPARE(d.window().selection().points().size(), std::size_t{2});
    d.click(d.atPoint(3), Qt::ShiftModifier);
    QVERIFY((d.window().selection().points() == std::set<PointRef>{{0, 1}}));
    d.click(d.nowhere());
    QVERIFY(d.window().selection().points().empty());
  }

  void ctrlKeepsToOneAxis() {
    WindowDriver& d = *driver_;
    const QPoint from = d.atPoint(1);
    d.drag(from, from + QPoint(50, 12), Qt::ControlModifier);
    QCOMPARE(d.chain().points()[1].y(), before_.curves[0].chain().points()[1].y());
    QVERIFY(d.chain().points()[1].x() > before_.curves[0].chain().points()[1].x());
  }

  void selectedPointsMoveTogether() {
    WindowDriver& d = *driver_;
    d.click(d.atPoint(0));
    d.click(d.atPoint(4), Qt::ShiftModifier);
    const QPoint from = d.atPoint(4);
    d.drag(from, from + QPoint(20, -30));
    const auto& old = before_.curves[0].chain().points();
    const Vec2 delta = d.chain().points()[4] - old[4];
    QVERIFY(delta.norm() > 0.0);
    QVERIFY((d.chain().points()[0] - old[0] - delta).norm() < 1e-12);
    QVERIFY(d.chain().points()[2] == old[2]);
  }

  void countsPerDragStep() {
    WindowDriver& d = *driver_;
    const QPoint from = d.atPoint(1);
    d.press(from);
    d.move(from + QPoint(8, 0));
    d.settle();
    QSignalSpy changes(&d.document(), &Document::changed);
    EventCounter paints(d.canvas(), QEvent::Paint);
    const int computed = d.document().featureComputations();
    for (int step = 1; step <= 5; ++step) {
      d.move(from + QPoint(8 + 5 * step, 3 * step));
      d.settle();
      QCOMPARE(changes.count(), step);
      QCOMPARE(d.document().featureComputations(), computed + step);
      QCOMPARE(paints.count(), step);
    }
    d.release(from + QPoint(33, 15));
  }

  void equalValuesRepaintNothing() {
    WindowDriver& d = *driver_;
    MainWindow& window = d.window();
    window.selection().setPoints({{0, 1}});
    d.settle();
    QSignalSpy changes(&d.document(), &Document::changed);
    EventCounter paints(d.canvas(), QEvent::Paint);
    window.selection().setPoints({{0, 1}});
    window.display().setShows(MarkKind::Ridge, window.display().shows(MarkKind::Ridge));
    window.viewport().centreOn(window.viewport().centre());
    window.stage().renew();
    d.child<QDoubleSpinBox>("view.angle").setValue(d.scene().view.angleDeg);
    d.child<QAction>("view.perspective").setChecked(d.scene().view.distance.has_value());
    d.settle();
    QCOMPARE(changes.count(), 0);
    QCOMPARE(paints.count(), 0);
    window.display().setShows(MarkKind::Ridge, !window.display().shows(MarkKind::Ridge));
    d.settle();
    QCOMPARE(paints.count(), 1);
  }

  void ringStandsStillDuringADrag() {
    WindowDriver& d = *driver_;
    const QPoint from = d.atPoint(0);
    const QPoint to = from + QPoint(-300, 100);
    const Vec2 handle = d.window().stage().handle();
    const double offset = d.window().stage().screenOffset();
    d.press(from);
    d.move(to);
    d.settle();
    QVERIFY(d.window().stage().handle() == handle);
    QCOMPARE(d.window().stage().screenOffset(), offset);
    d.release(to);
    QVERIFY2(d.window().stage().handle() != handle, "it follows when the button is let go");
  }

  void turningTheHandleTurnsTheView() {
    WindowDriver& d = *driver_;
    const QPoint from = d.atHandle();
    const QPoint pivot = d.at(d.window().stage().pivot());
    const QPoint up = pivot + QPoint(0, -(from.x() - pivot.x()));
    d.drag(from, up);
    QVERIFY(std::abs(d.scene().view.angleDeg - 90.0) < 1.0);
    QCOMPARE(d.document().undoStack().count(), 1);
    QVERIFY(std::abs(d.child<QDoubleSpinBox>("view.angle").value() - d.scene().view.angleDeg) <
            0.01);
    QVERIFY(d.scene().curves == before_.curves);
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(d.scene() == before_);
  }

  void shiftSnapsTheView() {
    WindowDriver& d = *driver_;
    const QPoint from = d.atHandle();
    d.drag(from, from + QPoint(-30, -90), Qt::ShiftModifier);
    const double angle = d.scene().view.angleDeg;
    QVERIFY(angle > 0.0);
    QCOMPARE(std::remainder(angle, 15.0), 0.0);
  }

  void escTakesATurnBack() {
    WindowDriver& d = *driver_;
    d.press(d.atHandle());
    d.move(d.atHandle() + QPoint(-40, 110));
    d.settle();
    QVERIFY(d.scene().view.angleDeg < -1.0);
    d.key(Qt::Key_Escape);
    QVERIFY(d.scene() == before_);
    QCOMPARE(d.document().undoStack().count(), 0);
    d.release({5, 5});
  }

  void typedAngleTurnsTheView() {
    WindowDriver& d = *driver_;
    auto& box = d.child<QDoubleSpinBox>("view.angle");
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, "37.5");
    QVERIFY2(d.scene() == before_, "half a number is no angle yet");
    QTest::keyClick(&box, Qt::Key_Return);
    d.settle();
    QCOMPARE(d.scene().view.angleDeg, 37.5);
    QCOMPARE(d.document().undoStack().count(), 1);
    QTest::mouseClick(&d.child<QAbstractButton>("view.angle.270"), Qt::LeftButton);
    QCOMPARE(d.scene().view.angleDeg, -90.0);
    QCOMPARE(box.value(), -90.0);
  }

  void shownAngleDoesNotRoundTheDocument() {
    WindowDriver& d = *driver_;
    Scene scene = before_;
    scene.view = {12.3456789, 7.123456789};
    d.document().start(scene, "precise");
    d.settle();
    auto& box = d.child<QDoubleSpinBox>("view.angle");
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Return);
    d.canvas().setFocus();
    d.settle();
    QVERIFY(d.scene() == scene);
    QVERIFY(!d.document().isModified());
  }

  void perspectiveViewerIsDraggedInDistance() {
    WindowDriver& d = *driver_;
    QTest::mouseClick(&d.child<QAbstractButton>("view.perspective"), Qt::LeftButton, {},
                      QPoint(8, d.child<QAbstractButton>("view.perspective").height() / 2));
    d.settle();
    QVERIFY(d.scene().view.distance);
    d.window().canvas().fit();
    d.settle();
    const double distance = *d.scene().view.distance;
    const QPoint from = d.atHandle();
    QVERIFY((d.window().viewport().toWorld(from) - frameOf(d.scene().view).eye()).norm() < 0.1);
    d.drag(from, from - QPoint(50, 0));
    QVERIFY(*d.scene().view.distance < distance);
    const double nearer = *d.scene().view.distance;
    d.drag(d.atHandle(), d.atHandle() + QPoint(-30, -60), Qt::ControlModifier);
    QCOMPARE(*d.scene().view.distance, nearer);
    QVERIFY(d.scene().view.angleDeg > 5.0);
  }

  void doubleClickInsertsAndKeepsTheShape() {
    WindowDriver& d = *driver_;
    // A place of the curve with nothing else near.
    const BezierChain chain = d.chain();
    const QPoint place = d.at(pointAt(chain, 0.28));
    QTest::mouseDClick(&d.canvas(), Qt::LeftButton, {}, place);
    d.settle();
    QCOMPARE(d.chain().pieceCount(), chain.pieceCount() + 1);
    QVERIFY(shapeDistance(d.chain(), chain) < 1e-7);
    QVERIFY(shapeDistance(chain, d.chain()) < 1e-7);
    QCOMPARE(d.document().undoStack().count(), 1);
    QCOMPARE(d.window().selection().points().size(), std::size_t{1});
    const std::size_t inserted = d.window().selection().points().begin()->point;
    QVERIFY2((d.atPoint(inserted) - place).manhattanLength() <= 4, "the new point is selected");
    d.canvasKey(Qt::Key_Delete);
    QCOMPARE(d.chain().pieceCount(), chain.pieceCount());
    // Inserted and not moved: taking it out again leaves the curve as it was.
    QVERIFY(shapeDistance(d.chain(), chain) < 1e-7);
    QVERIFY(shapeDistance(chain, d.chain()) < 1e-7);
  }

  void doubleClickOnAMarkInsertsThere() {
    WindowDriver& d = *driver_;
    const auto marks = d.document().features().marks;
    const auto mark = std::find_if(marks.begin(), marks.end(),
                                   [](const Mark& m) { return m.kind == MarkKind::Inflection; });
    QVERIFY(mark != marks.end());
    QTest::mouseDClick(&d.canvas(), Qt::LeftButton, {}, d.at(mark->point));
    d.settle();
    QCOMPARE(d.chain().pieceCount(), 2);
    const auto joint = static_cast<std::size_t>(d.chain().degree());
    QVERIFY((d.chain().points()[joint] - mark->point).norm() < 1e-12);
  }

  void deleteRemovesSelectedPoints() {
    WindowDriver& d = *driver_;
    d.canvasKey(Qt::Key_Delete);
    QVERIFY2(d.scene() == before_, "nothing selected, nothing removed");
    d.click(d.atPoint(2));
    d.canvasKey(Qt::Key_Delete);
    QCOMPARE(d.chain().points().size(), before_.curves[0].chain().points().size() - 1);
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(d.scene() == before_);
  }

  void tabAndArrows() {
    WindowDriver& d = *driver_;
    d.canvasKey(Qt::Key_Tab);
    QVERIFY((d.window().selection().points() == std::set<PointRef>{{0, 0}}));
    d.canvasKey(Qt::Key_Tab);
    QVERIFY((d.window().selection().points() == std::set<PointRef>{{0, 1}}));
    d.canvasKey(Qt::Key_Tab, Qt::ShiftModifier);
    d.canvasKey(Qt::Key_Tab, Qt::ShiftModifier);
    QVERIFY((d.window().selection().points() == std::set<PointRef>{{0, 4}}));
    const Vec2 old = d.chain().points()[4];
    d.canvasKey(Qt::Key_Right);
    const double step = d.chain().points()[4].x() - old.x();
    QVERIFY(step > 0.0);
    d.canvasKey(Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(std::abs(d.chain().points()[4].y() - old.y() - 10.0 * step) < 1e-9);
    d.canvasKey(Qt::Key_Left, Qt::AltModifier);
    QVERIFY(std::abs(d.chain().points()[4].x() - old.x() - 0.9 * step) < 1e-9);
    QCOMPARE(d.document().undoStack().count(), 3);
    d.canvasKey(Qt::Key_Escape);
    QVERIFY(d.window().selection().points().empty());
  }

  void rubberBandSelects() {
    WindowDriver& d = *driver_;
    QRect around(d.atPoint(0), QSize(1, 1));
    around = around.united(QRect(d.atPoint(4), QSize(1, 1))).adjusted(-15, -15, 15, 15);
    std::set<PointRef> inside;
    for (std::size_t i = 0; i < 5; ++i) {
      if (around.contains(d.atPoint(i))) inside.insert({0, i});
    }
    d.drag(around.bottomLeft(), around.topRight());
    QVERIFY(inside.size() >= 2 && inside.size() < 5);
    QVERIFY(d.window().selection().points() == inside);
    QVERIFY(d.scene() == before_);
    d.press(d.nowhere());
    d.move(QPoint(d.canvas().width() - 2, 2));
    QCOMPARE(d.window().selection().points().size(), std::size_t{5});
    d.key(Qt::Key_Escape);
    QVERIFY(d.window().selection().points() == inside);
    d.release(d.nowhere());
  }

  void wheelZoomsAtThePointer() {
    WindowDriver& d = *driver_;
    const QPointF place(200, 150);
    const Vec2 under = d.window().viewport().toWorld(place);
    const double scale = d.window().viewport().scale();
    QWheelEvent wheel(place, d.canvas().mapToGlobal(place), {}, QPoint(0, 120), Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&d.canvas(), &wheel);
    QVERIFY(d.window().viewport().scale() > scale);
    QVERIFY((d.window().viewport().toWorld(place) - under).norm() < 1e-9);
    d.canvasKey(Qt::Key_F);
    QVERIFY(std::abs(d.window().viewport().scale() - scale) < 1e-9 * scale);
  }

  void middleButtonAndSpacePan() {
    WindowDriver& d = *driver_;
    const QPoint place = d.atPoint(0);
    d.drag(d.nowhere(), d.nowhere() + QPoint(40, -25), {}, Qt::MiddleButton);
    QVERIFY((d.atPoint(0) - place - QPoint(40, -25)).manhattanLength() <= 1);
    d.canvas().setFocus();
    QTest::keyPress(&d.canvas(), Qt::Key_Space);
    d.drag(d.atPoint(1), d.atPoint(1) - QPoint(40, -25));
    QTest::keyRelease(&d.canvas(), Qt::Key_Space);
    QVERIFY((d.atPoint(0) - place).manhattanLength() <= 2);
    QVERIFY(d.scene() == before_);
  }

  void wholeCurveMoves() {
    WindowDriver& d = *driver_;
    const QPoint from = d.at(pointAt(d.chain(), 0.28));
    d.drag(from, from + QPoint(0, 20));
    const Vec2 delta = d.chain().points()[0] - before_.curves[0].chain().points()[0];
    QVERIFY(delta.y() < 0.0);
    for (std::size_t i = 0; i < 5; ++i) {
      QVERIFY((d.chain().points()[i] - before_.curves[0].chain().points()[i] - delta).norm() <
              1e-12);
    }
    QCOMPARE(d.document().undoStack().count(), 1);
  }

  void curveMenu() {
    WindowDriver& d = *driver_;
    d.trigger("curve.raise");
    QCOMPARE(d.chain().degree(), 5);
    d.trigger("curve.flip");
    QVERIFY(d.scene().curves[0].flipNormal);
    d.trigger("curve.add");
    QCOMPARE(d.scene().curves.size(), std::size_t{2});
    QCOMPARE(d.window().selection().points().size(), std::size_t{5});
    d.trigger("curve.remove");
    QCOMPARE(d.scene().curves.size(), std::size_t{1});
    QCOMPARE(d.chain().degree(), 5);
    d.trigger("curve.reset");
    QVERIFY(d.scene() == before_);
    QCOMPARE(d.document().undoStack().count(), 5);
    for (int i = 0; i < 5; ++i) d.trigger("edit.undo");
    QVERIFY(d.scene() == before_);
    QVERIFY(!d.document().isModified());
  }

  void everythingRemovedStillWorks() {
    WindowDriver& d = *driver_;
    d.canvasKey(Qt::Key_A, Qt::ControlModifier);
    d.canvasKey(Qt::Key_Delete);
    QVERIFY(d.scene().curves.empty());
    d.canvasKey(Qt::Key_Tab);
    d.canvasKey(Qt::Key_F);
    d.drag(d.nowhere(), d.nowhere() + QPoint(60, -60));
    QVERIFY(!d.child<QAction>("curve.raise").isEnabled());
    d.trigger("curve.add");
    QCOMPARE(d.scene().curves.size(), std::size_t{1});
  }

 private:
  std::unique_ptr<WindowDriver> driver_;
  Scene before_;
};

QTEST_MAIN(EditingTest)
#include "editing_test.moc"
