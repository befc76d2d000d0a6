// SPDX-License-Identifier: GPL-3.0-or-later
// Plots, probe and canvas show one place: what is done in one by mouse or keys is seen in the
// others.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "flatland/curve/arc_length.h"
#include "flatland/features/orientation.h"
#include "flatland/io/input_error.h"
#include "tests/ui/support_window.h"
#include "ui/commands/scene_commands.h"
#include "ui/plot/plots_panel.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr PlotKind kKinds[] = {PlotKind::Curvature, PlotKind::Lambda, PlotKind::Terms,
                               PlotKind::Ratio};

}  // namespace

class PlotsTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    driver_->window().resize(1280, 1100);  // all four plots are in sight
    driver_->settle();
    panel_ = driver_->window().findChild<PlotsPanel*>();
    QVERIFY(panel_);
  }
  void cleanup() { driver_.reset(); }

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

  void everyShownMarkIsOnEveryPlot() {
    WindowDriver& d = *driver_;
    const auto count = [&d] {
      const auto& marks = d.document().features().marks;
      return static_cast<int>(std::count_if(marks.begin(), marks.end(), [&](const Mark& m) {
        return d.window().display().shows(m.kind) &&
               (m.visible || d.window().display().showsHidden());
      }));
    };
    QVERIFY(count() >= 10);
    for (const PlotKind kind : kKinds) QCOMPARE(plot(kind).drawing().markCount(), count());
    d.window().display().setShows(MarkKind::Inflection, false);
    d.window().display().setShows(MarkKind::ApparentMinimum, true);
    d.settle();
    for (const PlotKind kind : kKinds) QCOMPARE(plot(kind).drawing().markCount(), count());
  }

  // On lambda and the terms, at the arc length and the value of the curve there: off every maximum
  // of lambda, and where the sum of the terms is not 0.
  void printedRootsMissTheMaximaInSight() {
    WindowDriver& d = *driver_;
    const auto drawn = [this](PlotKind kind) { return plot(kind).drawing().printedRoots(); };
    for (const PlotKind kind : kKinds) QVERIFY(drawn(kind).empty());
    d.trigger("lesson.shipped.apparent-ridge");
    while (!(d.window().lesson().equation() == DerivationStep::Eq3_13)) {
      d.canvasKey(Qt::Key_PageDown);
    }
    d.settle();
    const auto roots = findPrintedRoots(d.scene(), d.document().features()).roots;
    const ViewFrame frame = frameOf(d.scene().view);
    const int side = normalSide(d.scene().curves[0], frame);
    QVERIFY(roots.size() >= 2);
    QCOMPARE(drawn(PlotKind::Lambda).size(), roots.size());
    QCOMPARE(drawn(PlotKind::Terms).size(), roots.size());
    QVERIFY(drawn(PlotKind::Curvature).empty() && drawn(PlotKind::Ratio).empty());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const QPointF at = drawn(PlotKind::Lambda)[i];
      QVERIFY(std::abs(at.x() - lengthTo(roots[i].t)) < 1e-6);
      const Terms terms = termsAt(jetAt(d.scene().curves[0].shape, roots[i].t), frame, side);
      const PlotAxis axis = d.window().plots().axisOf(PlotKind::Lambda);
      const double lambda = std::clamp(*terms.lambda, axis.low, axis.high);
      QVERIFY(std::abs(at.y() - lambda) <= 1e-9 * lambda);
      for (const Mark& mark : d.document().features().marks) {
        if (mark.kind != MarkKind::ApparentRidge) continue;
        QVERIFY(std::abs(mark.u - at.x()) > 1e-3 * total());
      }
      const double sum = terms.feature + terms.offset;
      const double y = drawn(PlotKind::Terms)[i].y();
      QVERIFY(y != 0.0 && (y > 0.0) == (sum > 0.0));
    }
    QWidget& lambda = plot(PlotKind::Lambda).surface();
    const QImage with = lambda.grab().toImage();
    auto& box = d.child<QCheckBox>("lesson.printed-roots");
    QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
    d.settle();
    QVERIFY(drawn(PlotKind::Lambda).empty() && drawn(PlotKind::Terms).empty());
    QVERIFY2(lambda.grab().toImage() != with, "they were to be seen");
    QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
    d.window().display().setPlotAbscissa(Abscissa::Screen);
    d.settle();
    std::vector<double> screen;
    for (const PrintedRoot& root : roots) screen.push_back(*root.screen);
    std::sort(screen.begin(), screen.end());  // as the plot keeps them
    for (std::size_t i = 0; i < roots.size(); ++i) {
      QCOMPARE(drawn(PlotKind::Terms)[i].x(), screen[i]);
    }
  }

  void noLinePassesASilhouette() {
    WindowDriver& d = *driver_;
    for (const double angle : {0.0, 35.0, 110.0}) {
      d.document().push(std::make_unique<SetView>(d.document(), View{angle, std::nullopt}));
      d.settle();
      std::vector<double> silhouettes;
      for (const Mark& mark : d.document().features().marks) {
        if (mark.kind == MarkKind::Silhouette) silhouettes.push_back(mark.u);
      }
      QVERIFY(!silhouettes.empty());
      for (const auto& [kind, quantity] : {std::pair(PlotKind::Lambda, ProfileQuantity::Lambda),
                                           std::pair(PlotKind::Ratio, ProfileQuantity::Ratio)}) {
        const auto lines = plot(kind).drawing().linesOf(quantity);
        QVERIFY(lines.size() > silhouettes.size());
        for (const auto& line : lines) {
          QVERIFY(line.size() >= 2);
          for (const double u : silhouettes) {
            const bool passes = line.front().x() < u && line.back().x() > u;
            QVERIFY2(!passes, qPrintable(QString::number(u)));
          }
        }
      }
    }
  }

  void wheelZoomsAboutThePointerAndAllPlotsFollow() {
    Plots& plots = driver_->window().plots();
    ProfilePlot& p = plot(PlotKind::Lambda);
    const Plots::Range whole = plots.range();
    const double u = 0.3 * total();
    const QPoint pointer = at(p, u);
    wheel(p, pointer, 240);
    QVERIFY(std::abs(plots.range().width() / whole.width() - 1.0 / (1.2 * 1.2)) < 1e-9);
    for (const PlotKind kind : kKinds) {
      QVERIFY(std::abs(plot(kind).pixelOf(u) - pointer.x()) <= 1.0);
    }
    // Middle button moves.
    const double low = plots.range().low;
    QTest::mousePress(&p.surface(), Qt::MiddleButton, {}, pointer);
    moveTo(p, pointer - QPoint(30, 0), Qt::MiddleButton);
    QTest::mouseRelease(&p.surface(), Qt::MiddleButton, {}, pointer - QPoint(30, 0));
    driver_->settle();
    QVERIFY(plots.range().low > low);
    QVERIFY(std::abs(plot(PlotKind::Ratio).pixelOf(u) - (pointer.x() - 30)) <= 1.0);
    QTest::mouseDClick(&p.surface(), Qt::LeftButton, {}, pointer);
    QCOMPARE(plots.range().width(), whole.width());
    // Keys.
    QTest::keyClick(&p.surface(), Qt::Key_Plus);
    QVERIFY(plots.range().width() < whole.width());
    QTest::keyClick(&p.surface(), Qt::Key_0);
    QCOMPARE(plots.range().low, whole.low);
    // A range without width is refused.
    plots.setRange({1.0, 1.0});
    QCOMPARE(plots.range().width(), whole.width());
  }

  void againstTheScreen() {
    WindowDriver& d = *driver_;
    auto& against = d.child<QComboBox>("plots.against");
    against.setFocus();
    QTest::keyClick(&against, Qt::Key_Down);
    d.settle();
    QVERIFY(d.window().plots().abscissa() == Abscissa::Screen);
    const ViewFrame view = frameOf(d.scene().view);
    const auto place = d.window().probe().place();
    QCOMPARE(*plot(PlotKind::Lambda).drawing().probeX(),
             *screenCoordinate(view, pointAt(d.scene().curves[0].shape, place->t)));
    clickAt(plot(PlotKind::Lambda), 0.5);
    const auto clicked = d.window().probe().place();
    const double screen = *screenCoordinate(view, pointAt(d.scene().curves[0].shape, clicked->t));
    QVERIFY(std::abs(screen - 0.5) < 0.02);
  }

  void oneStepOfADragIsOneReplot() {
    WindowDriver& d = *driver_;
    const QPoint from = d.atPoint(1);
    d.press(from);
    d.move(from + QPoint(8, 8));
    d.settle();
    int before[4], computed = d.window().plots().profileComputations();
    for (int i = 0; i < 4; ++i) before[i] = plot(kKinds[i]).replots();
    for (int step = 1; step <= 5; ++step) {
      const double u = d.document().features().marks.front().u;
      d.move(from + QPoint(8 + 3 * step, 8));
      d.settle();
      QVERIFY(d.document().features().marks.front().u != u);
      for (int i = 0; i < 4; ++i) QCOMPARE(plot(kKinds[i]).replots() - before[i], step);
    }
    QCOMPARE(d.window().plots().profileComputations() - computed, 5);
    d.release(from + QPoint(23, 8));
    // The plots show the curve as it is now.
    const auto lines = plot(PlotKind::Curvature).drawing().linesOf(ProfileQuantity::Curvature);
    QVERIFY(std::abs(lines.back().back().x() - total()) < 1e-6);
  }

  void aHiddenPlotWaits() {
    WindowDriver& d = *driver_;
    d.trigger("plots.show.ratio");
    QVERIFY(!plot(PlotKind::Ratio).isVisible());
    const int before = plot(PlotKind::Ratio).replots();
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(20, 20));
    QCOMPARE(plot(PlotKind::Ratio).replots(), before);
    d.trigger("plots.show.ratio");
    QVERIFY(plot(PlotKind::Ratio).isVisible());
    QVERIFY(plot(PlotKind::Ratio).replots() > before);
    const auto lines = plot(PlotKind::Ratio).drawing().linesOf(ProfileQuantity::Ratio);
    QVERIFY(std::abs(lines.back().back().x() - total()) < 1e-3 * total());
  }

  void exportedFilesAreWhatTheySay() {
    WindowDriver& d = *driver_;
    PlotExportSettings how;
    how.widthCm = 10.0;
    how.heightCm = 5.0;
    how.dpi = 150.0;
    for (const PlotKind kind : kKinds) {
      for (const char* suffix : {"svg", "pdf", "png", "csv"}) {
        how.suffix = suffix;
        const QString name = d.path(QStringLiteral("plot.") + suffix);
        panel_->exporter().write(kind, name.toStdString(), how);
        QFile file(name);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        if (how.suffix == "svg") {
          QVERIFY(bytes.contains("<svg") && bytes.contains("<path"));
          QVERIFY2(!bytes.contains("<image"), "vectors, not pixels");
          QVERIFY(bytes.contains("width=\"100"));  // mm
        } else if (how.suffix == "pdf") {
          QVERIFY(bytes.startsWith("%PDF"));
        } else if (how.suffix == "png") {
          const QImage image = QImage::fromData(bytes);
          QCOMPARE(image.width(), qRound(378 * 150.0 / 96.0));
          QVERIFY(image.pixelColor(2, 2) == Qt::white);
        } else {
          QVERIFY(bytes.startsWith("curve,segment,t,u,screen,"));
        }
      }
    }
    how.suffix = "svg";
    bool thrown = false;
    try {
      panel_->exporter().write(PlotKind::Terms, d.path("no/such/folder.svg").toStdString(), how);
    } catch (const InputError&) {
      thrown = true;
    }
    QVERIFY(thrown);
  }

  void exportAsksAndRemembers() {
    WindowDriver& d = *driver_;
    const QString name = d.path("terms.png");
    whenModal([&](QWidget& dialog) {
      dialog.findChild<QComboBox*>("plot-export.format")->setCurrentIndex(2);
      dialog.findChild<QDoubleSpinBox*>("plot-export.width")->setValue(8.0);
      whenModal([&](QWidget& files) {
        auto& chooser = static_cast<QFileDialog&>(files);
        chooser.findChild<QLineEdit*>()->setText(name);
        QTest::keyClick(chooser.findChild<QLineEdit*>(), Qt::Key_Return);
      });
      QTest::mouseClick(dialog.findChild<QAbstractButton*>("plot-export.go"), Qt::LeftButton);
    });
    d.trigger("plots.export.terms");
    QVERIFY(QFile::exists(name));
    QCOMPARE(d.settings().value("plots/export-format").toString(), QStringLiteral("png"));
    QCOMPARE(d.settings().value("plots/export-width").toDouble(), 8.0);
  }

  void choicesAreRemembered() {
    WindowDriver& d = *driver_;
    d.trigger("plots.show.curvature");
    d.trigger("probe.comb");
    d.canvasKey(Qt::Key_BracketRight);
    d.window().display().setPlotAbscissa(Abscissa::Screen);
    QVERIFY(d.window().display().shows(Overlay::Comb));
    d.window().close();
    flatland::ui::Display again;
    again.restore(d.settings());
    QVERIFY(!again.shows(PlotKind::Curvature));
    QVERIFY(again.shows(PlotKind::Lambda));
    QVERIFY(again.shows(Overlay::Comb));
    QVERIFY(again.plotAbscissa() == Abscissa::Screen);
    QVERIFY(again.combScale() > 1.0);
  }

  void overlaysChangeTheCanvas() {
    WindowDriver& d = *driver_;
    for (const char* overlay :
         {"probe.vectors", "probe.circle", "probe.comb", "probe.screen-turn"}) {
      const QImage before = d.canvas().grab().toImage();
      d.trigger(overlay);
      QVERIFY2(d.canvas().grab().toImage() != before, overlay);
      d.trigger(overlay);
      QVERIFY2(d.canvas().grab().toImage() == before, overlay);
    }
  }

  void scenesWithoutCurvesOrWithPointsAreCalm() {
    WindowDriver& d = *driver_;
    d.document().start(Scene{}, "");
    d.settle();
    QVERIFY(!d.window().probe().place());
    QVERIFY(!d.window().plots().curve());
    QTest::keyClick(&plot(PlotKind::Terms).surface(), Qt::Key_Right);
    d.canvasKey(Qt::Key_M);
    QVERIFY(!d.window().probe().place());
    Scene line{{{.shape = BezierChain(Bezier{{{0, 0}, {1, 0}}})}}, View{0.0, std::nullopt}};
    d.document().start(line, "");
    d.window().display().setPlotAbscissa(Abscissa::Screen);  // seen end-on: one coordinate
    d.settle();
    QVERIFY(d.window().plots().range().width() > 0.0);
    showProbePanel();
    QCOMPARE(d.child<QLabel>("probe.radius").text(), QStringLiteral("–"));
  }

  void severalCurvesCanBeChosen() {
    WindowDriver& d = *driver_;
    auto& chooser = d.child<QComboBox>("plots.curve");
    QVERIFY(!chooser.isVisible());
    Scene two = defaultScene();
    two.curves.push_back({.shape = BezierChain(Bezier{{{3, 0}, {4, 1}, {5, 0}}})});
    d.document().start(two, "");
    d.settle();
    QVERIFY(chooser.isVisible());
    QCOMPARE(chooser.count(), 2);
    chooser.setFocus();
    QTest::keyClick(&chooser, Qt::Key_Down);
    d.settle();
    QCOMPARE(*d.window().plots().curve(), 1u);
    QCOMPARE(d.window().probe().place()->curve, 1u);
  }

 private:
  ProfilePlot& plot(PlotKind kind) { return panel_->plot(kind); }
  double total() { return driver_->window().plots().profile().length; }
  double lengthTo(double t) {
    return arcLength(driver_->scene().curves[0].shape, 0.0, t, 1e-12).value;
  }
  QPoint at(ProfilePlot& p, double x) { return {qRound(p.pixelOf(x)), p.surface().height() / 2}; }
  void clickAt(ProfilePlot& p, double x) {
    QTest::mouseClick(&p.surface(), Qt::LeftButton, {}, at(p, x));
    driver_->settle();
  }
  void moveTo(ProfilePlot& p, const QPoint& to, Qt::MouseButton button = Qt::LeftButton) {
    QMouseEvent event(QEvent::MouseMove, to, p.surface().mapToGlobal(to), Qt::NoButton, button, {});
    QCoreApplication::sendEvent(&p.surface(), &event);
    driver_->settle();
  }
  void wheel(ProfilePlot& p, const QPoint& where, int angle) {
    QWheelEvent event(where, p.surface().mapToGlobal(where), {}, {0, angle}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&p.surface(), &event);
    driver_->settle();
  }
  void showProbePanel() {
    auto& dock = driver_->child<QWidget>("probe");
    dock.show();
    dock.raise();
    driver_->settle();
  }

  std::unique_ptr<WindowDriver> driver_;
  PlotsPanel* panel_ = nullptr;
};

QTEST_MAIN(PlotsTest)
#include "plots_test.moc"
