// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of the document without a window: its camera, reading, lines, and the painted
// picture.
#include <Eigen/Geometry>
#include <QColor>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/commands/scene_commands.h"
#include "ui/model/orbit.h"
#include "ui/model/seen_surface.h"
#include "ui/model/surface_probe.h"
#include "ui/view3d/surface_figure.h"
#include "ui/view3d/surface_picture.h"

using namespace flatland;
using namespace flatland::ui;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kPatienceMs = 60000;  // estimates on a crowded machine

SurfaceCamera someCamera(bool perspective) {
  SurfaceCamera camera;
  camera.towards = Vector3d(0.3, -0.5, 0.8).normalized();
  camera.up = Vector3d(0.2, 1.0, 0.1);
  camera.centre = {0.1, 0.05, -0.2};
  camera.zoom = 1.7;
  if (perspective) camera.perspectiveDeg = 40.0;
  return camera;
}

/// Where the matrix puts a point, in pixels.
Vector2d byMatrix(const Projection& projection, const Vector3d& p) {
  const Eigen::Vector4d c = clipMatrix(projection, 1.2) * p.homogeneous();
  return {(c.x() / c.w() + 1.0) * 0.5 * projection.width,
          (1.0 - c.y() / c.w()) * 0.5 * projection.height};
}

/// A document with the sources that look at it.
struct Fixture {
  Document document{defaultScene(), "preset"};
  SurfaceSource source{document};
  SeenSource seen{document, source};
  QSignalSpy opened{&source, &SurfaceSource::opened};
  QSignalSpy failed{&source, &SurfaceSource::failed};

  Fixture() { source.setActive(true); }
  bool open(const QString& what) {
    source.open(what);
    return QTest::qWaitFor([this] { return !source.isBusy() && !seen.isStale(); }, kPatienceMs);
  }
  const SurfaceSetting& setting() { return *document.scene().surface; }
};

}  // namespace

class SurfaceModelTest : public QObject {
  Q_OBJECT

 private slots:
  /// The last message is about the file asked for last, and a mesh that comes back is told of.
  void whatCannotBeReadIsToldOnce() {
    Fixture f;
    const auto last = [&f] { return f.failed.last()[0].toString(); };
    const auto quiet = [&f] {
      return QTest::qWaitFor([&f] { return !f.source.isBusy(); }, kPatienceMs);
    };
    SurfaceSetting own;
    own.mesh = "none/own.ply";
    f.document.push(std::make_unique<SetSurface>(f.document, own, "edit"));
    QVERIFY(quiet());
    QCOMPARE(f.failed.count(), 1);
    QVERIFY2(last().contains("own.ply"), qPrintable(last()));
    f.source.open("none/other.ply");
    QVERIFY(quiet());
    QTest::qWait(50);
    QVERIFY(quiet());
    QCOMPARE(f.failed.count(), 2);
    QVERIFY2(last().contains("other.ply"), qPrintable(last()));
    f.document.undoStack().undo();
    QVERIFY(!f.document.scene().surface);
    f.document.undoStack().redo();
    QVERIFY(f.source.isReading());
    QVERIFY(quiet());
    QCOMPARE(f.failed.count(), 3);
    QVERIFY2(last().contains("own.ply"), qPrintable(last()));
    // Edits of how it would look do not read it again.
    own.style = "paper";
    f.document.push(std::make_unique<SetSurface>(f.document, own, "edit"));
    QVERIFY(!f.source.isBusy());
    // Another scene that names it does.
    Scene scene = f.document.scene();
    f.document.start(scene, "again");
    QVERIFY(quiet());
    QCOMPARE(f.failed.count(), 4);
    // What was being read for the scene when another file was asked for is read after it.
    own.mesh = "solid:torus:24";
    f.document.push(std::make_unique<SetSurface>(f.document, own, "edit"));
    QVERIFY(f.source.isReading());
    f.source.open("none/other.ply");
    QVERIFY(
        QTest::qWaitFor([&f] { return f.source.surface() && !f.source.isBusy(); }, kPatienceMs));
    QCOMPARE(f.failed.count(), 5);
    QCOMPARE(f.source.surface()->reference, std::string("solid:torus:24"));
  }

