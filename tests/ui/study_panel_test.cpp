// SPDX-License-Identifier: GPL-3.0-or-later
// The offset study in the window, by mouse and keys: it runs, stops, shows examples and writes.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QThreadPool>
#include <algorithm>
#include <cmath>

#include "flatland/io/study_text.h"
#include "tests/ui/support_window.h"
#include "ui/plot/study_panel.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kLongMs = 30000;  // for a study on a busy machine

}  // namespace

class StudyPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    auto* dock = driver_->window().findChild<QDockWidget*>("study");
    QVERIFY(dock);
    dock->show();
    dock->raise();
    driver_->window().resizeDocks({dock}, {430}, Qt::Vertical);
    driver_->window().resizeDocks({dock}, {560}, Qt::Horizontal);
    driver_->settle();
    panel_ = driver_->window().findChild<StudyPanel*>();
    QVERIFY(panel_);
    setCurves(1500);
  }
  void cleanup() { driver_.reset(); }

  void runReproducesTheMedian() {
    run();
    const OffsetSummary& summary = panel_->source().data()->summary;
    QCOMPARE(summary.curves, 1500);
    const Quartiles q = summary.ratio(TermConvention::ArcLength).perCurve;
    QVERIFY2(std::abs(q.median - 0.21) < 0.03, qPrintable(QString::number(q.median)));
    // The same numbers as without a window.
    OffsetCollector collector;
    runOffsetStudy({.curves = 1500}, 0, 1, [&](const CurveOffsets& curve) {
      collector.add(curve);
      return true;
    });
    QCOMPARE(q.median, collector.summary().ratio(TermConvention::ArcLength).perCurve.median);
    QVERIFY(driver_->child<QLabel>("study.state").text().contains("1500 curves"));
  }

  void theFormIsWhatRuns() {
    driver_->child<QSpinBox>("study.points").setValue(4);
    auto& seed = driver_->child<QLineEdit>("study.seed");
    seed.setFocus();
    seed.selectAll();
    QTest::keyClicks(&seed, "77");
    driver_->child<QDoubleSpinBox>("study.scale").setValue(100.0);
    driver_->child<QComboBox>("study.convention").setCurrentIndex(2);
    setCurves(200);
    run();
    const OffsetStudyOptions& options = panel_->source().data()->options;
    QCOMPARE(options.curves, 200);
    QCOMPARE(options.points, 4);
    QCOMPARE(options.seed, 77u);
    QCOMPARE(options.scale, 100.0);
    QVERIFY(options.convention == TermConvention::Unnormalised);
    seed.setText("many");
    click("study.run");
    QVERIFY(!panel_->source().isRunning());
  }

  void itShowsWhatItHasWhileItRunsAndStopsPromptly() {
    setCurves(10000000);
    click("study.run");
    QVERIFY(panel_->source().isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(panel_->source().data(), kLongMs);
    const auto first = panel_->source().data();
    QTRY_VERIFY_WITH_TIMEOUT(panel_->source().data()->summary.curves > first->summary.curves,
                             kLongMs);
    QVERIFY(panel_->source().isRunning());
    QCOMPARE(driver_->child<QPushButton>("study.run").text(), QStringLiteral("&Stop"));
    QElapsedTimer timer;
    timer.start();
    click("study.run");
    QVERIFY(timer.elapsed() < 1000);
    QVERIFY(!panel_->source().isRunning());
    const auto kept = panel_->source().data();
    QTest::qWait(300);
    QVERIFY2(panel_->source().data() == kept, "nothing arrives after the stop");
    QVERIFY(driver_->child<QLabel>("study.state").text().startsWith("Stopped"));
  }

  void aClickedBarShowsItsCurveAndUndoBringsOursBack() {
    WindowDriver& d = *driver_;
    run();
    const Scene mine = d.scene();
    const std::size_t bin = fullestBin();
    const OffsetExample& example = panel_->source().data()->summary.ratioExamples[bin];
    QTest::mouseClick(&view(), Qt::LeftButton, {}, QPoint(qRound(view().xOfBin(bin)), 100));
    d.settle();
    QVERIFY(d.scene() != mine);
    const Bezier curve = studyCurve(panel_->source().data()->options, example.index);
    QVERIFY(d.chain().points() == curve.points);
    QCOMPARE(d.scene().view.angleDeg, 90.0);
    QCOMPARE(d.document().undoStack().count(), 1);
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(d.scene() == mine);
  }

  void keysPickABarToo() {
    WindowDriver& d = *driver_;
    run();
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_Right);  // the fullest
    QTest::keyClick(&view(), Qt::Key_Right);
    QVERIFY(!d.document().undoStack().canUndo());
    QTest::keyClick(&view(), Qt::Key_Return);
    std::size_t bin = fullestBin() + 1;
    while (panel_->source().data()->summary.ratioExamples[bin].index < 0) ++bin;
    const Bezier curve = studyCurve(panel_->source().data()->options,
                                    panel_->source().data()->summary.ratioExamples[bin].index);
    QVERIFY(d.chain().points() == curve.points);
  }

  void mixedUnitsSlideToAHundredThousandth() {
    run();
    auto& diagram = driver_->child<QComboBox>("study.diagram");
    diagram.setFocus();
    QTest::keyClick(&diagram, Qt::Key_End);
    QVERIFY(view().diagram() == StudyDiagram::Conventions);
    auto& slide = driver_->child<QSlider>("study.slide");
    QVERIFY(slide.isVisible());
    const QImage unit = view().grab().toImage();
    slide.setFocus();
    QTest::keyClick(&slide, Qt::Key_PageUp);
    QTest::keyClick(&slide, Qt::Key_PageUp);
    QVERIFY(std::abs(view().scale() - 100.0) < 1e-9);
    QVERIFY(view().grab().toImage() != unit);
    // What is drawn is what a study at that scale finds.
    const double shown =
        panel_->source().data()->summary.ratio(TermConvention::Unnormalised).perCurve.median *
        scaleFactor(TermConvention::Unnormalised, view().scale());
    OffsetCollector collector;
    runOffsetStudy({.curves = 1500, .scale = 100.0}, 0, 2, [&](const CurveOffsets& curve) {
      collector.add(curve);
      return true;
    });
    const double measured = collector.summary().ratio(TermConvention::Unnormalised).perCurve.median;
    QVERIFY(std::abs(shown / measured - 1.0) < 1e-6);
    QVERIFY(shown > 1e-5 && shown < 3e-5);
  }

  void tableIsWrittenContinuedAndNeverOverwritten() {
    WindowDriver& d = *driver_;
    setCurves(120);
    const QString name = d.path("study.csv");
    writeTable(name);
    const QByteArray whole = read(name);
    QCOMPARE(whole.count('\n'), 121);
    QVERIFY(whole.startsWith(QByteArray::fromStdString(offsetCsvHeader())));
    // Cut within a row, as an interrupted run leaves it.
    QFile cut(name);
    QVERIFY(cut.resize(whole.size() / 2));
    writeTable(name);
    QVERIFY(read(name) == whole);
    // Another study's file stays as it is.
    driver_->child<QLineEdit>("study.seed").setText("2");
    QSignalSpy said(panel_, &StudyPanel::said);
    writeTable(name);
    QVERIFY(read(name) == whole);
    QCOMPARE(said.count(), 1);
    QVERIFY(said.front().front().toString().contains("not of this study"));
  }

  void progressIsShownWhileItRunsOnly() {
    auto& progress = driver_->child<QProgressBar>("study.progress");
    QVERIFY(!progress.isVisible());
    setCurves(10000000);
    click("study.run");
    QVERIFY(progress.isVisible());
    click("study.run");
    QVERIFY(!progress.isVisible());
  }

  // The picture is of what was shown when Export was pressed, though more arrives meanwhile.
  void exportsWhatWasShownWhileItRuns() {
    setCurves(10000000);
    click("study.run");
    QTRY_VERIFY_WITH_TIMEOUT(panel_->source().data(), kLongMs);
    const std::shared_ptr<const StudyData> first = panel_->source().data();
    const QString name = driver_->path("study.svg");
    typeFileName(name, [this, first] {
      QTRY_VERIFY_WITH_TIMEOUT(panel_->source().data()->summary.curves > first->summary.curves,
                               kLongMs);
    });
    click("study.export");
    click("study.run");
    QVERIFY2(read(name).contains(QByteArray::number(first->summary.curves) + " curves"),
             "the count that was shown");
  }

  void closingWhileItRunsIsPrompt() {
    setCurves(10000000);
    click("study.run");
    QTest::qWait(100);
    QElapsedTimer timer;
    timer.start();
    driver_.reset();
    QVERIFY(timer.elapsed() < 3000);
    QVERIFY(QThreadPool::globalInstance()->waitForDone(3000));
  }

 private:
  StudyView& view() { return panel_->view(); }
  void setCurves(int curves) { driver_->child<QSpinBox>("study.curves").setValue(curves); }
  void click(const char* name) {
    QTest::mouseClick(&driver_->child<QPushButton>(name), Qt::LeftButton);
    driver_->settle();
  }
  void run() {
    click("study.run");
    QTRY_VERIFY_WITH_TIMEOUT(!panel_->source().isRunning(), kLongMs);
    QVERIFY(panel_->source().data() && panel_->source().data()->isWhole());
    driver_->settle();
  }
  std::size_t fullestBin() {
    const RatioHistogram& shares =
        panel_->source().data()->summary.ratio(TermConvention::ArcLength).histogram;
    return static_cast<std::size_t>(std::max_element(shares.begin(), shares.end()) -
                                    shares.begin());
  }
  static QByteArray read(const QString& name) {
    QFile file(name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void writeTable(const QString& name) {
    typeFileName(name);
    click("study.table");
    QTRY_VERIFY_WITH_TIMEOUT(!panel_->source().isRunning(), kLongMs);
    driver_->settle();
  }

  std::unique_ptr<WindowDriver> driver_;
  StudyPanel* panel_ = nullptr;
};

QTEST_MAIN(StudyPanelTest)
#include "study_panel_test.moc"
