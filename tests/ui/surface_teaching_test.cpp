// SPDX-License-Identifier: GPL-3.0-or-later
// Chapters 4 and 5 at a picked point, in the real window, by mouse and keys.
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QSpinBox>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>

#include "core3d/study/surface_derivation.h"
#include "tests/ui/support_window.h"
#include "ui/app/layouts.h"
#include "ui/app/surface_controller.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_area.h"
#include "ui/view3d/triangle_view.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kPatienceMs = 30000;

}  // namespace

class SurfaceTeachingTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  void theDerivationFollowsPickAndCamera() {
    openSolid("bumpy-sphere:30");
    auto& text = show<QTextBrowser>("surface-derivation", "derivation.text");
    QVERIFY(text.toPlainText().contains("Click"));
    const QPoint middle(surface().width() / 2, surface().height() / 2);
    QTest::mouseClick(&surface(), Qt::LeftButton, {}, middle + QPoint(20, -30));
    QVERIFY(pick().hit());
    QVERIFY2(text.toPlainText().contains("(4.3) View-dependent curvature"),
             qPrintable(text.toPlainText()));
    QVERIFY(!text.toPlainText().contains("% of"));
    QVERIFY(!text.toPlainText().contains("nan"));
    QVERIFY(text.toPlainText().contains("both sides agree"));
    QCOMPARE(d().child<QSpinBox>("derivation.vertex").value(), static_cast<int>(pick().vertex()));
    // Turning the surface changes what is seen of it, not what it is.
    const QString before = text.toHtml();
    key(Qt::Key_Left);
    const QString after = text.toHtml();
    QVERIFY(before != after);
    auto& printed = d().child<QCheckBox>("derivation.printed");
    QTest::mouseClick(&printed, Qt::LeftButton, {}, {8, printed.height() / 2});
    QVERIFY(text.toPlainText().contains(", as printed"));
    QVERIFY(text.toPlainText().contains("% of"));
    // Another vertex by its number.
    auto& vertex = d().child<QSpinBox>("derivation.vertex");
    vertex.setFocus();
    vertex.selectAll();
    QTest::keyClicks(&vertex, "17");
    QTest::keyClick(&vertex, Qt::Key_Return);
    QCOMPARE(pick().vertex(), 17u);
    surface().setFocus();
    key(Qt::Key_Escape);
    QVERIFY(!pick().hit());
    QVERIFY(text.toPlainText().contains("Click"));
  }

  void aTriangleIsTakenApart() {
    openSolid("sine-sheet:24");
    auto& words = show<QLabel>("triangle", "triangle.words");
    auto& view = d().child<TriangleView>("triangle.view");
    auto& number = d().child<QSpinBox>("triangle.number");
    number.setFocus();
    number.selectAll();
    QTest::keyClicks(&number, "861");
    QTest::keyClick(&number, Qt::Key_Return);
    QVERIFY(pick().hit());
    QCOMPARE(pick().hit()->triangle, 861u);
    SurfaceCamera camera = d().scene().surface->camera;
    camera.towards = Eigen::Vector3d(0.5, 0.0, 0.866).normalized();
    d().document().setCamera(camera);
    QTRY_VERIFY2_WITH_TIMEOUT(words.text().contains("Kept"), qPrintable(words.text()), kPatienceMs);
    // Each stage is a button, by mouse and by key.
    for (const char* id :
         {"triangle.ring", "triangle.directions", "triangle.crossing", "triangle.perpendiculars"}) {
      auto& button = d().child<QToolButton>(id);
      QVERIFY(button.isChecked());
      const QImage with = view.grab().toImage();
      QTest::mouseClick(&button, Qt::LeftButton);
      QVERIFY(!button.isChecked());
      QVERIFY2(view.grab().toImage() != with, id);
      button.setFocus();
      QTest::keyClick(&button, Qt::Key_Space);
      QVERIFY(button.isChecked());
      QCOMPARE(view.grab().toImage(), with);
    }
    pick().pickTriangle(329);
    QTRY_VERIFY2_WITH_TIMEOUT(words.text().contains("below the threshold 2"),
                              qPrintable(words.text()), kPatienceMs);
    // All of the ring is on the widget, however flat it is: nothing meets its border.
    for (const std::uint32_t other : {329u, 861u, 400u}) {
      pick().pickTriangle(other);
      d().settle();
      view.resize(380, 150);
      const QImage image = view.grab().toImage();
      const QRgb ground = image.pixel(0, 0);
      for (int x = 0; x < image.width(); ++x) {
        QVERIFY(image.pixel(x, 0) == ground && image.pixel(x, image.height() - 1) == ground);
      }
    }
  }

  void theTriangleIsThatOfThePicture() {
    openSolid("sine-sheet:24");
    auto& words = show<QLabel>("triangle", "triangle.words");
    pick().pickTriangle(329);
    QTRY_VERIFY2_WITH_TIMEOUT(words.text().contains("below the threshold 2"),
                              qPrintable(words.text()), kPatienceMs);
    // Equal ink moves the threshold, and the sentence with it.
    auto& wanted = show<QCheckBox>("families", "families.ink");
    QTest::mouseClick(&wanted, Qt::LeftButton, {}, QPoint(8, wanted.height() / 2));
    QVERIFY(d().scene().surface->ink);
    const SurfaceModels models = d().window().surfaceModels();
    const auto threshold = [&models] {
      return *familyOf(models.setting().surface, LineFamily::ApparentRidges).threshold;
    };
    QVERIFY(QTest::qWaitFor([&] { return d().surfaceQuiet() && threshold() != 2.0; }, kPatienceMs));
    QTRY_VERIFY2_WITH_TIMEOUT(!words.text().contains("below the threshold 2."),
                              qPrintable(words.text()), kPatienceMs);
    QTRY_COMPARE_WITH_TIMEOUT(models.study.lesson()->threshold, threshold(), kPatienceMs);
    QTest::mouseClick(&wanted, Qt::LeftButton, {}, QPoint(8, wanted.height() / 2));
    QTRY_VERIFY2_WITH_TIMEOUT(words.text().contains("below the threshold 2"),
                              qPrintable(words.text()), kPatienceMs);
    // Without filters its crossing is drawn; what they would say stays.
    QVERIFY(!models.study.lesson()->drawn);
    auto& unfiltered = d().child<QCheckBox>("families.unfiltered");
    QTest::mouseClick(&unfiltered, Qt::LeftButton, {}, QPoint(8, unfiltered.height() / 2));
    QVERIFY(d().scene().surface->unfiltered);
    QTRY_VERIFY2_WITH_TIMEOUT(words.text().contains("Drawn, as every crossing"),
                              qPrintable(words.text()), kPatienceMs);
    QVERIFY2(words.text().contains("below the threshold 2"), qPrintable(words.text()));
    QVERIFY(models.study.lesson()->drawn);
  }

  void theLessonShowsThePlacesItNames() {
    const Scene mine = d().scene();
    d().window().lessons().openFile(":/lesson/lessons/surface.md");
    LessonModel& lesson = d().window().lesson();
    QVERIFY(lesson.isOpen());
    QVERIFY(quiet());
    QVERIFY(d().window().layouts().current() == Layouts::Kind::Surface);
    QVERIFY(d().child<QDockWidget>("surface-derivation").isVisible());
    QVERIFY(d().child<QDockWidget>("lesson").isVisible());
    QVERIFY(pick().hit());
    QCOMPARE(pick().vertex(), 6357u);
    auto& text = d().child<QTextBrowser>("derivation.text");
    QTRY_VERIFY_WITH_TIMEOUT(text.toPlainText().contains("both sides agree"), kPatienceMs);
    auto& words = d().child<QLabel>("triangle.words");
    QStringList verdicts;
    while (lesson.index() + 1 < lesson.count()) {
      QTest::mouseClick(&d().child<QToolButton>("lesson.next"), Qt::LeftButton);
      QVERIFY(quiet());
      QVERIFY2(pick().hit(), qPrintable(QString::fromStdString(lesson.step().title)));
      if (lesson.step().state.panel == "triangle") {
        const QString wanted = lesson.step().state.pick->number == 861 ? "Kept" : "minimum";
        QTRY_VERIFY2_WITH_TIMEOUT(words.text().contains(wanted), qPrintable(words.text()),
                                  kPatienceMs);
        verdicts << wanted;
      }
    }
    QCOMPARE(verdicts, QStringList({"Kept", "Kept", "minimum"}));
    QTest::mouseClick(&d().child<QToolButton>("lesson.leave"), Qt::LeftButton);
    d().settle();
    QVERIFY(d().scene() == mine);
    QVERIFY(!d().document().isModified());
    QVERIFY(d().window().layouts().current() == Layouts::Kind::Work);
    QVERIFY(!pick().hit());
  }

  void aStepShowsItsEquation() {
    for (const std::string_view id : kSurfaceEquations) QVERIFY(surfaceStepNamed(id));
    QCOMPARE(static_cast<int>(std::size(kSurfaceEquations)), kSurfaceStepCount);
    d().window().lessons().openFile(":/lesson/lessons/surface.md");
    QVERIFY(quiet());
    LessonModel& lesson = d().window().lesson();
    auto& text = d().child<QTextBrowser>("derivation.text");
    auto& printed = d().child<QCheckBox>("derivation.printed");
    const auto seen = [&text] {
      const int first = text.cursorForPosition({0, 4}).position();
      const int last = text.cursorForPosition({0, text.viewport()->height() - 30}).position();
      return text.toPlainText().mid(first, last - first);
    };
    const struct {
      int step;
      const char* words;
    } steps[] = {{2, "(4.3) View-dependent"}, {3, "derivative of an inverse"}, {0, "(4.1) Curv"}};
    for (const auto& [step, words] : steps) {
      lesson.goTo(step);
      QVERIFY(quiet());
      QTRY_VERIFY2_WITH_TIMEOUT(seen().contains(words), qPrintable(seen()), kPatienceMs);
      // As printed is for the step at which it was ticked.
      QVERIFY(!printed.isChecked());
      QTest::mouseClick(&printed, Qt::LeftButton, {}, {8, printed.height() / 2});
      QVERIFY(printed.isChecked());
    }
    lesson.leave();
    d().settle();
    QVERIFY(!printed.isChecked());
  }

  void theStripGoesWithItsLesson() {
    const auto& strip = d().child<QDockWidget>("lesson");
    const auto seen = [&strip] { return strip.isVisible() && !strip.visibleRegion().isEmpty(); };
    openSolid("torus:20");
    QVERIFY(!seen());
    d().window().lessons().openFile(":/lesson/lessons/surface.md");
    QVERIFY(quiet());
    QVERIFY(seen());
    d().window().lesson().leave();
    QVERIFY(quiet());
    QVERIFY(d().window().layouts().current() == Layouts::Kind::Surface);
    QVERIFY(strip.isHidden());
    // From and to the layout of all panels: it steps back behind another, in both layouts.
    d().trigger("surface.close");
    d().window().layouts().use(Layouts::Kind::Work);
    d().window().lessons().openFile(":/lesson/lessons/surface.md");
    QVERIFY(quiet());
    QVERIFY(seen());
    d().window().lesson().leave();
    d().settle();
    QVERIFY(d().window().layouts().current() == Layouts::Kind::Work);
    QVERIFY(!strip.isHidden());
    QVERIFY(!seen());
    d().window().layouts().use(Layouts::Kind::Surface);
    d().settle();
    QVERIFY(strip.isHidden());
  }

  void aLessonAboutCurvesHasNoEmptyPanel() {
    d().trigger("surface.solid.torus");
    QVERIFY(quiet());
    d().window().lessons().openFile(":/lesson/lessons/offset.md");
    QVERIFY(d().window().lesson().isOpen());
    QVERIFY(!d().scene().surface);
    QVERIFY(d().window().layouts().current() == Layouts::Kind::Work);
    QVERIFY(!d().window().surfaceArea().isVisible());
    QVERIFY(d().child<QDockWidget>("lesson").isVisible());
    QTest::mouseClick(&d().child<QToolButton>("lesson.leave"), Qt::LeftButton);
    QVERIFY(quiet());
    QVERIFY(d().scene().surface);
    QVERIFY(d().window().layouts().current() == Layouts::Kind::Surface);
    QVERIFY(d().window().surfaceArea().isVisible());
  }

 private:
  WindowDriver& d() { return *driver_; }
  QWidget& surface() { return *d().window().surfaceArea().canvas(); }
  SurfacePick& pick() { return d().window().surfaceModels().pick; }
  template <class Widget>
  Widget& show(const char* dock, const char* id) {
    d().window().docks().show(dock);
    d().settle();
    return d().child<Widget>(id);
  }
  bool quiet() {
    const SurfaceModels models = d().window().surfaceModels();
    const bool done = QTest::qWaitFor(
        [&models] { return !models.source.isBusy() && !models.seen.isStale(); }, kPatienceMs);
    d().settle();
    return done;
  }
  void openSolid(const char* name) {
    d().window().surfaces().openSolid(name);
    QVERIFY(quiet());
    d().window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&d().window()));
    surface().setFocus();
  }
  void key(Qt::Key k) {
    surface().setFocus();
    QTest::keyClick(&surface(), k);
    d().settle();
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(SurfaceTeachingTest)
#include "surface_teaching_test.moc"