  void matrixAndProjectionAgree() {
    for (const bool perspective : {false, true}) {
      const Projection projection = orbitProjection(someCamera(perspective), 1.2, 640, 400);
      for (const Vector3d& p :
           {Vector3d(0, 0, 0), Vector3d(0.7, -0.4, 0.5), Vector3d(-0.9, 0.3, -0.2)}) {
        const auto px = projection.toScreen(p);
        QVERIFY(px);
        QVERIFY((byMatrix(projection, p) - *px).norm() < 1e-9);
        // And the line of sight through that pixel leads back to the point.
        const Sight sight = sightThrough(projection, *px);
        QVERIFY((p - sight.from).cross(sight.along).norm() < 1e-9);
        // Nearer is less deep.
        const Eigen::Matrix4d clip = clipMatrix(projection, 1.2);
        const Eigen::Vector4d here = clip * p.homogeneous();
        const Eigen::Vector4d nearer = clip * Vector3d(p - 0.1 * sight.along).homogeneous();
        QVERIFY(nearer.z() / nearer.w() < here.z() / here.w());
        QVERIFY(std::abs(here.z()) < here.w());
      }
    }
  }

  void coloursKeepTheBulkApartFromTheExtremes() {
    // The terms grow without bound towards the outline, yet half of the vertices are in colour.
    Fixture f;
    QVERIFY(f.open("solid:bumpy-sphere"));
    const LoadedSurface& surface = *f.source.surface();
    for (const SurfaceQuantity quantity : {SurfaceQuantity::Feature, SurfaceQuantity::Offset}) {
      const VertexColours colours =
          vertexColours(*surface.mesh, *surface.fields, f.seen.seen()->view, quantity);
      const ColourScale& scale = colours.scale;
      QVERIFY(scale.knee > 0.0 && scale.knee < scale.high);
      QCOMPARE(scale.share(0.0), 0.5);
      QCOMPARE(scale.share(-scale.high), 0.0);
      QCOMPARE(scale.share(2.0 * scale.high), 1.0);
      QVERIFY(scale.share(std::nan("")) < 0.0);
      for (const double v : {0.1 * scale.knee, scale.knee, 0.5 * scale.high}) {
        QVERIFY(std::abs(scale.share(v) + scale.share(-v) - 1.0) < 1e-12);
        QVERIFY(scale.share(v) < scale.share(1.01 * v));
      }
      const auto apart = [](float share) { return std::abs(share - 0.5f) > 0.05f; };
      const auto coloured = std::count_if(colours.share.begin(), colours.share.end(), apart);
      QVERIFY(2 * coloured > static_cast<std::ptrdiff_t>(colours.share.size()));
    }
    // In the middle as pale or dark as the ground.
    ColourScale scale;
    scale.diverging = true;
    QVERIFY(scale.at(0.5, Palette::Light).r > 0xE0 && scale.at(0.5, Palette::Dark).r < 0x40);
    QVERIFY(scale.at(0.0, Palette::Light) == scale.stops(Palette::Light).front());
  }

  void theBallFitsAtZoomOne() {
    for (const bool perspective : {false, true}) {
      SurfaceCamera camera;
      if (perspective) camera.perspectiveDeg = 60.0;
      const Projection projection = orbitProjection(camera, 1.3, 500, 300);
      double highest = 1e9;
      for (int i = 0; i < 720; ++i) {
        for (int k = -60; k <= 60; ++k) {
          const double a = i * std::numbers::pi / 360.0, h = k / 60.0;
          const Vector3d p = 1.3 * Vector3d(std::sqrt(1 - h * h) * std::cos(a), h,
                                            std::sqrt(1 - h * h) * std::sin(a));
          highest = std::min(highest, projection.toScreen(p)->y());
        }
      }
      const double margin = drawingCamera(camera, 500, 300).margin;
      QVERIFY2(std::abs(highest - margin) < 0.5, qPrintable(QString::number(highest)));
    }
  }

  void theFrontFollowsTheHand() {
    const SurfaceCamera camera = someCamera(false);
    const Projection before = orbitProjection(camera, 1.0, 600, 600);
    const Vector3d front = camera.centre + 0.5 * camera.towards;
    for (const Vector2d& drag : {Vector2d(30, 0), Vector2d(0, 30), Vector2d(-20, 10)}) {
      const SurfaceCamera after = orbited(camera, drag, 600);
      const Projection seen = orbitProjection(after, 1.0, 600, 600);
      const Vector2d moved = *seen.toScreen(front) - *before.toScreen(front);
      QVERIFY(moved.dot(drag) > 0.9 * moved.norm() * drag.norm());
      QVERIFY(std::abs(after.towards.norm() - 1.0) < 1e-12);
      QVERIFY(std::abs(after.towards.dot(after.up)) < 1e-12);
      QCOMPARE(after.centre, camera.centre);
    }
    // Over the height of the picture: half a turn.
    const SurfaceCamera half = orbited(camera, {600, 0}, 600);
    QVERIFY((half.towards + camera.towards -
             2.0 * camera.towards.dot(Vector3d(before.axes.row(1))) * Vector3d(before.axes.row(1)))
                .norm() < 1e-12);
  }

