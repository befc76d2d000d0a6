// SPDX-License-Identifier: GPL-3.0-or-later
// The limits in the window: the slider turns the view to the n.w it says, by mouse and keys.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <cmath>

#include "flatland/features/terms.h"
#include "flatland/io/limits_text.h"
#include "tests/ui/support_window.h"
#include "ui/commands/scene_commands.h"
#include "ui/plot/limits_panel.h"

using namespace flatland;
using namespace flatland::ui;

class LimitsPanelTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    auto* dock = driver_->window().findChild<QDockWidget*>("limits");
    QVERIFY(dock);
    dock->show();
    dock->raise();
    driver_->settle();
    panel_ = driver_->window().findChild<LimitsPanel*>();
    QVERIFY(panel_);
    driver_->window().probe().setPlace(Probe::Place{0, 0.4});
    ready();
  }
  void cleanup() { driver_.reset(); }

  void draggingTheSliderTurnsTheViewInOneStep() {
    WindowDriver& d = *driver_;
    auto& slide = d.child<QSlider>("limits.slide");
    const double before = d.scene().view.angleDeg;
    QTest::mousePress(&slide, Qt::LeftButton, {}, grip());
    for (const int value : {800, 500, 150}) {
      QMouseEvent event(QEvent::MouseMove, gripAt(value), slide.mapToGlobal(gripAt(value)),
                        Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&slide, &event);
      d.settle();
      QVERIFY(std::abs(nw() - slide.value() / 1000.0) < 1e-9);
    }
    QTest::mouseRelease(&slide, Qt::LeftButton, {}, gripAt(150).toPoint());
    d.settle();
    QVERIFY2(nw() < 0.25, qPrintable(QString::number(nw())));
    QCOMPARE(d.document().undoStack().count(), 1);
    d.document().undoStack().undo();
    QCOMPARE(d.scene().view.angleDeg, before);
  }

  void keysStepAndAHeldKeyIsOneStep() {
    WindowDriver& d = *driver_;
    auto& slide = d.child<QSlider>("limits.slide");
    slide.setFocus();
    QTest::keyPress(&slide, Qt::Key_Home);
    for (int i = 0; i < 5; ++i) {
      QKeyEvent repeat(QEvent::KeyPress, Qt::Key_PageUp, {}, QString(), true);
      QCoreApplication::sendEvent(&slide, &repeat);
    }
    QTest::keyRelease(&slide, Qt::Key_PageUp);
    QVERIFY(std::abs(nw() - 0.5) < 1e-9);
    QCOMPARE(d.document().undoStack().count(), 1);
    QTest::keyClick(&slide, Qt::Key_Down);
    QVERIFY(std::abs(std::abs(nw() - 0.5) - 0.001) < 1e-9);
    QCOMPARE(d.document().undoStack().count(), 2);
  }

  void atZeroItSaysThatTheEquationIsSingular() {
    WindowDriver& d = *driver_;
    auto& slide = d.child<QSlider>("limits.slide");
    slide.setFocus();
    QTest::keyClick(&slide, Qt::Key_Home);
    QVERIFY(nw() < 1e-14);
    QVERIFY(d.child<QLabel>("limits.now").text().contains("no value"));
    QVERIFY(d.child<QLabel>("limits.words").text().contains("supremum"));
    // The probe stands on a silhouette now.
    double nearest = 1.0;
    for (const Mark& mark : d.document().features().marks) {
      if (mark.kind == MarkKind::Silhouette) nearest = std::min(nearest, std::abs(mark.t - 0.4));
    }
    QVERIFY(nearest < 1e-9);
    // And back out of it.
    QTest::keyClick(&slide, Qt::Key_End);
    QVERIFY(std::abs(nw() - 1.0) < 1e-12);
  }

  void typedForeshorteningTurnsTheView() {
    auto& box = driver_->child<QDoubleSpinBox>("limits.nw");
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, "0.00012");
    QTest::keyClick(&box, Qt::Key_Return);
    QVERIFY(std::abs(nw() - 0.00012) < 1e-12);
    QCOMPARE(driver_->document().undoStack().count(), 1);
    QVERIFY(driver_->child<QLabel>("limits.now").text().contains("0.00012"));
  }

  void eachWayShowsItsLaw() {
    auto& experiment = driver_->child<QComboBox>("limits.experiment");
    QVERIFY(series().limitCase == LimitCase::FixedPoint);
    QVERIFY(std::abs(series().laws[0].fit->slope + 2.0) < 1e-8);
    experiment.setFocus();
    QTest::keyClick(&experiment, Qt::Key_Down);
    ready();
    QVERIFY(series().experiment == LimitExperiment::Walk);
    QVERIFY(std::abs(series().laws[0].fit->slope + 2.0) < 1e-3);
    QVERIFY(std::abs(series().laws[0].fit->coefficient - 1.0) < 1e-2);
    QTest::keyClick(&experiment, Qt::Key_Down);
    ready();
    QVERIFY(series().experiment == LimitExperiment::Slide);
    QVERIFY(std::abs(series().laws[0].fit->slope - 0.5) < 1e-3);
    QCOMPARE(driver_->child<QComboBox>("limits.law").count(), 2);
    QVERIFY(!driver_->document().undoStack().canUndo());
  }

  void anotherQuantityIsAnotherPicture() {
    auto& law = driver_->child<QComboBox>("limits.law");
    QCOMPARE(law.count(), 4);
    const QImage lambda = panel_->view().grab().toImage();
    law.setFocus();
    QTest::keyClick(&law, Qt::Key_Down);
    driver_->settle();
    QVERIFY(panel_->view().grab().toImage() != lambda);
  }

  void followsTheProbe() {
    const double before = *series().laws[0].coefficient;
    driver_->window().probe().setPlace(Probe::Place{0, 0.2});
    ready();
    QCOMPARE(series().t, 0.2);
    QVERIFY(*series().laws[0].coefficient != before);
  }

  void saysWhyThereIsNothingToShow() {
    WindowDriver& d = *driver_;
    d.child<QComboBox>("limits.experiment").setCurrentIndex(2);
    d.document().push(std::make_unique<ReplaceScene>(d.document(), presets()[1].scene, "circle"));
    ready();
    QVERIFY(!panel_->view().series());
    QVERIFY(!d.child<QPushButton>("limits.export").isEnabled());
    // No curve at all.
    d.document().push(std::make_unique<ReplaceScene>(d.document(), Scene{}, "nothing"));
    ready();
    QVERIFY(!d.child<QSlider>("limits.slide").isEnabled());
    QVERIFY(!panel_->place());
  }

  void perspectiveLocksTheSlider() {
    WindowDriver& d = *driver_;
    d.document().push(std::make_unique<SetView>(d.document(), View{0.0, 9.0}));
    QVERIFY(!d.child<QSlider>("limits.slide").isEnabled());
    QVERIFY(d.child<QLabel>("limits.words").text().contains("perspective"));
  }

  // The file is what was shown when Export was pressed, whatever arrives while the dialog is open.
  void exportsWhatWasShownWhileTheNextIsComputed() {
    WindowDriver& d = *driver_;
    const std::string shown = limitsToCsv({series()});
    const QString name = d.path("limits.csv");
    typeFileName(name, [this] {
      Document& document = driver_->document();
      document.push(std::make_unique<ReplaceScene>(document, presets()[2].scene, "other"));
      QVERIFY(panel_->isStale());
      QTRY_VERIFY(!panel_->isStale());
    });
    QTest::mouseClick(&d.child<QPushButton>("limits.export"), Qt::LeftButton);
    ready();
    QVERIFY(!panel_->view().series() || limitsToCsv({series()}) != shown);
    QFile written(name);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QCOMPARE(written.readAll(), QByteArray::fromStdString(shown));
  }

  // The dialog asks about the name as typed; what is written has a suffix too.
  void aFileInTheWayOfANameWithoutSuffixIsAskedAbout() {
    WindowDriver& d = *driver_;
    QFile mine(d.path("keep.svg"));
    QVERIFY(mine.open(QIODevice::WriteOnly));
    mine.write("mine");
    mine.close();
    bool asked = false;
    typeFileName(d.path("keep"), [&asked] {
      whenModal(
          [&asked](QWidget& dialog) {
            auto& box = static_cast<QMessageBox&>(dialog);
            asked = box.text().contains("keep.svg");
            QTest::mouseClick(box.button(QMessageBox::No), Qt::LeftButton);
          },
          [](QWidget& dialog) { return qobject_cast<QMessageBox*>(&dialog) != nullptr; });
    });
    QTest::mouseClick(&d.child<QPushButton>("limits.export"), Qt::LeftButton);
    QVERIFY(asked);
    QVERIFY(mine.open(QIODevice::ReadOnly));
    QCOMPARE(mine.readAll(), QByteArray("mine"));
  }

 private:
  void ready() {
    driver_->settle();
    QTRY_VERIFY(!panel_->isStale());
    driver_->settle();
  }
  const LimitSeries& series() { return *panel_->view().series(); }
  double nw() {
    const auto place = *driver_->window().probe().place();
    return std::abs(termsAt(jetAt(driver_->scene().curves[place.curve].shape, place.t),
                            frameOf(driver_->scene().view), 1)
                        .nw);
  }
  QPoint grip() {
    auto& slide = driver_->child<QSlider>("limits.slide");
    return gripAt(slide.value()).toPoint();
  }
  // The slider runs from 1 at the left to 0 at the right.
  QPointF gripAt(int value) {
    auto& slide = driver_->child<QSlider>("limits.slide");
    const int handle = slide.style()->pixelMetric(QStyle::PM_SliderLength, nullptr, &slide);
    const int x = QStyle::sliderPositionFromValue(0, 1000, value, slide.width() - handle, true);
    return {x + 0.5 * handle, 0.5 * slide.height()};
  }

  std::unique_ptr<WindowDriver> driver_;
  LimitsPanel* panel_ = nullptr;
};

QTEST_MAIN(LimitsPanelTest)
#include "limits_panel_test.moc"
