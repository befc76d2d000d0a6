// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as curves in the real window, by mouse and keys: planes, sections and their marks.
#include <Eigen/Geometry>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/ui/support_bridging.h"
#include "tests/ui/support_meshes.h"
#include "ui/app/layouts.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/flat/crossing_overlay.h"
#include "ui/model/cutting_plane.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/model/surface_panes.h"
#include "ui/view3d/plane_marks.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr double kDeg = 180.0 / std::numbers::pi;

}  // namespace

class SlicingTest : public QObject, private BridgingWindow {
  Q_OBJECT

 private slots:
  void init() { open(); }
  void cleanup() { close(); }

  void aSliceOfAMeshIsACurveWithMarks() {
    WindowDriver& d = *driver_;
    NEEDS_DATA_MESH(mesh, "spot_quads.obj");
    const Scene before = d.scene();
    d.window().surfaces().openFile(mesh);
    QVERIFY(quiet());
    d.trigger("surface.plane.view");
    QVERIFY(quiet());
    const auto section = this->section().view();
    QVERIFY(section && !section->section.scene.curves.empty());
    QVERIFY(!section->lines.empty());
    // Exactly cut: every point of the line is in the plane.
    const SurfacePlane plane = *d.scene().surface->plane;
    for (const LineVertex& v : section->lines) {
      QVERIFY(std::abs(plane.normal.dot(Eigen::Vector3d(v.x, v.y, v.z) - plane.point)) < 1e-5);
    }
    // The plane holds the line of sight, so the flat view is the camera's.
    QVERIFY(std::abs(plane.normal.dot(camera().towards)) < 1e-9);
    QVERIFY(!section->marks.marks.empty());
    QVERIFY(!section->marks.ridges.empty());
    auto& table = d.child<QTableWidget>("section.pairs");
    const auto listed = [&](double threshold) {
      return static_cast<int>(
          std::count_if(section->pairs.begin(), section->pairs.end(),
                        [&](const SectionPair& pair) { return pair.strength >= threshold; }));
    };
    const double usual =
        lineOptionsOf(paneSetting(*d.scene().surface, 0)).thresholdOf(LineFamily::ApparentRidges);
    const int all = static_cast<int>(section->pairs.size());
    QCOMPARE(table.rowCount(), listed(usual));
    // Those below the threshold of the view are counted, not listed.
    auto& weaker = d.child<QLabel>("section.weaker");
    QCOMPARE(!weaker.text().isEmpty(), listed(usual) < all);
    const double middle = section->pairs[section->pairs.size() / 2].strength;
    d.child<QDoubleSpinBox>("families.apparent-ridges.threshold").setValue(middle + 0.01);
    QVERIFY(quiet());
    QCOMPARE(table.rowCount(), listed(middle + 0.01));
    QVERIFY(weaker.text().startsWith(QString::number(all - table.rowCount())));
    d.child<QDoubleSpinBox>("families.apparent-ridges.threshold").setValue(usual);
    QVERIFY(quiet());
    QCOMPARE(table.rowCount(), listed(usual));
    QVERIFY(!d.child<QLabel>("section.sentence").text().isEmpty());
    auto& crossings = d.child<CrossingOverlay>("canvas.crossings");
    QVERIFY(crossings.crossings().empty());  // the curves are still the person's own

    const int steps = d.document().undoStack().count();
    auto& open = d.child<QPushButton>("section.open");
    QTest::mouseClick(&open, Qt::LeftButton);
    QVERIFY(quiet());
    QCOMPARE(d.document().undoStack().count(), steps + 1);
    QVERIFY(d.scene().curves == section->section.scene.curves);
    QVERIFY(d.document().features().marks.size() == section->marks.marks.size());
    QVERIFY(!crossings.crossings().empty());
    // Ridges of the surface that cross the plane are on the curves.
    const CutPlane cut = this->section().view()->section.plane;
    for (const CrossedRidge& ridge : this->section().view()->marks.ridges) {
      double nearest = 1e9;
      for (const SceneCurve& curve : d.scene().curves) {
        nearest = std::min(nearest, nearestPoint(curve.shape, ridge.inPlane).distance);
      }
      QVERIFY(nearest < 5.0 * this->section().view()->tolerance);
      QVERIFY((cut.inSpace(ridge.inPlane) - ridge.at).norm() < 1e-9);
    }
    // Turning the surface turns the flat view of the section.
    QVERIFY(d.window().bridges().link.canLink() && d.window().bridges().link.isOn());
    dragSurface({30, 200}, {70, 210});
    QVERIFY(quiet());
    const Vec2 w(cut.right.dot(camera().towards), cut.up.dot(camera().towards));
    QVERIFY(sameAngle(std::atan2(w.y(), w.x()) * kDeg, d.scene().view.angleDeg));
    QVERIFY(this->section().isInFlatland());
    // Saved and opened again, section and curves still belong together.
    const Scene mine = d.scene();
    QVERIFY(d.window().files().saveTo(d.path("section.json")));
    d.trigger("file.new");
    d.window().files().openFile(d.path("section.json"));
    QVERIFY(quiet());
    QVERIFY(d.scene() == mine);
    QVERIFY(this->section().isInFlatland());
    QVERIFY(d.window().bridges().link.isOn());
    QVERIFY(before.curves != mine.curves);
  }