  void movingAndZoomingKeepWhatIsUnderTheHand() {
    for (const bool perspective : {false, true}) {
      const SurfaceCamera camera = someCamera(perspective);
      const Projection before = orbitProjection(camera, 1.0, 640, 480);
      const Vector2d px(500, 100), drag(37, -12);
      const Projection moved = orbitProjection(panned(camera, before, drag), 1.0, 640, 480);
      QVERIFY((*moved.toScreen(camera.centre) - Vector2d(320, 240) - drag).norm() < 1e-9);
      // A point of the plane through the centre that is under the pointer stays there.
      const Sight sight = sightThrough(before, px);
      const double s =
          (camera.centre - sight.from).dot(camera.towards) / sight.along.dot(camera.towards);
      const Vector3d under = sight.from + s * sight.along;
      const Projection zoomed = orbitProjection(zoomedAt(camera, before, px, 1.5), 1.0, 640, 480);
      QVERIFY((*zoomed.toScreen(under) - px).norm() < 1e-9);
      QCOMPARE(zoomedAt(camera, before, px, 1e9).zoom, kMostZoom);
    }
  }

  void viewsAndTurns() {
    const SurfaceCamera camera = someCamera(true);
    QCOMPARE(seenFrom(camera, StandardView::Top).towards, Vector3d(0, 1, 0));
    QCOMPARE(seenFrom(camera, StandardView::Right).towards, Vector3d(1, 0, 0));
    QVERIFY(seenFrom(camera, StandardView::Front).perspectiveDeg);
    QVERIFY(!withPerspectiveToggled(camera).perspectiveDeg);
    SurfaceCamera turning = camera;
    for (int i = 0; i < 360; ++i) turning = rolled(turning, std::numbers::pi / 180.0);
    QVERIFY((turning.towards - camera.towards).norm() < 1e-12);
    const Projection seen = orbitProjection(camera, 1.0, 100, 100);
    const Projection quarter = orbitProjection(rolled(camera, std::numbers::pi / 2), 1.0, 100, 100);
    // Counter-clockwise: what pointed right points up.
    const Vector3d right = camera.centre + 0.1 * Vector3d(seen.axes.row(0));
    QVERIFY(quarter.toScreen(right)->y() < 49.0);
  }

  void anotherAxisPointsUpward() {
    const Vector3d axes[] = {Vector3d::UnitX(),  -Vector3d::UnitX(), Vector3d::UnitY(),
                             -Vector3d::UnitY(), Vector3d::UnitZ(),  -Vector3d::UnitZ()};
    for (const Vector3d& up : axes) {
      const Eigen::Matrix3d turn = uprightTurn(up);
      QCOMPARE(turn.determinant(), 1.0);
      QCOMPARE(Vector3d(turn * Vector3d::UnitY()), up);
      for (const StandardView view : {StandardView::Front, StandardView::Left}) {
        const SurfaceCamera camera = seenFrom({}, view, up);
        QCOMPARE(camera.up, up);
        QCOMPARE(camera.towards.dot(up), 0.0);
      }
      QCOMPARE(seenFrom({}, StandardView::Top, up).towards, up);
      // What is nearer to the top of the file is higher on the picture.
      const Projection home = orbitProjection(homeCamera(up), 1.0, 100, 100);
      QVERIFY(home.toScreen(0.5 * up)->y() < home.toScreen(-0.5 * up)->y() - 30.0);
    }
    QCOMPARE(seenFrom({}, StandardView::Front, Vector3d::UnitZ()).towards, Vector3d(0, -1, 0));
    QCOMPARE(seenFrom({}, StandardView::Right, Vector3d::UnitZ()).towards, Vector3d(1, 0, 0));
    QVERIFY(homeCamera(Vector3d::UnitY()) == SurfaceCamera{});
  }

  void openingIsOneUndoStep() {
    Fixture f;
    QVERIFY(f.open("solid:torus:30"));
    QCOMPARE(f.opened.count(), 1);
    QCOMPARE(f.document.undoStack().count(), 1);
    QCOMPARE(f.setting().mesh, std::string("solid:torus:30"));
    QVERIFY(f.source.surface() && f.source.surface()->fields);
    QCOMPARE(f.document.featureComputations(), 0);  // marks of the curves are not its matter
    f.document.undoStack().undo();
    QVERIFY(!f.document.scene().surface);
    QVERIFY(!f.source.surface());
    QVERIFY(!f.seen.seen());
    f.document.undoStack().redo();
    QVERIFY(QTest::qWaitFor([&] { return f.source.surface() && f.source.surface()->fields; },
                            kPatienceMs));
  }

