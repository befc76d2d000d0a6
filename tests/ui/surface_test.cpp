// SPDX-License-Identifier: GPL-3.0-or-later
// The surface in the real window, by mouse and keys. FLATLAND_DATA names the example meshes.
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QWheelEvent>

#include "flatland/io/scene_json.h"
#include "tests/ui/support_meshes.h"
#include "tests/ui/support_window.h"
#include "ui/app/layouts.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_area.h"
#include "ui/view3d/surface_overlay.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kPatienceMs = 60000;

/// Somewhere on the picture there is more than the background.
bool hasPicture(const QImage& image) {
  const QRgb corner = image.pixel(2, image.height() / 2);
  int others = 0;
  for (int y = 0; y < image.height(); y += 4) {
    for (int x = 0; x < image.width(); x += 4) others += image.pixel(x, y) != corner;
  }
  return others > 500;
}

}  // namespace

class SurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  void aMeshComesByTheOpenDialog() {
    NEEDS_DATA_MESH(mesh, "spot_quads.obj");
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    typeFileName(mesh);
    d.canvasKey(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(quiet());
    QCOMPARE(QString::fromStdString(d.scene().surface->mesh), mesh);
    QVERIFY(d.scene().curves == before.curves);
    QCOMPARE(d.document().undoStack().count(), 1);
    QVERIFY(d.window().layouts().current() == Layouts::Kind::Surface);
    QVERIFY(d.window().surfaceArea().isVisible());
    QVERIFY(d.canvas().isVisible());
    QVERIFY(hasPicture(surface().grab().toImage()));
    QVERIFY(d.window().files().recentFiles().contains(mesh));
    // The next one of the folder and back.
    d.trigger("surface.next");
    QVERIFY(quiet());
    QVERIFY(QString::fromStdString(d.scene().surface->mesh).endsWith("sword_quads.obj"));
    d.trigger("surface.previous");
    QVERIFY(quiet());
    QCOMPARE(QString::fromStdString(d.scene().surface->mesh), mesh);
  }

  void aSolidComesByTheMenu() {
    driver_->trigger("surface.solid.torus");
    QVERIFY(quiet());
    QCOMPARE(driver_->scene().surface->mesh, std::string("solid:torus"));
    QVERIFY(hasPicture(surface().grab().toImage()));
  }

  /// A window that is made anew is gone for a moment, and may come back elsewhere.
  void theWindowStaysTheSameWithItsFirstSurface() {
    const WId before = driver_->window().winId();
    EventCounter hidden(driver_->window(), QEvent::Hide);
    driver_->trigger("surface.solid.torus");
    QVERIFY(quiet());
    QCOMPARE(driver_->window().winId(), before);
    QCOMPARE(hidden.count(), 0);
  }

