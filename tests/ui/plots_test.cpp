// SPDX-License-Identifier: GPL-3.0-or-later
// The plots: what they draw, how they are moved, copied and exported.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <algorithm>
#include <cmath>

#include "flatland/features/orientation.h"
#include "flatland/io/input_error.h"
#include "tests/ui/support_plots.h"
#include "ui/commands/scene_commands.h"

using namespace flatland;
using namespace flatland::ui;

class PlotsTest : public QObject, private PlotsDriver {
  Q_OBJECT

 private slots:
  void init() { QVERIFY(start()); }
  void cleanup() { stop(); }

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

  void aWheelThatShallNotZoomDoesNot() {
    WindowDriver& d = *driver_;
    ProfilePlot& p = plot(PlotKind::Curvature);
    const QPoint pointer(p.surface().width() / 2, p.surface().height() / 2);
    d.trigger("view.wheel-zooms");  // off
    const double before = d.window().plots().range().high - d.window().plots().range().low;
    wheel(p, pointer, 240);
    QCOMPARE(d.window().plots().range().high - d.window().plots().range().low, before);
    d.trigger("view.wheel-zooms");
    wheel(p, pointer, 240);
    QVERIFY(d.window().plots().range().high - d.window().plots().range().low < before);
  }

  // In the heading, not over the lines.
  void theScaleOfAnAxisIsSaidOutsideThePlot() {
    QVERIFY(plot(PlotKind::Terms).drawing().heading().contains("asinh, linear to"));
    QVERIFY(plot(PlotKind::Ratio).drawing().heading().endsWith("log"));
    QVERIFY(!plot(PlotKind::Curvature).drawing().heading().contains("log"));
  }

  // The line of the ratio and the number beside it end at the same places.
  void theRatioIsKnownToPlotAndPanelAlike() {
    WindowDriver& d = *driver_;
    const Plots& plots = d.window().plots();
    int with = 0, without = 0;
    for (const ProfileSegment& segment : plots.profile().segments) {
      for (const ProfileSample& sample : segment.samples) {
        const auto reading = Probe::readingAt(d.scene(), {0, sample.t});
        QVERIFY(reading);
        const auto value = Probe::valueOf(*reading, ProfileQuantity::Ratio);
        if (sample.ratio) QVERIFY(value);
        ++(sample.ratio ? with : without);
      }
    }
    QVERIFY(with > 50 && without > 0);
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
};

QTEST_MAIN(PlotsTest)
#include "plots_test.moc"
