// SPDX-License-Identifier: GPL-3.0-or-later
// Plots, probe and canvas show one place: what is done in one by mouse or keys is seen in the
// others.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "flatland/features/orientation.h"
#include "tests/ui/support_plots.h"
#include "ui/commands/scene_commands.h"

using namespace flatland;
using namespace flatland::ui;

class ProbeTest : public QObject, private PlotsDriver {
  Q_OBJECT

 private slots:
  void init() { QVERIFY(start()); }
  void cleanup() { stop(); }

  void theProbeBeginsOnTheCurveOffTheMarks() {
    WindowDriver& d = *driver_;
    const auto place = d.window().probe().place();
    QVERIFY(place);
    for (const Mark& mark : d.document().features().marks)
      QVERIFY(std::abs(mark.t - place->t) > 1e-3);
    for (const PlotKind kind : kKinds) {
      QVERIFY(plot(kind).drawing().probeX());
      QVERIFY(std::abs(*plot(kind).drawing().probeX() - lengthTo(place->t)) < 1e-6);
    }
  }

  void aClickInAPlotMovesTheProbeEverywhere() {
    WindowDriver& d = *driver_;
    const QImage before = d.canvas().grab().toImage();
    const double u = 0.62 * total();
    clickAt(plot(PlotKind::Lambda), u);
    const auto place = d.window().probe().place();
    QVERIFY(place);
    QVERIFY(std::abs(lengthTo(place->t) - u) < 0.01 * total());  // to the pixel
    QVERIFY2(d.canvas().grab().toImage() != before, "the canvas shows it elsewhere");
    QCOMPARE(*plot(PlotKind::Ratio).drawing().probeX(),
             *plot(PlotKind::Curvature).drawing().probeX());
    showProbePanel();
    const Jet jet = jetAt(d.scene().curves[0].shape, place->t);
    const Terms terms = termsAt(jet, frameOf(d.scene().view),
                                normalSide(d.scene().curves[0], frameOf(d.scene().view)));
    QCOMPARE(d.child<QLabel>("probe.k").text(), QString::number(terms.k, 'g', 6));
    QCOMPARE(d.child<QLabel>("probe.lambda").text(),
             QString::number(terms.k * terms.k / (terms.nw * terms.nw), 'g', 6));
    QCOMPARE(d.child<QLabel>("probe.sum").text(), QString::number(terms.sum(), 'g', 6));
    QCOMPARE(d.document().undoStack().count(), 0);
  }

  void aDragInAPlotSlidesTheProbe() {
    ProfilePlot& p = plot(PlotKind::Terms);
    const QPoint from = at(p, 0.2 * total());
    QTest::mousePress(&p.surface(), Qt::LeftButton, {}, from);
    moveTo(p, at(p, 0.5 * total()));
    QVERIFY(std::abs(lengthTo(driver_->window().probe().place()->t) - 0.5 * total()) <
            0.01 * total());
    QTest::mouseRelease(&p.surface(), Qt::LeftButton, {}, at(p, 0.5 * total()));
    moveTo(p, at(p, 0.9 * total()), Qt::NoButton);
    QVERIFY2(
        std::abs(lengthTo(driver_->window().probe().place()->t) - 0.5 * total()) < 0.01 * total(),
        "let go is let go");
  }

