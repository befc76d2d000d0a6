// SPDX-License-Identifier: GPL-3.0-or-later
// What counts as unsaved work, and what the question about it names (docs/decisions/0029).
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "ui/commands/scene_commands.h"
#include "ui/commands/sweep_command.h"
#include "ui/model/surface_look.h"
#include "ui/model/surface_source.h"
#include "ui/model/unsaved_work.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kPatienceMs = 60000;  // estimates on a crowded machine

/// A scene without a file, as the program starts.
struct Fixture {
  Document document{defaultScene(), "preset"};
  SurfaceSource source{document};

  bool open(const QString& what) {
    QSignalSpy opened(&source, &SurfaceSource::opened);
    source.open(what);
    return QTest::qWaitFor([&] { return opened.count() == 1; }, kPatienceMs);
  }
  const SurfaceSetting& setting() { return *document.scene().surface; }
  void set(const SurfaceSetting& setting) {
    document.push(std::make_unique<SetSurface>(document, setting, "edit"));
  }
  void keepCamera() {
    SurfaceSetting kept = setting();
    kept.savedCameras.push_back({"mine", kept.camera});
    set(kept);
  }
  void moveThreshold() {
    SurfaceFamily ridges = familyOf(setting(), LineFamily::ApparentRidges);
    ridges.threshold = 0.123;
    set(withFamily(setting(), ridges));
  }
  double threshold() { return *familyOf(setting(), LineFamily::ApparentRidges).threshold; }
  void undo() { document.undoStack().undo(); }
  bool modified() const { return document.isModified(); }
  UnsavedWork gone() {
    return workTakenOut(document.undoStack(), document.undoStack().index(), document.scene(),
                        document.saved());
  }
  QString changes() { return changesForPeople(document.scene(), document.saved()); }
};

}  // namespace

class UnsavedTest : public QObject {
  Q_OBJECT

 private slots:
  void keptCamerasThatAnotherMeshTookThePlaceOf() {
    Fixture f;
    QVERIFY(f.open("solid:torus:16"));
    QVERIFY(f.open("solid:sphere:16"));
    QVERIFY(!f.modified());  // looking is no work
    f.keepCamera();
    QVERIFY(f.modified());
    QVERIFY(f.open("solid:torus:16"));
    QVERIFY(f.modified());
    QVERIFY(f.gone().cameras && !f.gone().lines && !f.gone().swept);
    f.undo();
    QVERIFY(!f.gone().any());
    f.undo();
    QVERIFY(!f.modified());
    // Who removes a camera by hand does not want it.
    f.keepCamera();
    SurfaceSetting without = f.setting();
    without.savedCameras.clear();
    f.set(without);
    QVERIFY(f.open("solid:torus:16"));
    QVERIFY(!f.modified());
  }

  void sweepingTakesKeptCamerasToo() {
    Fixture f;
    QVERIFY(f.open("solid:torus:16"));
    f.keepCamera();
    sweepCurve(f.document, 0, SweptSurface::Kind::Extrusion);  // one step of several commands
    QVERIFY(f.gone().cameras);
    // Sweeping it again leaves those of its own.
    f.keepCamera();
    SurfaceSetting higher = f.setting();
    higher.swept->amount *= 2.0;
    f.set(higher);
    sweepCurve(f.document, 0, SweptSurface::Kind::Extrusion);
    QCOMPARE(f.setting().savedCameras.size(), std::size_t{1});
    sweepCurve(f.document, 0, SweptSurface::Kind::Revolution);
    QVERIFY(f.setting().savedCameras.empty());
  }

  void whatWasMadeOfACurveAndGone() {
    for (const bool closed : {true, false}) {
      Fixture f;
      sweepCurve(f.document, 0, SweptSurface::Kind::Extrusion);
      QVERIFY(f.modified());
      if (closed) {
        f.source.close();
      } else {
        QVERIFY(f.open("solid:torus:16"));
      }
      QVERIFY(f.modified());
      QVERIFY(f.gone().swept && !f.gone().lines && !f.gone().cameras);
      f.undo();
      f.undo();
      QVERIFY(!f.modified());
    }
  }

