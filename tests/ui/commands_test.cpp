// SPDX-License-Identifier: GPL-3.0-or-later
// The commands and models without a window.
#include <QSignalSpy>
#include <QTest>

#include "flatland/io/input_error.h"
#include "ui/commands/curve_commands.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/probe.h"
#include "ui/model/stage.h"
#include "ui/model/swept_surface.h"
#include "ui/model/viewport.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

/// A document with what each test asks of it.
struct Fixture {
  Document document{defaultScene(), "preset"};
  Scene before = document.scene();
  QSignalSpy spy{&document, &Document::changed};

  int steps() { return document.undoStack().count(); }
};

/// What holds for every command: one signal each way, undo restores to the last bit, redo the
/// result.
void checkSwap(Fixture& f, std::unique_ptr<QUndoCommand> command) {
  f.document.push(std::move(command));
  const Scene after = f.document.scene();
  QVERIFY(!(after == f.before));
  QCOMPARE(f.spy.count(), 1);
  QCOMPARE(f.steps(), 1);
  f.document.undoStack().undo();
  QVERIFY(f.document.scene() == f.before);
  QCOMPARE(f.spy.count(), 2);
  f.document.undoStack().redo();
  QVERIFY(f.document.scene() == after);
  QCOMPARE(f.spy.count(), 3);
}

/// Five curves apart from each other; a surface is swept from one of them.
Scene sweptScene(std::size_t swept) {
  Scene scene;
  for (int i = 0; i < 5; ++i) {
    const double x = 10.0 * i;
    scene.curves.push_back({BezierChain(Bezier{{{x, 0}, {x + 1, 2}, {x + 2, -2}, {x + 3, 1}}})});
  }
  scene.surface = sweptSetting(scene, swept, SweptSurface::Kind::Extrusion);
  return scene;
}

/// A document of that; the shape that its surface is swept from.
struct SweptFixture {
  explicit SweptFixture(std::size_t swept)
      : document(sweptScene(swept), "preset"), before(document.scene()) {}

  Curve shape() { return sweptOf(document.scene())->curve; }
  void removeCurves(const std::set<std::size_t>& curves) {
    std::set<PointRef> points;
    for (const std::size_t c : curves) {
      for (std::size_t i = 0; i < 4; ++i) points.insert({c, i});
    }
    document.push(std::make_unique<RemovePoints>(document, withoutPoints(before, points)));
  }

  Document document;
  Scene before;
  QSignalSpy spy{&document, &Document::changed};
};

double farthestFrom(const BezierChain& a, const BezierChain& b) {
  double worst = 0.0;
  for (int i = 0; i <= 200; ++i) {
    worst = std::max(worst, nearestPoint(b, pointAt(a, a.pieceCount() * i / 200.0)).distance);
  }
  return worst;
}

/// Nearest points are good to about 1e-8 in the parameter.
constexpr double kSameShape = 1e-7;

}  // namespace

class CommandsTest : public QObject {
  Q_OBJECT

 private slots:
  void movesPoints() {
    Fixture f;
    checkSwap(f, std::make_unique<MovePoints>(f.document, f.before, std::set<PointRef>{{0, 1}},
                                              Vec2(0.25, -0.5), JointMode::Keep));
    const Vec2 expected = f.before.curves[0].chain().points()[1] + Vec2(0.25, -0.5);
    QVERIFY(f.document.scene().curves[0].chain().points()[1] == expected);
    QVERIFY(f.document.scene().curves[0].chain().points()[2] ==
            f.before.curves[0].chain().points()[2]);
  }

  void placesAPointExactly() {
    Fixture f;
    const Vec2 target(0.1 + 0.2, 1.0 / 3.0);
    checkSwap(f, std::make_unique<PlacePoint>(f.document, PointRef{0, 2}, target));
    QVERIFY(f.document.scene().curves[0].chain().points()[2] == target);
  }

  void insertsWithoutChangingTheShape() {
    Fixture f;
    checkSwap(f, std::make_unique<InsertPoint>(f.document, 0, 0.3));
    const BezierChain& chain = f.document.scene().curves[0].chain();
    QCOMPARE(chain.pieceCount(), 2);
    QVERIFY(farthestFrom(chain, f.before.curves[0].chain()) < kSameShape);
    QVERIFY(farthestFrom(f.before.curves[0].chain(), chain) < kSameShape);
  }

  void raisesTheDegreeWithoutChangingTheShape() {
    Fixture f;
    checkSwap(f, std::make_unique<RaiseDegree>(f.document, 0));
    const BezierChain& chain = f.document.scene().curves[0].chain();
    QCOMPARE(chain.degree(), f.before.curves[0].chain().degree() + 1);
    QVERIFY(farthestFrom(chain, f.before.curves[0].chain()) < kSameShape);
  }