  void nothingMovesInThePanelWhenASectionIsThere() {
    WindowDriver& d = *driver_;
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
      d.window().resize(size);
      d.trigger("surface.solid.torus");
      QVERIFY(quiet());
      showSection();
      auto& table = d.child<QTableWidget>("section.pairs");
      const auto places = [&] {
        QList<QRect> found;
        for (const char* name : {"section.along-view", "section.along-ridge", "section.remove",
                                 "section.azimuth", "section.height", "section.tolerance",
                                 "section.open", "section.pairs", "section.sentence"}) {
          auto& part = d.child<QWidget>(name);
          found << QRect(part.mapTo(&d.window(), QPoint()), part.size());
        }
        return found;
      };
      const QList<QRect> empty = places();
      QVERIFY(table.isVisible() && table.rowCount() == 0);
      // Beside one another, not spread over the height of the panel.
      QVERIFY(empty[6].top() - empty[5].bottom() < empty[6].height());
      QVERIFY(!d.child<QLabel>("section.state").text().isEmpty());
      QTest::mouseClick(&d.child<QPushButton>("section.along-view"), Qt::LeftButton);
      QVERIFY(quiet());
      QVERIFY(table.rowCount() > 0);
      QCOMPARE(places(), empty);
      QTest::mouseClick(&d.child<QPushButton>("section.remove"), Qt::LeftButton);
      QVERIFY(quiet());
      QCOMPARE(places(), empty);
    }
  }

  void theRowThatIsSelectedIsRingedInBothPictures() {
    WindowDriver& d = *driver_;
    openSectionOfTorus();
    d.window().docks().show("section");
    d.settle();
    const auto& view = section().view();
    auto& table = d.child<QTableWidget>("section.pairs");
    auto& flat = d.child<CrossingOverlay>("canvas.crossings");
    QVERIFY(table.rowCount() > 1);
    // Nobody has selected one.
    QVERIFY(!section().chosen() && chosenSpots(section(), projection()).empty());
    QVERIFY(flat.chosen().empty());
    table.setFocus(Qt::TabFocusReason);
    setPlaneBeside();
    QVERIFY(!section().chosen());
    for (const int row : {1, 0}) {
      QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                        table.visualItemRect(table.item(row, 0)).center());
      QVERIFY(section().chosen().has_value());
      const SectionPair& pair = view->pairs.at(*section().chosen());
      const std::vector<Eigen::Vector2d> spots = chosenSpots(section(), projection());
      QCOMPARE(spots.size(), std::size_t(pair.ridge.has_value()) + pair.mark.has_value());
      QCOMPARE(flat.chosen().size(), spots.size());
      if (!pair.mark) continue;
      const SectionMark& mark = view->marks.marks[*pair.mark];
      const TriangleMesh& mesh = *view->surface->mesh;
      const auto at = projection().toScreen((mark.at - mesh.origin) / mesh.unit);
      QVERIFY((spots.back() - *at).norm() < 1e-9);
      QCOMPARE(flat.chosen().back().toPoint(), d.at(mark.mark.point));
    }
    // Another cut keeps the row.
    table.selectRow(1);
    const auto chosen = section().chosen();
    setPlaneBeside();
    QCOMPARE(table.currentRow(), 1);
    QVERIFY(chosen && section().chosen() == chosen);
    // The curve that was asked for has as much room as the surface.
    QVERIFY(d.canvas().isVisible());
    QVERIFY(d.canvas().width() > surface().width() * 9 / 10);
    QTest::mouseClick(&d.child<QPushButton>("section.remove"), Qt::LeftButton);
    QVERIFY(quiet());
    QVERIFY(!section().chosen() && flat.chosen().empty());
  }

  void aPlaneThatIsBeingCutIsNotMissing() {
    WindowDriver& d = *driver_;
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    const auto& state = d.child<QLabel>("section.state");
    QVERIFY(state.text().startsWith("No plane yet"));
    SurfaceSetting setting = *d.scene().surface;
    setting.plane = SurfacePlane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
    d.document().push(std::make_unique<SetSurface>(d.document(), setting, "cut"));
    QVERIFY(section().isStale() && !section().view());
    QCOMPARE(state.text(), QString("The surface is being cut."));
    QVERIFY(quiet());
    QVERIFY(section().view());
    QVERIFY2(!state.text().contains("being cut"), qPrintable(state.text()));
  }

  void aSectionIsSeenWhereCurvesWereAway() {
    WindowDriver& d = *driver_;
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    d.trigger("view.flat-beside");
    QVERIFY(!d.canvas().isVisible());
    d.trigger("surface.plane.view");
    QVERIFY(quiet());
    d.trigger("surface.plane.open");
    QVERIFY(quiet());
    QVERIFY(d.canvas().isVisible() && d.canvas().width() > 100);
    QVERIFY(d.child<QAction>("view.flat-beside").isChecked());
  }

  void undoOfASectionBringsTheCurvesBack() {
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    openSectionOfTorus();
    QVERIFY(d.scene().curves != before.curves);
    QVERIFY(d.window().bridges().link.isOn());
    const Scene opened = d.scene();
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(d.scene().curves == before.curves);
    QVERIFY(d.scene().view == before.view);
    QVERIFY(d.window().bridges().link.isOn());
    d.trigger("edit.redo");
    QVERIFY(quiet());
    QVERIFY(d.scene() == opened);
    QVERIFY(d.window().bridges().link.isOn());
    // Undo does not move the cameras.
    SurfaceCamera nearer = camera();
    nearer.zoom *= 1.5;
    d.document().setCamera(nearer);
    d.trigger("edit.undo");
    QVERIFY(camera() == nearer);
    d.trigger("edit.undo");
    QVERIFY(!d.scene().surface->plane);
    QVERIFY(quiet());
    QVERIFY(!section().view());
  }

  void redoneASectionIsSeenAsTheSurfaceIsNow() {
    WindowDriver& d = *driver_;
    const View mine = d.scene().view;
    openSectionOfTorus();
    const CutPlane plane = section().view()->section.plane;
    const Scene opened = d.scene();
    d.trigger("edit.undo");
    QVERIFY(quiet());
    // The curves are no section now, so that nothing follows the camera.
    dragSurface({30, 200}, {70, 210});
    QVERIFY(quiet());
    const SurfaceCamera turned = camera();
    QVERIFY(turned.towards.dot(opened.surface->camera.towards) < 0.999);
    QVERIFY(d.scene().view == mine);
    QSignalSpy changes(&d.document(), &Document::changed);
    d.trigger("edit.redo");
    QCOMPARE(changes.count(), 1);
    QVERIFY(quiet());
    QVERIFY(d.scene().curves == opened.curves);
    QVERIFY(camera() == turned);
    const Vec2 w(plane.right.dot(turned.towards), plane.up.dot(turned.towards));
    QVERIFY(sameAngle(std::atan2(w.y(), w.x()) * kDeg, d.scene().view.angleDeg));
    QVERIFY(d.window().bridges().link.canLink() && d.window().bridges().link.isOn());
    // The person's own view comes back, whatever the camera did.
    d.trigger("edit.undo");
    QVERIFY(d.scene().view == mine);
    QVERIFY(camera() == turned);
  }

  void aSectionOfAnExtrusionIsTheCurveStretched() {
    extrude();
    WindowDriver& d = *driver_;
    const Scene before = d.scene();
    // Across x and z by 45 degrees: y stays as it is, and x becomes sqrt(2) times as long.
    SurfaceSetting setting = *before.surface;
    setting.plane =
        SurfacePlane{Eigen::Vector3d::Zero(), Eigen::Vector3d(1.0, 0.0, 1.0).normalized()};
    setting.swept->amount = 20.0;  // so high that the plane cuts all of it
    d.document().push(std::make_unique<SetSurface>(d.document(), setting, "cut"));
    QVERIFY(quiet());
    QVERIFY(section().view() && !section().view()->section.scene.curves.empty());
    const CutPlane plane = section().view()->section.plane;
    QTest::mouseClick(&showSection(), Qt::LeftButton);
    QVERIFY(quiet());
    QCOMPARE(d.document().undoStack().text(0), QString("extrude curve"));
    QVERIFY(!d.scene().surface && !source().surface() && !section().view());
    QCOMPARE(d.scene().curves.size(), std::size_t{1});
    const Curve& cut = d.scene().curves.front().shape;
    double farthest = 0.0, longest = 0.0;
    for (int i = 0; i <= 100; ++i) {
      const Vec2 p = pointAt(cut, pieceCount(cut) * i / 100.0);
      const Eigen::Vector3d q = plane.inSpace(p);
      farthest =
          std::max(farthest, nearestPoint(before.curves[0].shape, Vec2(q.head<2>())).distance);
      longest = std::max(longest, std::abs(q.z() - plane.inSpace({0.0, 0.0}).z()));
    }
    QVERIFY2(farthest < 0.02, qPrintable(QString::number(farthest)));
    QVERIFY(longest > 0.5);
    d.trigger("edit.undo");
    QVERIFY(quiet());
    QVERIFY(d.scene().curves == before.curves);
    QVERIFY(source().surface() && source().surface()->swept);
    QVERIFY(d.scene().surface->plane);
    d.trigger("edit.redo");
    QVERIFY(quiet());
    QVERIFY(!d.scene().surface);
  }

  void handlesMoveAndTurnThePlane() {
    WindowDriver& d = *driver_;
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    d.trigger("surface.plane.view");
    QVERIFY(quiet());
    const int steps = d.document().undoStack().count();
    const SurfaceCamera seen = camera();
    const SurfacePlane start = plane();
    // The middle goes along the normal, which is to the right here: with the hand.
    const QPoint middle = handle(0);
    dragSurface(middle, middle + QPoint(40, 15));
    QVERIFY(camera() == seen);
    QVERIFY((plane().normal - start.normal).norm() < 1e-12);
    QVERIFY((plane().point - start.point).cross(start.normal).norm() < 1e-9);
    const double moved = (plane().point - start.point).dot(start.normal);
    QVERIFY(std::abs(moved * projection().pxPerUnit - 40.0) < 1.5);
    QCOMPARE(d.document().undoStack().count(), steps + 1);
    QVERIFY(quiet());
    QVERIFY(section().view()->plane == plane());
    // A place of the rim comes under the hand, and the middle stays.
    const SurfacePlane before = plane();
    const QPoint rim = handle(2);
    const QPoint target = rim + QPoint(30, 20);
    dragSurface(rim, target);
    QVERIFY(plane().point == before.point);
    QVERIFY((plane().normal - before.normal).norm() > 0.05);
    QVERIFY(std::abs(plane().normal.norm() - 1.0) < 1e-12);
    // The pixel's line of sight meets the turned plane's ball in the plane.
    const Sight sight = sightThrough(projection(), {target.x() + 0.0, target.y() + 0.0});
    const double radius = handlesOf(plane(), ball()).radius;
    const Eigen::Vector3d from = sight.from - plane().point;
    const Eigen::Vector3d foot = from - from.dot(sight.along) * sight.along;
    const double half = std::sqrt(radius * radius - foot.squaredNorm());
    const double off = std::min(std::abs(plane().normal.dot(foot + half * sight.along)),
                                std::abs(plane().normal.dot(foot - half * sight.along)));
    QVERIFY2(off < 1e-6, qPrintable(QString::number(off)));
    QCOMPARE(d.document().undoStack().count(), steps + 2);
    // The untouched angle stays as it is, not as its field rounds it.
    const NormalAngles angles = anglesOf(plane().normal);
    d.child<QDoubleSpinBox>("section.azimuth").setValue(std::round(*angles.azimuthDeg) + 3.0);
    QVERIFY(std::abs(anglesOf(plane().normal).elevationDeg - angles.elevationDeg) < 1e-9);
    d.trigger("edit.undo");
    // Another view lets the shared grip go, and keys come in the middle of a drag.
    const SurfacePlane untouched = plane();
    const QPoint held = handle(0);
    QTest::mousePress(&surface(), Qt::LeftButton, {}, held);
    d.window().bridges().grip.setHandle(std::nullopt);
    QTest::keyClick(&surface(), Qt::Key_BracketRight);
    QVERIFY(plane() == untouched);
    moveOver(held + QPoint(20, 0));
    QVERIFY(!(plane() == untouched));
    QTest::keyClick(&surface(), Qt::Key_Escape);
    QTest::mouseRelease(&surface(), Qt::LeftButton, {}, held);
    QVERIFY(plane() == untouched);
    // Esc takes a drag back and leaves no step.
    const SurfacePlane kept = plane();
    QTest::mousePress(&surface(), Qt::LeftButton, {}, handle(0));
    moveOver(handle(0) + QPoint(20, 0));
    QVERIFY(!(plane() == kept));
    QTest::keyClick(&surface(), Qt::Key_Escape);
    QVERIFY(plane() == kept);
    QTest::mouseRelease(&surface(), Qt::LeftButton, {}, handle(0));
    QCOMPARE(d.document().undoStack().count(), steps + 2);
    // Keys.
    surface().setFocus();
    QTest::keyClick(&surface(), Qt::Key_BracketRight);
    QVERIFY((plane().point - kept.point).dot(kept.normal) > 0.01);
    QTest::keyClick(&surface(), Qt::Key_BracketLeft);
    QVERIFY((plane().point - kept.point).norm() < 1e-12);
    QVERIFY(d.window().bridges().grip.hasKeys());  // it was taken hold of
    QTest::keyClick(&surface(), Qt::Key_Left);
    QVERIFY(camera() == seen);
    QVERIFY((plane().normal - kept.normal).norm() > 0.02);
    QTest::keyClick(&surface(), Qt::Key_C);
    QTest::keyClick(&surface(), Qt::Key_Left);
    QVERIFY(!(camera() == seen));
    // Numbers.
    auto& height = d.child<QDoubleSpinBox>("section.height");
    height.setValue(0.25);
    QVERIFY(std::abs(plane().point.dot(plane().normal) - 0.25) < 1e-9);
    auto& azimuth = d.child<QDoubleSpinBox>("section.azimuth");
    auto& elevation = d.child<QDoubleSpinBox>("section.elevation");
    azimuth.setValue(90.0);
    elevation.setValue(0.0);
    QVERIFY((plane().normal - Eigen::Vector3d(0, 0, -1)).norm() < 1e-9);
    QVERIFY(quiet());
    while (d.document().undoStack().index() > steps) d.document().undoStack().undo();
    QVERIFY(plane() == start);
  }

  void hintsFitWhatIsBelowTheHand() {
    WindowDriver& d = *driver_;
    const auto& hint = d.child<QLabel>("status.hint");
    QVERIFY(hint.text().contains("bend the curve"));
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    // The surface that was opened has the keys, and its words.
    QVERIFY(surface().hasFocus());
    QVERIFY2(hint.text().startsWith("Drag: turn (Shift"), qPrintable(hint.text()));
    d.trigger("surface.plane.view");
    QVERIFY(quiet());
    QVERIFY(hint.text().startsWith("Drag: turn (Shift"));
    const auto hover = [&](const QPoint& p) {
      QMouseEvent event(QEvent::MouseMove, p, surface().mapToGlobal(p), Qt::NoButton, Qt::NoButton,
                        {});
      QCoreApplication::sendEvent(&surface(), &event);
    };
    hover(handle(2));
    QCOMPARE(hint.text(), QString("Drag: turn the plane"));
    const QPoint from = handle(2);
    QTest::mousePress(&surface(), Qt::LeftButton, {}, from);
    moveOver(from + QPoint(15, 10));
    QVERIFY(hint.text().contains("Esc takes it back"));
    QTest::mouseRelease(&surface(), Qt::LeftButton, {}, from + QPoint(15, 10));
    QVERIFY(quiet());
    QVERIFY2(!hint.text().contains("Esc takes it back"), qPrintable(hint.text()));
    hover({5, 5});
    QVERIFY(hint.text().startsWith("The arrow keys turn the plane"));
    QTest::keyClick(&surface(), Qt::Key_Escape);
    QVERIFY(hint.text().startsWith("Drag: turn (Shift"));
    // Linked curves that turn with it do not talk.
    d.trigger("surface.plane.open");
    QVERIFY(quiet());
    surface().setFocus();
    dragSurface({30, 200}, {70, 210});
    QVERIFY(quiet());
    QVERIFY2(hint.text().startsWith("Drag: turn (Shift"), qPrintable(hint.text()));
  }

  void anUprightNormalKeepsItsAzimuth() {
    WindowDriver& d = *driver_;
    d.trigger("surface.solid.torus");
    QVERIFY(quiet());
    d.trigger("surface.plane.view");
    QVERIFY(quiet());
    auto& azimuth = d.child<QDoubleSpinBox>("section.azimuth");
    auto& elevation = d.child<QDoubleSpinBox>("section.elevation");
    azimuth.setValue(30.0);
    for (const double end : {90.0, -90.0}) {
      elevation.setValue(end);
      QVERIFY(plane().normal == Eigen::Vector3d(0.0, std::copysign(1.0, end), 0.0));
      QVERIFY(!anglesOf(plane().normal).azimuthDeg);
      QCOMPARE(azimuth.value(), 30.0);
    }
    // What a turn leaves beside the axis says nothing of an azimuth.
    SurfaceSetting setting = *d.scene().surface;
    setting.plane->normal = Eigen::Vector3d(-3e-17, 1.0, 2e-16);
    d.document().push(std::make_unique<SetSurface>(d.document(), setting, "upright"));
    QCOMPARE(azimuth.value(), 30.0);
    elevation.setValue(45.0);
    const double side = std::sqrt(0.5) * std::cos(30.0 / kDeg);
    QVERIFY((plane().normal - Eigen::Vector3d(side, std::sqrt(0.5), -0.5 * std::sqrt(0.5))).norm() <
            1e-12);
    // Chosen while it says nothing, it is there when the normal leans again.
    elevation.setValue(90.0);
    azimuth.setValue(-120.0);
    elevation.setValue(0.0);
    QVERIFY(std::abs(*anglesOf(plane().normal).azimuthDeg + 120.0) < 1e-9);
  }

  void alongTAFlatlandAgrees() {
    WindowDriver& d = *driver_;
    d.trigger("surface.solid.gaussian-bump");
    QVERIFY(quiet());
    surface().setFocus();
    QTest::keyClick(&surface(), Qt::Key_R);
    QVERIFY(quiet());
    // On a ridge, taken from what was found.
    const auto& ridges = seen().seen()->found->of(LineFamily::ApparentRidges);
    QVERIFY(!ridges.empty());
    d.window().surfaceModels().pick.pickTriangle(ridges[ridges.size() / 2].triangle);
    d.trigger("surface.plane.ridge");
    QVERIFY(quiet());
    const auto& view = section().view();
    QVERIFY(view && !view->pairs.empty());
    double least = 90.0;
    for (const SectionPair& pair : view->pairs) {
      if (pair.ridge && pair.offPlaneDeg) least = std::min(least, *pair.offPlaneDeg);
    }
    QVERIFY2(least < 3.0, qPrintable(QString::number(least)));
    // Where flatland agrees, a mark is as strong as the line of the surface, up to the fit of the
    // curve and the estimate of curvature.
    int agreeing = 0;
    for (const SectionPair& pair : view->pairs) {
      if (!pair.ridge || !pair.mark || *pair.offPlaneDeg > 3.0) continue;
      const double line = view->marks.ridges[*pair.ridge].strength;
      const double mark = strengthOf(view->marks.marks[*pair.mark], *view->surface);
      QVERIFY2(std::abs(mark / line - 1.0) < 0.25, qPrintable(QString::number(mark / line)));
      QCOMPARE(pair.strength, std::max(line, mark));
      ++agreeing;
    }
    QVERIFY(agreeing > 0);
    QVERIFY(view->section.plane.normal.cross(camera().towards).norm() > 0.999);
  }

 private:
  /// Cuts a little beside, and back.
  void setPlaneBeside() {
    auto& height = driver_->child<QDoubleSpinBox>("section.height");
    const double before = height.value();
    for (const double value : {before + 1e-3, before}) {
      height.setValue(value);
      QVERIFY(quiet());
    }
  }
  QPushButton& showSection() {
    driver_->window().docks().show("section");
    driver_->settle();
    return driver_->child<QPushButton>("section.open");
  }
  const SurfacePlane& plane() { return *driver_->scene().surface->plane; }
  double ball() { return source().surface()->ballRadius; }
  Projection projection() {
    return orbitProjection(camera(), ball(), surface().width(), surface().height());
  }
  /// Where a handle of the plane is seen.
  QPoint handle(int number) {
    const PlaneHandles handles = handlesOf(plane(), ball());
    const Eigen::Vector3d p =
        number == 0 ? handles.centre : handles.rim[static_cast<std::size_t>(number - 1)];
    const Eigen::Vector2d px = *projection().toScreen(p);
    return {qRound(px.x()), qRound(px.y())};
  }
  void moveOver(const QPoint& p) {
    QMouseEvent event(QEvent::MouseMove, p, surface().mapToGlobal(p), Qt::NoButton, Qt::LeftButton,
                      {});
    QCoreApplication::sendEvent(&surface(), &event);
  }
};

QTEST_MAIN(SlicingTest)
#include "slicing_test.moc"