  void whatCannotBeReadChangesNothing() {
    Fixture f;
    QVERIFY(f.open("solid:sphere:16"));
    const auto before = f.source.surface();
    const Scene scene = f.document.scene();
    const QTemporaryDir folder;
    QFile file(folder.filePath("bad.obj"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("v 0 0 0\nv 1 0 0\nf 1 2 7\n");
    file.close();
    for (const QString& name :
         {file.fileName(), folder.filePath("none.ply"), QString("solid:cube")}) {
      f.failed.clear();
      QVERIFY(f.open(name));
      QCOMPARE(f.failed.count(), 1);
      QVERIFY2(f.failed[0][0].toString().contains(name), qPrintable(f.failed[0][0].toString()));
      QVERIFY(f.document.scene() == scene);
      QCOMPARE(f.source.surface(), before);
    }
    QCOMPARE(f.document.undoStack().count(), 1);
  }

  void theCameraIsNoEdit() {
    Fixture f;
    QVERIFY(f.open("solid:torus:30"));
    SurfaceSetting edited = f.setting();
    edited.style = "paper";
    f.document.push(std::make_unique<SetSurface>(f.document, edited, "edit"));
    const int steps = f.document.undoStack().count();
    const QSignalSpy changes(&f.document, &Document::changed);
    const SurfaceCamera side = seenFrom(f.setting().camera, StandardView::Right);
    f.document.setCamera(side);
    f.document.setCamera(side);
    QCOMPARE(changes.count(), 1);
    QCOMPARE(f.document.undoStack().count(), steps);
    f.document.undoStack().undo();
    QCOMPARE(f.setting().style, SurfaceSetting{}.style);
    QVERIFY(f.setting().camera == side);
  }

  void linesFollowTheNewestCamera() {
    Fixture f;
    QVERIFY(f.open("solid:bumpy-sphere:24"));
    QVERIFY(f.seen.seen());
    const int before = f.seen.searches();
    constexpr int kTurns = 40;
    for (int i = 0; i < kTurns; ++i) f.document.setCamera(orbited(f.setting().camera, {7, 3}, 500));
    QVERIFY(f.seen.isStale());
    QVERIFY(f.seen.seen());  // the last ones stay meanwhile
    QVERIFY(QTest::qWaitFor([&] { return !f.seen.isStale(); }, kPatienceMs));
    QVERIFY((f.seen.seen()->view.towards - f.setting().camera.towards).norm() < 1e-12);
    QVERIFY(f.seen.searches() - before <= 2);  // the one under way, and the newest
    const auto& lines = f.seen.seen()->lines;
    QVERIFY(!lines[static_cast<std::size_t>(LineFamily::OccludingContours)].empty());
    QVERIFY(lines[static_cast<std::size_t>(LineFamily::Ridges)].empty());
  }

  void familiesAndThresholdsDecideTheLines() {
    Fixture f;
    QVERIFY(f.open("solid:bumpy-sphere:24"));
    const auto count = [&f](LineFamily family) {
      if (!QTest::qWaitFor([&f] { return !f.seen.isStale(); }, kPatienceMs)) qFatal("no lines");
      return f.seen.seen()->lines[static_cast<std::size_t>(family)].size();
    };
    const auto set = [&f](const SurfaceFamily& family) {
      f.document.push(
          std::make_unique<SetSurface>(f.document, withFamily(f.setting(), family), "edit"));
    };
    SurfaceFamily ridges = usualFamily(LineFamily::ApparentRidges);
    ridges.threshold = 0.5;
    set(ridges);
    const std::size_t many = count(LineFamily::ApparentRidges);
    ridges.threshold = 8.0;
    set(ridges);
    const std::size_t few = count(LineFamily::ApparentRidges);
    QVERIFY(many > 0);
    QVERIFY2(few < many, qPrintable(QString("%1 %2").arg(few).arg(many)));
    ridges.on = false;
    set(ridges);
    QCOMPARE(count(LineFamily::ApparentRidges), std::size_t{0});
    SurfaceFamily isophotes = usualFamily(LineFamily::Isophotes);
    isophotes.on = true;
    set(isophotes);
    QVERIFY(count(LineFamily::Isophotes) > 0);
  }

  void aFamilyWithoutAThresholdHasTheUsualOne() {
    for (const LineFamily family : allLineFamilies()) {
      SurfaceSetting setting;
      SurfaceFamily named;
      named.name = nameOf(family);
      setting.families = {named};
      const double usual = LineOptions{}.threshold[static_cast<std::size_t>(family)];
      QCOMPARE(familyOf(setting, family).threshold, std::optional(usual));
      QCOMPARE(lineOptionsOf(setting).threshold[static_cast<std::size_t>(family)], usual);
      setting.families[0].threshold = 0.25;
      QCOMPARE(familyOf(setting, family).threshold, std::optional(0.25));
    }
    // A sphere has no creases; with a threshold of 0 every edge is one.
    Fixture f;
    QVERIFY(f.open("solid:sphere:8"));
    SurfaceFamily creases;
    creases.name = nameOf(LineFamily::Creases);
    f.document.push(
        std::make_unique<SetSurface>(f.document, withFamily(f.setting(), creases), "edit"));
    QTRY_VERIFY_WITH_TIMEOUT(!f.seen.isStale(), kPatienceMs);
    QVERIFY(f.seen.seen()->lines[static_cast<std::size_t>(LineFamily::Creases)].empty());
  }

  void thePaintedPictureShowsTheSphere() {
    Fixture f;
    QVERIFY(f.open("solid:sphere:16"));
    SurfacePicture picture;
    picture.surface = f.source.surface();
    picture.setting = f.setting();
    const QImage image = paintSurface(picture, {200, 100});
    QCOMPARE(image.size(), QSize(200, 100));
    const QColor background(Qt::white);
    QCOMPARE(image.pixelColor(5, 5), background);
    QVERIFY(image.pixelColor(100, 50).lightness() < 250);
    // The light comes from the upper left.
    QVERIFY(image.pixelColor(88, 38).lightness() > image.pixelColor(112, 62).lightness() + 20);
    // The colour map of k1 has one colour on a sphere.
    picture.setting.style = "colours";
    picture.setting.quantity = "k1";
    f.document.push(std::make_unique<SetSurface>(f.document, picture.setting, "edit"));
    QVERIFY(QTest::qWaitFor([&] { return !f.seen.isStale(); }, kPatienceMs));
    picture.seen = f.seen.seen();
    QVERIFY(picture.colours());
    QCOMPARE(picture.colours()->share.size(), picture.surface->mesh->vertexCount());
    QVERIFY(picture.colours()->scale.diverging);
  }

  void theProbeReadsTheSphere() {
    Fixture f;
    QVERIFY(f.open("solid:sphere:16"));
    const Projection projection =
        orbitProjection(f.setting().camera, f.source.surface()->ballRadius, 300, 300);
    const auto reading = readingAt(*f.source.surface(), projection, {150, 150}, projection.view());
    QVERIFY(reading && reading->terms);
    QVERIFY(std::abs(reading->terms->nw - 1.0) < 0.01);
    QVERIFY(std::abs(reading->terms->k1 - 1.0) < 0.05);  // times the size, its radius
    QVERIFY(std::abs(*reading->terms->lambda - 1.0) < 0.1);
    QVERIFY(!readingAt(*f.source.surface(), projection, {3, 3}, projection.view()));
  }

  void exportedLinesAreThoseOfTheWindow() {
    Fixture f;
    QVERIFY(f.open("solid:torus:30"));
    SurfacePicture picture;
    picture.surface = f.source.surface();
    picture.setting = f.setting();
    SurfaceFamily contours = usualFamily(LineFamily::OccludingContours);
    contours.colour = "#123456";
    contours.widthPx = 3.5;
    picture.setting = withFamily(picture.setting, contours);
    picture.pane = paneSetting(picture.setting, 0);
    const Figure figure = surfaceFigure({picture}, {400, 300});
    QCOMPARE(figure.width, 400.0);
    int strokes = 0;
    for (const FigureGroup& group : figure.groups) {
      if (!QByteArray::fromStdString(group.id).startsWith("contours")) continue;
      for (const Shape& shape : group.shapes) {
        const auto& path = std::get<PathShape>(shape);
        QVERIFY(path.stroke && path.stroke->colour == (Rgb{0x12, 0x34, 0x56}));
        QCOMPARE(path.stroke->width, 3.5);
        ++strokes;
      }
    }
    QVERIFY(strokes > 0);
  }
};

QTEST_MAIN(SurfaceModelTest)
#include "surface_model_test.moc"
