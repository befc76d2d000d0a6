// SPDX-License-Identifier: GPL-3.0-or-later
// The window in front of a class: layouts, projector mode, themes, languages, trackpads, and what
// is remembered of them.
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QStatusBar>
#include <QTableView>
#include <QToolBar>
#include <QToolButton>
#include <QWheelEvent>

#include "flatland/curve/families.h"
#include "tests/ui/support_window.h"
#include "ui/app/language.h"
#include "ui/app/layouts.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/core_words.h"
#include "ui/model/theme.h"
#include "ui/plot/sweep_panel.h"

namespace flatland::ui {

namespace {

QStringList openDocks(MainWindow& window) {
  QStringList open;
  for (QDockWidget* dock : window.docks().all()) {
    if (!dock->isHidden()) open << dock->objectName();
  }
  return open;
}

/// A window on settings that outlive it, for what is remembered.
std::unique_ptr<MainWindow> openWindow(QSettings* settings) {
  auto window = std::make_unique<MainWindow>(defaultScene(), "preset", settings);
  window->show();
  window->activateWindow();
  if (!QTest::qWaitForWindowActive(window.get())) qFatal("the window does not become active");
  return window;
}

void sendWheel(QWidget& widget, const QPoint& pixels, int degrees, Qt::KeyboardModifiers keys,
               Qt::ScrollPhase phase) {
  const QPoint at = widget.rect().center() + QPoint(40, 30);
  QWheelEvent event(at, widget.mapToGlobal(at), pixels, {0, degrees}, Qt::NoButton, keys, phase,
                    false);
  QCoreApplication::sendEvent(&widget, &event);
}

/// Nothing but the centre differs: a pan. The scale differs: a zoom.
enum class Moved { Not, Pan, Zoom };
Moved whatMoved(Viewport& viewport, const std::function<void()>& act) {
  const double scale = viewport.scale();
  const Vec2 centre = viewport.centre();
  act();
  if (viewport.scale() != scale) return Moved::Zoom;
  return viewport.centre() == centre ? Moved::Not : Moved::Pan;
}

}  // namespace

class ClassroomTest : public QObject {
  Q_OBJECT

