// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures in pixels, cameras and fields as files, from the real window.
#include <QLabel>
#include <QSignalSpy>
#include <cmath>

#include "core3d/draw/draughtsman.h"
#include "core3d/io/cameras_json.h"
#include "tests/ui/support_export.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_figure.h"

using namespace flatland;
using namespace flatland::ui;

class SurfaceFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<ExportDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  void camerasGiveTheSamePictureOnTheCommandLine() {
    SurfaceSetting setting = *driver_->scene().surface;
    SurfaceCamera tilted = orbited(setting.camera, {120, 33}, 500);
    tilted.perspectiveDeg = 40.0;
    tilted.centre = {0.1, -0.2, 0.05};
    tilted.zoom = 1.7;
    setting.savedCameras = {{"Kamera 1 (schräg)", tilted}, {"Kamera 1 schr g", tilted}};
    QVERIFY(driver_->push(setting));
    SurfaceCamera now = rolled(setting.camera, 0.3);
    now.centre = {-0.3, 0.0, 0.1};
    driver_->document().setCamera(now);
    const QString name = driver_->path("cameras.json");
    driver_->exportTo(name, {});
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

  /// What is hidden lies below all that is visible, of families painted later too.
  void hiddenLinesArePaintedBelowVisibleOnes() {
    SurfacePicture picture = pictureOf(driver_->window().surfaceModels());
    auto seen = std::make_shared<SeenSurface>(*picture.seen);
    for (auto& lines : seen->lines) lines.clear();
    // A visible ridge and a hidden contour cross at the middle of the picture.
    const Eigen::Matrix3d axes =
        orbitProjection(picture.setting.camera, picture.surface->ballRadius, 300, 300).axes;
    const auto across = [&axes](int axis) {
      std::vector<LineVertex> ends;
      for (const double side : {-0.5, 0.5}) {
        const Eigen::Vector3f p = (side * axes.row(axis).transpose()).cast<float>();
        ends.push_back({p.x(), p.y(), p.z(), 1e3f});
      }
      return ends;
    };
    const auto ridges = static_cast<std::size_t>(LineFamily::ApparentRidges);
    const auto contours = static_cast<std::size_t>(LineFamily::OccludingContours);
    seen->lines[ridges] = across(0);
    seen->lines[contours] = across(1);
    seen->visibleEnds.emplace();
    (*seen->visibleEnds)[ridges] = 2;
    picture.seen = seen;
    picture.setting.style = "paper";
    picture.setting.hidden = "shown";
    SurfaceFamily look = familyOf(picture.setting, LineFamily::ApparentRidges);
    look.widthPx = 9.0;
    picture.setting = withFamily(picture.setting, look);
    const QImage image = paintSurface(picture, {300, 300});
    const Rgb ridge = colourOf(look, picture.palette);
    QCOMPARE(image.pixel(150, 150), qRgb(ridge.r, ridge.g, ridge.b));
    // The contour is there, pale.
    const QColor off = image.pixelColor(150, 130);
    QVERIFY(off.value() < 250 && off.saturation() < 20);
  }

  void fieldsAreWrittenForTheViewThere() {
    const QString csv = driver_->path("fields.csv"), ply = driver_->path("fields.ply");
    driver_->exportTo(csv, {});
    QVERIFY(ExportDriver::comes(csv));
    const QByteArray text = textOf(csv);
    QVERIFY(text.startsWith("x,y,z,nx,ny,nz,k1,k2"));
    const auto vertices = driver_->window().surfaceModels().source.surface()->mesh->vertexCount();
    QCOMPARE(static_cast<std::size_t>(text.count('\n')), vertices + 1);
    driver_->exportTo(ply, {});
    QVERIFY(ExportDriver::comes(ply));
    QVERIFY(textOf(ply).startsWith("ply\nformat binary_little_endian"));
    // Foreshortening is that of the camera: another one gives other values.
    driver_->document().setCamera(seenFrom(driver_->scene().surface->camera, StandardView::Right));
    QVERIFY(driver_->quiet());
    const QString side = driver_->path("side.csv");
    driver_->exportTo(side, {});
    QVERIFY(ExportDriver::comes(side));
    QVERIFY(textOf(side) != text);
  }

