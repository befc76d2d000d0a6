// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of the surface and its views, from the real window.
#include <QLabel>
#include <QSignalSpy>

#include "core3d/draw/draughtsman.h"
#include "core3d/io/cameras_json.h"
#include "tests/ui/support_window.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/compare_presets.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_figure.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

constexpr int kPatienceMs = 60000;  // estimates on a crowded machine

QByteArray textOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class SurfaceExportTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<WindowDriver>();
    QVERIFY(driver_->ready());
    driver_->window().surfaces().openSolid("bumpy-sphere:20");
    QVERIFY(quiet());
    QVERIFY(driver_->scene().surface.has_value());
  }
  void cleanup() { driver_.reset(); }

  void viewsAreWrittenSideBySide() {
    driver_->trigger("surface.compare.families");
    QVERIFY(quiet());
    const QString svg = driver_->path("views.svg");
    typeFileName(svg);
    driver_->trigger("surface.export");
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(svg), kPatienceMs);
    const QByteArray text = textOf(svg);
    for (const char* id : {"view-1-contours-visible", "view-2-suggestive-contours-visible",
                           "view-3-title", "view-4-apparent-ridges-visible"}) {
      QVERIFY2(text.contains(QByteArray("id=\"") + id), id);
    }
    QVERIFY(!text.contains("id=\"view-1-apparent-ridges"));
    const QString png = driver_->path("views.png");
    driver_->window().surfaces().exporter().exportTo(png, {640, 480});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(png), kPatienceMs);
    const QImage image(png);
    QCOMPARE(image.size(), QSize(640, 480));
    // Each quarter shows the ball.
    for (const QPoint& middle : {QPoint(160, 130), QPoint(480, 130), QPoint(160, 370)}) {
      QVERIFY(image.pixel(middle) != image.pixel(middle.x(), 28));
    }
  }

  void aDifferenceIsWrittenInItsColours() {
    driver_->trigger("surface.compare.difference");
    QVERIFY(quiet());
    SurfaceSetting setting = *driver_->scene().surface;
    setting.panes[0].families = std::vector<std::string>{"ridges"};
    setting.panes[0].derivative = kClosedForm;
    push(setting);
    const std::vector<SurfacePicture> pictures = picturesOf(driver_->window().surfaceModels());
    const Figure figure = surfaceFigure(pictures, {800, 400});
    int added = 0, missing = 0;
    for (const FigureGroup& group : figure.groups) {
      for (const Shape& shape : group.shapes) {
        const auto* path = std::get_if<PathShape>(&shape);
        if (!path) continue;
        if (group.id == "view-2-difference-added-visible") {
          ++added;
          QVERIFY(path->stroke->colour ==
                  differenceColour(SeenDifference::Added, pictures[0].palette));
        }
        missing += group.id == "view-2-difference-missing-visible";
      }
    }
    QVERIFY(added > 0 && missing > 0);
  }

  void camerasGiveTheSamePictureOnTheCommandLine() {
    SurfaceSetting setting = *driver_->scene().surface;
    SurfaceCamera tilted = orbited(setting.camera, {120, 33}, 500);
    tilted.perspectiveDeg = 40.0;
    tilted.centre = {0.1, -0.2, 0.05};
    tilted.zoom = 1.7;
    setting.savedCameras = {{"Kamera 1 (schräg)", tilted}, {"Kamera 1 schr g", tilted}};
    push(setting);
    SurfaceCamera now = rolled(setting.camera, 0.3);
    now.centre = {-0.3, 0.0, 0.1};
    driver_->document().setCamera(now);
    const QString name = driver_->path("cameras.json");
    driver_->window().surfaces().exporter().exportTo(name, {});
    QTRY_VERIFY(QFile::exists(name));
    constexpr double kWidth = 1000.0, kHeight = 700.0;
    Camera usual;  // as flatland lines has it for --size 1000x700
    usual.width = kWidth;
    usual.height = kHeight;
    usual.margin *= pictureScale(kWidth, kHeight);
    const std::vector<NamedCamera> read = loadCameras(name.toStdString(), usual);
    QCOMPARE(read.size(), std::size_t{3});
    QCOMPARE(read[0].name, std::string("now"));
    const LoadedSurface& surface = *driver_->window().surfaceModels().source.surface();
    const SurfaceCamera cameras[] = {now, tilted, tilted};
    for (std::size_t i = 0; i < 3; ++i) {
      const Projection there = projectionOf(read[i].camera, *surface.mesh, true);
      const Projection here = orbitProjection(cameras[i], surface.ballRadius, kWidth, kHeight);
      for (const Eigen::Vector3d& p :
           {Eigen::Vector3d(0.4, 0.2, -0.7), Eigen::Vector3d(-0.5, 0.9, 0.1)}) {
        QVERIFY((*there.toScreen(p) - *here.toScreen(p)).norm() < 1e-9);
      }
      QCOMPARE(there.view().eye.has_value(), i > 0);
    }
    QVERIFY((read[1].camera.towards - tilted.towards).norm() < 1e-15);
    // And so the strokes are those of the exported picture.
    SurfacePicture picture = pictureOf(driver_->window().surfaceModels());
    const Figure figure = surfaceFigure({picture}, {1000, 700});
    const Drawing drawing = Draughtsman(*surface.mesh, *surface.fields)
                                .draw(projectionOf(read[0].camera, *surface.mesh),
                                      lineOptionsOf(picture.pane), StrokeOptions{});
    std::size_t strokes = 0;
    for (const FigureGroup& group : figure.groups) strokes += group.shapes.size();
    QVERIFY(strokes > 0);
    QCOMPARE(strokes, drawing.polylines.size());
  }

  void fieldsAreWrittenForTheViewThere() {
    const QString csv = driver_->path("fields.csv"), ply = driver_->path("fields.ply");
    driver_->window().surfaces().exporter().exportTo(csv, {});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(csv), kPatienceMs);
    const QByteArray text = textOf(csv);
    QVERIFY(text.startsWith("x,y,z,nx,ny,nz,k1,k2"));
    const auto vertices = driver_->window().surfaceModels().source.surface()->mesh->vertexCount();
    QCOMPARE(static_cast<std::size_t>(text.count('\n')), vertices + 1);
    driver_->window().surfaces().exporter().exportTo(ply, {});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(ply), kPatienceMs);
    QVERIFY(textOf(ply).startsWith("ply\nformat binary_little_endian"));
    // Foreshortening is that of the camera: another one gives other values.
    driver_->document().setCamera(seenFrom(driver_->scene().surface->camera, StandardView::Right));
    QVERIFY(quiet());
    const QString side = driver_->path("side.csv");
    driver_->window().surfaces().exporter().exportTo(side, {});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(side), kPatienceMs);
    QVERIFY(textOf(side) != text);
  }

  void exportsWaitForEachOther() {
    const QString csv = driver_->path("first.csv"), png = driver_->path("second.png");
    SurfaceExporter& exporter = driver_->window().surfaces().exporter();
    QSignalSpy written(&exporter, &SurfaceExporter::written);
    exporter.exportTo(csv, {});
    exporter.exportTo(png, {320, 240});
    QTRY_COMPARE_WITH_TIMEOUT(written.count(), 2, kPatienceMs);
    QCOMPARE(written[0][0].toString(), csv);
    QCOMPARE(written[1][0].toString(), png);
    QVERIFY(QFile::exists(csv));
    QCOMPARE(QImage(png).size(), QSize(320, 240));
  }

  void theMeshItselfIsNotOverwritten() {
    const QString mesh = driver_->path("mesh.ply");
    driver_->window().surfaces().exporter().exportTo(mesh, {});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(mesh), kPatienceMs);
    driver_->window().surfaces().openFile(mesh);
    QVERIFY(quiet());
    const QByteArray before = textOf(mesh);
    driver_->window().surfaces().exporter().exportTo(mesh, {});
    driver_->settle();
    QVERIFY(driver_->child<QLabel>("message.text").text().contains("mesh.ply"));
    QVERIFY(textOf(mesh) == before);
  }

 private:
  void push(const SurfaceSetting& setting) {
    driver_->document().push(std::make_unique<SetSurface>(driver_->document(), setting, "edit"));
    QVERIFY(quiet());
  }
  bool quiet() { return driver_->surfaceQuiet(); }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(SurfaceExportTest)
#include "surface_export_test.moc"
