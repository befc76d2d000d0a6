// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of the surface and its views, from the real window.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QRegularExpression>
#include <QSignalSpy>
#include <cmath>
#include <set>

#include "core3d/draw/draughtsman.h"
#include "core3d/io/cameras_json.h"
#include "tests/ui/support_window.h"
#include "ui/app/export_settings.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/export/line_style.h"
#include "ui/model/compare_presets.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_area.h"
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
    exportAs("svg", svg);
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

  void predictionsAreExported() {
    driver_->trigger("surface.extrude");
    QVERIFY(quiet());
    const SurfaceModels models = driver_->window().surfaceModels();
    const std::vector<SurfacePicture> pictures = picturesOf(models);
    const BridgeView& bridge = *models.bridges.source.view();
    const Figure figure = surfaceFigure(pictures, {800, 600});
    // Each is drawn, and nothing but them: ends of strokes lie on the pictures of rulings.
    const Projection projection =
        orbitProjection(pictures[0].setting.camera, pictures[0].surface->ballRadius, 800, 600);
    std::set<std::size_t> met;
    for (const std::string name : {"predicted-apparent-ridges", "predicted-contours"}) {
      const bool ridges = name == "predicted-apparent-ridges";
      const MarkKind kind = ridges ? MarkKind::ApparentRidge : MarkKind::Silhouette;
      const FigureGroup* group = groupOf(figure, name + "-visible");
      QVERIFY2(group, name.c_str());
      QVERIFY(QString::fromStdString(group->classes).contains("predicted"));
      for (const Shape& shape : group->shapes) {
        const PathShape& path = std::get<PathShape>(shape);
        QVERIFY(path.stroke && path.stroke->dash.size() == 2);
        QVERIFY(path.stroke->colour == predictedColour(kind, pictures[0].palette));
        for (const Vec2& p : path.path.points) {
          const auto line = lineAt(bridge, projection, p, kind);
          QVERIFY(line);
          QVERIFY(bridge.limits[*line] == BridgeLimit::None);
          met.insert(*line);
        }
      }
    }
    // Those that face the viewer and can be expected; some may be behind others.
    std::size_t expected = 0;
    for (const BridgeLimit limit : bridge.limits) expected += limit == BridgeLimit::None;
    QVERIFY(met.size() > 1 && met.size() <= expected);
    QVERIFY(groupOf(figure, "predicted-ticks"));
    QVERIFY(!groupOf(figure, "section-visible"));
    // Switched off they are nowhere.
    models.bridges.source.setShown(false);
    const Figure without = surfaceFigure(picturesOf(models), {800, 600});
    QVERIFY(!groupOf(without, "predicted-apparent-ridges-visible"));
    QVERIFY(!groupOf(without, "predicted-ticks"));
    models.bridges.source.setShown(true);
    for (const char* suffix : {"svg", "tex", "pdf"}) {
      const QString name = driver_->path(QStringLiteral("predicted.") + suffix);
      driver_->window().surfaces().exporter().exportTo(name, {640, 480});
      QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(name), kPatienceMs);
      const bool text = QByteArray(suffix) != "pdf";
      QCOMPARE(textOf(name).contains("predicted-apparent-ridges-visible"), text);
    }
  }

  void theSectionIsExported() {
    driver_->window().surfaces().openSolid("torus:40");
    QVERIFY(quiet());
    SurfaceSetting setting = *driver_->scene().surface;
    setting.camera.towards = Eigen::Vector3d(0.5, 0.6, 1.0).normalized();
    setting.plane =
        SurfacePlane{Eigen::Vector3d(0.0, 0.1, 0.0), Eigen::Vector3d(0.2, 1.0, 0.1).normalized()};
    const SurfaceModels models = driver_->window().surfaceModels();
    double length[3] = {};  // hidden lines left out; seen and hidden ones
    for (const char* hidden : {"off", "dashed"}) {
      setting.hidden = hidden;
      push(setting);
      QVERIFY(QTest::qWaitFor([&] { return !models.bridges.isStale(); }, kPatienceMs));
      const Figure figure = surfaceFigure(picturesOf(models), {800, 600});
      const bool off = setting.hidden == "off";
      for (const bool seen : {true, false}) {
        const FigureGroup* group = groupOf(figure, seen ? "section-visible" : "section-hidden");
        QCOMPARE(group != nullptr, seen || !off);
        if (group) length[off ? 0 : seen ? 1 : 2] = lengthOf(*group);
      }
      QVERIFY(groupOf(figure, "section-marks"));
    }
    QVERIFY(models.bridges.section.view());
    const SectionView& section = *models.bridges.section.view();
    const Projection projection = orbitProjection(driver_->scene().surface->camera,
                                                  models.source.surface()->ballRadius, 800, 600);
    double whole = 0.0;
    for (std::size_t i = 0; i + 1 < section.lines.size(); i += 2) {
      const auto px = [&](const LineVertex& v) {
        return *projection.toScreen(Eigen::Vector3f(v.x, v.y, v.z).cast<double>());
      };
      whole += (px(section.lines[i]) - px(section.lines[i + 1])).norm();
    }
    const auto words = QStringLiteral("%1 of %2 + %3 = %4")
                           .arg(length[0])
                           .arg(length[1])
                           .arg(length[2])
                           .arg(whole);
    QVERIFY2(length[0] > 0.3 * whole && length[0] < 0.8 * whole, qPrintable(words));
    QVERIFY2(std::abs(length[0] - length[1]) < 1.0, qPrintable(words));
    QVERIFY2(std::abs(length[1] + length[2] - whole) < 0.03 * whole, qPrintable(words));
    const QString svg = driver_->path("section.svg");
    driver_->window().surfaces().exporter().exportTo(svg, {640, 480});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(svg), kPatienceMs);
    QVERIFY(textOf(svg).contains("id=\"section-visible\""));
  }

  void picturesHaveTheirLegend() {
    SurfaceSetting setting = *driver_->scene().surface;
    setting.style = "colours";
    setting.quantity = "k1";
    push(setting);
    const SurfaceModels models = driver_->window().surfaceModels();
    QVERIFY(models.seen.seen()->colours);
    const ColourScale scale = models.seen.seen()->colours->scale;
    QImage image = exported("colours.png");
    QCOMPARE(image.size(), QSize(640, 480));
    // Somewhere at the bottom right is a bar of all its colours, 220 px long.
    bool found = false;
    for (int y = image.height() - 60; y < image.height() - 10 && !found; ++y) {
      found = true;
      for (int x = 5; x < 215 && found; x += 10) {
        const Rgb c = scale.at((x + 0.5) / 220.0, picturesOf(models)[0].palette);
        found = image.pixel(image.width() - 230 + x, y) == qRgb(c.r, c.g, c.b);
      }
    }
    QVERIFY(found);
    driver_->trigger("surface.compare.difference");
    QVERIFY(quiet());
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

  void aNameWithoutSuffixGetsThatOfTheFormat() {
    for (const char* suffix : {"svg", "tex", "png", "csv", "json"}) {
      const QString name = driver_->path(QStringLiteral("of-") + suffix);
      exportAs(suffix, name);
      QTRY_VERIFY2_WITH_TIMEOUT(QFile::exists(name + "." + suffix), suffix, kPatienceMs);
    }
    QVERIFY(!QImage(driver_->path("of-png.png")).isNull());
  }

  void exportsHaveTheSizeAskedFor() {
    const auto size = [](QWidget& dialog) {
      chosen(dialog, "export.unit", static_cast<int>(ExportSettings::Unit::Centimetres));
      dialog.findChild<QDoubleSpinBox*>("export.width")->setValue(12.7);
      dialog.findChild<QDoubleSpinBox*>("export.height")->setValue(7.62);
      dialog.findChild<QDoubleSpinBox*>("export.dpi")->setValue(200.0);
    };
    const QString png = driver_->path("size.png"), svg = driver_->path("size.svg");
    exportAs("png", png, size);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(png), kPatienceMs);
    const QImage image(png);
    QCOMPARE(image.size(), QSize(1000, 600));
    QCOMPARE(qRound(image.dotsPerMeterX() * 0.0254), 200);
    exportAs("svg", svg, size);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(svg), kPatienceMs);
    QVERIFY(textOf(svg).contains("width=\"480\" height=\"288\""));
    // What was asked for is there the next time, in the shape of the panel.
    const QSize panel = driver_->window().surfaceArea().viewsSize();
    double width = 0.0, height = 0.0;
    QString suffix;
    whenModal([&](QWidget& dialog) {
      width = dialog.findChild<QDoubleSpinBox*>("export.width")->value();
      height = dialog.findChild<QDoubleSpinBox*>("export.height")->value();
      suffix = dialog.findChild<QComboBox*>("export.format")->currentData().toString();
      qobject_cast<QDialog*>(&dialog)->reject();
    });
    driver_->trigger("surface.export");
    QCOMPARE(suffix, QStringLiteral("svg"));
    QCOMPARE(width, 12.7);
    QVERIFY(std::abs(height / width - 1.0 * panel.height() / panel.width()) < 0.01);
  }

  void coloursAreThoseAskedFor() {
    for (const Palette palette : {Palette::Light, Palette::Dark, Palette::HighContrast}) {
      const auto colours = [palette](QWidget& dialog) {
        chosen(dialog, "export.colours", static_cast<int>(palette));
      };
      const Rgb ground = sceneColours(palette).background;
      const QString png = driver_->path(QString::number(static_cast<int>(palette)) + ".png");
      exportAs("png", png, colours);
      QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(png), kPatienceMs);
      QCOMPARE(QImage(png).pixel(2, 2), qRgb(ground.r, ground.g, ground.b));
      const QString svg = driver_->path(QString::number(static_cast<int>(palette)) + ".svg");
      exportAs("svg", svg, colours);
      QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(svg), kPatienceMs);
      QVERIFY(textOf(svg).contains("fill=\"" + QByteArray::fromStdString(toHex(ground)) + "\""));
    }
  }

  /// The same picture with more pixels, not one with thinner lines.
  void moreDotsPerInchAreFiner() {
    SurfaceSetting setting = *driver_->scene().surface;
    setting.style = "paper";
    push(setting);
    QImage images[2];
    for (const double dpi : {96.0, 288.0}) {
      const QString name = driver_->path(QString::number(dpi) + ".png");
      driver_->window().surfaces().exporter().exportTo(name, {400, 300, dpi});
      QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(name), kPatienceMs);
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
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, kPatienceMs);
    QVERIFY(!QFile::exists(png));
  }

  /// The key of exports is that of the view worked with last.
  void theKeyExportsTheViewWorkedWith() {
    const auto asked = [this](QWidget& view) {
      QString name;
      QTest::mouseClick(&view, Qt::LeftButton, {}, QPoint(15, view.height() - 15));
      driver_->window().activateWindow();
      if (!QTest::qWaitForWindowActive(&driver_->window())) return name;
      whenModal([&name](QWidget& dialog) {
        name = dialog.objectName();
        qobject_cast<QDialog*>(&dialog)->reject();
      });
      driver_->key(Qt::Key_E, Qt::ControlModifier);
      return name;
    };
    QWidget& surface = *driver_->window().surfaceArea().canvas();
    QCOMPARE(asked(surface), QStringLiteral("surface-export"));
    QCOMPARE(asked(driver_->canvas()), QStringLiteral("export"));
    QCOMPARE(asked(surface), QStringLiteral("surface-export"));
    driver_->trigger("surface.close");
    QCOMPARE(asked(driver_->canvas()), QStringLiteral("export"));
  }

  /// What an SVG says made it makes it.
  void theCommandOfAPictureMakesItAgain_data() {
    QTest::addColumn<QString>("style");
    for (const char* style : {"usual", "hidden", "perspective", "unfiltered", "smooth"}) {
      QTest::newRow(style) << QString(style);
    }
  }
  void theCommandOfAPictureMakesItAgain() {
    QFETCH(QString, style);
    SurfaceSetting setting = *driver_->scene().surface;
    SurfaceCamera camera = setting.camera;
    camera.towards = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
    camera.zoom = 1.3;
    camera.centre = Eigen::Vector3d(0.1, -0.05, 0.02);
    if (style == "hidden") {
      setting.hidden = "dashed";
      SurfaceFamily isophotes = familyOf(setting, LineFamily::Isophotes);
      isophotes.on = true;
      setting = withFamily(std::move(setting), isophotes);
      setting.isophotes = 4;
    }
    if (style == "perspective") camera.perspectiveDeg = 35.0;
    if (style == "unfiltered") setting.unfiltered = true;
    if (style == "smooth") {
      setting.fitScale = 2.0;
      SurfaceFamily ridges = familyOf(setting, LineFamily::ApparentRidges);
      ridges.threshold = 0.4;
      setting = withFamily(std::move(setting), ridges);
    }
    push(setting);
    driver_->document().setCamera(camera);
    QVERIFY(quiet());
    const QString name = driver_->path("it's one.svg");
    driver_->window().surfaces().exporter().exportTo(name, {640, 480});
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(name), kPatienceMs);
    const QString exported = textOf(name);
    QString command = exported.section("<command>", 1).section("</command>", 0, 0);
    QVERIFY2(command.startsWith("flatland lines solid:bumpy-sphere:20 -o 'it'\\''s one.svg' "),
             qPrintable(command));
    QVERIFY(QFile::rename(name, driver_->path("window.svg")));
    QProcess shell;
    shell.setWorkingDirectory(QFileInfo(name).path());
    command.replace(0, 8, "\"$0\"").replace("&quot;", "\"");
    shell.start("sh", {"-c", command, FLATLAND_PROGRAM});
    QVERIFY(shell.waitForFinished(kPatienceMs));
    QCOMPARE(QString(shell.readAllStandardError()), QString());
    QCOMPARE(shell.exitCode(), 0);
    const auto paths = [](const QString& svg) {
      static const QRegularExpression path("<path[^>]*>");
      QStringList all;
      for (auto found = path.globalMatch(svg); found.hasNext();) all << found.next().captured();
      all.sort();
      return all;
    };
    QVERIFY(paths(exported).size() > 3);
    QCOMPARE(paths(textOf(name)), paths(exported));
  }

  void whatNoCommandMakesHasNone() {
    const auto hasCommand = [this](const char* what) {
      const QString name = driver_->path(QString(what) + ".svg");
      driver_->window().surfaces().exporter().exportTo(name, {640, 480});
      if (!QTest::qWaitFor([&name] { return QFile::exists(name); }, kPatienceMs)) return false;
      return textOf(name).contains("<command>");
    };
    QVERIFY(hasCommand("plain"));
    const SurfaceSetting usual = *driver_->scene().surface;
    SurfaceSetting setting = usual;
    setting.ink = 0.03;
    push(setting);
    QVERIFY(!hasCommand("ink"));
    SurfaceFamily ridges = familyOf(usual, LineFamily::ApparentRidges);
    ridges.colour = "#123456";
    push(withFamily(usual, ridges));
    QVERIFY(!hasCommand("colour"));
    ridges.colour.clear();
    ridges.widthPx += 1.0;
    push(withFamily(usual, ridges));
    QVERIFY(!hasCommand("width"));
    push(usual);
    QVERIFY(hasCommand("again"));
    driver_->trigger("surface.compare.families");
    QVERIFY(quiet());
    QVERIFY(!hasCommand("views"));
  }

  void closingWaitsForTheExport() {
    const QString svg = driver_->path("late.svg"), csv = driver_->path("later.csv");
    exportAs("svg", svg);
    driver_->window().surfaces().exporter().exportTo(csv, {});
    discardChanges();
    QVERIFY(driver_->window().close());
    QVERIFY(textOf(svg).contains("</svg>"));
    QVERIFY(!textOf(csv).isEmpty());
  }

  void aFailedExportKeepsTheWindowOpen() {
    const QString svg = driver_->path("nowhere/late.svg");
    SurfaceExporter& exporter = driver_->window().surfaces().exporter();
    exporter.exportTo(svg, {320, 240});
    QVERIFY(exporter.isBusy());
    QVERIFY(!driver_->window().close());
    QVERIFY(driver_->window().isVisible());
    QVERIFY(driver_->child<QLabel>("message.text").text().contains("late.svg"));
    // Told once, it closes.
    discardChanges();
    QVERIFY(driver_->window().close());
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
  static const FigureGroup* groupOf(const Figure& figure, const std::string& id) {
    const auto at = std::find_if(figure.groups.begin(), figure.groups.end(),
                                 [&id](const FigureGroup& group) { return group.id == id; });
    return at == figure.groups.end() ? nullptr : &*at;
  }
  static double lengthOf(const FigureGroup& group) {
    double length = 0.0;
    for (const Shape& shape : group.shapes) {
      const PathData& path = std::get<PathShape>(shape).path;
      for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        length += (path.points[i + 1] - path.points[i]).norm();
      }
      if (path.verbs.back() == PathData::Verb::Close) {
        length += (path.points.back() - path.points.front()).norm();
      }
    }
    return length;
  }
  /// The predicted line of a kind whose picture goes through a pixel.
  static std::optional<std::size_t> lineAt(const BridgeView& bridge, const Projection& projection,
                                           const Vec2& px, MarkKind kind) {
    const TriangleMesh& mesh = *bridge.seen->surface->mesh;
    for (std::size_t i = 0; i < bridge.prediction.lines().size(); ++i) {
      const PredictedLine& line = bridge.prediction.lines()[i];
      if (line.kind != kind) continue;
      const auto ends = inMeshCoordinates(line.points, mesh);
      const Vec2 a = *projection.toScreen(ends.front().cast<double>());
      const Vec2 b = *projection.toScreen(ends.back().cast<double>());
      const double share = std::clamp((px - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      if ((a + share * (b - a) - px).norm() < 0.05) return i;
    }
    return std::nullopt;
  }
  static void chosen(QWidget& dialog, const char* box, const QVariant& data) {
    auto* choice = dialog.findChild<QComboBox*>(box);
    choice->setCurrentIndex(choice->findData(data));
  }
  /// Through both dialogs, in the first of which something is set.
  void exportAs(
      const QString& suffix, const QString& file,
      const std::function<void(QWidget&)>& set = [](QWidget&) {}) {
    whenModal(
        [=](QWidget& dialog) {
          chosen(dialog, "export.format", suffix);
          set(dialog);
          typeFileName(file);
          QTest::mouseClick(dialog.findChild<QAbstractButton*>("export.go"), Qt::LeftButton);
        },
        [](QWidget& dialog) { return dialog.objectName() == "surface-export"; });
    driver_->trigger("surface.export");
  }
  QImage exported(const char* name) {
    const QString file = driver_->path(name);
    driver_->window().surfaces().exporter().exportTo(file, {640, 480});
    if (!QTest::qWaitFor([&file] { return QFile::exists(file); }, kPatienceMs)) return {};
    return QImage(file);
  }
  /// Answers the question about unsaved work that closing asks.
  static void discardChanges() {
    whenModal([](QWidget& box) {
      QTest::mouseClick(qobject_cast<QMessageBox*>(&box)->button(QMessageBox::Discard),
                        Qt::LeftButton);
    });
  }
  void push(const SurfaceSetting& setting) {
    driver_->document().push(std::make_unique<SetSurface>(driver_->document(), setting, "edit"));
    QVERIFY(quiet());
  }
  bool quiet() {
    const SurfaceModels models = driver_->window().surfaceModels();
    return QTest::qWaitFor(
        [&] {
          return driver_->surfaceQuiet() && !models.source.isStale() && !models.bridges.isStale();
        },
        kPatienceMs);
  }

  std::unique_ptr<WindowDriver> driver_;
};

QTEST_MAIN(SurfaceExportTest)
#include "surface_export_test.moc"