  void whatACloseTookAway() {
    Fixture f;
    QVERIFY(f.open("solid:torus:16"));
    f.source.close();
    QVERIFY(!f.modified());
    f.undo();
    f.moveThreshold();
    f.keepCamera();
    f.source.close();
    QVERIFY(f.modified());
    QVERIFY(f.gone().cameras && f.gone().lines);
    const QString said = workForPeople(f.gone());
    QVERIFY2(said.contains("thresholds") && said.contains("cameras"), qPrintable(said));
    // The lines live on in the next mesh, the cameras do not.
    QVERIFY(f.open("solid:sphere:16"));
    QCOMPARE(f.threshold(), 0.123);
    QVERIFY(f.gone().cameras && !f.gone().lines);
    // Another scene in the place of all asks for itself; what was given up with it does not.
    f.document.push(std::make_unique<ReplaceScene>(f.document, f.document.origin(), "reset"));
    QVERIFY(!f.modified());
    f.undo();
    QVERIFY(f.modified());
  }

  void aClosedSurfaceLendsNothingToAnotherDocument() {
    Fixture f;
    QVERIFY(f.open("solid:torus:16"));
    f.moveThreshold();
    SurfaceSetting look = f.setting();
    look.ink = 0.05;
    look.upAxis = "z";
    look.panes.resize(1);
    f.set(look);
    f.source.close();
    // A step that brings another scene, and undo, are no other document.
    f.document.push(std::make_unique<ReplaceScene>(f.document, presets()[2].scene, "step"));
    f.undo();
    QVERIFY(f.open("solid:sphere:16"));
    QCOMPARE(f.threshold(), 0.123);
    QCOMPARE(f.setting().upAxis, std::string("z"));
    f.source.close();
    f.document.start(presets()[2].scene, "another");
    QVERIFY(f.open("solid:sphere:16"));
    QCOMPARE(f.threshold(), *usualFamily(LineFamily::ApparentRidges).threshold);
    QVERIFY(!f.setting().ink && f.setting().panes.empty());
    QCOMPARE(f.setting().upAxis, std::string("y"));
    QVERIFY(!f.modified());
  }

  void aSceneWithAFileNamesWhatChanged() {
    Fixture f;
    QTemporaryDir folder;
    const auto save = [&] { f.document.save(folder.filePath("scene.json").toStdString()); };
    const auto says = [&f](const char* what) {
      const bool good = f.modified() && f.changes() == what;
      if (!good) qWarning() << f.changes();
      return good;
    };
    save();
    QVERIFY(f.open("solid:torus:16"));
    QVERIFY(says("torus:16 beside the curves"));
    f.keepCamera();
    save();
    QVERIFY(!f.gone().any());
    QVERIFY(f.open("solid:sphere:16"));
    // The file has the camera.
    QVERIFY(!f.gone().any());
    QVERIFY(says("sphere:16 in the place of: torus:16"));
    f.undo();
    f.source.close();
    QVERIFY(says("that a surface was closed (torus:16)"));
    f.undo();
    SurfaceSetting cut = f.setting();
    cut.plane = SurfacePlane{};
    f.set(cut);
    QVERIFY(says("the plane that cuts the surface"));
    save();
    cut.plane.reset();
    f.set(cut);
    QVERIFY(says("that the plane was removed"));
    f.undo();
    SurfaceSetting paper = f.setting();
    paper.style = "paper";
    f.set(paper);
    QVERIFY(says("how torus:16 is shown"));
    f.undo();
    sweepCurve(f.document, 0, SweptSurface::Kind::Extrusion);
    QVERIFY(says("the surface made of a curve"));
  }
};

QTEST_MAIN(UnsavedTest)
#include "unsaved_test.moc"