 private slots:
  void fitsAScreenOf1280By800() {
    WindowDriver driver;
    const QSize least = driver.window().minimumSizeHint();
    QVERIFY2(least.width() <= 1280 && least.height() <= 800,
             qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
    QCOMPARE(driver.window().size(), QSize(1280, 800));
    // The canvas has the most of it.
    QVERIFY(driver.canvas().width() >= 840);
    QVERIFY(driver.canvas().height() >= 520);
  }

  void theProjectorTakesAndGivesBackTheWindow() {
    WindowDriver driver;
    MainWindow& window = driver.window();
    window.resize(1200, 780);
    driver.settle();
    driver.child<QDockWidget>("legend").close();
    const QRect geometry = window.geometry();
    const QStringList open = openDocks(window);
    const double font = QApplication::font().pointSizeF();
    QToolButton& leave = driver.child<QToolButton>("projector.leave");
    QVERIFY(!leave.isVisible());

    driver.canvasKey(Qt::Key_F11);
    QVERIFY(window.isFullScreen());
    QVERIFY(window.display().isProjector());
    QVERIFY(leave.isVisible());
    QVERIFY(leave.text().contains("Esc"));
    QVERIFY(QApplication::font().pointSizeF() > 1.5 * font);
    QCOMPARE(openDocks(window), QStringList{"legend"});

    driver.canvasKey(Qt::Key_Escape);
    QVERIFY(!window.isFullScreen());
    QVERIFY(!window.display().isProjector());
    QVERIFY(!leave.isVisible());
    QCOMPARE(QApplication::font().pointSizeF(), font);
    QCOMPARE(openDocks(window), open);
    QTRY_COMPARE(window.geometry(), geometry);
  }

  void escFirstTakesBackWhatIsUnderWayThenLeavesTheProjector() {
    WindowDriver driver;
    driver.canvasKey(Qt::Key_F11);
    const Vec2 before = driver.chain().points()[2];
    driver.press(driver.atPoint(2));
    driver.move(driver.atPoint(2) + QPoint(60, 40));
    QVERIFY(driver.chain().points()[2] != before);
    driver.canvasKey(Qt::Key_Escape);
    QCOMPARE(driver.chain().points()[2], before);
    QVERIFY(driver.window().display().isProjector());
    driver.release(driver.nowhere());
    driver.canvasKey(Qt::Key_Escape);
    if (driver.window().display().isProjector()) driver.canvasKey(Qt::Key_Escape);  // deselected
    QVERIFY(!driver.window().display().isProjector());
  }

  void theButtonLeavesTheProjectorToo() {
    WindowDriver driver;
    driver.canvasKey(Qt::Key_F11);
    QTest::mouseClick(&driver.child<QToolButton>("projector.leave"), Qt::LeftButton);
    driver.settle();
    QVERIFY(!driver.window().isFullScreen());
  }

  void theSizeIsOfTheModeAndIsRemembered() {
    QTemporaryDir folder;
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    {
      const auto window = openWindow(&settings);
      QTest::keyClick(&window->canvas(), Qt::Key_Plus, Qt::ControlModifier | Qt::AltModifier);
      QTest::keyClick(&window->canvas(), Qt::Key_Plus, Qt::ControlModifier | Qt::AltModifier);
      QCOMPARE(window->display().uiScale(), 1.2);
      QTest::keyClick(&window->canvas(), Qt::Key_F11);
      QCOMPARE(window->display().uiScale(), Display::kProjectorScale);
      for (int i = 0; i < 30; ++i) {
        QTest::keyClick(&window->canvas(), Qt::Key_Plus, Qt::ControlModifier | Qt::AltModifier);
      }
      QCOMPARE(window->display().uiScale(), Display::kLargestScale);
      window->display().setTheme(Display::Theme::Dark);
      window->display().setShows(MarkKind::Flat, true);
      window->close();
    }
    const auto window = openWindow(&settings);
    QVERIFY(!window->display().isProjector());
    QCOMPARE(window->display().uiScale(), 1.2);
    QCOMPARE(window->display().theme(), Display::Theme::Dark);
    QVERIFY(window->display().shows(MarkKind::Flat));
    window->display().setProjector(true);
    QCOMPARE(window->display().uiScale(), Display::kLargestScale);
  }

  void layoutsKeepTheirPanelsApart() {
    QTemporaryDir folder;
    QSettings settings(folder.filePath("s.ini"), QSettings::IniFormat);
    {
      const auto window = openWindow(&settings);
      const QStringList all = openDocks(*window);
      QVERIFY(all.size() >= 4);
      auto* bar = window->findChild<QToolBar*>("picture-bar");
      QVERIFY(bar && !bar->isVisible());
      window->findChild<QDockWidget*>("points")->close();
      QTest::keyClick(&window->canvas(), Qt::Key_2, Qt::ControlModifier);
      QVERIFY(openDocks(*window).isEmpty());
      QVERIFY(bar->isVisible());
      QVERIFY(bar->actions().contains(window->findChild<QAction*>("file.export")));
      // Its buttons are reached by the keyboard, each by its name.
      for (QAction* action : bar->actions()) {
        auto* button = bar->findChild<QWidget*>("picture-bar." + action->objectName());
        QVERIFY(button && button == bar->widgetForAction(action));
        QVERIFY(button->focusPolicy() & Qt::TabFocus);
        QCOMPARE(button->accessibleName(), action->toolTip());
      }
      window->docks().show("marks");
      QTest::keyClick(&window->canvas(), Qt::Key_1, Qt::ControlModifier);
      QVERIFY(!openDocks(*window).contains("points"));
      QVERIFY(openDocks(*window).contains("legend"));
      QVERIFY(!bar->isVisible());
      QTest::keyClick(&window->canvas(), Qt::Key_2, Qt::ControlModifier);
      QCOMPARE(openDocks(*window), QStringList{"marks"});
      window->close();
    }
    const auto window = openWindow(&settings);
    QVERIFY(window->layouts().current() == Layouts::Kind::Picture);
    QCOMPARE(openDocks(*window), QStringList{"marks"});
    window->layouts().use(Layouts::Kind::Work);
    QVERIFY(!openDocks(*window).contains("points"));
    window->findChild<QAction*>("view.restore-layout")->trigger();
    QVERIFY(openDocks(*window).contains("points"));
  }

  void damagedSettingsDoNoHarm() {
    QTemporaryDir folder;
    const QByteArray damages[] = {
        "\x00\xff\xfegarbage without any meaning \x01\x02",
        "[window]\ngeometry=@ByteArray(\\x1\\xd9\\xd0\\xcb nonsense)\nlayout=nowhere\n"
        "layout-work=@ByteArray(nonsense)\nlanguage=tlh\n[display]\nscale=many\n"
        "projector-scale=-7\ntheme=42\nridge=@Variant(\\0\\0\\0\\x7f)\n[export]\nformat=99\n"
        "scale=nan\ncolours=-3\n[files]\nrecent=@Invalid()\n"};
    for (const QByteArray& damage : damages) {
      QFile file(folder.filePath("s.ini"));
      QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
      file.write(damage);
      file.close();
      QSettings settings(file.fileName(), QSettings::IniFormat);
      QCOMPARE(chosenLanguage(settings), "system");
      const auto window = openWindow(&settings);
      QCOMPARE(window->display().uiScale(), 1.0);
      QVERIFY(window->display().theme() == Display::Theme::System);
      QVERIFY(openDocks(*window).contains("marks"));
      QVERIFY(window->canvas().width() > 400);
      window->display().setProjector(true);
      QVERIFY(window->display().uiScale() >= 1.0);
      window->display().setProjector(false);
      window->close();
      settings.remove("");
    }
  }

  void everythingGrowsInTheProjectorAndShrinksAgain() {
    WindowDriver driver;
    driver.window().resize(1280, 800);
    driver.settle();
    auto& table = driver.child<QTableView>("marks.table");
    auto& title = driver.child<QLabel>("dock.legend.title");
    const int row = table.rowHeight(0), letters = title.fontMetrics().height();
    const int height = title.height();
    driver.canvasKey(Qt::Key_F11);
    QVERIFY(title.fontMetrics().height() > 1.3 * letters);
    QVERIFY(title.height() > 1.3 * height);
    driver.canvasKey(Qt::Key_Escape);
    QVERIFY(!driver.window().display().isProjector());
    driver.settle();
    QCOMPARE(table.rowHeight(0), row);
    QCOMPARE(title.fontMetrics().height(), letters);
  }

  // On a wall of 1280 by 800 nothing needs scrolling sideways.
  void panelsAndKeySheetFitIntoTheProjector() {
    WindowDriver driver;
    driver.window().display().setProjector(true);
    driver.window().resize(1280, 800);
    for (const char* id : {"sweep", "study", "limits", "plots"}) {
      auto& dock = driver.child<QDockWidget>(id);
      dock.show();
      dock.raise();
      driver.window().resizeDocks({&dock}, {400}, Qt::Horizontal);
      driver.settle();
      const auto* area = qobject_cast<QScrollArea*>(dock.widget());
      QVERIFY2(area->horizontalScrollBar()->maximum() == 0, id);
    }
    driver.trigger("help.keys");
    auto* sheet = driver.window().findChild<QScrollArea*>("keys.sheet");
    QVERIFY(sheet && sheet->isVisible());
    QVERIFY(sheet->window()->width() <= 1280);
    QCOMPARE(sheet->horizontalScrollBar()->maximum(), 0);
    sheet->window()->close();
    driver.window().display().setProjector(false);
  }

  void aWheelZoomsAndTwoFingersPan() {
    WindowDriver driver;
    Viewport& viewport = driver.window().viewport();
    FlatCanvas& canvas = driver.canvas();
    const auto wheel = [&](Qt::KeyboardModifiers keys, Qt::ScrollPhase phase) {
      return whatMoved(viewport, [&] { sendWheel(canvas, {}, 120, keys, phase); });
    };
    QVERIFY(wheel({}, Qt::NoScrollPhase) == Moved::Zoom);
    QVERIFY(wheel({}, Qt::ScrollUpdate) == Moved::Pan);
    QVERIFY(wheel(Qt::ControlModifier, Qt::ScrollUpdate) == Moved::Zoom);
    QVERIFY(wheel(Qt::ControlModifier, Qt::NoScrollPhase) == Moved::Zoom);
    driver.trigger("view.wheel-zooms");  // off
    QVERIFY(wheel({}, Qt::NoScrollPhase) == Moved::Pan);
    QVERIFY(wheel(Qt::ControlModifier, Qt::NoScrollPhase) == Moved::Zoom);
    // What two fingers move goes with them, pixel for pixel.
    const QPointF place = viewport.toWidget(Vec2(0.5, 0.5));
    sendWheel(canvas, {7, -11}, -11, {}, Qt::ScrollUpdate);
    QCOMPARE(viewport.toWidget(Vec2(0.5, 0.5)), place + QPointF(7, -11));
  }

  void theWheelKeepsThePlaceUnderThePointer() {
    WindowDriver driver;
    Viewport& viewport = driver.window().viewport();
    const QPointF at = driver.canvas().rect().center() + QPoint(40, 30);
    const Vec2 world = viewport.toWorld(at);
    sendWheel(driver.canvas(), {}, 240, {}, Qt::NoScrollPhase);
    QVERIFY((viewport.toWorld(at) - world).norm() < 1e-12);
  }

  void marksGrowWithScaleAndWithLargeCanvases() {
    WindowDriver driver;
    Display& display = driver.window().display();
    const QSizeF usual(860, 540);
    const QSizeF large(1500, 900);
    QCOMPARE(drawnScale(display, usual), 1.0);
    QVERIFY(drawnScale(display, large) > 1.2);
    display.setUiScale(2.0);
    QCOMPARE(drawnScale(display, usual), 2.0);
    // The reach of the pointer grows as well: 15 px off a point still hits it.
    driver.settle();
    const QPoint at = driver.atPoint(1) + QPoint(-15, 0);
    QVERIFY(targetAt({driver.document(), driver.window().selection(), driver.window().viewport(),
                      display, driver.window().stage(), driver.window().probe()},
                     driver.canvas().size(), at)
                .what == Target::What::Point);
    display.setUiScale(1.0);
  }

  void themesReachCanvasAndIcons() {
    WindowDriver driver;
    Display& display = driver.window().display();
    const auto corner = [&] { return driver.canvas().grab().toImage().pixelColor(3, 3); };
    display.setTheme(Display::Theme::Light);
    driver.settle();
    QVERIFY(themePalette() == Palette::Light);
    QCOMPARE(corner(), QColor(Qt::white));
    const QImage icon =
        driver.child<QAbstractButton>("legend.inflection").icon().pixmap(16).toImage();
    display.setTheme(Display::Theme::Dark);
    driver.settle();
    QVERIFY(themePalette() == Palette::Dark);
    QCOMPARE(corner(), QColor(0x1E, 0x1E, 0x22));
    QVERIFY(driver.child<QAbstractButton>("legend.inflection").icon().pixmap(16).toImage() != icon);
    driver.trigger("view.theme.high-contrast");
    QVERIFY(themePalette() == Palette::HighContrast);
    QCOMPARE(corner(), QColor(Qt::black));
    driver.trigger("view.theme.system");
    QVERIFY(themePalette() == Palette::Light);
  }

  void theStatusLineTellsWhenRidgesAndValleysExchangeNames() {
    WindowDriver driver;
    // The chord of the first preset runs from (-1.3, -1.2) to (-1.5, 1.0): the view passes it near
    // 95 degrees.
    driver.trigger("view.from.0");
    driver.window().statusBar()->clearMessage();
    driver.document().push(std::make_unique<SetView>(driver.document(), View{80.0, std::nullopt}));
    QVERIFY(driver.window().statusBar()->currentMessage().isEmpty());
    driver.document().push(std::make_unique<SetView>(driver.document(), View{110.0, std::nullopt}));
    QVERIFY(driver.window().statusBar()->currentMessage().contains("exchange names"));
  }

  void theStatusLineSaysOneThingAtATimeAndNothingOfNoCurves() {
    WindowDriver driver;
    QStatusBar& bar = *driver.window().statusBar();
    const auto field = [&bar](const char* name) { return bar.findChild<QWidget*>(name); };
    // What is said while the bar is not there covers the hint all the same.
    bar.hide();
    bar.showMessage("said");
    bar.show();
    QVERIFY(!field("status.hint")->isVisible());
    bar.clearMessage();
    QVERIFY(field("status.hint")->isVisible());
    for (const char* name : {"status.view", "status.marks", "status.time"}) {
      QVERIFY(field(name)->isVisible());
    }
    Scene empty = driver.document().scene();
    empty.curves.clear();
    driver.document().start(empty, "empty");
    for (const char* name : {"status.view", "status.marks", "status.time"}) {
      QVERIFY(!field(name)->isVisible());
    }
  }

  void theFieldOfTheMarksListsWhatIsOpen() {
    WindowDriver driver;
    auto& field = driver.child<QToolButton>("status.marks");
    QVERIFY(field.text().contains("certified"));
    QMenu* places = field.menu();
    emit places->aboutToShow();
    QCOMPARE(places->actions().size(), 1);
    QVERIFY(!places->actions().front()->isEnabled());
    // A curve beyond what doubles can decide is listed as such.
    Scene scene = driver.scene();
    std::vector<Vec2> points = scene.curves[0].chain().points();
    for (Vec2& p : points) p *= 1e60;
    scene.curves[0].shape = BezierChain(Bezier{points});
    driver.document().start(scene, "far");
    driver.settle();
    QVERIFY2(field.text().contains("unresolved"), qPrintable(field.text()));
    emit places->aboutToShow();
    QVERIFY(places->actions().size() >= 1);
    QVERIFY(places->actions().front()->isEnabled());
    QVERIFY(places->actions().front()->text().contains("curve 0"));
  }

  void speaksGerman() {
    installLanguage("de");
    {
      WindowDriver driver;
      QCOMPARE(driver.child<QAction>("file.open").text(), "Ö&ffnen …");
      QCOMPARE(driver.child<QAbstractButton>("legend.silhouette").text(), "Silhouetten");
      QVERIFY(driver.canvas().accessibleDescription().contains("5 Kontrollpunkte"));
      // Every word that comes from the libraries is in the list.
      for (const Preset& preset : presets()) {
        QVERIFY2(coreWords(preset.description) != QString::fromStdString(preset.description),
                 preset.id.c_str());
      }
      for (const Family& family : families()) {
        for (const FamilyParameter& parameter : family.parameters) {
          QVERIFY2(coreWords(parameter.meaning) != QString::fromStdString(parameter.meaning),
                   parameter.meaning.c_str());
        }
      }
      // So are sentences with values in them.
      for (const auto& [english, german] :
           {std::pair{"degree 30 is above 25, the highest supported",
                      "Grad 30 liegt über 25, dem höchsten erlaubten"},
            {"\"q\" is not known: there is no such function",
             "\"q\" ist unbekannt: eine solche Funktion gibt es nicht"},
            {"expected a number, found a string", "erwartet: eine Zahl, gefunden: ein Text"},
            {"100% of %1 is strange", "100% of %1 is strange"}}) {
        QCOMPARE(coreWords(english), QString(german));
      }
      QFile broken(driver.path("broken.json"));
      QVERIFY(broken.open(QIODevice::WriteOnly));
      broken.write("{\"flatland\": 1, \"curves\": [{\"bezier\": [[0, \"x\"], [1, 0]]}]}");
      broken.close();
      driver.window().files().openFile(broken.fileName());
      const QString said = driver.child<QLabel>("message.text").text();
      QVERIFY2(said.endsWith("curves[0].bezier[0][1]: erwartet: eine Zahl, gefunden: ein Text"),
               qPrintable(said));
      driver.window().files().openFile(driver.path("none.json"));
      QVERIFY(driver.child<QLabel>("message.text").text().contains("ist nicht lesbar"));
      // So are the diagrams, and no panel needs scrolling sideways.
      driver.window().resize(1280, 800);
      for (const char* id : {"sweep", "study", "limits", "plots"}) {
        auto& dock = driver.child<QDockWidget>(id);
        dock.raise();
        driver.settle();
        const auto* area = qobject_cast<QScrollArea*>(dock.widget());
        QVERIFY(area && area->isVisible());
        QVERIFY2(area->horizontalScrollBar()->maximum() == 0, id);
      }
      auto& sweep = *driver.window().findChild<SweepPanel*>();
      driver.child<QDockWidget>("sweep").raise();
      QTRY_VERIFY(sweep.source().data() && !sweep.source().isStale());
      std::string words;
      for (const FigureGroup& group : sweep.view().figureForFile().groups) {
        for (const auto& shape : group.shapes) {
          if (const auto* text = std::get_if<TextShape>(&shape)) words += text->text + ";";
        }
      }
      for (const char* german :
           {"Bogenlänge", "Blickrichtung", "Wendepunkte", "Scheinbare Grate"}) {
        QVERIFY2(words.find(german) != std::string::npos, german);
      }
      for (const char* english : {"arc length", "view direction", "Inflection", "ridge"}) {
        QVERIFY2(words.find(english) == std::string::npos, english);
      }
      // So do the lessons.
      driver.trigger("lesson.shipped.silhouette");
      QCOMPARE(driver.child<QAction>("lesson.shipped.silhouette").text(),
               "Was ist eine Silhouette in Flatland (Arbeit, Abschnitt 3.1)");
      QCOMPARE(QString::fromStdString(driver.window().lesson().step().title),
               "Eine Welt mit zwei Dimensionen");
      driver.window().lesson().leave();
      // A number that is typed or shown has a point in every language.
      QVERIFY(driver.child<QWidget>("view.angle").property("text").toString().contains('.'));
    }
    installLanguage("en");
    WindowDriver driver;
    QCOMPARE(driver.child<QAction>("file.open").text(), "&Open…");
    driver.trigger("lesson.shipped.silhouette");
    QCOMPARE(QString::fromStdString(driver.window().lesson().step().title),
             "A world of two dimensions");
  }

  void remembersTheLanguageForTheNextStart() {
    WindowDriver driver;
    QCOMPARE(chosenLanguage(driver.settings()), "system");
    driver.trigger("view.language.de");
    QCOMPARE(chosenLanguage(driver.settings()), "de");
    QVERIFY(driver.window().statusBar()->currentMessage().contains("next"));
  }

  void pluralsAreRight() {
    installLanguage("en");
    WindowDriver driver;
    QVERIFY(driver.canvas().accessibleDescription().contains("1 curve,"));
  }
};

}  // namespace flatland::ui

QTEST_MAIN(flatland::ui::ClassroomTest)
#include "classroom_test.moc"