  void keysMoveTheProbe() {
    Probe& probe = driver_->window().probe();
    QWidget& surface = plot(PlotKind::Curvature).surface();
    clickAt(plot(PlotKind::Curvature), 0.3 * total());
    const double before = lengthTo(probe.place()->t);
    QTest::keyClick(&surface, Qt::Key_Right);
    const double one = lengthTo(probe.place()->t) - before;
    QVERIFY(one > 0.0);
    QTest::keyClick(&surface, Qt::Key_Left);
    QVERIFY(std::abs(lengthTo(probe.place()->t) - before) < 1e-8);
    QTest::keyClick(&surface, Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(std::abs(lengthTo(probe.place()->t) - before - 10.0 * one) < 1e-8);
    QTest::keyClick(&surface, Qt::Key_End);
    QCOMPARE(probe.place()->t, 1.0);
    QTest::keyClick(&surface, Qt::Key_Right);
    QCOMPARE(probe.place()->t, 1.0);
    QTest::keyClick(&surface, Qt::Key_Home);
    QCOMPARE(probe.place()->t, 0.0);
  }

  void nextMarkGoesToTheMarksExactly() {
    WindowDriver& d = *driver_;
    Probe& probe = d.window().probe();
    QTest::keyClick(&plot(PlotKind::Curvature).surface(), Qt::Key_Home);
    std::vector<double> expected;
    for (const Mark& mark : d.document().features().marks) {
      if (d.window().display().shows(mark.kind)) expected.push_back(mark.t);
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    QVERIFY(expected.size() >= 8);
    for (const double t : expected) {
      d.canvasKey(Qt::Key_M);
      QCOMPARE(probe.place()->t, t);
    }
    d.canvasKey(Qt::Key_M);
    QCOMPARE(probe.place()->t, expected.front());
    d.canvasKey(Qt::Key_M, Qt::ShiftModifier);
    QCOMPARE(probe.place()->t, expected.back());
  }

  void atASilhouetteThePanelSaysWhyThereIsNoLambda() {
    WindowDriver& d = *driver_;
    for (const Mark& mark : d.document().features().marks) {
      if (mark.kind == MarkKind::Silhouette) d.window().probe().setPlace(Probe::Place{0, mark.t});
    }
    showProbePanel();
    auto& lambda = d.child<QLabel>("probe.lambda");
    QCOMPARE(lambda.text(), QStringLiteral("–"));
    QVERIFY(lambda.toolTip().contains("silhouette"));
    QCOMPARE(d.child<QLabel>("probe.screen-turn").text(), QStringLiteral("–"));
    QVERIFY(d.child<QLabel>("probe.k").text() != QStringLiteral("–"));
  }

  void typedPlacesMoveTheProbe() {
    WindowDriver& d = *driver_;
    showProbePanel();
    auto& t = d.child<QLineEdit>("probe.t");
    t.setFocus();
    t.selectAll();
    QTest::keyClicks(&t, "0.4375");
    QTest::keyClick(&t, Qt::Key_Return);
    QCOMPARE(d.window().probe().place()->t, 0.4375);
    auto& u = d.child<QLineEdit>("probe.u");
    u.setFocus();
    u.selectAll();
    QTest::keyClicks(&u, "1.25");
    QTest::keyClick(&u, Qt::Key_Return);
    QVERIFY(std::abs(lengthTo(d.window().probe().place()->t) - 1.25) < 1e-8);
    const auto before = d.window().probe().place();
    t.setFocus();
    t.selectAll();
    QTest::keyClicks(&t, "abc");
    QTest::keyClick(&t, Qt::Key_Return);
    QVERIFY(d.window().probe().place() == before);
    QVERIFY(t.text() != "abc");
  }

  void canvasClickPlacesDragSlidesEscClears() {
    WindowDriver& d = *driver_;
    Probe& probe = d.window().probe();
    const Curve& curve = d.scene().curves[0].shape;
    const Scene before = d.scene();
    d.click(d.at(pointAt(curve, 0.42)));
    QVERIFY(std::abs(probe.place()->t - 0.42) < 0.01);
    d.drag(d.at(pointAt(curve, probe.place()->t)), d.at(pointAt(curve, 0.6)) + QPoint(5, 0));
    QVERIFY(std::abs(probe.place()->t - 0.6) < 0.01);
    QVERIFY2(d.scene() == before, "the curve stays where it is");
    // A drag taken back.
    const auto here = probe.place();
    d.press(d.at(pointAt(curve, here->t)));
    d.move(d.at(pointAt(curve, 0.3)));
    QVERIFY(!(probe.place() == here));
    d.key(Qt::Key_Escape);
    QVERIFY(probe.place() == here);
    d.release(d.at(pointAt(curve, 0.3)));
    // A drag beside the probe moves the curve, as ever.
    d.drag(d.at(pointAt(curve, 0.42)), d.at(pointAt(curve, 0.42)) + QPoint(20, 10));
    QVERIFY(!(d.scene() == before));
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(d.scene() == before);
    d.canvasKey(Qt::Key_Escape);
    QVERIFY(!probe.place());
    QVERIFY(!plot(PlotKind::Terms).drawing().probeX());
    d.move(d.at(pointAt(curve, 0.28)), {}, Qt::NoButton);
    d.canvasKey(Qt::Key_K);
    QVERIFY(probe.place() && std::abs(probe.place()->t - 0.28) < 0.01);
    d.canvasKey(Qt::Key_Period);
    QVERIFY(probe.place()->t > 0.2801);
  }

  void theProbeStaysWhenAPointIsInserted() {
    WindowDriver& d = *driver_;
    d.window().probe().setPlace(Probe::Place{0, 0.8});
    const Vec2 before = pointAt(d.scene().curves[0].shape, 0.8);
    QTest::mouseDClick(&d.canvas(), Qt::LeftButton, {},
                       d.at(pointAt(d.scene().curves[0].shape, 0.42)));
    d.settle();
    QCOMPARE(d.chain().pieceCount(), 2);
    QVERIFY((pointAt(d.scene().curves[0].shape, d.window().probe().place()->t) - before).norm() <
            1e-9);
  }

  void aDoubleClickStillInsertsThoughItsFirstClickPutTheProbeThere() {
    WindowDriver& d = *driver_;
    const Vec2 world = pointAt(d.scene().curves[0].shape, 0.42);
    const QPoint place = d.at(world);
    d.click(place);
    QTest::mouseDClick(&d.canvas(), Qt::LeftButton, {}, place);
    d.settle();
    QCOMPARE(d.chain().pieceCount(), 2);
    QVERIFY((d.chain().points()[4] - world).norm() * d.window().viewport().scale() < 2.0);
    QCOMPARE(d.document().undoStack().count(), 1);
  }

  void aClickOnTheProbeReachesTheMarkBelow() {
    WindowDriver& d = *driver_;
    const auto& marks = d.document().features().marks;
    std::size_t inflection = 0;
    while (marks[inflection].kind != MarkKind::Inflection) ++inflection;
    d.window().probe().setPlace(Probe::Place{0, marks[inflection].t});
    d.click(d.at(marks[inflection].point));
    QVERIFY(d.window().selection().mark() == keyOf(d.document().features(), inflection));
  }
};

QTEST_MAIN(ProbeTest)
#include "probe_test.moc"
