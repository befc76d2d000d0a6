// SPDX-License-Identifier: GPL-3.0-or-later
// Several views of one surface: what each shows, as a model and in the real window by mouse and
// keys.
#include <Eigen/Geometry>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QSignalSpy>
#include <QTextBrowser>
#include <QToolButton>

#include "core3d/draw/draughtsman.h"
#include "tests/ui/support_window.h"
#include "ui/app/message_bar.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/export/figure_qt.h"
#include "ui/export/mark_style.h"
#include "ui/model/compare_presets.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/model/theme.h"
#include "ui/view3d/pick_marks.h"
#include "ui/view3d/surface_area.h"
#include "ui/view3d/surface_overlay.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

double lengthOf(const std::vector<LineSegment>& pieces) {
  double length = 0.0;
  for (const LineSegment& piece : pieces) length += (piece.b.at - piece.a.at).norm();
  return length;
}

std::size_t countOf(const SeenSource& source, LineFamily family) {
  return source.seen() ? source.seen()->lines[static_cast<std::size_t>(family)].size() : 0;
}

}  // namespace

class CompareTest : public QObject {
  Q_OBJECT

 private slots:
  void aPaneSaysOnlyWhatIsDifferent() {
    SurfaceSetting setting;
    setting.families.push_back(usualFamily(LineFamily::Ridges));
    setting.families.back().on = true;
    setting.families.back().threshold = 7.0;
    setting.panes.resize(2);
    QCOMPARE(paneCount(setting), std::size_t{3});
    QVERIFY(lineOptionsOf(paneSetting(setting, 1))[LineFamily::Ridges]);
    setting.panes[0].families = std::vector<std::string>{"valleys"};
    setting.panes[1].derivative = kOneRing;
    setting.panes[1].camera = seenFrom(setting.camera, StandardView::Right);
    const LineOptions first = lineOptionsOf(paneSetting(setting, 0));
    const LineOptions valleys = lineOptionsOf(paneSetting(setting, 1));
    QVERIFY(first[LineFamily::Ridges] && !first[LineFamily::Valleys]);
    QVERIFY(!valleys[LineFamily::Ridges] && valleys[LineFamily::Valleys]);
    QVERIFY(!valleys[LineFamily::OccludingContours]);
    QCOMPARE(valleys.thresholdOf(LineFamily::Ridges), 7.0);
    const PaneSetting elsewhere = paneSetting(setting, 2);
    QVERIFY(elsewhere.derivative == RidgeDerivative::OneRing);
    QVERIFY(elsewhere.ownCamera);
    QCOMPARE(elsewhere.camera.towards, Eigen::Vector3d(1, 0, 0));
    QCOMPARE(elsewhere.surface.camera.towards, setting.camera.towards);  // lines are found for it
    // A view that drew what the first draws gets a list of its own, the others stay.
    const SurfaceSetting edited = withFamilyOn(setting, 2, LineFamily::Creases, true);
    QVERIFY(lineOptionsOf(paneSetting(edited, 2))[LineFamily::Creases]);
    QVERIFY(lineOptionsOf(paneSetting(edited, 2))[LineFamily::Ridges]);
    QVERIFY(!lineOptionsOf(paneSetting(edited, 0))[LineFamily::Creases]);
    const SurfaceSetting none = withFamilyOn(setting, 1, LineFamily::Valleys, false);
    QVERIFY(none.panes[0].families && none.panes[0].families->empty());
  }

  void presetsShowWhatTheySay() {
    SurfaceSetting setting;
    setting.camera.zoom = 2.0;
    const SurfaceSetting four = withPreset(setting, ComparePreset::Families);
    QCOMPARE(paneCount(four), std::size_t{4});
    QVERIFY(!lineOptionsOf(paneSetting(four, 0))[LineFamily::ApparentRidges]);
    QVERIFY(lineOptionsOf(paneSetting(four, 1))[LineFamily::SuggestiveContours]);
    QVERIFY(lineOptionsOf(paneSetting(four, 2))[LineFamily::Valleys]);
    QVERIFY(lineOptionsOf(paneSetting(four, 3))[LineFamily::ApparentRidges]);
    QCOMPARE(paneCount(withPreset(four, ComparePreset::TwoViews)), std::size_t{2});
    QVERIFY(withPreset(four, ComparePreset::TwoViews).panes[0] == four.panes[0]);
    QCOMPARE(paneCount(withPreset(four, ComparePreset::OneView)), std::size_t{1});
    const SurfaceSetting two = withPreset(setting, ComparePreset::SecondCamera);
    QVERIFY(std::abs(paneCamera(two, 1).towards.dot(setting.camera.towards)) < 1e-12);
    QCOMPARE(paneCamera(two, 1).zoom, 2.0);
  }