  void picturesHaveTheirLegend() {
    SurfaceSetting setting = *driver_->scene().surface;
    setting.style = "colours";
    setting.quantity = "k1";
    QVERIFY(driver_->push(setting));
    const SurfaceModels models = driver_->window().surfaceModels();
    QVERIFY(models.seen.seen()->colours);
    const ColourScale scale = models.seen.seen()->colours->scale;
    QImage image = exported("colours.png");
    QCOMPARE(image.size(), QSize(640, 480));
    const auto barTop = [&scale, &models](const QImage& picture) {
      // The first row that has a bar of all its colours at the right, 220 px long.
      const SurfacePicture shown = pictureOf(models);
      for (int y = 0; y < picture.height(); ++y) {
        bool found = true;
        for (int x = 5; x < 215 && found; x += 10) {
          const Rgb c = scale.at((x + 0.5) / 220.0, shown.palette);
          found = picture.pixel(picture.width() - 228 + x, y) == qRgb(c.r, c.g, c.b);
        }
        if (found) return y;
      }
      return -1;
    };
    const int top = barTop(image);
    QVERIFY2(top > 480 - 50, qPrintable(QString::number(top)));
    // The surface is above it, as in a picture of that height.
    SurfacePicture alone = pictureOf(models);
    const QImage above = paintSurface(alone, {640, top - 5});
    for (int y = 0; y < above.height(); y += 7) {
      for (int x = 0; x < above.width(); x += 7) QCOMPARE(image.pixel(x, y), above.pixel(x, y));
    }
    // One for all views.
    driver_->trigger("surface.compare.four");
    QVERIFY(driver_->quiet());
    image = exported("four.png");
    QVERIFY(barTop(image) > 480 - 50);
    driver_->trigger("surface.compare.difference");
    QVERIFY(driver_->quiet());
    image = exported("difference.png");
    const Rgb c = differenceColour(SeenDifference::Missing, picturesOf(models)[0].palette);
    int longest = 0;
    for (int y = image.height() - 180; y < image.height() - 10; ++y) {
      int run = 0;
      for (int x = image.width() / 2 + 60; x < image.width(); ++x) {
        run = image.pixel(x, y) == qRgb(c.r, c.g, c.b) ? run + 1 : 0;
        longest = std::max(longest, run);
      }
    }
    QCOMPARE(longest, 18);
  }

  /// The same picture with more pixels, not one with thinner lines.
  void moreDotsPerInchAreFiner() {
    SurfaceSetting setting = *driver_->scene().surface;
    setting.style = "paper";
    QVERIFY(driver_->push(setting));
    QImage images[2];
    for (const double dpi : {96.0, 288.0}) {
      const QString name = driver_->path(QString::number(dpi) + ".png");
      driver_->exportTo(name, {400, 300, dpi});
      QVERIFY(ExportDriver::comes(name));
      images[dpi > 100.0] = QImage(name);
    }
    QCOMPARE(images[1].size(), QSize(1200, 900));
    double ink[2] = {};
    for (std::size_t i = 0; i < 2; ++i) {
      for (int y = 0; y < images[i].height(); ++y) {
        for (int x = 0; x < images[i].width(); ++x) {
          ink[i] += 255 - qGray(images[i].pixel(x, y));
        }
      }
      ink[i] /= 255.0 * images[i].width() * images[i].height();
    }
    QVERIFY(ink[0] > 0.002);
    QVERIFY2(std::abs(ink[1] / ink[0] - 1.0) < 0.1,
             qPrintable(QStringLiteral("%1 and %2").arg(ink[0]).arg(ink[1])));
  }

  void tooLargeAPictureIsRefused() {
    SurfaceExporter& exporter = driver_->window().surfaces().exporter();
    QSignalSpy failed(&exporter, &SurfaceExporter::failed);
    const QString png = driver_->path("huge.png");
    exporter.exportTo(png, {20000, 20000, 2400.0});
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, ExportDriver::kPatienceMs);
    QVERIFY(!QFile::exists(png));
  }

  void exportsWaitForEachOther() {
    const QString csv = driver_->path("first.csv"), png = driver_->path("second.png");
    SurfaceExporter& exporter = driver_->window().surfaces().exporter();
    QSignalSpy written(&exporter, &SurfaceExporter::written);
    exporter.exportTo(csv, {});
    exporter.exportTo(png, {320, 240});
    QTRY_COMPARE_WITH_TIMEOUT(written.count(), 2, ExportDriver::kPatienceMs);
    QCOMPARE(written[0][0].toString(), csv);
    QCOMPARE(written[1][0].toString(), png);
    QVERIFY(QFile::exists(csv));
    QCOMPARE(QImage(png).size(), QSize(320, 240));
  }

  void theMeshItselfIsNotOverwritten() {
    const QString mesh = driver_->path("mesh.ply");
    driver_->exportTo(mesh, {});
    QVERIFY(ExportDriver::comes(mesh));
    driver_->window().surfaces().openFile(mesh);
    QVERIFY(driver_->quiet());
    const QByteArray before = textOf(mesh);
    driver_->exportTo(mesh, {});
    driver_->settle();
    QVERIFY(driver_->child<QLabel>("message.text").text().contains("mesh.ply"));
    QVERIFY(textOf(mesh) == before);
  }

 private:
  QImage exported(const char* name) {
    const QString file = driver_->path(name);
    driver_->exportTo(file, {640, 480});
    if (!QTest::qWaitFor([&file] { return QFile::exists(file); }, ExportDriver::kPatienceMs))
      return {};
    return QImage(file);
  }

  std::unique_ptr<ExportDriver> driver_;
};

QTEST_MAIN(SurfaceFilesTest)
#include "surface_files_test.moc"