  void flipsTheNormal() {
    Fixture f;
    checkSwap(f, std::make_unique<FlipNormal>(f.document, 0));
    QVERIFY(f.document.scene().curves[0].flipNormal != f.before.curves[0].flipNormal);
  }

  void removesPoints() {
    Fixture f;
    PointRemoval removal = withoutPoints(f.before, {{0, 2}});
    QVERIFY(removal.possible());
    checkSwap(f, std::make_unique<RemovePoints>(f.document, std::move(removal)));
    QCOMPARE(f.document.scene().curves[0].chain().points().size(), std::size_t{4});
  }

  void removingAllPointsRemovesTheCurve() {
    Fixture f;
    std::set<PointRef> all;
    for (std::size_t i = 0; i < f.before.curves[0].chain().points().size(); ++i) all.insert({0, i});
    PointRemoval removal = withoutPoints(f.before, all);
    QVERIFY(removal.possible());
    QVERIFY(removal.curves.empty());
  }

  void saysWhyPointsCannotGo() {
    const Scene line{{{BezierChain(Bezier{{{0, 0}, {1, 0}, {2, 1}}})}}, {}};
    const PointRemoval removal = withoutPoints(line, {{0, 0}, {0, 1}});
    QVERIFY(!removal.possible());
    QVERIFY(!removal.reason.empty());
  }

  void addsAndRemovesCurves() {
    Fixture f;
    const SceneCurve other{BezierChain(Bezier{{{0, 0}, {1, 2}, {2, 0}}})};
    checkSwap(f, std::make_unique<AddCurve>(f.document, other));
    QCOMPARE(f.document.scene().curves.size(), std::size_t{2});
    QVERIFY(f.document.scene().curves[1] == other);
    f.document.push(std::make_unique<RemoveCurve>(f.document, 0));
    QVERIFY(f.document.scene().curves == std::vector<SceneCurve>{other});
    f.document.undoStack().undo();
    QVERIFY(f.document.scene().curves[0] == f.before.curves[0]);
  }

  void aSweptSurfaceStaysWithItsCurve() {
    SweptFixture f(2);
    const Curve swept = f.before.curves[2].shape;
    f.document.push(std::make_unique<RemoveCurve>(f.document, 0));
    QCOMPARE(f.document.scene().surface->swept->curve, std::size_t{1});
    QVERIFY(f.shape() == swept);
    f.document.push(std::make_unique<RemoveCurve>(f.document, 3));
    QVERIFY(f.shape() == swept);
    f.document.undoStack().undo();
    f.document.undoStack().undo();
    QVERIFY(f.document.scene() == f.before);
    f.removeCurves({0, 1, 4});
    QCOMPARE(f.document.scene().surface->swept->curve, std::size_t{0});
    QVERIFY(f.shape() == swept);
    QCOMPARE(f.spy.count(), 5);  // one each
    // Looking is no edit: it outlasts undo.
    SurfaceCamera camera = f.before.surface->camera;
    camera.zoom = 2.0;
    f.document.setCamera(camera);
    f.document.undoStack().undo();
    QVERIFY(f.shape() == swept);
    QCOMPARE(f.document.scene().surface->camera.zoom, 2.0);
    // A curve more changes nothing.
    f.document.push(std::make_unique<AddCurve>(f.document, f.before.curves[0]));
    QVERIFY(f.shape() == swept);
  }

  void aSweptSurfaceGoesWithItsCurve() {
    for (const bool byPoints : {false, true}) {
      SweptFixture f(2);
      if (byPoints) {
        f.removeCurves({0, 2});
      } else {
        f.document.push(std::make_unique<RemoveCurve>(f.document, 2));
      }
      QVERIFY(!f.document.scene().surface);
      QCOMPARE(f.document.undoStack().count(), 1);
      QVERIFY(f.spy.takeFirst().at(0).value<Change>().touchesSurface());
      // Curves that come later are not swept.
      f.document.push(std::make_unique<AddCurve>(f.document, f.before.curves[0]));
      QVERIFY(!f.document.scene().surface);
      f.document.undoStack().undo();
      f.document.undoStack().undo();
      QVERIFY(f.document.scene() == f.before);
      QVERIFY(f.spy.takeLast().at(0).value<Change>().touchesSurface());
      f.document.undoStack().redo();
      QVERIFY(!f.document.scene().surface);
      f.document.undoStack().undo();
      QVERIFY(f.document.scene() == f.before);
    }
  }