  void oneViewHasTheLinesOfBefore() {
    open();
    const auto drawn = [this] {
      std::vector<bool> on;
      for (const LineFamily family : allLineFamilies()) {
        on.push_back(familyOf(*driver_->scene().surface, family).on);
      }
      return on;
    };
    driver_->document().push(std::make_unique<SetSurface>(
        driver_->document(),
        withFamilyOn(*driver_->scene().surface, 0, LineFamily::SuggestiveContours, true), "lines"));
    const auto before = drawn();
    for (const char* id : {"surface.compare.families", "surface.compare.two",
                           "surface.compare.derivatives", "surface.compare.difference"}) {
      driver_->trigger(id);
      QVERIFY(drawn() != before);
    }
    driver_->trigger("surface.compare.one");
    QVERIFY(drawn() == before);
    // What a person chose meanwhile stays.
    driver_->trigger("surface.compare.families");
    driver_->document().push(std::make_unique<SetSurface>(
        driver_->document(), withFamilyOn(*driver_->scene().surface, 0, LineFamily::Valleys, true),
        "lines"));
    const auto chosen = drawn();
    driver_->trigger("surface.compare.one");
    QVERIFY(drawn() == chosen);
  }

  void oneHandMovesAllViews() {
    open();
    driver_->trigger("surface.compare.two");
    QVERIFY(quiet());
    QVERIFY(canvas(1) && canvas(1)->isVisible() && !canvas(2));
    QVERIFY(canvas(0)->width() > 100 && canvas(1)->width() > 100);
    const SurfaceCamera start = camera();
    drag(1, {60, 60}, {110, 60});
    QVERIFY((camera().towards - start.towards).norm() > 0.1);
    QVERIFY(quiet());
    for (const std::size_t pane : {0, 1}) {
      QVERIFY((views().seen(pane).seen()->view.towards - camera().towards).norm() < 1e-12);
    }
    driver_->trigger("edit.undo");
    QVERIFY(!canvas(1));
    QVERIFY(!views().seen(1).seen());
  }

  void familiesAreThoseOfTheActiveView() {
    open();
    driver_->trigger("surface.compare.two");
    QVERIFY(quiet());
    auto& ridges = driver_->child<QAbstractButton>("families.ridges.on");
    QVERIFY(!ridges.isChecked());
    QTest::mouseClick(canvas(1), Qt::LeftButton, {}, {3, 40});
    QCOMPARE(views().active(), std::size_t{1});
    QTest::mouseClick(&ridges, Qt::LeftButton, {}, {8, ridges.height() / 2});
    QVERIFY(quiet());
    QCOMPARE(countOf(views().seen(0), LineFamily::Ridges), std::size_t{0});
    QVERIFY(countOf(views().seen(1), LineFamily::Ridges) > 0);
    QTest::mouseClick(canvas(0), Qt::LeftButton, {}, {3, 40});
    QVERIFY(!ridges.isChecked());
    // The same by the row above the view, with the keys alone.
    auto& title = driver_->child<QToolButton>("surface.pane.1.menu");
    QVERIFY(title.accessibleName().contains("Ridges"));
    whenPopup([](QMenu& menu) {
      for (int i = 0; i < 40 && (!menu.activeAction() ||
                                 menu.activeAction()->objectName() != "pane.family.valleys");
           ++i) {
        QTest::keyClick(&menu, Qt::Key_Down);
      }
      QTest::keyClick(&menu, Qt::Key_Return);
    });
    title.setFocus();
    QTest::keyClick(&title, Qt::Key_Space);
    QVERIFY(quiet());
    QVERIFY(countOf(views().seen(1), LineFamily::Valleys) > 0);
    QCOMPARE(countOf(views().seen(0), LineFamily::Valleys), std::size_t{0});
  }

