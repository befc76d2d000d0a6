// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson is given by mouse and keys, and the person's own work comes back whole.
#include <QCheckBox>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QScrollBar>
#include <QSet>
#include <QSvgRenderer>
#include <QTextBrowser>
#include <QToolButton>

#include "tests/ui/support_window.h"
#include "ui/commands/scene_commands.h"
#include "ui/lesson/formula_view.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/plot/step_size_plot.h"

using namespace flatland;
using namespace flatland::ui;

class LessonTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  void everyEquationHasItsFormula() {
    for (int i = 0; i < kDerivationStepCount; ++i) {
      const auto step = static_cast<DerivationStep>(i);
      for (const bool printed : {false, true}) {
        QFile file(FormulaView::fileOf(step, printed));
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
        QSvgRenderer renderer(file.readAll());
        QVERIFY2(renderer.isValid(), qPrintable(file.fileName()));
        QImage image(renderer.defaultSize() * 3, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        renderer.render(&painter);
        painter.end();
        int dark = 0;
        for (int y = 0; y < image.height(); ++y) {
          for (int x = 0; x < image.width(); ++x) dark += qGray(image.pixel(x, y)) < 128;
        }
        QVERIFY2(dark > 300, qPrintable(file.fileName()));
      }
      const bool differ = FormulaView::fileOf(step, true) != FormulaView::fileOf(step, false);
      QCOMPARE(differ, textOf(step).isMisprinted());
    }
  }

  void shippedLessonsShowAllStepsWithTheirValues() {
    WindowDriver& d = *driver_;
    QCOMPARE(d.window().lessons().shipped().size(), 4);
    for (const char* id : {"silhouette", "apparent-ridge", "offset"}) {
      d.trigger(qPrintable(QStringLiteral("lesson.shipped.") + id));
      LessonModel& lesson = d.window().lesson();
      QVERIFY(lesson.isOpen());
      for (int i = 0; i < lesson.count(); ++i) {
        lesson.goTo(i);
        if (!lesson.equation()) continue;
        const auto reading = lesson.reading();
        QVERIFY2(reading && reading->corrected, qPrintable(QString::number(i)));
        QVERIFY(reading->corrected->residual < 1e-12);
        auto& values = d.child<QLabel>("lesson.values");
        QVERIFY(values.text().contains("left − right"));
        d.settle();
        // Nothing wraps out of the strip, and the words have their room.
        QVERIFY2(values.heightForWidth(values.width()) <= values.height() &&
                     values.minimumSizeHint().width() <= values.width(),
                 lesson.step().title.c_str());
        QVERIFY(d.child<QWidget>("lesson.words").width() >= 200);
      }
    }
  }