  void whatIsPickedOfACurveStaysThere() {
    SweptFixture f(0);
    Selection selection(f.document);
    Probe probe(f.document);
    selection.setPoints({{1, 0}, {3, 2}});
    selection.setMark(keyOf(f.document.features(), f.document.features().marks.size() - 1));
    QCOMPARE(selection.mark()->curve, 4);
    selection.setCurrentCurve(3);
    probe.setPlace(Probe::Place{3, 0.25});
    const auto stays = [&](std::size_t curve) {
      return selection.points() == std::set<PointRef>{{curve, 2}} &&
             selection.mark()->curve == static_cast<int>(curve) + 1 &&
             selection.currentCurve() == curve && probe.place()->curve == curve &&
             std::abs(probe.place()->t - 0.25) < kSameShape;
    };
    f.removeCurves({1, 2});
    QVERIFY(stays(1));
    f.document.undoStack().undo();
    QVERIFY(stays(3));
    f.document.undoStack().redo();
    QVERIFY(stays(1));
    // Where the curve itself goes, so does what is picked of it.
    f.document.push(std::make_unique<RemoveCurve>(f.document, 1));
    QVERIFY(selection.points().empty());
    QCOMPARE(selection.mark()->curve, 1);
    QCOMPARE(probe.place()->curve, std::size_t{0});
    f.document.push(std::make_unique<RemoveCurve>(f.document, 1));
    QVERIFY(!selection.mark());
  }

  void setsTheView() {
    Fixture f;
    checkSwap(f, std::make_unique<SetView>(f.document, View{30.0, 5.0}));
  }

  void replacesTheScene() {
    Fixture f;
    checkSwap(f, std::make_unique<ReplaceScene>(f.document, presets()[1].scene, "reset"));
  }

  void aGestureIsOneStep() {
    Fixture f;
    const int gesture = f.document.newGesture();
    for (int i = 1; i <= 10; ++i) {
      f.document.push(std::make_unique<MovePoints>(f.document, f.before, std::set<PointRef>{{0, 0}},
                                                   Vec2(0.1 * i, 0.0), JointMode::Keep, gesture));
    }
    QCOMPARE(f.spy.count(), 10);
    QCOMPARE(f.steps(), 1);
    const int next = f.document.newGesture();
    f.document.push(std::make_unique<MovePoints>(f.document, f.document.scene(),
                                                 std::set<PointRef>{{0, 0}}, Vec2(0.0, 1.0),
                                                 JointMode::Keep, next));
    QCOMPARE(f.steps(), 2);
    f.document.undoStack().undo();
    f.document.undoStack().undo();
    QVERIFY(f.document.scene() == f.before);
  }

  void aGestureThatReturnsLeavesNoStep() {
    Fixture f;
    const int gesture = f.document.newGesture();
    for (const double x : {0.3, 0.7, 0.0}) {
      f.document.push(std::make_unique<MovePoints>(f.document, f.before, std::set<PointRef>{{0, 0}},
                                                   Vec2(x, 0.0), JointMode::Keep, gesture));
    }
    QVERIFY(f.document.scene() == f.before);
    QCOMPARE(f.steps(), 0);
    QVERIFY(!f.document.isModified());
    const int turn = f.document.newGesture();
    for (const double angle : {10.0, 20.0, f.before.view.angleDeg}) {
      f.document.push(std::make_unique<SetView>(f.document, View{angle, std::nullopt}, turn));
    }
    QCOMPARE(f.steps(), 0);
  }

  void equalValuesLeaveNoTrace() {
    Fixture f;
    f.document.push(std::make_unique<SetView>(f.document, View{45.0, std::nullopt}));
    f.document.undoStack().undo();
    f.spy.clear();
    const auto& points = f.before.curves[0].chain().points();
    f.document.push(std::make_unique<SetView>(f.document, f.before.view));
    f.document.push(std::make_unique<PlacePoint>(f.document, PointRef{0, 1}, points[1]));
    f.document.push(std::make_unique<ReplaceScene>(f.document, f.before, "reset"));
    QCOMPARE(f.spy.count(), 0);
    QVERIFY2(f.document.undoStack().canRedo(), "what was undone can still be redone");
  }

  void marksAreComputedOncePerChange() {
    Fixture f;
    f.document.features();
    const int before = f.document.featureComputations();
    f.document.features();
    QCOMPARE(f.document.featureComputations(), before);
    f.document.push(std::make_unique<SetView>(f.document, View{45.0, std::nullopt}));
    f.document.features();
    f.document.features();
    QCOMPARE(f.document.featureComputations(), before + 1);
    QVERIFY(!f.document.features().marks.empty());
  }