  void aSecondCameraMovesAlone() {
    open();
    driver_->trigger("surface.compare.camera");
    QVERIFY(quiet());
    const SurfaceCamera first = camera(), second = camera(1);
    // It begins at the right hand of the first.
    QVERIFY(second.towards.dot(first.up.cross(first.towards)) > 0.9);
    const int searches = views().seen(0).searches();
    drag(1, {60, 60}, {110, 60});
    QVERIFY((camera(1).towards - second.towards).norm() > 0.1);
    QVERIFY(camera() == first);
    QVERIFY(quiet());
    // It looks at the lines of the first: nothing was looked for.
    QCOMPARE(views().seen(0).searches(), searches);
    QVERIFY(views().seen(1).seen() == views().seen(0).seen());
    const SurfaceCamera moved = camera(1);
    drag(0, {60, 60}, {110, 60});
    QVERIFY((camera().towards - first.towards).norm() > 0.1);
    QVERIFY(camera(1) == moved);
    QVERIFY(quiet());
    QVERIFY(views().seen(1).seen() == views().seen(0).seen());
    QVERIFY((views().seen(1).seen()->view.towards - camera().towards).norm() < 1e-12);
    // Looking is no edit, in either view.
    const int steps = driver_->document().undoStack().count();
    driver_->trigger("edit.undo");
    QVERIFY(!canvas(1));
    driver_->trigger("edit.redo");
    QCOMPARE(driver_->document().undoStack().count(), steps);
    QVERIFY(camera(1) == moved);
  }