  void lookingAtMeshesIsNoReasonToSave() {
    WindowDriver& d = *driver_;
    openSolid("torus:20");
    openSolid("sphere:20");
    QVERIFY(d.window().windowTitle().startsWith("sphere:20[*]"));
    QVERIFY(!d.window().isWindowModified());
    // Back at the scene there was at first, nothing would be lost either.
    d.document().undoStack().undo();
    d.document().undoStack().undo();
    QVERIFY(d.window().windowTitle().startsWith("preset[*]"));
    QVERIFY(!d.window().isWindowModified());
    // An edit is one, and stays one under the next mesh.
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(33, 17));
    QVERIFY(d.window().isWindowModified());
    openSolid("torus:20");
    QVERIFY(d.window().isWindowModified());
    // A scene with a file has another surface then.
    QVERIFY(d.window().files().saveTo(d.path("mine.json")));
    QVERIFY(d.window().windowTitle().startsWith(QStringLiteral("mine.json – torus:20[*]")));
    QVERIFY(!d.window().isWindowModified());
    openSolid("sphere:20");
    QVERIFY(d.window().isWindowModified());
  }

  void openingTheSameMeshAgainSavesNoEdit() {
    WindowDriver& d = *driver_;
    openSolid("torus:20");
    QVERIFY(!d.window().isWindowModified());
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(15, 17));
    QVERIFY(d.window().isWindowModified());
    openSolid("torus:20");
    QVERIFY(d.window().isWindowModified());
  }

  void projectorAndPictureLayoutShowTheSurface() {
    WindowDriver& d = *driver_;
    d.canvasKey(Qt::Key_F11);
    QVERIFY(!d.window().surfaceArea().isVisible());
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    QVERIFY(d.window().layouts().current() == Layouts::Kind::Projector);
    QVERIFY(d.window().surfaceArea().isVisible());
    QVERIFY(hasPicture(surface().grab().toImage()));
    QVERIFY(d.canvas().isVisible());
    d.window().layouts().use(Layouts::Kind::Picture);
    QVERIFY(d.window().surfaceArea().isVisible());
    d.window().layouts().use(Layouts::Kind::Work);
    QVERIFY(!d.window().surfaceArea().isVisible());
    // Where there are no curves there is no empty canvas, unless it would be all.
    d.window().layouts().use(Layouts::Kind::Surface);
    Scene bare = d.scene();
    bare.curves.clear();
    d.document().push(std::make_unique<ReplaceScene>(d.document(), bare, "bare"));
    QVERIFY(!d.canvas().isVisible());
    d.window().layouts().use(Layouts::Kind::Work);
    QVERIFY(d.canvas().isVisible());
  }

  void theCurvesLeaveTheirPlaceToTheSurface() {
    WindowDriver& d = *driver_;
    d.trigger("view.flat-beside");
    QVERIFY(d.canvas().isVisible());  // there is no surface to leave it to
    openSolid("torus:20");
    QVERIFY(!d.canvas().isVisible());
    const int wide = surface().width();
    for (const auto kind : {Layouts::Kind::Picture, Layouts::Kind::Projector}) {
      d.window().layouts().use(kind);
      QVERIFY(surface().isVisible() && !d.canvas().isVisible());
    }
    d.window().layouts().use(Layouts::Kind::Work);
    QVERIFY(d.canvas().isVisible());
    d.window().layouts().use(Layouts::Kind::Surface);
    d.window().layouts().save(d.settings());
    QVERIFY(!d.settings().value("window/flat-beside").toBool());
    d.trigger("view.flat-beside");
    QVERIFY(d.canvas().isVisible());
    d.settle();
    QVERIFY(surface().width() < wide);
    d.window().layouts().restore(d.settings());
    QVERIFY(!d.canvas().isVisible());
    QVERIFY(!d.child<QAction>("view.flat-beside").isChecked());
  }

  void aClassSeesNoTimes() {
    openSolid("torus:20");
    const SurfaceOverlay& words = *driver_->window().surfaceArea().overlay();
    QVERIFY(words.timeLines().join(' ').contains("Frame"));
    driver_->window().layouts().use(Layouts::Kind::Projector);
    QVERIFY(words.timeLines().isEmpty());
  }

  void thePanelOfLinesFitsItsDock() {
    WindowDriver& d = *driver_;
    d.window().resize(1280, 800);
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    auto& width = d.child<QDoubleSpinBox>("families.apparent-ridges.width");
    auto& slider = d.child<QSlider>("families.apparent-ridges.slider");
    auto& creases = d.child<QDoubleSpinBox>("families.creases.threshold");
    const auto fits = [&] {
      d.window().docks().show("families");
      d.settle();
      const QWidget* panel = d.window().findChild<QWidget*>("families-panel");
      for (const auto* field : {&width, &creases}) {
        if (!field->isVisible()) continue;
        // A text edit keeps 2 px beside its text.
        const auto* edit = field->findChild<QLineEdit*>();
        if (edit->contentsRect().width() <
            edit->fontMetrics().horizontalAdvance(edit->text()) + 4) {
          return false;
        }
      }
      return panel->width() <= panel->parentWidget()->width();
    };
    QVERIFY(fits());
    QVERIFY(width.isVisible() && slider.isVisible());
    d.canvasKey(Qt::Key_F11);
    QVERIFY(fits());
    QVERIFY(creases.isVisible());
    // Every name is whole and every slider has room, also beside a bar that scrolls the rest.
    const auto& area = d.child<QScrollArea>("families-panel.scroll");
    for (const QCheckBox* name : d.child<QWidget>("families-panel").findChildren<QCheckBox*>()) {
      if (name->isVisible()) QVERIFY(name->width() >= name->minimumSizeHint().width());
    }
    QVERIFY(slider.isVisible() && slider.width() > 300);
    QCOMPARE(area.horizontalScrollBar()->maximum(), 0);
    d.canvasKey(Qt::Key_F11);
    QVERIFY(fits());
    QVERIFY(slider.isVisible() && slider.width() > 300);
  }

  void sliderStepsAreFineAndTheWheelScrollsWhatScrolls() {
    WindowDriver& d = *driver_;
    d.window().resize(1280, 800);
    openSolid("torus:20");
    auto& slider = d.child<QSlider>("families.apparent-ridges.slider");
    const auto threshold = [&] {
      return *familyOf(*d.scene().surface, LineFamily::ApparentRidges).threshold;
    };
    const double usual = threshold();
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_Left);
    QVERIFY(threshold() < usual && threshold() > 0.95 * usual);
    QTest::keyClick(&slider, Qt::Key_Right);
    QVERIFY(std::abs(threshold() / usual - 1.0) < 0.02);
    // A hand's breadth is not the whole range.
    const QPoint knob(slider.width() * slider.value() / slider.maximum(), slider.height() / 2);
    QTest::mousePress(&slider, Qt::LeftButton, {}, knob);
    const QPoint to = knob - QPoint(20, 0);
    QMouseEvent move(QEvent::MouseMove, to, slider.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     {});
    QCoreApplication::sendEvent(&slider, &move);
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, to);
    QVERIFY2(threshold() > 0.4 * usual && threshold() < 0.9 * usual,
             qPrintable(QString::number(threshold())));
    // The next mesh has the same size, so it keeps what was chosen.
    const double chosen = threshold();
    openSolid("gaussian-bump");
    QCOMPARE(threshold(), chosen);
    // The wheel.
    const auto turn = [&slider](int degrees) {
      const QPointF at(slider.rect().center());
      QWheelEvent event(at, slider.mapToGlobal(at), {}, {0, 8 * degrees}, Qt::NoButton, {},
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(&slider, &event);
      return event.isAccepted();  // else it goes on to what scrolls
    };
    slider.setFocus();
    QVERIFY(turn(15));
    QVERIFY(threshold() > chosen);
    d.canvasKey(Qt::Key_F11);
    d.settle();
    const auto& bar = *d.child<QScrollArea>("families-panel.scroll").verticalScrollBar();
    QVERIFY(bar.maximum() > 0);
    d.canvas().setFocus();
    const double before = threshold();
    QVERIFY(!turn(-30));
    QCOMPARE(threshold(), before);
    slider.setFocus();
    QVERIFY(turn(-30));
    QVERIFY(threshold() < before);
    d.canvasKey(Qt::Key_F11);
  }

  void aSurfaceThatIsClosedLeavesItsRoomToTheCurves() {
    WindowDriver& d = *driver_;
    openSolid("torus:20");
    QVERIFY(d.window().surfaceArea().isVisible());
    d.trigger("surface.close");
    QVERIFY(quiet());
    QVERIFY(!d.window().surfaceArea().isVisible() && d.canvas().isVisible());
    QCOMPARE(d.window().layouts().current(), Layouts::Kind::Work);
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(d.window().surfaceArea().isVisible());
    QCOMPARE(d.window().layouts().current(), Layouts::Kind::Surface);
    // So in its own layout, where panels made or unmade it.
    d.trigger("edit.redo");
    QVERIFY(quiet());
    QVERIFY(!d.window().surfaceArea().isVisible() && d.canvas().isVisible());
    // Who asks for its place gets it, with what to do there.
    d.trigger("view.layout.surface");
    d.settle();
    QVERIFY(d.window().surfaceArea().isVisible());
    auto& open = d.child<QPushButton>("surface.empty.open");
    QVERIFY(open.isVisible());
    bool asked = false;
    whenModal([&](QWidget& dialog) {
      asked = true;
      static_cast<QDialog&>(dialog).reject();
    });
    QTest::mouseClick(&open, Qt::LeftButton);
    QVERIFY(asked);
    openSolid("torus:20");
    QVERIFY(!open.isVisible());
  }

  void whatMayLieDownIsAskedOnce() {
    WindowDriver& d = *driver_;
    QSignalSpy said(&d.window().surfaces(), &SurfaceController::said);
    // A tetrahedron whose longest side is along the axis at that place.
    const auto openLongAlong = [&](int axis) {
      QFile file(d.path("long.obj"));
      QVERIFY(file.open(QIODevice::WriteOnly));
      for (int corner = 0; corner < 4; ++corner) {
        file.write("v");
        for (int i = 0; i < 3; ++i) {
          file.write(corner == i + 1 ? (i == axis ? " 3" : " 1") : " 0");
        }
        file.write("\n");
      }
      file.write("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
      file.close();
      d.window().surfaces().openFile(d.path("long.obj"));
      QVERIFY(quiet());
    };
    openLongAlong(2);
    QCOMPARE(said.count(), 1);
    QVERIFY(said.takeFirst().front().toString().contains("Up Axis"));
    d.trigger("surface.up.z");
    QVERIFY(quiet());
    QCOMPARE(said.count(), 0);
    d.trigger("surface.up.y");
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    openLongAlong(1);
    QCOMPARE(said.count(), 0);
    // So is what comes with a scene.
    Scene scene = d.scene();
    openLongAlong(2);
    scene.surface = d.scene().surface;
    said.clear();
    const std::string file = d.path("scene.json").toStdString();
    saveScene(scene, file);
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    QVERIFY(d.window().files().saveTo(d.path("other.json")));
    d.window().files().openFile(d.path("scene.json"));
    QVERIFY(quiet());
    QCOMPARE(said.count(), 1);
  }

  void aBadMeshIsToldInTheOnePlace() {
    WindowDriver& d = *driver_;
    QFile file(d.path("bad.ply"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("ply\nformat ascii 1.0\nelement vertex 999999999\n");
    file.close();
    const Scene before = d.scene();
    drop(file.fileName());
    QVERIFY(quiet());
    QVERIFY(d.scene() == before);
    auto& message = d.child<QLabel>("message.text");
    QVERIFY(message.isVisible());
    QVERIFY2(message.text().contains("bad.ply"), qPrintable(message.text()));
    QVERIFY(!d.document().isModified());
  }

  void mouseAndKeysTurnTheCamera() {
    openSolid("torus:40");
    WindowDriver& d = *driver_;
    const int steps = d.document().undoStack().count();
    const SurfaceCamera start = camera();
    drag({200, 200}, {260, 200});
    // Esc has nothing to take back any more.
    QVERIFY(!d.child<QLabel>("status.hint").text().contains("Esc"));
    QVERIFY((camera().towards - start.towards).norm() > 0.1);
    QCOMPARE(camera().centre, start.centre);
    const SurfaceCamera turned = camera();
    drag({200, 200}, {230, 180}, Qt::ShiftModifier);
    QVERIFY((camera().centre - turned.centre).norm() > 0.01);
    QCOMPARE(camera().towards, turned.towards);
    const SurfaceCamera moved = camera();
    drag({200, 200}, {230, 180}, {}, Qt::MiddleButton);
    QVERIFY((camera().centre - moved.centre).norm() > 0.01);
    // Esc takes a drag back.
    const SurfaceCamera before = camera();
    QTest::mousePress(&surface(), Qt::LeftButton, {}, {200, 200});
    move({280, 240});
    QVERIFY(!(camera() == before));
    QTest::keyClick(&surface(), Qt::Key_Escape);
    QVERIFY(camera() == before);
    QTest::mouseRelease(&surface(), Qt::LeftButton, {}, {280, 240});
    key(Qt::Key_7);
    QCOMPARE(camera().towards, Eigen::Vector3d(0, 1, 0));
    key(Qt::Key_9);
    QCOMPARE(camera().towards, Eigen::Vector3d(0, -1, 0));
    key(Qt::Key_3);
    QCOMPARE(camera().towards, Eigen::Vector3d(1, 0, 0));
    key(Qt::Key_1);
    QCOMPARE(camera().towards, Eigen::Vector3d(0, 0, 1));
    QCOMPARE(d.scene().view.angleDeg, defaultScene().view.angleDeg);  // the flat view's own keys
    key(Qt::Key_5);
    QVERIFY(camera().perspectiveDeg);
    key(Qt::Key_Left);
    QVERIFY((camera().towards - Eigen::Vector3d(0, 0, 1)).norm() > 0.05);
    key(Qt::Key_R);
    QVERIFY(camera() == SurfaceCamera{});
    QCOMPARE(d.document().undoStack().count(), steps);
  }

  void scansThatLieOnTheirBackStandUp() {
    openSolid("torus:40");
    WindowDriver& d = *driver_;
    drag({200, 200}, {260, 200});
    const SurfaceCamera turned = camera();
    d.trigger("surface.up.z");
    QCOMPARE(d.scene().surface->upAxis, std::string("z"));
    QVERIFY(camera().towards.z() > 0.1 && camera().towards.z() < 0.6);  // a little from above
    key(Qt::Key_1);
    QCOMPARE(camera().towards, Eigen::Vector3d(0, -1, 0));
    QCOMPARE(camera().up, Eigen::Vector3d(0, 0, 1));
    key(Qt::Key_7);
    QCOMPARE(camera().towards, Eigen::Vector3d(0, 0, 1));
    key(Qt::Key_R);
    QVERIFY(camera() == homeCamera(Eigen::Vector3d::UnitZ()));
    // The camera belongs to this edit, unlike to others.
    d.trigger("edit.undo");
    QCOMPARE(d.scene().surface->upAxis, std::string("y"));
    QVERIFY(camera() == turned);
    d.trigger("edit.redo");
    // The next one of the folder lies as this one did.
    openSolid("sphere:16");
    QCOMPARE(d.scene().surface->upAxis, std::string("z"));
    QVERIFY(camera() == homeCamera(Eigen::Vector3d::UnitZ()));
  }

  void aClickPicksAPoint() {
    openSolid("torus:40");
    WindowDriver& d = *driver_;
    SurfacePick& pick = d.window().surfaceModels().pick;
    QSignalSpy changes(&pick, &SurfacePick::changed);
    const Projection projection = orbitProjection(camera(), pick.surface()->ballRadius,
                                                  surface().width(), surface().height());
    // A vertex turned to the viewer: its own pixel picks it, or another one in front of it.
    const QPoint ring(surface().width() / 2,
                      qRound(surface().height() / 2 + 0.6 * projection.pxPerUnit));
    const SurfaceCamera before = camera();
    QTest::mousePress(&surface(), Qt::LeftButton, {}, ring);
    move(ring + QPoint(2, 1), {}, Qt::LeftButton);  // a hand trembles
    QTest::mouseRelease(&surface(), Qt::LeftButton, {}, ring + QPoint(2, 1));
    QVERIFY(camera() == before);
    QVERIFY(pick.hit());
    QCOMPARE(changes.count(), 1);
    const auto px = projection.toScreen(pick.hit()->at);
    QVERIFY(px && (*px - Eigen::Vector2d(ring.x(), ring.y())).norm() < 1e-6);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const TriangleMesh& mesh = *pick.surface()->mesh;
    for (std::size_t k = 0; k < 3; ++k) {
      middle += pick.hit()->weights[k] *
                mesh.position(mesh.triangles[pick.hit()->triangle][k]).cast<double>();
    }
    QVERIFY((middle - pick.hit()->at).norm() < 1e-6);
    // It stays on the surface while that is turned; a drag picks nothing.
    const SurfaceHit picked = *pick.hit();
    drag({200, 200}, {260, 200});
    QVERIFY(pick.hit() && pick.hit()->at == picked.at);
    key(Qt::Key_Escape);
    QVERIFY(!pick.hit());
    // P looks in the middle of the picture, which is the hole of the torus seen from the front.
    key(Qt::Key_1);
    key(Qt::Key_P);
    QVERIFY(!pick.hit());
    key(Qt::Key_7);
    pick.pickVertex(7);
    QVERIFY(pick.hit());
    QCOMPARE(pick.vertex(), 7u);
    QVERIFY((pick.hit()->at - mesh.position(7).cast<double>()).norm() == 0.0);
    QTest::mouseClick(&surface(), Qt::LeftButton, {}, {3, surface().height() / 2});
    QVERIFY(!pick.hit());
    pick.pickTriangle(11);
    QCOMPARE(pick.hit()->triangle, 11u);
    pick.pickTriangle(static_cast<std::uint32_t>(mesh.triangleCount()));
    QCOMPARE(pick.hit()->triangle, 11u);
    // Fields come and go; another mesh has other triangles.
    auto& scale = d.child<QDoubleSpinBox>("surface.scale");
    scale.setValue(2.0);
    QVERIFY(quiet());
    QCOMPARE(pick.hit()->triangle, 11u);
    openSolid("sphere:16");
    QVERIFY(!pick.hit());
  }

  void theWheelZoomsAtThePointer() {
    openSolid("torus:40");
    const double zoom = camera().zoom;
    QWheelEvent event({150, 150}, surface().mapToGlobal(QPointF(150, 150)), {}, {0, 240},
                      Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&surface(), &event);
    QVERIFY(camera().zoom > 1.3 * zoom);
    QVERIFY(camera().centre.norm() > 0.0);
    key(Qt::Key_F);
    QCOMPARE(camera().zoom, 1.0);
  }

  void spaceSpins() {
    openSolid("sphere:16");
    const SurfaceCamera before = camera();
    key(Qt::Key_Space);
    QVERIFY(driver_->child<QAction>("surface.spin").isChecked());
    QTRY_VERIFY((camera().towards - before.towards).norm() > 0.02);
    key(Qt::Key_Escape);
    QVERIFY(!driver_->child<QAction>("surface.spin").isChecked());
  }

  void familiesAreSwitchedByMouse() {
    openSolid("bumpy-sphere:30");
    WindowDriver& d = *driver_;
    auto& on = d.child<QCheckBox>("families.apparent-ridges.on");
    QVERIFY(on.isVisible() && on.isChecked());
    QVERIFY(shown(LineFamily::ApparentRidges) > 0);
    QTest::mouseClick(&on, Qt::LeftButton, {}, {8, on.height() / 2});
    QVERIFY(quiet());
    QCOMPARE(shown(LineFamily::ApparentRidges), std::size_t{0});
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(on.isChecked());
    const std::size_t usual = shown(LineFamily::ApparentRidges);
    QVERIFY(usual > 0);
    // A typed threshold, and the slider goes along.
    auto& field = d.child<QDoubleSpinBox>("families.apparent-ridges.threshold");
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, "9");
    QTest::keyClick(&field, Qt::Key_Return);
    QVERIFY(quiet());
    QVERIFY(shown(LineFamily::ApparentRidges) < usual);
    auto& slider = d.child<QSlider>("families.apparent-ridges.slider");
    QVERIFY(slider.value() > 100);
    // A pull of the slider is one step.
    const int steps = d.document().undoStack().count();
    slider.setSliderDown(true);
    for (const int value : {90, 60, 30}) slider.setValue(value);
    slider.setSliderDown(false);
    QVERIFY(quiet());
    QCOMPARE(d.document().undoStack().count(), steps + 1);
    QVERIFY(shown(LineFamily::ApparentRidges) > usual);
  }

  void colourMapsHaveALegendAndAProbe() {
    openSolid("torus:40");
    WindowDriver& d = *driver_;
    d.window().docks().show("surface");
    d.settle();
    auto& quantity = d.child<QComboBox>("surface.quantity");
    quantity.setFocus();
    QTest::keyClick(&quantity, Qt::Key_Up);
    QVERIFY(quiet());
    QCOMPARE(d.scene().surface->style, std::string("colours"));
    QCOMPARE(d.scene().surface->quantity, std::string("k2"));
    QVERIFY(d.window().surfaceModels().seen.seen()->colours);
    key(Qt::Key_1);
    QVERIFY(quiet());
    // On the ring of the torus, not in its hole.
    const Projection projection =
        orbitProjection(camera(), d.window().surfaceModels().source.surface()->ballRadius,
                        surface().width(), surface().height());
    const QPoint middle(surface().width() / 2, surface().height() / 2);
    const int ring = qRound(0.71 * projection.pxPerUnit);
    move(middle + QPoint(ring, 0));
    SurfaceOverlay& overlay = *d.window().surfaceArea().overlay();
    QTRY_VERIFY(overlay.reading().has_value());
    QVERIFY(overlay.reading()->terms);
    QVERIFY(overlay.readingLines().size() > 3);
    move(middle);
    QTRY_VERIFY(!overlay.reading().has_value());
    QVERIFY(overlay.timeLines().size() == 2);
  }

  void camerasAreKeptWithTheScene() {
    openSolid("torus:40");
    WindowDriver& d = *driver_;
    d.window().docks().show("surface");
    d.settle();
    key(Qt::Key_7);
    QTest::mouseClick(&d.child<QAbstractButton>("surface.camera.keep"), Qt::LeftButton);
    key(Qt::Key_3);
    auto& list = d.child<QListWidget>("surface.cameras");
    QCOMPARE(list.count(), 1);
    const QPoint at = list.visualItemRect(list.item(0)).center();
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, at);
    d.settle();
    QCOMPARE(camera().towards, Eigen::Vector3d(0, 1, 0));
    // Saved and opened again, with what is drawn.
    const Scene mine = d.scene();
    QVERIFY(d.window().files().saveTo(d.path("mine.json")));
    d.trigger("file.new");
    QVERIFY(!d.scene().surface);
    d.window().files().openFile(d.path("mine.json"));
    QVERIFY(quiet());
    QVERIFY(d.scene() == mine);
    QVERIFY(d.window().surfaceModels().source.surface());
  }

  void whatIsSeenIsExported() {
    openSolid("torus:40");
    WindowDriver& d = *driver_;
    const QString svg = d.path("lines.svg"), png = d.path("picture.png");
    whenModal(
        [&svg](QWidget& dialog) {
          typeFileName(svg);
          QTest::mouseClick(dialog.findChild<QAbstractButton*>("export.go"), Qt::LeftButton);
        },
        [](QWidget& dialog) { return dialog.objectName() == "surface-export"; });
    d.trigger("surface.export");
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(svg), kPatienceMs);
    QFile file(svg);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("contours-visible"));
    QVERIFY(text.contains("solid:torus"));  // the scene it came from
    d.window().surfaces().exporter().exportTo(png, {640, 480});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(png), kPatienceMs);
    QCOMPARE(QImage(png).size(), QSize(640, 480));
    QVERIFY(hasPicture(QImage(png)));
  }

 private:
  QWidget& surface() { return *driver_->window().surfaceArea().canvas(); }
  const SurfaceCamera& camera() { return driver_->scene().surface->camera; }
  std::size_t shown(LineFamily family) {
    return driver_->window()
        .surfaceModels()
        .seen.seen()
        ->lines[static_cast<std::size_t>(family)]
        .size();
  }
  bool quiet() { return driver_->surfaceQuiet(); }
  void openSolid(const char* name) {
    driver_->window().surfaces().openSolid(name);
    QVERIFY(quiet());
    QVERIFY(driver_->scene().surface.has_value());
    driver_->window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&driver_->window()));
    surface().setFocus();
  }
  void key(Qt::Key k) {
    surface().setFocus();
    QTest::keyClick(&surface(), k);
    driver_->settle();
  }
  void move(const QPoint& p, Qt::KeyboardModifiers keys = {}, Qt::MouseButton b = Qt::NoButton) {
    const bool pressed = b != Qt::NoButton || QGuiApplication::mouseButtons() != Qt::NoButton;
    QMouseEvent event(QEvent::MouseMove, p, surface().mapToGlobal(p), Qt::NoButton,
                      pressed && b == Qt::NoButton ? Qt::LeftButton : b, keys);
    QCoreApplication::sendEvent(&surface(), &event);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {},
            Qt::MouseButton b = Qt::LeftButton) {
    QTest::mousePress(&surface(), b, keys, from);
    for (int i = 1; i <= 4; ++i) move(from + (to - from) * i / 4, keys, b);
    QTest::mouseRelease(&surface(), b, keys, to);
    driver_->settle();
  }
  void drop(const QString& name) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(name)});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&driver_->window(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&driver_->window(), &event);
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(SurfaceTest)
#include "surface_test.moc"
