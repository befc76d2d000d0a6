// SPDX-License-Identifier: GPL-3.0-or-later
// The view sweep in the window, by mouse and keys: it goes where it is clicked, follows, and plays.
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QToolButton>
#include <QWheelEvent>

#include "flatland/curve/curve.h"
#include "flatland/io/sweep_text.h"
#include "tests/ui/support_window.h"
#include "ui/commands/scene_commands.h"
#include "ui/plot/figure_files.h"
#include "ui/plot/sweep_panel.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

// Half a pixel of the diagram: about 290 px for 360 degrees at the default size.
constexpr double kPixelDeg = 1.5;

}  // namespace

class SweepPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    auto* dock = driver_->window().findChild<QDockWidget*>("sweep");
    QVERIFY(dock);
    dock->show();
    dock->raise();
    // Room enough that a pixel is about a degree.
    driver_->window().resizeDocks({dock}, {460}, Qt::Vertical);
    driver_->window().resizeDocks({dock}, {620}, Qt::Horizontal);
    driver_->settle();
    panel_ = driver_->window().findChild<SweepPanel*>();
    QVERIFY(panel_);
    QTRY_VERIFY(panel_->source().data() && !panel_->source().isStale());
  }
  void cleanup() { driver_.reset(); }

  void clickGoesToTheView() {
    WindowDriver& d = *driver_;
    // A free place, away from every line.
    const double length = panel_->source().data()->lengths.at(0);
    const QPointF at = *view().positionOf(58.0, 0, 0.55 * length);
    click(at);
    QVERIFY(std::abs(angle() - 58.0) <= kPixelDeg);
    const auto place = d.window().probe().place();
    QVERIFY(place && place->curve == 0);
    QVERIFY(std::abs(lengthAt(place->t) - 0.55 * length) < 0.02 * length);
    QCOMPARE(d.document().undoStack().count(), 1);
    QCOMPARE(d.child<QDoubleSpinBox>("sweep.angle").value(), angle());
    d.document().undoStack().undo();
    QCOMPARE(angle(), 0.0);
  }

  void aClickGoesExactlyThereAndUndoBringsBackTheProbeToo() {
    WindowDriver& d = *driver_;
    const double length = panel_->source().data()->lengths.at(0);
    const auto before = d.window().probe().place();
    QVERIFY(before);
    const QPointF zero = *view().positionOf(0.0, 0, 0.0), ninety = *view().positionOf(90.0, 0, 0.0);
    const double perPixel = 90.0 / (ninety.x() - zero.x());
    const QPoint pixel = view().positionOf(47.6, 0, 0.55 * length)->toPoint();
    const double there = (pixel.x() - zero.x()) * perPixel;
    QVERIFY2(std::abs(there - std::round(there)) > 0.06, "a pixel that is no whole degree");
    click(pixel);
    QVERIFY2(std::abs(angle() - there) <= 0.06 * perPixel, qPrintable(QString::number(angle())));
    QVERIFY(!(d.window().probe().place() == before));
    const auto gone = d.window().probe().place();
    d.document().undoStack().undo();
    QVERIFY(d.window().probe().place() == before);
    d.document().undoStack().redo();
    QVERIFY(d.window().probe().place() == gone);
    // Esc during a drag takes back both, without a step.
    d.document().undoStack().undo();
    press(pixel);
    move(pixel + QPointF(30, 0), Qt::LeftButton);
    QTest::keyClick(&view(), Qt::Key_Escape);
    QVERIFY(d.window().probe().place() == before);
    QCOMPARE(angle(), 0.0);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel);
  }

  // The diagram is still that of one curve, the probe already on another.
  void aProbeThatTheOldDiagramDoesNotKnowIsLeftOut() {
    WindowDriver& d = *driver_;
    Scene many = d.scene();
    many.curves.push_back(presets()[2].scene.curves.at(0));
    d.document().push(std::make_unique<ReplaceScene>(d.document(), many, "many"));
    d.window().probe().setPlace(Probe::Place{1, 0.5});
    QVERIFY(panel_->source().isStale());
    const QImage with = view().grab().toImage();
    d.window().probe().setPlace(std::nullopt);
    QVERIFY(panel_->source().isStale());
    QVERIFY(view().grab().toImage() == with);
    QTRY_VERIFY(!panel_->source().isStale());
    const QImage without = view().grab().toImage();
    d.window().probe().setPlace(Probe::Place{1, 0.5});
    QVERIFY2(view().grab().toImage() != without, "on the new one it is shown");
  }

  // The file is what was shown when Export was pressed, whatever arrives while the dialog is open.
  void exportsWhatWasShownWhileTheNextIsComputed() {
    WindowDriver& d = *driver_;
    const std::string shown = sweepToCsv(panel_->source().data()->sweep);
    const QString name = d.path("shown.csv");
    d.document().push(std::make_unique<ReplaceScene>(d.document(), presets()[2].scene, "other"));
    QVERIFY(panel_->source().isStale());
    typeFileName(name, [this] { QTRY_VERIFY(!panel_->source().isStale()); });
    QTest::mouseClick(&d.child<QToolButton>("sweep.export"), Qt::LeftButton);
    QVERIFY(sweepToCsv(panel_->source().data()->sweep) != shown);
    QFile written(name);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(written.readAll(), QByteArray::fromStdString(shown));
  }

  void clickOnABranchFindsItsMark() {
    WindowDriver& d = *driver_;
    const SweepBranch* ridge = nullptr;
    for (const SweepBranch& branch : panel_->source().data()->sweep.branches) {
      if (branch.kind == MarkKind::ApparentRidge &&
          (!ridge || branch.points.size() > ridge->points.size())) {
        ridge = &branch;
      }
    }
    QVERIFY(ridge);
    const SweepPoint point = ridge->points[ridge->points.size() / 2];
    click(*view().positionOf(halfTurnDeg(point.angleDeg), 0, point.u));
    // Among the marks of the view that was gone to, one is an apparent ridge at the probe.
    double nearest = 1e9;
    for (const Mark& mark : d.document().features().marks) {
      if (mark.kind != MarkKind::ApparentRidge) continue;
      nearest = std::min(nearest, std::abs(mark.t - d.window().probe().place()->t));
    }
    QVERIFY2(nearest < 2e-3, qPrintable(QString::number(nearest)));
  }

  void clickOnARingGoesToTheBirthExactly() {
    const SweepEvent& fold = aFold();
    click(*view().positionOf(fold.angleDeg, 0, fold.u) + QPointF(2, 1));
    QVERIFY(std::abs(angle() - fold.angleDeg) < 1e-12);
    QVERIFY(std::abs(driver_->window().probe().place()->t - fold.t) < 1e-6);
  }

  void hoveringARingShowsItsAngle() {
    const SweepEvent& fold = aFold();
    move(*view().positionOf(fold.angleDeg, 0, fold.u), Qt::NoButton);
    const QString text = driver_->child<QLabel>("sweep.state").text();
    QVERIFY2(text.contains(QString::number(fold.angleDeg, 'f', 4)), qPrintable(text));
    move(*view().positionOf(60.0, 0, 0.1), Qt::NoButton);
    QVERIFY(!driver_->child<QLabel>("sweep.state")
                 .text()
                 .contains(QString::number(fold.angleDeg, 'f', 4)));
  }

  void dragScrubsInOneStep() {
    WindowDriver& d = *driver_;
    const QPointF from = *view().positionOf(30.0, 0, 1.0), to = *view().positionOf(120.0, 0, 1.0);
    drag(from, to);
    QVERIFY(std::abs(angle() - 120.0) <= kPixelDeg);
    QCOMPARE(d.document().undoStack().count(), 1);
    d.document().undoStack().undo();
    QCOMPARE(angle(), 0.0);
    // Esc takes a drag back without a trace.
    press(from);
    move(to, Qt::LeftButton);
    QVERIFY(angle() > 90.0);
    QTest::keyClick(&view(), Qt::Key_Escape);
    QCOMPARE(angle(), 0.0);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to.toPoint());
    QCOMPARE(angle(), 0.0);
    QVERIFY(!d.document().undoStack().canUndo());
  }

  void keysTurnTheView() {
    WindowDriver& d = *driver_;
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Right);
    QTest::keyClick(&view(), Qt::Key_Right);
    QCOMPARE(angle(), 2.0);
    QCOMPARE(d.document().undoStack().count(), 2);
    QTest::keyClick(&view(), Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(std::abs(angle() - 1.9) < 1e-12);
    QTest::keyClick(&view(), Qt::Key_Left);
    QCOMPARE(angle(), 1.0);
  }

  void aHeldKeyIsOneStep() {
    WindowDriver& d = *driver_;
    view().setFocus();
    QTest::keyPress(&view(), Qt::Key_Right);
    for (int i = 0; i < 9; ++i) {
      QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Right, {}, QString(), true);
      QCoreApplication::sendEvent(&view(), &repeat);
    }
    QTest::keyRelease(&view(), Qt::Key_Right);
    QCOMPARE(angle(), 10.0);
    QCOMPARE(d.document().undoStack().count(), 1);
  }

  void controlArrowsVisitEveryEvent() {
    const Sweep& sweep = panel_->source().data()->sweep;
    QVERIFY(sweep.events.size() >= 4);
    view().setFocus();
    std::set<std::size_t> met;
    double last = angle(), turned = 0.0;
    for (std::size_t i = 0; i < sweep.events.size(); ++i) {
      QTest::keyClick(&view(), Qt::Key_Right, Qt::ControlModifier);
      bool isEvent = false;
      for (std::size_t e = 0; e < sweep.events.size(); ++e) {
        if (std::abs(halfTurnDeg(angle() - sweep.events[e].angleDeg)) > 1e-9) continue;
        isEvent = true;
        met.insert(e);
      }
      QVERIFY(isEvent);
      turned += angle() - last + (angle() < last ? 360.0 : 0.0);
      last = angle();
    }
    QCOMPARE(met.size(), sweep.events.size());
    QVERIFY(turned <= 180.0 + 1e-6);
    QTest::keyClick(&view(), Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(angle() < last);
  }

  void playTurnsAndEscReturns() {
    WindowDriver& d = *driver_;
    d.child<QDoubleSpinBox>("sweep.speed").setValue(200.0);
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Space);
    QTRY_VERIFY(angle() > 20.0);
    QTest::keyClick(&view(), Qt::Key_Escape);
    QCOMPARE(angle(), 0.0);
    QTest::qWait(80);
    QCOMPARE(angle(), 0.0);
    QVERIFY(!d.document().undoStack().canUndo());
    // Paused it stays, as one step.
    auto& play = d.child<QToolButton>("sweep.play");
    QTest::mouseClick(&play, Qt::LeftButton);
    QTRY_VERIFY(angle() > 20.0);
    QTest::mouseClick(&play, Qt::LeftButton);
    const double there = angle();
    QTest::qWait(80);
    QCOMPARE(angle(), there);
    QCOMPARE(d.document().undoStack().count(), 1);
    d.document().undoStack().undo();
    QCOMPARE(angle(), 0.0);
  }

  void playEndsAfterAFullTurnWhereItBegan() {
    WindowDriver& d = *driver_;
    d.child<QDoubleSpinBox>("sweep.speed").setValue(360.0);
    view().setFocus();
    double largest = 0.0;
    connect(&d.document(), &Document::changed, this,
            [&] { largest = std::max(largest, std::abs(angle())); });
    QTest::keyClick(&view(), Qt::Key_Space);
    QTRY_COMPARE_WITH_TIMEOUT(d.child<QToolButton>("sweep.play").text(), QStringLiteral("Play"),
                              20000);
    QVERIFY2(largest > 150.0, "it went around");
    QCOMPARE(angle(), 0.0);
    QVERIFY(!d.document().undoStack().canUndo());
  }

  void anEditWhilePlayingStopsIt() {
    WindowDriver& d = *driver_;
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Space);
    QTRY_VERIFY(angle() > 1.0);
    d.document().push(std::make_unique<SetView>(d.document(), View{77.0, std::nullopt}));
    QTest::qWait(80);
    QCOMPARE(angle(), 77.0);
  }

  void typedAngleIsTheView() {
    auto& box = driver_->child<QDoubleSpinBox>("sweep.angle");
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, "33.25");
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(angle(), 33.25);
  }

  void wheelZoomsAtThePointerAndFShowsAll() {
    const double length = panel_->source().data()->lengths.at(0);
    const QPointF at = *view().positionOf(40.0, 0, 0.5 * length);
    wheel(at, 5);
    QVERIFY(view().window());
    const double range = view().window()->angleHigh - view().window()->angleLow;
    QVERIFY(range < 200.0);
    const QPointF after = *view().positionOf(40.0, 0, 0.5 * length);
    QVERIFY((after - at).manhattanLength() < 1e-6);
    // The middle button moves it.
    QTest::mousePress(&view(), Qt::MiddleButton, {}, at.toPoint());
    move(at + QPointF(30, 10), Qt::MiddleButton);
    QTest::mouseRelease(&view(), Qt::MiddleButton, {}, (at + QPointF(30, 10)).toPoint());
    const QPointF moved = *view().positionOf(40.0, 0, 0.5 * length);
    QVERIFY((moved - at - QPointF(30, 10)).manhattanLength() < 2.0);
    QCOMPARE(angle(), 0.0);
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_F);
    QVERIFY(!view().window());
  }

  void followsEditsAndKeepsTheOldUntilTheNewIsReady() {
    WindowDriver& d = *driver_;
    const auto before = panel_->source().data();
    d.document().push(std::make_unique<ReplaceScene>(d.document(), presets()[2].scene, "other"));
    QVERIFY2(panel_->source().isStale(), "it says so at once");
    QVERIFY2(panel_->source().data() == before, "and keeps what there is");
    QVERIFY(d.child<QLabel>("sweep.state").text().contains("Updating"));
    QTRY_VERIFY(!panel_->source().isStale());
    QVERIFY(panel_->source().data()->scene.curves == d.scene().curves);
    QVERIFY(panel_->source().data()->visibility);
    // Turning the view computes nothing.
    const auto now = panel_->source().data();
    d.document().push(std::make_unique<SetView>(d.document(), View{60.0, std::nullopt}));
    QVERIFY(!panel_->source().isStale() && panel_->source().data() == now);
  }

  // Views that change while it computes do not start it anew, so that it comes to an end.
  void turningMeanwhileDoesNotHoldItUp() {
    WindowDriver& d = *driver_;
    Scene many = d.scene();
    for (int i = 0; i < 3; ++i) many.curves.push_back(many.curves.front());
    d.document().push(std::make_unique<ReplaceScene>(d.document(), many, "many"));
    QElapsedTimer timer;
    timer.start();
    double turned = 0.0;
    while (panel_->source().isStale() && timer.elapsed() < 20000) {
      turned += 0.01;
      d.document().push(std::make_unique<SetView>(d.document(), View{turned, std::nullopt}));
      QTest::qWait(1);
    }
    QVERIFY(!panel_->source().isStale());
    QCOMPARE(panel_->source().data()->lengths.size(), std::size_t{4});
  }

  void perspectiveIsSaidToBeAnotherMatter() {
    WindowDriver& d = *driver_;
    QVERIFY(!d.child<QLabel>("sweep.state").text().contains("perspective"));
    d.document().push(std::make_unique<SetView>(d.document(), View{0.0, 9.0}));
    QVERIFY(d.child<QLabel>("sweep.state").text().contains("perspective"));
    click(*view().positionOf(90.0, 0, 1.0));
    QCOMPARE(d.scene().view.distance, std::optional(9.0));
  }

  void writesEveryFormat() {
    WindowDriver& d = *driver_;
    const SweepData& data = *panel_->source().data();
    const FigureFile file{.suggestedName = "sweep",
                          .title = "sweep",
                          .sceneJson = "{}",
                          .figure = [this] { return view().figureForFile(); },
                          .table = [&data] { return sweepToCsv(data.sweep); }};
    for (const auto& [suffix, beginning] :
         {std::pair{"svg", "<?xml"}, {"pdf", "%PDF"}, {"png", "\x89PNG"}, {"csv", "what,kind"}}) {
      const QString name = d.path(QStringLiteral("sweep.") + suffix);
      writeFigureFile(name.toStdString(), file);
      QFile written(name);
      QVERIFY(written.open(QIODevice::ReadOnly));
      QVERIFY2(written.readAll().startsWith(beginning), suffix);
    }
    QVERIFY_EXCEPTION_THROWN(writeFigureFile(d.path("sweep.doc").toStdString(), file),
                             std::runtime_error);
  }

  void closingWhileComputingIsPrompt() {
    WindowDriver& d = *driver_;
    Scene many = d.scene();
    for (int i = 0; i < 12; ++i) many.curves.push_back(many.curves.front());
    d.document().push(std::make_unique<ReplaceScene>(d.document(), many, "many"));
    QVERIFY(panel_->source().isStale());
    QElapsedTimer timer;
    timer.start();
    driver_.reset();
    QVERIFY(timer.elapsed() < 3000);
  }

 private:
  SweepView& view() { return panel_->view(); }
  double angle() { return driver_->scene().view.angleDeg; }
  double lengthAt(double t) { return panel_->source().data()->lengthAt(0, t); }
  const SweepEvent& aFold() {
    for (const SweepEvent& event : panel_->source().data()->sweep.events) {
      if (event.what == SweepEvent::What::Fold) return event;
    }
    qFatal("no fold");
  }
  void press(const QPointF& at) { QTest::mousePress(&view(), Qt::LeftButton, {}, at.toPoint()); }
  void move(const QPointF& at, Qt::MouseButton button) {
    QMouseEvent event(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton, button, {});
    QCoreApplication::sendEvent(&view(), &event);
    driver_->settle();
  }
  void click(const QPointF& at) {
    QTest::mouseClick(&view(), Qt::LeftButton, {}, at.toPoint());
    driver_->settle();
  }
  void drag(const QPointF& from, const QPointF& to) {
    press(from);
    for (int i = 1; i <= 4; ++i) move(from + (to - from) * i / 4, Qt::LeftButton);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to.toPoint());
  }
  void wheel(const QPointF& at, int notches) {
    QWheelEvent event(at, view().mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view(), &event);
    driver_->settle();
  }

  std::unique_ptr<WindowDriver> driver_;
  SweepPanel* panel_ = nullptr;
};

QTEST_MAIN(SweepPanelTest)
#include "sweep_panel_test.moc"