  void aSecondCameraIsKeptAndUsedWhereItIs() {
    open();
    driver_->trigger("surface.compare.camera");
    driver_->window().docks().show("surface");
    QVERIFY(quiet());
    QTest::mouseClick(canvas(1), Qt::LeftButton, {}, {3, 40});
    QCOMPARE(views().active(), std::size_t{1});
    const SurfaceCamera first = camera(), second = camera(1);
    QVERIFY(!(first == second));
    QTest::mouseClick(&driver_->child<QAbstractButton>("surface.camera.keep"), Qt::LeftButton);
    QCOMPARE(driver_->scene().surface->savedCameras.size(), std::size_t{1});
    QVERIFY(driver_->scene().surface->savedCameras[0].camera == second);
    drag(1, {60, 60}, {110, 60});
    QVERIFY(!(camera(1) == second));
    auto& list = driver_->child<QListWidget>("surface.cameras");
    const QPoint at = list.visualItemRect(list.item(0)).center();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, at);
    QVERIFY(camera(1) == second);
    QVERIFY(camera() == first);
  }

  void aFailureIsToldOnce() {
    open();
    QSignalSpy again(&driver_->window().surfaceArea(), &SurfaceArea::failed);
    emit views().failed("no memory");
    QCOMPARE(driver_->child<MessageBar>("message").text(), QString("no memory"));
    QCOMPARE(again.count(), 0);
  }

  void aSecondCameraTellsOfTheFirst() {
    open();
    // With one camera nobody has to say whose numbers they are.
    QMouseEvent over(QEvent::MouseMove, middleOf(0), canvas(0)->mapToGlobal(middleOf(0)),
                     Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(canvas(0), &over);
    QTRY_VERIFY(overlay(0).reading() && overlay(0).reading()->terms);
    QVERIFY(!overlay(0).readingLines().join('\n').contains("view 1"));
    driver_->trigger("surface.compare.camera");
    QVERIFY(quiet());
    driver_->window().docks().show("surface-derivation");
    driver_->settle();
    // What a click in the second view picks is the vertex that the pointer reads there.
    QTest::mouseClick(canvas(1), Qt::LeftButton, {}, middleOf(1));
    const SurfaceModels models = driver_->window().surfaceModels();
    QVERIFY(models.pick.hit());
    QMouseEvent again(QEvent::MouseMove, middleOf(1), canvas(1)->mapToGlobal(middleOf(1)),
                      Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(canvas(1), &again);
    QTRY_VERIFY(overlay(1).reading() && overlay(1).reading()->terms);
    const SurfaceReading& reading = *overlay(1).reading();
    const std::uint32_t vertex = models.pick.vertex();
    QCOMPARE(reading.vertex, vertex);
    const LoadedSurface& surface = *models.source.surface();
    const auto termsFrom = [&](const SurfaceCamera& from) {
      const SurfaceView view = orbitProjection(from, surface.ballRadius, 50, 80).view();
      return *termsAt(*surface.mesh, *surface.fields, view, vertex);
    };
    const SurfaceTerms first = termsFrom(camera(0)), second = termsFrom(camera(1));
    QVERIFY(std::abs(first.nw - second.nw) > 0.05);
    QCOMPARE(reading.terms->nw, first.nw);
    QCOMPARE(*reading.terms->lambda, *first.lambda);
    QCOMPARE(reading.terms->feature, first.feature);
    QCOMPARE(reading.terms->offset, first.offset);
    // The panel has the same numbers, and both say whose they are.
    const QString words = overlay(1).readingLines().join('\n');
    QVERIFY2(words.contains("As view 1 sees it"), qPrintable(words));
    const QString panel = driver_->child<QTextBrowser>("derivation.text").toPlainText();
    QVERIFY2(panel.contains("As view 1 sees it"), qPrintable(panel.left(200)));
    QVERIFY2(panel.contains(QString::number(*first.lambda, 'g', 4)), qPrintable(panel.left(600)));
    // The arrows: t_A on the screen of the first view, and what it is the picture of from
    // elsewhere.
    QVERIFY(arrowPoints(models, 0, first.r));
    QVERIFY(arrowPoints(models.of(1), 1, first.r));
    QVERIFY(!arrowPoints(models.of(1), 1, second.r));
    QVERIFY(models.study.place());
    QVERIFY(!overlay(1).readingLines().filter("perspective").size());
  }

  void anotherMeshIsFramedAnewInEveryView() {
    open();
    driver_->trigger("surface.compare.camera");
    QVERIFY(quiet());
    drag(0, {60, 60}, {110, 90});
    drag(1, {60, 60}, {90, 140});
    QTest::keyClick(canvas(1), Qt::Key_Plus);
    const SurfaceCamera moved = camera(1);
    driver_->window().surfaces().openSolid("torus:24");
    QVERIFY(quiet());
    const SurfaceCamera home = homeCamera(Eigen::Vector3d::UnitY());
    QVERIFY(camera(0) == home);
    QCOMPARE(camera(1).zoom, home.zoom);
    QVERIFY(camera(1).centre == home.centre);
    QVERIFY(std::abs(camera(1).towards.dot(home.towards)) < 1e-9);  // from the side
    // The old mesh is seen again as it was.
    driver_->trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(camera(1) == moved);
    // A curve that is swept is another surface, and so is the next way of sweeping.
    driver_->trigger("surface.extrude");
    QVERIFY(quiet());
    QVERIFY(!(camera(1) == moved));
    const SurfaceCamera extruded = camera(1);
    drag(1, {60, 60}, {90, 140});
    driver_->trigger("surface.extrude");
    QVERIFY(quiet());
    QVERIFY(camera(1) == extruded);
  }

  void neighboursGiveOtherApparentRidges() {
    open();
    driver_->trigger("surface.compare.derivatives");
    QVERIFY(quiet());
    const std::size_t closed = countOf(views().seen(0), LineFamily::ApparentRidges);
    const std::size_t ring = countOf(views().seen(1), LineFamily::ApparentRidges);
    QVERIFY(closed > 0 && ring > 0 && closed != ring);
    QCOMPARE(countOf(views().seen(0), LineFamily::OccludingContours),
             countOf(views().seen(1), LineFamily::OccludingContours));
  }

  void aDifferenceIsCountedAndNamed() {
    open();
    driver_->trigger("surface.compare.difference");
    QVERIFY(quiet());
    QVERIFY(!views().seen(0).seen()->difference);
    const auto& difference = views().seen(1).seen()->difference;
    QVERIFY(difference);
    // Every piece of the view's own lines is in one of two parts, and the lengths say the share.
    const std::size_t own = countOf(views().seen(1), LineFamily::ApparentRidges) / 2;
    const auto& pieces = difference->pieces;
    QCOMPARE(pieces[SeenDifference::Common].size() + pieces[SeenDifference::Added].size(), own);
    QVERIFY(difference->addedShare + difference->missingShare > 0.0);
    QVERIFY(difference->addedShare < 0.5);
    QVERIFY(difference->missingShare < 0.5);
    QVERIFY(difference->tolerance > 0.0);
    QCOMPARE(driver_->window().surfaceArea().overlay(1)->differenceWords().size(), 3);
    QVERIFY(driver_->window().surfaceArea().overlay(0)->differenceWords().isEmpty());
    // From other families everything is another line.
    SurfaceSetting other = *driver_->scene().surface;
    other.panes[0].families = std::vector<std::string>{"parabolic"};
    other.panes[0].derivative = kClosedForm;
    driver_->document().push(std::make_unique<SetSurface>(driver_->document(), other, "edit"));
    QVERIFY(quiet());
    QVERIFY(views().seen(1).seen()->difference->missingShare > 0.5);
    QVERIFY(views().seen(1).seen()->difference->addedShare > 0.5);
    // With a family more something is added and nothing missing, with one less the reverse.
    const auto differenceWith = [&](const std::vector<std::string>& families) {
      other.panes[0].families = families;
      driver_->document().push(std::make_unique<SetSurface>(driver_->document(), other, "edit"));
      return quiet() ? views().seen(1).seen()->difference : std::nullopt;
    };
    const auto more =
        differenceWith({"occluding-contours", "boundaries", "apparent-ridges", "parabolic"});
    QVERIFY(more);
    const auto share = [](const SeenDifference& d, SeenDifference::Part part) {
      return lengthOf(d.pieces[part]) /
             (lengthOf(d.pieces[part]) + lengthOf(d.pieces[SeenDifference::Common]));
    };
    QCOMPARE(more->missingShare, 0.0);
    QVERIFY(more->addedShare > 0.1);
    QVERIFY(std::abs(more->addedShare - share(*more, SeenDifference::Added)) < 1e-3);
    const auto less = differenceWith({"occluding-contours", "boundaries"});
    QVERIFY(less);
    QCOMPARE(less->addedShare, 0.0);
    QVERIFY(less->missingShare > 0.1);
    // The first view against itself: it is one search, and nothing differs.
    other.panes[0].families.reset();
    driver_->document().push(std::make_unique<SetSurface>(driver_->document(), other, "edit"));
    QVERIFY(quiet());
    QCOMPARE(views().seen(1).seen()->difference->missingShare, 0.0);
    QCOMPARE(views().seen(1).seen()->difference->addedShare, 0.0);
  }

  void equalInkIsThatOfTheCommandLine() {
    open();
    driver_->trigger("surface.compare.families");
    QVERIFY(quiet());
    QTest::mouseClick(&driver_->child<QAbstractButton>("families.ink"), Qt::LeftButton, {}, {8, 8});
    QVERIFY(quiet());
    // What there is of lines must be more. Where it is not, the panel says so, and how much it is.
    const auto& missed = driver_->child<QLabel>("families.ink.missed");
    const auto reached = [this](std::size_t pane) { return views().ink().of(pane)->reached; };
    QVERIFY(!reached(0) && views().ink().of(0)->share < 0.04);
    QVERIFY(!missed.isHidden());
    const QString share = QString::number(100.0 * views().ink().of(0)->share, 'f', 1);
    QVERIFY2(missed.text().startsWith("View 1: All lines of these families give " + share),
             qPrintable(missed.text() + " " + share));
    driver_->child<QDoubleSpinBox>("families.ink.share").setValue(1.0);
    QVERIFY(quiet());
    QCOMPARE(driver_->scene().surface->ink, std::optional(0.01));
    QCOMPARE(missed.isHidden(), reached(0) && reached(1) && reached(2) && reached(3));
    const SurfaceModels models = driver_->window().surfaceModels();
    const LoadedSurface& surface = *models.source.surface();
    Draughtsman draughtsman(*surface.mesh, *surface.fields);
    StrokeOptions strokes;
    strokes.ink = driver_->scene().surface->ink;
    for (std::size_t pane = 0; pane < 4; ++pane) {
      const PaneInk* ink = views().ink().of(pane);
      QVERIFY(ink);
      const PaneSetting asked = paneSetting(*driver_->scene().surface, pane);
      const Camera camera = drawingCamera(asked.surface.camera, 800, 600);
      const Drawing drawing =
          draughtsman.draw(projectionOf(camera, *surface.mesh), lineOptionsOf(asked), strokes);
      QCOMPARE(ink->factor, drawing.stats.thresholdFactor);
      QCOMPARE(ink->share, drawing.stats.ink);
      // The lines that are seen are those above the thresholds found.
      const double least = ink->factor * *usualFamily(LineFamily::ApparentRidges).threshold;
      QCOMPARE(*familyOf(models.of(pane).setting().surface, LineFamily::ApparentRidges).threshold,
               least);
    }
    QVERIFY2(views().ink().of(1)->factor != views().ink().of(3)->factor,
             qPrintable(QString::number(views().ink().of(1)->factor)));
    QVERIFY(driver_->window().surfaceArea().overlay(3)->timeLines().size() == 4);
    // Solved again when the camera has come to rest, once.
    const int before = views().ink().solutions();
    drag(0, {60, 60}, {110, 60});
    QVERIFY(quiet());
    QCOMPARE(views().ink().solutions(), before + 1);
    driver_->trigger("edit.undo");
    driver_->trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(!views().ink().of(0));
  }

  void cleanup() { driver_.reset(); }

 private:
  SurfaceViews& views() { return driver_->window().surfaceModels().views; }
  QWidget* canvas(std::size_t pane) { return driver_->window().surfaceArea().canvas(pane); }
  SurfaceOverlay& overlay(std::size_t pane) {
    return *driver_->window().surfaceArea().overlay(pane);
  }
  QPoint middleOf(std::size_t pane) { return canvas(pane)->rect().center(); }
  /// True if the arrow of t_A points where a direction on the surface is seen in a view.
  bool arrowPoints(const SurfaceModels& models, std::size_t pane, const Eigen::Vector3d& along) {
    constexpr int kSide = 400;
    const Projection projection =
        orbitProjection(camera(pane), models.source.surface()->ballRadius, kSide, kSide);
    QImage image(kSide, kSide, QImage::Format_RGB32);
    image.fill(Qt::white);
    {
      QPainter painter(&image);
      painter.setBackground(Qt::white);
      paintPick(painter, models, projection);
    }
    const Eigen::Vector3d at = models.pick.hit()->at;
    const Eigen::Vector2d from = *projection.toScreen(at);
    const Eigen::Vector2d to = *projection.toScreen(at + 1e-3 * along) - from;
    // Its length is that of a direction on the screen (46 px), or on the surface.
    const double length = pane == 0
                              ? 46.0
                              : 0.22 * models.source.surface()->fields->size *
                                    (*projection.toScreen(at + along.normalized()) - from).norm();
    const QColor ink = toQColor(styleOf(MarkKind::ApparentRidge, themePalette()).colour);
    for (double share = 0.3; share < 0.7; share += 0.1) {
      const Eigen::Vector2d p = from + share * length * to.normalized();
      // Smooth edges mix it with the ground; nothing else there has so little blue beside red.
      const QColor seen = image.pixelColor(qFloor(p.x()), qFloor(p.y()));
      if (std::abs(seen.red() - ink.red()) > 40 || std::abs(seen.blue() - ink.blue()) > 60) {
        return false;
      }
    }
    return true;
  }
  const SurfaceCamera& camera(std::size_t pane = 0) {
    return paneCamera(*driver_->scene().surface, pane);
  }
  void open(const char* name = "bumpy-sphere:30") {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    driver_->window().surfaces().openSolid(name);
    QVERIFY(quiet());
    QVERIFY(driver_->scene().surface.has_value());
    driver_->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&driver_->window()));
  }
  bool quiet() { return driver_->surfaceQuiet(); }
  void drag(std::size_t pane, const QPoint& from, const QPoint& to) {
    QWidget& on = *canvas(pane);
    QTest::mousePress(&on, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 4; ++i) {
      const QPoint p = from + (to - from) * i / 4;
      QMouseEvent event(QEvent::MouseMove, p, on.mapToGlobal(p), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(&on, &event);
    }
    QTest::mouseRelease(&on, Qt::LeftButton, {}, to);
    driver_->settle();
  }
  /// Waits for the menu that the next action opens, and deals with it once.
  template <class Deal>
  void whenPopup(Deal deal) {
    auto* timer = new QTimer(qApp);
    timer->setInterval(20);
    QObject::connect(timer, &QTimer::timeout, timer, [timer, deal] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (!menu) return;
      timer->stop();
      timer->deleteLater();
      deal(*menu);
    });
    timer->start();
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(CompareTest)
#include "compare_test.moc"
