// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as surfaces in the real window, by mouse and keys: what flatland predicts of them, and
// how their views follow each other.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <cmath>

#include "tests/ui/support_bridging.h"
#include "ui/app/file_controller.h"
#include "ui/app/layouts.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/flat/crossing_overlay.h"
#include "ui/model/bridge_words.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/plot/bridge_study.h"
#include "ui/view3d/surface_picture.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kStudyPatienceMs = 60000;
// Lines found may be this far from the prediction, in edges: docs/math/bridges.md measures 0.05 at
// 256 cells, where the window has 128.
constexpr double kNearEdges = 0.2;

}  // namespace

class BridgingTest : public QObject, private BridgingWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void extrudingAgainIsNoStep() {
    WindowDriver& d = *driver_;
    extrude();
    QVERIFY(d.window().files().saveTo(d.path("own.json")));
    const SurfaceCamera first = camera();
    dragSurface({200, 200}, {260, 220});
    QVERIFY(!(camera() == first));
    const int steps = d.document().undoStack().count();
    const bool modified = d.document().isModified();
    extrude();
    QCOMPARE(d.document().undoStack().count(), steps);
    QCOMPARE(d.document().isModified(), modified);
    d.trigger("surface.revolve");
    QVERIFY(quiet());
    QCOMPARE(d.document().undoStack().count(), steps + 1);
  }

  void theSurfaceFollowsTheCurve() {
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    extrude();
    QCOMPARE(d.document().undoStack().count(), 1);
    QVERIFY(d.window().layouts().current() == Layouts::Kind::Surface);
    QVERIFY(d.canvas().isVisible() && d.window().surfaceArea().isVisible());
    QVERIFY(d.scene().curves == before.curves);
    QCOMPARE(source().surface()->swept->cells, d.scene().surface->swept->cells);
    QVERIFY(agrees());
    const double span = curveSpan();
    // The last of them stay until the next are there: never none.
    int without = 0;
    QSignalSpy meshes(&source(), &SurfaceSource::changed);
    const auto watch =
        connect(&seen(), &SeenSource::changed, &seen(), [&] { without += !seen().seen(); });
    const QPoint from = d.atPoint(2);
    d.press(from);
    for (int i = 1; i <= 8; ++i) {
      d.move(from + QPoint(3 * i, -2 * i));
      QTest::qWait(30);
    }
    QVERIFY(meshes.count() > 0);
    d.release(from + QPoint(24, -16));
    QVERIFY(quiet());
    disconnect(watch);
    QCOMPARE(without, 0);
    QVERIFY(!(d.scene().curves == before.curves));
    QVERIFY(std::abs(curveSpan() - span) > 1e-4);
    // Every vertex is over a point of the curve as it is now, for its parameter.
    const SweptOrigin& origin = *source().surface()->swept;
    QVERIFY(origin.surface.curve == d.scene().curves[0].shape);
    QCOMPARE(origin.cells, d.scene().surface->swept->cells);
    const TriangleMesh& mesh = *source().surface()->mesh;
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      const Vec2 p = pointAt(d.scene().curves[0].shape, origin.mesh.parameters[mesh.fileVertex[v]]);
      QVERIFY((mesh.positionInFile(v).head<2>() - p).norm() < 1e-5);
    }
    QVERIFY(agrees());
    // The drag is one step; the surface goes back with the curve.
    QCOMPARE(d.document().undoStack().count(), 2);
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(d.scene().curves == before.curves);
    QVERIFY(std::abs(curveSpan() - span) < 1e-6);
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(!d.scene().surface && !source().surface() && !bridge().view());
  }

  void thePickStaysWhereItIsOnOtherMeshes() {
    WindowDriver& d = *driver_;
    extrude();
    SurfacePick& pick = d.window().surfaceModels().pick;
    const auto placeInFile = [&] {
      const TriangleMesh& mesh = *source().surface()->mesh;
      return Eigen::Vector3d(mesh.origin + mesh.unit * pick.hit()->at);
    };
    const auto first = source().surface();
    pick.pickTriangle(static_cast<std::uint32_t>(first->mesh->triangleCount() / 3));
    const Eigen::Vector3d picked = placeInFile();
    SurfaceSetting coarser = *d.scene().surface;
    coarser.swept->cells /= 2;
    d.document().push(std::make_unique<SetSurface>(d.document(), coarser, "coarser"));
    QVERIFY(quiet());
    QVERIFY(source().surface()->mesh != first->mesh);
    QVERIFY(pick.hit());
    // Facets are off the curve by an eighth of their square over its radius.
    QVERIFY2((placeInFile() - picked).norm() < 0.01 * curveSpan(),
             qPrintable(QString::number((placeInFile() - picked).norm())));
    // Dragged, the curve takes it along; another surface does not.
    d.drag(d.atPoint(2), d.atPoint(2) + QPoint(12, 8));
    QVERIFY(quiet());
    QVERIFY(pick.hit());
    QVERIFY(pick.hit()->triangle < source().surface()->mesh->triangleCount());
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    QVERIFY(!pick.hit());
  }

  void aNumberIsThatOfTheMeshAskedFor() {
    WindowDriver& d = *driver_;
    SurfacePick& pick = d.window().surfaceModels().pick;
    std::vector<int> cells;  // of the meshes that are shown
    connect(&source(), &SurfaceSource::changed, &source(), [&] {
      if (source().surface()) cells.push_back(source().surface()->swept->cells);
    });
    pick.pickWhenRead(true, 2500);
    extrude();
    QVERIFY(cells.front() < d.scene().surface->swept->cells);  // a coarse one came first
    QCOMPARE(cells.back(), d.scene().surface->swept->cells);
    QVERIFY(pick.hit());
    QCOMPARE(pick.hit()->triangle, 2500u);
  }

  void turningOneTurnsTheOther() {
    extrude();
    WindowDriver& d = *driver_;
    QVERIFY(sameAngle(azimuthDeg(camera()), d.scene().view.angleDeg));
    const double start = d.scene().view.angleDeg;
    const SurfaceCamera startCamera = camera();
    dragSurface({200, 200}, {260, 210});
    QVERIFY(!sameAngle(d.scene().view.angleDeg, start));
    QVERIFY(sameAngle(azimuthDeg(camera()), d.scene().view.angleDeg));
    QCOMPARE(d.document().undoStack().count(), 1);
    QVERIFY(quiet());
    QVERIFY(agrees());
    // The view's handle in flatland turns the surface.
    const double before = d.scene().view.angleDeg;
    const QPoint handle = d.atHandle();
    d.drag(handle, handle + QPoint(-10, 40));
    const View turned = d.scene().view;
    QVERIFY(!sameAngle(turned.angleDeg, before));
    QVERIFY(sameAngle(azimuthDeg(camera()), turned.angleDeg));
    QCOMPARE(d.document().undoStack().count(), 2);
    // Undo turns the flat view back to where the handle took it, wherever the camera has been
    // since, and the surface with it, as high above the plane as it is now.
    dragSurface({200, 200}, {230, 215});
    QVERIFY(!sameAngle(d.scene().view.angleDeg, turned.angleDeg));
    const double raised = camera().towards.z();
    d.trigger("edit.undo");
    QCOMPARE(d.scene().view.angleDeg, before);
    QVERIFY(sameAngle(azimuthDeg(camera()), before));
    QVERIFY(std::abs(camera().towards.z() - raised) < 1e-9);
    QCOMPARE(d.document().undoStack().index(), 1);
    dragSurface({200, 200}, {170, 200});
    d.trigger("edit.redo");
    QVERIFY(d.scene().view == turned);
    QVERIFY(sameAngle(azimuthDeg(camera()), turned.angleDeg));
    // Switched off, each goes its own way; along the rulings there is no flat view.
    d.window().bridges().link.setOn(false);
    const double kept = d.scene().view.angleDeg;
    dragSurface({200, 200}, {240, 200});
    QCOMPARE(d.scene().view.angleDeg, kept);
    QVERIFY(d.window().bridges().link.whyNot().empty());
    surface().setFocus();
    QTest::keyClick(&surface(), Qt::Key_1);
    QVERIFY(!d.window().bridges().link.whyNot().empty());
    QVERIFY((startCamera.towards - camera().towards).norm() > 0.1);
  }

  void aTurnOfTheSurfaceIsNoEdit() {
    WindowDriver& d = *driver_;
    const Scene start = d.scene();
    extrude();
    const Scene before = d.scene();
    d.drag(d.atPoint(2), d.atPoint(2) + QPoint(12, 8));
    QVERIFY(quiet());
    const std::vector<SceneCurve> dragged = d.scene().curves;
    QVERIFY(dragged != before.curves);
    d.trigger("edit.undo");
    QVERIFY(d.scene().curves == before.curves);
    QVERIFY(d.window().files().saveTo(d.path("mine.json")));
    QVERIFY(!d.document().isModified());
    surface().setFocus();
    QTest::keyClick(&surface(), Qt::Key_Left);
    QVERIFY(!sameAngle(d.scene().view.angleDeg, before.view.angleDeg));
    QVERIFY(sameAngle(azimuthDeg(camera()), d.scene().view.angleDeg));
    QVERIFY(!d.document().isModified());
    QCOMPARE(d.document().undoStack().count(), 2);
    d.trigger("edit.redo");
    QVERIFY(d.scene().curves == dragged);
    // Undone as far as it goes, all is as it was, the view too.
    d.trigger("edit.undo");
    d.trigger("edit.undo");
    QVERIFY(d.scene() == start);
  }

  void aRevolutionIsSeenAlongItsAxis() {
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    d.trigger("surface.revolve");
    QVERIFY(quiet());
    QCOMPARE(d.document().undoStack().count(), 1);
    QCOMPARE(d.scene().surface->swept->kind, std::string("revolution"));
    QCOMPARE(camera().towards, Eigen::Vector3d(0, 1, 0));
    QCOMPARE(d.scene().view.angleDeg, 90.0);
    QVERIFY(bridge().view()->prediction.flat().view);
    QVERIFY(contoursAgree());
    dragSurface({200, 200}, {240, 230});
    QVERIFY(quiet());
    QVERIFY(!d.window().bridges().link.whyNot().empty());
    QCOMPARE(d.scene().view.angleDeg, 90.0);
    QVERIFY(!bridge().view()->prediction.flat().view);
    // From a revolution to an extrusion and back.
    d.trigger("surface.extrude");
    QVERIFY(quiet());
    QVERIFY(d.window().bridges().link.whyNot().empty());
    QVERIFY(contoursAgree());
    d.trigger("edit.undo");
    d.trigger("edit.undo");
    QVERIFY(d.scene() == before);
    // Another surface has its noise, and the usual threshold against it.
    d.trigger("surface.extrude");
    QVERIFY(quiet());
    QCOMPARE(*familyOf(*d.scene().surface, LineFamily::ApparentRidges).threshold, 0.0);
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    QVERIFY(d.scene().surface->families.empty() && !d.scene().surface->swept);
    QVERIFY(source().surface()->fields && !source().surface()->swept && !bridge().view());
  }

  void whatIsSavedComesBack() {
    extrude();
    WindowDriver& d = *driver_;
    dragSurface({200, 200}, {230, 205});
    const Scene mine = d.scene();
    QVERIFY(d.window().files().saveTo(d.path("mine.json")));
    d.trigger("file.new");
    QVERIFY(quiet());
    QVERIFY(!source().surface());
    d.window().files().openFile(d.path("mine.json"));
    QVERIFY(quiet());
    QVERIFY(d.scene() == mine);
    QVERIFY(d.window().bridges().link.isOn());
    QVERIFY(agrees());
  }

  void viewsThatDoNotMatchAreNotLinked() {
    extrude();
    WindowDriver& d = *driver_;
    const ViewLink& link = d.window().bridges().link;
    Scene other = d.scene();
    QVERIFY(link.isOn());
    other.view.angleDeg += 40.0;
    d.document().start(other, "other");
    // At once, and not only when the window has come to it.
    QVERIFY(!link.isOn());
    const View view = d.scene().view;
    d.document().setCamera(spun(camera(), 0.2));
    QVERIFY(d.scene().view == view);
    QVERIFY(!d.document().isModified());
    // A section is cut beside the window's thread: whose plane the curves are in is known late.
    d.document().start(defaultScene(), "mine");
    d.window().bridges().link.setOn(true);
    openSectionOfTorus();
    QVERIFY(link.isOn());
    const Scene matching = d.scene();
    other = matching;
    other.view.angleDeg -= 40.0;
    for (const bool matches : {false, true}) {
      d.document().start(defaultScene(), "mine");
      QVERIFY(quiet());
      d.window().bridges().link.setOn(true);
      d.document().start(matches ? matching : other, "section");
      QVERIFY(quiet());
      QVERIFY(section().isInFlatland());
      QCOMPARE(link.isOn(), matches);
    }
  }

  void predictedLinesAreDashedOnce() {
    extrude();
    WindowDriver& d = *driver_;
    d.trigger("surface.compare.two");
    QVERIFY(quiet());
    const SurfaceModels models = d.window().surfaceModels();
    const auto dashes = [&](std::size_t pane) { return pictureOf(models.of(pane)).marks; };
    const std::vector<MarkLines> first = dashes(0);
    QVERIFY(!first.empty() && !first.front().ends->empty());
    QCOMPARE(first.size(), bridge().view()->prediction.lines().size());
    for (const std::size_t pane : {0, 1}) {
      const std::vector<MarkLines> again = dashes(pane);
      for (std::size_t i = 0; i < first.size(); ++i) QVERIFY(again[i].ends == first[i].ends);
    }
    // Of another curve they are others.
    d.drag(d.atPoint(2), d.atPoint(2) + QPoint(24, -16));
    QVERIFY(quiet());
    QVERIFY(dashes(0).front().ends != first.front().ends);
  }

  void aHeightOfNothingIsNotTaken() {
    extrude();
    WindowDriver& d = *driver_;
    d.child<QDoubleSpinBox>("bridge.amount").setValue(0.0);
    QVERIFY(quiet());
    QVERIFY(d.scene().surface->swept->amount > 0.0);
    QVERIFY(source().surface());
    const Scene mine = d.scene();
    QVERIFY(d.window().files().saveTo(d.path("flat.json")));
    d.trigger("file.new");
    d.window().files().openFile(d.path("flat.json"));
    QVERIFY(quiet());
    QVERIFY(d.scene() == mine);
  }

  void undoOfAKindBringsItsCameraBack() {
    extrude();
    const SurfaceCamera seen = camera();
    driver_->trigger("surface.revolve");
    QVERIFY(quiet());
    QVERIFY((camera().up - seen.up).norm() > 0.1);
    driver_->trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY((camera().up - seen.up).norm() < 1e-9);
    QVERIFY((camera().towards - seen.towards).norm() < 1e-9);
  }

  void theSurfaceKeepsToItsCurveWhenOthersGo() {
    WindowDriver& d = *driver_;
    d.trigger("curve.add");  // beside the first, and the one the menus are about
    QCOMPARE(d.window().selection().currentCurve(), std::optional<std::size_t>(1));
    extrude();
    const Curve swept = d.scene().curves[1].shape;
    QVERIFY(source().surface()->swept->surface.curve == swept);
    QVERIFY(agrees());
    const auto surfaceBefore = source().surface();
    // A curve before it goes by its points: the surface stays, and is not even made anew.
    d.canvas().setFocus();
    QTest::keyClick(&d.canvas(), Qt::Key_Escape);
    std::set<PointRef> points;
    for (std::size_t i = 0; i < d.chain(0).points().size(); ++i) points.insert({0, i});
    d.window().selection().setPoints(points);
    d.canvasKey(Qt::Key_Delete);
    QCOMPARE(d.scene().curves.size(), std::size_t{1});
    QVERIFY(quiet());
    QCOMPARE(d.scene().surface->swept->curve, std::size_t{0});
    QVERIFY(source().surface() == surfaceBefore);
    QCOMPARE(d.child<QComboBox>("bridge.curve").currentIndex(), 0);
    // Its own curve goes: so does the surface, with the words about it.
    d.window().selection().setCurrentCurve(0);
    d.trigger("curve.remove");
    QVERIFY(quiet());
    QVERIFY(d.scene().curves.empty() && !d.scene().surface && !source().surface());
    QVERIFY(!bridge().view() && !seen().seen());
    // One step each; the lines come back with the surface.
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(source().surface()->swept->surface.curve == swept);
    QVERIFY(agrees());
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QCOMPARE(d.scene().surface->swept->curve, std::size_t{1});
    QVERIFY(source().surface()->swept->surface.curve == swept);
    QCOMPARE(d.child<QComboBox>("bridge.curve").currentIndex(), 1);
  }

  /// What a view shows has no part in what its surface has.
  void familiesLeftOutAreStillCompared() {
    WindowDriver& d = *driver_;
    extrude();
    QVERIFY(agrees());
    switchRidges();
    QVERIFY(seen().seen()->found->of(LineFamily::ApparentRidges).empty());
    QVERIFY(agrees());
    d.trigger("surface.solid.gaussian-bump");
    QVERIFY(quiet());  // the plane is that of the surface there is
    d.trigger("surface.plane.view");
    QVERIFY(quiet());
    QVERIFY(section().view());
    const std::size_t ridges = section().view()->marks.ridges.size();
    QVERIFY(ridges > 0);
    const auto shown = seen().seen();
    switchRidges();
    QVERIFY(seen().seen()->found->of(LineFamily::ApparentRidges).size() !=
            shown->found->of(LineFamily::ApparentRidges).size());
    QCOMPARE(section().view()->marks.ridges.size(), ridges);
  }

  void theStudyMeasuresResolutions() {
    extrude();
    WindowDriver& d = *driver_;
    auto& run = d.child<QPushButton>("bridge.study.run");
    auto& study = d.child<BridgeStudy>("bridge.study");
    QTest::mouseClick(&run, Qt::LeftButton);
    QVERIFY(study.isRunning());
    QTest::mouseClick(&run, Qt::LeftButton);  // gives up
    QVERIFY(!study.isRunning() && !study.data());
    QTest::mouseClick(&run, Qt::LeftButton);
    QVERIFY(QTest::qWaitFor([&] { return study.data() != nullptr; }, kStudyPatienceMs));
    QCOMPARE(study.data()->series.size(), std::size_t{4});
    const BridgeRow& finest = study.data()->series[0].rows.back();
    QVERIFY2(finest.ridges.medianEdges < 0.1,
             qPrintable(QString::number(finest.ridges.medianEdges)));
    typeFileName(d.path("bridge.csv"));
    QTest::mouseClick(&d.child<QPushButton>("bridge.study.export"), Qt::LeftButton);
    QVERIFY(QFile::exists(d.path("bridge.csv")));
    // Of another curve it is shown as such, of another sweep not at all.
    auto& diagram = d.child<QWidget>("bridge.study.diagram");
    auto& old = d.child<QLabel>("bridge.study.old");
    QVERIFY(!diagram.isHidden() && old.isHidden());
    d.drag(d.atPoint(1), d.atPoint(1) + QPoint(15, 10));
    QVERIFY(quiet());
    QTRY_VERIFY(!diagram.isHidden() && !old.isHidden());
    d.document().undoStack().undo();
    QVERIFY(quiet());
    QTRY_VERIFY(!diagram.isHidden() && old.isHidden());
    d.trigger("surface.revolve");
    QVERIFY(quiet());
    QTRY_VERIFY(diagram.isHidden() && old.isHidden());
    QVERIFY(!d.child<QPushButton>("bridge.study.export").isEnabled());
  }

 private:
  void switchRidges() {
    driver_->window().docks().show("families");
    driver_->settle();
    auto& on = driver_->child<QCheckBox>("families.apparent-ridges.on");
    const bool before = on.isChecked();
    on.setFocus();
    QTest::keyClick(&on, Qt::Key_Space);
    QVERIFY(on.isChecked() != before);
    QVERIFY(quiet());
  }
  /// Ridges are there, and where they are predicted.
  bool agrees() {
    const auto& view = bridge().view();
    if (!view || view->seen != seen().seen() || view->seen->surface != source().surface()) {
      return false;
    }
    const LineAgreement& ridges = view->row.ridges;
    if (ridges.lines == 0 || ridges.pieces == 0) {
      qWarning("%zu pieces, %s", ridges.pieces, qPrintable(agreementWords(*view).join(" | ")));
      return false;
    }
    if (!(ridges.medianEdges < kNearEdges) || !(ridges.coverage > 0.9)) {
      qWarning("%s", qPrintable(agreementWords(*view).join(" | ")));
      return false;
    }
    return true;
  }
  bool contoursAgree() {
    const LineAgreement& contours = bridge().view()->row.contours;
    return contours.lines > 0 && contours.medianEdges < kNearEdges && contours.coverage > 0.9;
  }
  /// How far the mesh reaches along the curve's plane, in the curve's unit.
  double curveSpan() {
    const TriangleMesh& mesh = *source().surface()->mesh;
    double farthest = 0.0;
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      farthest += mesh.positionInFile(v).head<2>().norm();
    }
    return farthest / static_cast<double>(mesh.vertexCount());
  }
};

QTEST_MAIN(BridgingTest)
#include "bridging_test.moc"