  void keysAndButtonsStep() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.apparent-ridge");
    LessonModel& lesson = d.window().lesson();
    QCOMPARE(lesson.index(), 0);
    d.canvasKey(Qt::Key_PageDown);
    QCOMPARE(lesson.index(), 1);
    d.canvasKey(Qt::Key_PageDown);
    d.canvasKey(Qt::Key_PageUp);
    QCOMPARE(lesson.index(), 1);
    d.canvasKey(Qt::Key_PageDown, Qt::ShiftModifier);
    QVERIFY(lesson.step().stop);
    QCOMPARE(lesson.index(), 4);
    d.canvasKey(Qt::Key_Home);
    QCOMPARE(lesson.index(), 0);
    QTest::mouseClick(&d.child<QToolButton>("lesson.next"), Qt::LeftButton);
    QCOMPARE(lesson.index(), 1);
    QTest::mouseClick(&d.child<QToolButton>("lesson.next-stop"), Qt::LeftButton);
    QCOMPARE(lesson.index(), 4);
    QTest::mouseClick(&d.child<QToolButton>("lesson.back"), Qt::LeftButton);
    QCOMPARE(lesson.index(), 3);
  }

  void ownSceneComesBackUnmodified() {
    WindowDriver& d = *driver_;
    d.document().start(presets()[2].scene, "own");
    const Scene own = d.scene();
    d.window().display().setShows(MarkKind::Flat, true);
    const MarkKinds families = d.window().display().families();
    d.trigger("lesson.shipped.silhouette");
    d.canvasKey(Qt::Key_PageDown);
    QVERIFY(!(d.scene() == own));
    QVERIFY(d.window().display().families() != families);
    d.trigger("edit.undo");  // one step of the lesson is one step of undo
    d.trigger("edit.undo");
    QVERIFY(d.scene() == own);
    d.trigger("edit.redo");
    QTest::mouseClick(&d.child<QToolButton>("lesson.leave"), Qt::LeftButton);
    QVERIFY(!d.window().lesson().isOpen());
    QVERIFY(d.scene() == own);
    QVERIFY(!d.document().isModified());
    QVERIFY(d.window().display().families() == families);
  }

  void undoLeadsToTheStepWhoseSceneComesBack() {
    WindowDriver& d = *driver_;
    d.document().start(presets()[2].scene, "own");
    const Scene own = d.scene();
    const auto probe = d.window().probe().place();
    LessonModel& lesson = d.window().lesson();
    d.trigger("lesson.shipped.silhouette");
    std::vector<int> shown;  // steps that brought a scene of their own
    int steps = d.document().undoStack().count();
    shown.push_back(0);
    while (shown.size() < 3 && lesson.index() + 1 < lesson.count()) {
      d.canvasKey(Qt::Key_PageDown);
      if (d.document().undoStack().count() > steps) shown.push_back(lesson.index());
      steps = d.document().undoStack().count();
    }
    QVERIFY(shown.size() >= 2);
    const int last = shown.back();
    const Scene scene = d.scene();
    d.canvasKey(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(lesson.index(), last - 1);
    QVERIFY(d.child<QLabel>("lesson.title").text().contains(QString("Step %1 of").arg(last)));
    d.trigger("edit.redo");
    QCOMPARE(lesson.index(), last);
    QVERIFY(d.scene() == scene);
    // Below the first step there is the own scene, and the strip says so.
    while (d.document().undoStack().canUndo()) d.trigger("edit.undo");
    QVERIFY(d.scene() == own);
    QVERIFY(d.window().probe().place() == probe);
    QVERIFY(d.child<QLabel>("lesson.title").text().contains("your own scene"));
    d.canvasKey(Qt::Key_PageDown);
    QVERIFY(!d.child<QLabel>("lesson.title").text().contains("your own scene"));
    QCOMPARE(lesson.index(), 1);
  }

  void editsMadeInALessonAreNotLostAndNeitherIsOwnWork() {
    WindowDriver& d = *driver_;
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(30, 10));
    const Scene own = d.scene();
    QVERIFY(d.document().isModified());
    d.trigger("lesson.shipped.silhouette");
    d.drag(d.atPoint(2), d.atPoint(2) + QPoint(40, 25));
    const Scene edited = d.scene();
    QVERIFY(!(edited == own));
    d.trigger("lesson.step.leave");
    QVERIFY(d.scene() == own);
    QVERIFY(d.document().isModified());
    d.trigger("edit.undo");
    QVERIFY2(d.scene() == edited, "what was drawn in the lesson");
  }

  void ownSceneComesBackWhereUndoWentBelowTheLesson() {
    WindowDriver& d = *driver_;
    QVERIFY(d.window().files().saveTo(d.path("own.json")));
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(30, 10));
    const Scene own = d.scene();
    d.trigger("lesson.shipped.silhouette");
    d.trigger("edit.undo");
    d.trigger("edit.undo");
    d.canvasKey(Qt::Key_PageDown);
    QVERIFY(!(d.scene() == own));
    d.trigger("file.save");
    QVERIFY(d.scene() == own);
    d.document().open(d.path("own.json").toStdString());
    QVERIFY2(d.scene() == own, "the file has the person's scene, not the lesson's");
  }

  void claimsAboutValuesHoldWhateverWasDoneBefore() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.apparent-ridge");
    LessonModel& lesson = d.window().lesson();
    for (int i = 9; i <= 15; ++i) {
      lesson.goTo(i - 1);
      Scene turned = d.scene();
      turned.view.angleDeg = 180.0;
      d.document().push(std::make_unique<ReplaceScene>(d.document(), turned, "turn"));
      d.window().probe().setPlace(std::nullopt);
      d.canvasKey(Qt::Key_PageDown);
      QCOMPARE(lesson.index(), i);
      QCOMPARE(d.scene().view.angleDeg, 20.0);
      const auto reading = lesson.reading();
      QVERIFY2(reading && reading->corrected, lesson.step().title.c_str());
      if (i == 9) {
        const StepSides& printed = *reading->printed;
        QVERIFY(std::abs(printed.left.entries[0]) > 0.01);
        QVERIFY(std::abs(printed.left.entries[0] + printed.right.entries[0]) < 1e-12);
      }
      QCOMPARE(d.window().display().showsPrintedRoots(), i == 14);
    }
  }

  void twoSilhouettesMeetAtTheInflectionAsTheLessonSays() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.silhouette");
    d.window().lesson().goTo(3);
    const auto silhouettes = [&d] {
      std::vector<double> at;
      for (const Mark& mark : d.document().features().marks) {
        if (mark.kind == MarkKind::Silhouette) at.push_back(mark.t);
      }
      return at;
    };
    double apart = 1.0;  // of the parameter, in [0, 1]
    View view = d.scene().view;
    while (silhouettes().size() == 2) {
      QVERIFY(silhouettes()[0] < 0.5 && silhouettes()[1] > 0.5);
      QVERIFY(silhouettes()[1] - silhouettes()[0] < apart);
      apart = silhouettes()[1] - silhouettes()[0];
      view.angleDeg += 0.25;
      d.document().setView(view);
    }
    QVERIFY(apart < 0.1 && silhouettes().empty());
    QVERIFY(view.angleDeg > 110.0 && view.angleDeg < 140.0);
  }

  void aLessonKnowsThePanelsOfTheWindow() {
    QStringList known;
    for (const std::string_view id : kLessonPanels)
      known << QString::fromStdString(std::string(id));
    QStringList docks;
    for (const QDockWidget* dock : driver_->window().findChildren<QDockWidget*>()) {
      docks << dock->objectName();
    }
    known.sort();
    docks.sort();
    QCOMPARE(known, docks);
  }

  void theStripShowsItAllWithoutScrolling() {
    WindowDriver& d = *driver_;
    d.window().resize(1280, 800);
    d.settle();
    d.trigger("lesson.shipped.apparent-ridge");
    d.window().lesson().goTo(14);
    d.settle();
    seen("lesson.values");
    seen("lesson.printed");
    seen("lesson.printed-roots");
    QVERIFY(d.child<QWidget>("lesson.formula").height() >= 30);
  }

  void theProjectorKeepsTheStrip() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.apparent-ridge");
    d.window().lesson().goTo(9);
    d.canvasKey(Qt::Key_F11);
    d.settle();
    seen("lesson.values");
    seen("lesson.words");
    QVERIFY(d.child<QWidget>("lesson.formula").height() >= 30);
    d.trigger("lesson.step.leave");
    QVERIFY(!d.child<QDockWidget>("lesson").isVisible());
    d.trigger("lesson.shipped.offset");
    QVERIFY(d.child<QDockWidget>("lesson").isVisible());
    d.canvasKey(Qt::Key_F11);
  }

  void cancelledFileDialogsLeaveTheLessonOpen() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.silhouette");
    const Scene shown = d.scene();
    for (const char* action : {"file.open", "file.save-as"}) {
      whenModal([](QWidget& dialog) { static_cast<QDialog&>(dialog).reject(); });
      d.trigger(action);
      QVERIFY2(d.window().lesson().isOpen(), action);
      QVERIFY(d.scene() == shown);
    }
    d.trigger("lesson.step.leave");
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(30, 10));
    d.trigger("lesson.shipped.silhouette");
    whenModal([](QWidget& dialog) { static_cast<QDialog&>(dialog).reject(); });
    d.trigger("file.new");
    QVERIFY2(d.window().lesson().isOpen(), "unsaved work, the question cancelled");
  }

  void theSceneOfALessonCanBeSavedBeforeItGoes() {
    WindowDriver& d = *driver_;
    QVERIFY(d.window().files().saveTo(d.path("own.json")));
    const Scene own = d.scene();
    d.trigger("lesson.shipped.silhouette");
    d.drag(d.atPoint(2), d.atPoint(2) + QPoint(40, 25));
    const Scene edited = d.scene();
    QVERIFY(!(edited == own));
    QString question;
    whenModal([&](QWidget& dialog) {
      auto& box = static_cast<QMessageBox&>(dialog);
      question = box.text();
      typeFileName(d.path("step.json"));
      QTest::mouseClick(box.button(QMessageBox::Save), Qt::LeftButton);
    });
    d.trigger("file.new");
    QVERIFY2(question.contains("lesson"), qPrintable(question));
    QVERIFY(!d.window().lesson().isOpen());
    // The own scene was saved and is not asked about; its file is as it was.
    d.document().open(d.path("own.json").toStdString());
    QVERIFY(d.scene() == own);
    d.document().open(d.path("step.json").toStdString());
    QVERIFY(d.scene() == edited);
  }

  void savingSavesTheOwnScene() {
    WindowDriver& d = *driver_;
    const Scene own = d.scene();
    QVERIFY(d.window().files().saveTo(d.path("own.json")));
    d.trigger("lesson.shipped.offset");
    d.canvasKey(Qt::Key_PageDown);
    QVERIFY(!(d.scene() == own));
    d.trigger("file.save");
    QVERIFY(d.scene() == own);
    d.document().open(d.path("own.json").toStdString());
    QVERIFY(d.scene() == own);
  }

  void openingAnotherSceneEndsTheLesson() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.offset");
    d.trigger("file.preset.circle");
    QVERIFY(!d.window().lesson().isOpen());
    QVERIFY(d.scene() == presets()[1].scene);
  }

  void printedAndCorrectedDifferOnScreen() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.apparent-ridge");
    LessonModel& lesson = d.window().lesson();
    while (!(lesson.equation() == DerivationStep::Eq3_13)) lesson.next();
    d.settle();
    QVERIFY(lesson.isPrinted());
    QVERIFY(d.window().display().showsPrintedRoots());
    QVERIFY(d.child<QLabel>("lesson.values").text().contains("% of"));
    const QImage with = d.canvas().grab().toImage();
    d.window().display().setShowsPrintedRoots(false);
    QVERIFY2(d.canvas().grab().toImage() != with, "hollow roots on the canvas");
    QTest::mouseClick(&d.child<QToolButton>("lesson.corrected"), Qt::LeftButton);
    QVERIFY(!lesson.isPrinted());
    QVERIFY(d.child<QLabel>("lesson.values").text().contains("agree"));
    QTest::mouseClick(&d.child<QToolButton>("lesson.printed"), Qt::LeftButton);
    QVERIFY(lesson.isPrinted());
  }

  void howFarThePrintedRootsMissIsSaid() {
    WindowDriver& d = *driver_;
    d.window().resize(1280, 800);
    auto& misses = d.child<QLabel>("lesson.misses");
    d.trigger("lesson.shipped.apparent-ridge");
    QVERIFY(!misses.isVisible());
    while (!(d.window().lesson().equation() == DerivationStep::Eq3_13)) {
      d.canvasKey(Qt::Key_PageDown);
    }
    QVERIFY(misses.isVisible());
    QVERIFY2(misses.text().endsWith(missesExpected()), qPrintable(misses.text()));
    QVERIFY2(misses.sizeHint().width() <= misses.width(), "one line, not cut");
    const auto roots = d.document().printedRoots().roots.size();
    QVERIFY(roots >= 2);
    QCOMPARE(misses.toolTip().count('\n'), static_cast<qsizetype>(roots));
    const QString before = misses.text();
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(15, 10));
    QVERIFY(misses.text() != before);
    QVERIFY2(misses.text().endsWith(missesExpected()), qPrintable(misses.text()));
    auto& box = d.child<QCheckBox>("lesson.printed-roots");
    QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
    QVERIFY(!d.window().display().showsPrintedRoots());
    QVERIFY(!misses.isVisible());
    QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
    QVERIFY(misses.isVisible());
    QTest::mouseClick(&d.child<QToolButton>("lesson.leave"), Qt::LeftButton);
    QVERIFY(!misses.isVisible());
  }

  void theStripHasRoomForTheMisses() {
    WindowDriver& d = *driver_;
    d.window().resize(1280, 800);
    d.trigger("lesson.shipped.apparent-ridge");
    LessonModel& lesson = d.window().lesson();
    d.window().display().setShowsPrintedRoots(true);
    auto& words = d.child<QTextBrowser>("lesson.words");
    const auto& misses = d.child<QLabel>("lesson.misses");
    QSet<int> heights;
    for (int i = 0; i < lesson.count(); ++i) {
      lesson.goTo(i);
      if (!lesson.equation()) continue;
      d.settle();
      heights << words.parentWidget()->height();
      if (!misses.isVisible()) continue;
      // What the equations have elsewhere, at the usual size of type.
      const QWidget& equation = *d.child<QWidget>("lesson.formula").parentWidget();
      QVERIFY2(equation.height() >= 200, qPrintable(QString::number(equation.height())));
    }
    QCOMPARE(heights.size(), 1);  // the picture stands still
    lesson.goTo(0);
    while (!(lesson.equation() == DerivationStep::Eq3_13)) lesson.next();
    d.settle();
    QVERIFY(misses.isVisible());
    // No word is out of its column.
    for (const int width : {1280, 1600}) {
      d.window().resize(width, 800);
      d.settle();
      QCOMPARE(words.verticalScrollBar()->maximum(), 0);
    }
  }

  void theFileMenuOpensALessonToo() {
    WindowDriver& d = *driver_;
    QFile file(d.path("own.md"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("# My own\n\n## Only step\n\nWords.\n");
    file.close();
    auto& menu = d.child<QMenu>("menu.file");
    QVERIFY(menu.actions().contains(&d.child<QAction>("lesson.open")));
    menu.popup(d.window().mapToGlobal(QPoint(0, 0)));
    QVERIFY(QTest::qWaitForWindowExposed(&menu));
    typeFileName(file.fileName());
    QTest::keyClick(&menu, Qt::Key_L);
    QVERIFY(d.window().lesson().isOpen());
    QCOMPARE(d.window().lesson().lesson().title, std::string("My own"));
  }

  void valuesFollowTheDragAndTheProbe() {
    WindowDriver& d = *driver_;
    d.trigger("lesson.shipped.apparent-ridge");
    d.window().lesson().goTo(6);
    auto& values = d.child<QLabel>("lesson.values");
    const QString before = values.text();
    d.window().probe().moveBy(0.05);
    QVERIFY(values.text() != before);
    const QString moved = values.text();
    const QPoint from = d.atPoint(1);
    d.press(from);
    d.move(from + QPoint(20, 20));
    QVERIFY2(values.text() != moved, "before any event is processed: in the same frame");
    d.release(from + QPoint(20, 20));
    QVERIFY(d.window().findChild<StepSizePlot*>()->pointCount() > 20);
  }

  void aBrokenLessonIsToldAndChangesNothing() {
    WindowDriver& d = *driver_;
    const Scene own = d.scene();
    QFile file(d.path("broken.md"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("# Broken\n\n## Step\n\n```flatland\n{\"preset\": \"nowhere\"}\n```\n");
    file.close();
    d.window().lessons().openFile(file.fileName());
    QVERIFY(!d.window().lesson().isOpen());
    QVERIFY(d.scene() == own);
  }

 private:
  void seen(const char* name) {
    const QWidget& widget = driver_->child<QWidget>(name);
    QVERIFY2(widget.isVisible() && widget.visibleRegion().boundingRect() == widget.rect(), name);
  }

  // Counted and measured here anew: maxima by their parameter, distances by arc length.
  QString missesExpected() {
    const Scene& scene = driver_->scene();
    const Curve& curve = scene.curves[0].shape;
    const double length = arcLength(curve, 0.0, pieceCount(curve), 1e-12).value;
    const auto& features = driver_->document().features();
    double least = 1e300, most = 0.0;
    const auto roots = findPrintedRoots(scene, features).roots;
    for (const PrintedRoot& root : roots) {
      double nearest = 1e300;
      for (const Mark& mark : features.marks) {
        if (mark.kind != MarkKind::ApparentRidge) continue;
        const double along = std::abs(arcLength(curve, root.t, mark.t, 1e-12).value);
        nearest = std::min({nearest, along, isClosed(curve) ? length - along : along});
      }
      least = std::min(least, nearest);
      most = std::max(most, nearest);
    }
    const auto text = [&](double along) {
      return QStringLiteral("%1 (%2 % of the curve)")
          .arg(QString::number(along, 'g', 2), QString::number(100.0 * along / length, 'g', 2));
    };
    return QStringLiteral(
               "maximum of λ: 0 of %1; off the nearest apparent ridge by %2 at best, "
               "%3 at worst")
        .arg(roots.size())
        .arg(text(least), text(most));
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(LessonTest)
#include "lesson_test.moc"
