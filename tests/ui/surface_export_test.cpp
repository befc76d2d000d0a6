// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of the surface and its views, from the real window.
#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QSignalSpy>
#include <set>

#include "core3d/draw/draughtsman.h"
#include "core3d/io/cameras_json.h"
#include "tests/ui/support_window.h"
#include "ui/app/surface_controller.h"
#include "ui/commands/scene_commands.h"
#include "ui/export/line_style.h"
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

  void aNameWithoutSuffixGetsThatOfTheFilter() {
    const std::pair<const char*, const char*> cases[] = {
        {"lines", ".svg"}, {"shade", ".png"}, {"curvature", ".ply"}, {"cameras", ".json"}};
    int row = 0;
    for (const auto& [name, suffix] : cases) {
      typeFileName(driver_->path(name), [row] {
        auto* types = QApplication::activeModalWidget()->findChild<QComboBox*>("fileTypeCombo");
        QVERIFY(types);
        for (int i = 0; i < row; ++i) QTest::keyClick(types, Qt::Key_Down);
      });
      driver_->trigger("surface.export");
      QTRY_VERIFY2_WITH_TIMEOUT(QFile::exists(driver_->path(name) + suffix), name, kPatienceMs);
      ++row;
    }
    QVERIFY(!QImage(driver_->path("shade.png")).isNull());
  }

  void closingWaitsForTheExport() {
    const QString svg = driver_->path("late.svg"), csv = driver_->path("later.csv");
    typeFileName(svg);
    driver_->trigger("surface.export");
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
