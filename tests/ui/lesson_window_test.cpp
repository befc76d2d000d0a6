// SPDX-License-Identifier: GPL-3.0-or-later
// The window while a lesson about a surface is given: what is seen, what keys do, and that
// everything is afterwards as it was.
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QScrollBar>
#include <QSpinBox>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>

#include "tests/ui/support_window.h"
#include "ui/app/layouts.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_area.h"

using namespace flatland;
using namespace flatland::ui;

class LessonWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    d().window().resize(1280, 800);
    d().settle();
  }
  void cleanup() { driver_.reset(); }

  void theProjectorShowsThePanelOfTheStep() {
    startLesson("surface");
    for (int i = 0; i < lesson().count(); ++i) {
      lesson().goTo(i);
      QVERIFY(d().surfaceQuiet());
      const std::string panel = lesson().step().state.panel;
      QVERIFY2(seen(panel.c_str()) && seen("lesson"), panel.c_str());
      d().trigger("view.layout.projector");
      d().settle();
      QVERIFY2(seen(panel.c_str()) && seen("lesson"), panel.c_str());
      // And a step later, or back in the window.
      if (i % 2 == 0) continue;
      d().trigger("view.layout.projector");
      d().settle();
      QVERIFY2(seen(panel.c_str()) && seen("lesson"), panel.c_str());
    }
    // No other panel of a step is left.
    QCOMPARE(openPanels(), QStringList({"lesson", "triangle"}));
  }

  void escLeavesTheProjectorAndNotThePoint() {
    startLesson("surface");
    lesson().goTo(4);
    QVERIFY(d().surfaceQuiet());
    QVERIFY(d().child<QLabel>("status.hint").text().contains("5: perspective"));
    d().trigger("view.layout.projector");
    const std::uint32_t vertex = pick().vertex();
    pressed(Qt::Key_Escape);
    QVERIFY(!d().window().display().isProjector());
    QVERIFY(pick().hit() && pick().vertex() == vertex);
    pressed(Qt::Key_Escape);
    QVERIFY(!pick().hit());
  }

  void theMenuSaysWhatALessonCovers() {
    for (const char* id : {"silhouette", "apparent-ridge", "offset", "surface"}) {
      const QString text = d().child<QAction>((std::string("lesson.shipped.") + id).c_str()).text();
      QVERIFY2(text.contains("(thesis, "), qPrintable(text));
    }
  }

  void thereIsRoomForWhatIsTaught() {
    startLesson("surface");
    const auto& words = d().child<QTextBrowser>("lesson.words");
    int least = 10000, most = 0;
    for (int i = 0; i < lesson().count(); ++i) {
      lesson().goTo(i);
      QVERIFY(d().surfaceQuiet());
      QCOMPARE(words.verticalScrollBar()->maximum(), 0);
      const QWidget& view = *d().window().surfaceArea().canvas();
      least = qMin(least, view.height());
      most = qMax(most, view.height());
      QVERIFY2(view.height() >= 600, qPrintable(QString::number(view.height())));
      QVERIFY2(view.width() >= 700, qPrintable(QString::number(view.width())));
      QVERIFY(!d().canvas().isVisible());
      const auto& matrices = d().child<QTextBrowser>("derivation.text");
      if (matrices.isVisible()) QCOMPARE(matrices.horizontalScrollBar()->maximum(), 0);
    }
    QCOMPARE(least, most);  // the picture stands still from step to step
    // Who wants the curves, has them.
    d().trigger("view.flat-beside");
    QVERIFY(d().canvas().isVisible());
    lesson().goTo(2);
    d().settle();
    QVERIFY(d().canvas().isVisible());
  }

  void keysReachTheSurfaceFromStripAndPanels() {
    startLesson("surface");
    lesson().goTo(3);
    QVERIFY(d().surfaceQuiet());
    const std::uint32_t vertex = pick().vertex();
    auto& printed = d().child<QCheckBox>("derivation.printed");
    QTest::mouseClick(&printed, Qt::LeftButton, {}, {8, printed.height() / 2});
    QVERIFY(printed.isChecked());
    pressed(Qt::Key_PageDown);  // a step on, as the lesson says
    QCOMPARE(lesson().index(), 4);
    QVERIFY(d().surfaceQuiet());
    pressed(Qt::Key_5);
    QVERIFY(camera().perspectiveDeg.has_value());
    pressed(Qt::Key_5);
    QVERIFY(!camera().perspectiveDeg);
    // From wherever the focus may be, but where a number is typed.
    for (const char* id :
         {"lesson.next", "lesson.words", "derivation.text", "derivation.printed"}) {
      d().child<QWidget>(id).setFocus();
      pressed(Qt::Key_5);
      QVERIFY2(camera().perspectiveDeg.has_value(), id);
      pressed(Qt::Key_5);
      pressed(Qt::Key_3);
      const Eigen::Vector3d right = camera().towards;
      pressed(Qt::Key_1);
      QVERIFY2((camera().towards - right).norm() > 1.0, id);
      if (qobject_cast<QTextBrowser*>(&d().child<QWidget>(id))) {
        const Eigen::Vector3d before = camera().towards;
        pressed(Qt::Key_Left);
        QVERIFY2((camera().towards - before).norm() > 0.01, id);
      }
    }
    auto& number = d().child<QSpinBox>("derivation.vertex");
    number.setFocus();
    pressed(Qt::Key_5);
    QVERIFY(!camera().perspectiveDeg);
    QCOMPARE(pick().vertex(), vertex);
    // Home is the first step, as its tip says, also for who looks at the surface.
    d().window().surfaceArea().canvas()->setFocus();
    pressed(Qt::Key_Home);
    QCOMPARE(lesson().index(), 0);
  }

  void theMarkedEquationHasTheColoursOfTheTheme() {
    startLesson("surface");
    lesson().goTo(3);
    QVERIFY(d().surfaceQuiet());
    const auto ground = [this] {
      const QTextDocument& text = *d().child<QTextBrowser>("derivation.text").document();
      QColor colour;
      for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().background().style() == Qt::NoBrush) continue;
        if (!block.text().startsWith("The derivative of an inverse")) return QColor();
        colour = block.blockFormat().background().color();
      }
      return colour;
    };
    d().window().display().setTheme(ui::Display::Theme::Light);
    d().settle();
    const QColor light = ground();
    QVERIFY(light.isValid() && light.lightness() > 180);
    d().window().display().setTheme(ui::Display::Theme::Dark);
    d().settle();
    QVERIFY(ground().isValid() && ground().lightness() < 100);
    d().window().display().setTheme(ui::Display::Theme::System);
  }

  // A student takes the two sides that are shown, and finds the difference and the share shown.
  void theNumbersAreThoseOfTheDigitsShown() {
    startLesson("surface");
    const auto& text = d().child<QTextBrowser>("derivation.text");
    auto& printed = d().child<QCheckBox>("derivation.printed");
    int parted = 0, agreeing = 0;
    for (const std::uint32_t vertex : {6357u, 100u, 2500u}) {
      pick().pickVertex(vertex);
      for (const bool asPrinted : {false, true}) {
        printed.setChecked(asPrinted);
        d().settle();
        const std::vector<Sides> all = sidesIn(text.toPlainText());
        QCOMPARE(all.size(), std::size_t{20});
        for (const Sides& sides : all) {
          const auto what = qPrintable(sides.name + " " + sides.rest);
          double most = 0.0, reach = 0.0;
          for (qsizetype i = 0; i < sides.left.size(); ++i) {
            most = qMax(most, qAbs(sides.left[i] - sides.right[i]));
            reach = qMax(reach, qAbs(sides.left[i]) + qAbs(sides.right[i]));
          }
          if (sides.rest.contains("rounding")) {
            ++agreeing;
            QVERIFY2(most <= 1e-5 * reach + 1e-9, what);
            continue;
          }
          ++parted;
          QVERIFY2(qAbs(qAbs(sides.difference) - most) <= 6e-4 * most, what);
          if (sides.left.size() == 1) {
            QVERIFY2(sides.difference * (sides.left[0] - sides.right[0]) > 0.0, what);
          }
          const double percent = sides.rest.section("% of", 0, 0).section(": ", 1).toDouble();
          QVERIFY2(qAbs(percent - 100.0 * most / reach) < 0.06, what);
        }
      }
    }
    QCOMPARE(agreeing, 3 * (20 + 17));
    QCOMPARE(parted, 9);
  }

  void nothingPickedIsSaid() {
    d().window().surfaces().openSolid("torus:20");
    QVERIFY(d().surfaceQuiet());
    for (const auto& [dock, id] :
         {std::pair{"surface-derivation", "derivation.vertex"}, {"triangle", "triangle.number"}}) {
      d().window().docks().show(dock);
      d().settle();
      const auto& number = d().child<QSpinBox>(id);
      QCOMPARE(number.text(), "none");
      pick().pickVertex(17);
      d().settle();
      QVERIFY(number.text().toInt() > 0);
      pick().pick(std::nullopt);
      d().settle();
      QCOMPARE(number.text(), "none");
    }
    auto& number = d().child<QSpinBox>("triangle.number");
    number.setFocus();
    pressed(Qt::Key_Up);
    QCOMPARE(pick().hit()->triangle, 0u);
    pressed(Qt::Key_Down);
    QVERIFY(!pick().hit());
  }

  void lookingIsNoWorkAndWorkIsNamed() {
    d().window().surfaces().openSolid("torus:20");
    QVERIFY(d().surfaceQuiet());
    const auto change = [this](const auto& edit) {
      std::optional<SurfaceSetting> setting = d().scene().surface;
      edit(*setting);
      d().document().push(std::make_unique<SetSurface>(d().document(), setting, "edit"));
      d().settle();
    };
    change([](SurfaceSetting& s) { s = withFamily(s, shown(LineFamily::Ridges)); });
    change([](SurfaceSetting& s) { s.style = "toon"; });
    d().trigger("surface.compare.two");
    QVERIFY(d().scene().surface->panes.size() == 1);
    d().document().undoStack().undo();
    QVERIFY(!d().window().isWindowModified());
    // A threshold set by hand is some, also after a lesson, which is none itself.
    change([](SurfaceSetting& s) { s = withFamily(s, shown(LineFamily::Ridges, 7.5)); });
    QVERIFY(d().window().isWindowModified());
    QVERIFY(asked().contains("widths of the lines of torus:20"));
    d().document().undoStack().undo();
    d().settle();
    QVERIFY(!d().window().isWindowModified());
    startLesson("surface");
    QVERIFY(d().window().windowTitle().startsWith("Apparent ridges on a surface"));
    QVERIFY(!d().window().isWindowModified());
    pressed(Qt::Key_Left);
    change([](SurfaceSetting& s) { s = withFamily(s, shown(LineFamily::Valleys)); });
    QVERIFY(!d().window().isWindowModified());
    d().document().undoStack().undo();
    lesson().leave();
    QVERIFY(d().surfaceQuiet());
    QVERIFY(!d().window().isWindowModified());
    QVERIFY(d().window().windowTitle().startsWith("torus:20"));
    // Of curves the question speaks where they were changed.
    d().drag(d().atPoint(1), d().atPoint(1) + QPoint(33, 17));
    QVERIFY(d().window().isWindowModified());
    const QString said = asked();
    QVERIFY2(said.contains("the curves") && !said.contains("torus"), qPrintable(said));
  }

  void theNextMeshLooksAsTheOneThatWasClosed() {
    d().window().surfaces().openSolid("torus:20");
    QVERIFY(d().surfaceQuiet());
    std::optional<SurfaceSetting> mine = d().scene().surface;
    mine->style = "toon";
    mine = withFamily(*mine, shown(LineFamily::Ridges, 7.5));
    d().document().push(std::make_unique<SetSurface>(d().document(), mine, "edit"));
    d().trigger("surface.close");
    QVERIFY(!d().scene().surface);
    startLesson("surface");
    lesson().leave();
    QVERIFY(d().surfaceQuiet());
    QVERIFY(!d().scene().surface);
    d().window().surfaces().openSolid("sphere:20");
    QVERIFY(d().surfaceQuiet());
    QCOMPARE(d().scene().surface->style, mine->style);
    QVERIFY(d().scene().surface->families == mine->families);
  }

  void theEmptyPlaceOfASurfaceComesBack() {
    d().trigger("view.layout.surface");
    d().settle();
    QVERIFY(!d().scene().surface && d().window().surfaceArea().isVisible());
    startLesson("surface");
    lesson().leave();
    QVERIFY(d().surfaceQuiet());
    QVERIFY(!d().scene().surface);
    QVERIFY(d().window().surfaceArea().isVisible());
  }

  void theStripStaysAsThePersonHasIt() {
    startLesson("surface");
    auto& strip = d().child<QDockWidget>("lesson");
    auto& words = d().child<QTextBrowser>("lesson.words");
    const int wanted = strip.height();
    d().window().resizeDocks({&strip}, {wanted + 60}, Qt::Vertical);
    d().settle();
    QCOMPARE(strip.height(), wanted + 60);
    d().trigger("view.flat-beside");
    d().settle();
    QCOMPARE(strip.height(), wanted + 60);
    // A layout that is entered has its room for the words.
    d().trigger("view.restore-layout");
    d().settle();
    QCOMPARE(strip.height(), wanted);
    // Closed, it is not opened by the curves, a width or a type.
    strip.close();
    d().settle();
    d().trigger("view.flat-beside");
    d().window().resize(1100, 800);
    d().settle();
    QVERIFY(!strip.isVisible());
    QWidget& panel = *words.parentWidget();
    QFont larger = panel.font();
    larger.setPointSizeF(larger.pointSizeF() * 1.5);
    panel.setFont(larger);
    d().settle();
    QVERIFY(!strip.isVisible());
    d().trigger("view.layout.projector");
    d().settle();
    QVERIFY(seen("lesson"));
  }

  void theArrangementComesBack() {
    d().window().surfaces().openSolid("torus:20");
    QVERIFY(d().surfaceQuiet());
    auto& docks = d().window().docks();
    docks.hide("bridge");
    docks.show("section");
    docks.show("sweep");
    d().settle();
    const QStringList panels = openPanels();
    const bool front = seen("section");
    const Scene scene = d().scene();
    const int wide = d().canvas().width();
    for (const bool onTheWall : {false, true}) {
      d().trigger("lesson.shipped.surface");
      QVERIFY(d().surfaceQuiet());
      QCOMPARE(openPanels(), QStringList({"lesson", "surface-derivation"}));
      lesson().goTo(6);
      QVERIFY(d().surfaceQuiet());
      docks.show("families");
      if (onTheWall) d().trigger("view.layout.projector");
      d().settle();
      QTest::mouseClick(&d().child<QToolButton>("lesson.leave"), Qt::LeftButton);
      QVERIFY(d().surfaceQuiet());
      if (onTheWall) d().trigger("view.layout.projector");
      d().settle();
      QCOMPARE(openPanels(), panels);
      QCOMPARE(seen("section"), front);
      QVERIFY(d().scene() == scene);
      QVERIFY(d().canvas().isVisible());
      QVERIFY(qAbs(d().canvas().width() - wide) <= 2);
    }
    // Closed in the middle of a lesson, the next session has the person's own as well.
    d().trigger("lesson.shipped.surface");
    QVERIFY(d().surfaceQuiet());
    d().window().layouts().save(d().settings());
    lesson().leave();
    d().settle();
    docks.hide("section");
    d().window().layouts().restore(d().settings());
    d().settle();
    QCOMPARE(openPanels(), panels);
  }

 private:
  static SurfaceFamily shown(LineFamily which, std::optional<double> threshold = {}) {
    SurfaceFamily family = usualFamily(which);
    family.on = true;
    if (threshold) family.threshold = threshold;
    return family;
  }
  /// What closing the window asks, which is cancelled.
  QString asked() {
    QString said;
    whenModal([&said](QWidget& dialog) {
      auto* box = qobject_cast<QMessageBox*>(&dialog);
      QVERIFY(box);
      said = box->text() + " " + box->informativeText();
      QTest::mouseClick(box->button(QMessageBox::Cancel), Qt::LeftButton);
    });
    if (d().window().close()) qFatal("nothing was asked");
    return said;
  }
  WindowDriver& d() { return *driver_; }
  LessonModel& lesson() { return d().window().lesson(); }
  SurfacePick& pick() { return d().window().surfaceModels().pick; }
  const SurfaceCamera& camera() { return d().scene().surface->camera; }
  void startLesson(const char* name) {
    d().trigger((std::string("lesson.shipped.") + name).c_str());
    QVERIFY(lesson().isOpen());
    QVERIFY(d().surfaceQuiet());
  }
  /// Not closed, and not behind another.
  bool seen(const char* dock) {
    const auto& widget = d().child<QDockWidget>(dock);
    return widget.isVisible() && !widget.visibleRegion().isEmpty();
  }
  QStringList openPanels() {
    QStringList open;
    for (const QDockWidget* dock : d().window().findChildren<QDockWidget*>()) {
      if (!dock->isHidden()) open << dock->objectName();
    }
    open.sort();
    return open;
  }
  struct Sides {
    QString name, rest;  ///< the label of the left side; what stands after the difference
    QList<double> left, right;
    double difference = 0.0;
  };
  /// The equations of the panel, as somebody reads them: a cell a line.
  static std::vector<Sides> sidesIn(QString text) {
    text.replace(QChar(0x2212), '-').replace(QChar(0xa0), ' ');
    const auto numbers = [](QString cell) {
      QList<double> values;
      const QStringList words =
          cell.remove('=').remove('(').remove(')').replace(';', ' ').split(' ', Qt::SkipEmptyParts);
      for (const QString& word : words) values << word.toDouble();
      return values;
    };
    std::vector<Sides> all;
    const QStringList lines = text.split('\n');
    for (qsizetype i = 4; i + 1 < lines.size(); ++i) {
      if (!lines[i].contains("left - right|") && !lines[i].contains("left - right ")) continue;
      const QString rest = lines[i + 1].mid(2);
      all.push_back({lines[i - 4].trimmed(), rest, numbers(lines[i - 3]), numbers(lines[i - 1]),
                     rest.section(':', 0, 0).toDouble()});
    }
    return all;
  }
  /// Where the focus is, shortcuts included.
  void pressed(Qt::Key key) {
    d().window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&d().window()));
    QVERIFY(QApplication::focusWidget());
    QTest::keyClick(QApplication::focusWidget(), key);
    d().settle();
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(LessonWindowTest)
#include "lesson_window_test.moc"