  void failedOpenChangesNothing() {
    Fixture f;
    f.document.push(std::make_unique<SetView>(f.document, View{45.0, std::nullopt}));
    const Scene mine = f.document.scene();
    f.spy.clear();
    QVERIFY_EXCEPTION_THROWN(f.document.open("/nonexistent/scene.json"), InputError);
    QVERIFY(f.document.scene() == mine);
    QCOMPARE(f.steps(), 1);
    QCOMPARE(f.spy.count(), 0);
  }

  void selectionLosesWhatVanishes() {
    Fixture f;
    Selection selection(f.document);
    selection.setPoints({{0, 1}, {0, 4}, {7, 0}});
    QVERIFY((selection.points() == std::set<PointRef>{{0, 1}, {0, 4}}));
    QSignalSpy changed(&selection, &Selection::changed);
    selection.setPoints({{0, 1}, {0, 4}});
    QCOMPARE(changed.count(), 0);
    f.document.push(std::make_unique<RemovePoints>(f.document, withoutPoints(f.before, {{0, 2}})));
    QVERIFY((selection.points() == std::set<PointRef>{{0, 1}}));
    QCOMPARE(changed.count(), 1);
  }

  void marksKeepTheirKeys() {
    Fixture f;
    const FeatureSet& features = f.document.features();
    for (std::size_t i = 0; i < features.marks.size(); ++i) {
      QVERIFY(indexOf(features, keyOf(features, i)) == i);
    }
    QVERIFY(!indexOf(features, {MarkKind::Silhouette, 5, 0}));
  }

  void viewportMapsThereAndBack() {
    Viewport viewport;
    viewport.setSize({800, 600});
    viewport.fit({{-2, -1}, {4, 3}});
    const Vec2 world(1.25, -0.75);
    QVERIFY((viewport.toWorld(viewport.toWidget(world)) - world).norm() < 1e-12);
    QVERIFY((viewport.worldToWidget().map(QPointF(1.25, -0.75)) - viewport.toWidget(world))
                .manhattanLength() < 1e-9);
    QVERIFY2(viewport.toWidget({0, 1}).y() < viewport.toWidget({0, 0}).y(), "y points up");
    const QPointF fixed(123, 456);
    const Vec2 under = viewport.toWorld(fixed);
    viewport.zoomAt(fixed, 3.0);
    QVERIFY((viewport.toWorld(fixed) - under).norm() < 1e-12);
    QSignalSpy changed(&viewport, &Viewport::changed);
    viewport.panBy({});
    viewport.centreOn(viewport.centre());
    QCOMPARE(changed.count(), 0);
  }

  void fittedBoxIsInside() {
    Viewport viewport;
    viewport.setSize({800, 300});
    viewport.fit({{-2, -1}, {4, 3}});
    const QRectF room(QPointF(), QSizeF(800, 300));
    QVERIFY(room.contains(viewport.toWidget({-2, -1})) && room.contains(viewport.toWidget({4, 3})));
    QVERIFY(std::abs(viewport.toWidget({0, 3}).y() - Viewport::kMarginPx) < 1e-9);
  }

  void stageTurnsWithTheHandle() {
    Fixture f;
    Stage stage(f.document);
    for (const double angle : {0.0, 30.0, 135.0, -90.0}) {
      f.document.push(std::make_unique<SetView>(f.document, View{angle, std::nullopt}));
      QCOMPARE(stage.viewWithHandleAt(stage.handle(), false, false).angleDeg, angle);
    }
    const Vec2 up = stage.pivot() + Vec2(0.3, 5.0);
    QCOMPARE(stage.viewWithHandleAt(up, true, false).angleDeg, 90.0);
    QVERIFY(!stage.viewWithHandleAt(up, true, false).distance);
    f.document.push(std::make_unique<SetView>(f.document, View{0.0, 8.0}));
    QVERIFY((stage.handle() - Vec2(8, 0)).norm() < 1e-12);
    QCOMPARE(*stage.viewWithHandleAt({0, 6}, false, false).distance, 6.0);
    QCOMPARE(*stage.viewWithHandleAt({0, 6}, false, true).distance, 8.0);
    QCOMPARE(stage.viewWithHandleAt({0, 6}, false, false).angleDeg, 90.0);
    QVERIFY(stage.screenOffset() < 8.0);
  }

  void stageStandsStillWhileHeld() {
    Fixture f;
    Stage stage(f.document);
    const double radius = stage.radius();
    stage.hold();
    f.document.push(std::make_unique<MovePoints>(f.document, f.before, std::set<PointRef>{{0, 0}},
                                                 Vec2(50.0, 0.0), JointMode::Keep));
    QCOMPARE(stage.radius(), radius);
    stage.release();
    QVERIFY(stage.radius() > 2.0 * radius);
  }
};

QTEST_GUILESS_MAIN(CommandsTest)
#include "commands_test.moc"
