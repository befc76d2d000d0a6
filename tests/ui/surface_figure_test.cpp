// SPDX-License-Identifier: GPL-3.0-or-later
// What vector files have of the surface and its views, from the real window: SVG, and with it TikZ
// and PDF, which are written from the same figure.
#include <QProcess>
#include <QRegularExpression>
#include <cmath>
#include <set>

#include "tests/ui/support_export.h"
#include "ui/export/figure_writers.h"
#include "ui/export/line_style.h"
#include "ui/model/compare_presets.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/surface_figure.h"

using namespace flatland;
using namespace flatland::ui;

class SurfaceFigureTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    driver_ = std::make_unique<ExportDriver>();
    QVERIFY(driver_->ready());
  }
  void cleanup() { driver_.reset(); }

  void viewsAreWrittenSideBySide() {
    driver_->trigger("surface.compare.families");
    QVERIFY(driver_->quiet());
    const QString svg = driver_->path("views.svg");
    driver_->exportAs("svg", svg);
    QVERIFY(ExportDriver::comes(svg));
    const QByteArray text = textOf(svg);
    for (const char* id : {"view-1-contours-visible", "view-2-suggestive-contours-visible",
                           "view-3-title", "view-4-apparent-ridges-visible"}) {
      QVERIFY2(text.contains(QByteArray("id=\"") + id), id);
    }
    QVERIFY(!text.contains("id=\"view-1-apparent-ridges"));
    const QString png = driver_->path("views.png");
    driver_->exportTo(png, {640, 480});
    QVERIFY(ExportDriver::comes(png));
    const QImage image(png);
    QCOMPARE(image.size(), QSize(640, 480));
    // Each quarter shows the ball.
    for (const QPoint& middle : {QPoint(160, 130), QPoint(480, 130), QPoint(160, 370)}) {
      QVERIFY(image.pixel(middle) != image.pixel(middle.x(), 28));
    }
  }

  /// The order of painting is one, in the window and in every file: hidden lines below, contours
  /// above all families.
  void filesPaintInTheOrderOfTheWindow() {
    SurfaceSetting setting = *driver_->scene().surface;
    setting.hidden = "dashed";
    for (const LineFamily family :
         {LineFamily::OccludingContours, LineFamily::ApparentRidges, LineFamily::Ridges,
          LineFamily::Valleys, LineFamily::Isophotes, LineFamily::Topographic}) {
      SurfaceFamily look = familyOf(setting, family);
      look.on = true;
      setting = withFamily(std::move(setting), look);
    }
    QVERIFY(driver_->push(setting));
    const SurfacePicture picture = pictureOf(driver_->window().surfaceModels());
    QStringList inWindow, inFile;
    for (const bool visible : {false, true}) {
      for (const LineLayer& layer : lineLayers(picture)) {
        const auto index = static_cast<std::size_t>(layer.ends - picture.seen->lines.data());
        QVERIFY(layer.visibleEnds);
        const std::string_view family = nameOf(static_cast<LineFamily>(index));
        const QString name = QString::fromUtf8(family.data(), static_cast<int>(family.size()));
        const std::size_t seen = *layer.visibleEnds;
        if ((visible ? seen : layer.ends->size() - seen) == 0) continue;
        inWindow << name + (visible ? "-visible" : "-hidden");
      }
    }
    QVERIFY2(inWindow.size() > 6, qPrintable(inWindow.join(' ')));
    QCOMPARE(inWindow.last(), QStringLiteral("contours-visible"));
    const Figure figure = surfaceFigure({picture}, {640, 480});
    for (const FigureGroup& group : figure.groups) inFile << QString::fromStdString(group.id);
    QCOMPARE(inFile, inWindow);
    const std::string svg = figureToSvg(figure, {}), tikz = figureToTikz(figure, {});
    for (const std::string& text : {svg, tikz}) {
      std::size_t at = 0;
      for (const QString& id : inWindow) {
        at = text.find(id.toStdString(), at);
        QVERIFY2(at != std::string::npos, qPrintable(id));
      }
    }
  }

  void aDifferenceIsWrittenInItsColours() {
    driver_->trigger("surface.compare.difference");
    QVERIFY(driver_->quiet());
    SurfaceSetting setting = *driver_->scene().surface;
    setting.panes[0].families = std::vector<std::string>{"ridges"};
    setting.panes[0].derivative = kClosedForm;
    QVERIFY(driver_->push(setting));
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

  void predictionsAreExported() {
    driver_->trigger("surface.extrude");
    QVERIFY(driver_->quiet());
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
      driver_->exportTo(name, {640, 480});
      QVERIFY(ExportDriver::comes(name));
      const bool text = QByteArray(suffix) != "pdf";
      QCOMPARE(textOf(name).contains("predicted-apparent-ridges-visible"), text);
    }
  }

  void theSectionIsExported() {
    driver_->window().surfaces().openSolid("torus:40");
    QVERIFY(driver_->quiet());
    SurfaceSetting setting = *driver_->scene().surface;
    setting.camera.towards = Eigen::Vector3d(0.5, 0.6, 1.0).normalized();
    setting.plane =
        SurfacePlane{Eigen::Vector3d(0.0, 0.1, 0.0), Eigen::Vector3d(0.2, 1.0, 0.1).normalized()};
    const SurfaceModels models = driver_->window().surfaceModels();
    double length[3] = {};  // hidden lines left out; seen and hidden ones
    for (const char* hidden : {"off", "dashed"}) {
      setting.hidden = hidden;
      QVERIFY(driver_->push(setting));
      QVERIFY(
          QTest::qWaitFor([&] { return !models.bridges.isStale(); }, ExportDriver::kPatienceMs));
      const Figure figure = surfaceFigure(picturesOf(models), {800, 600});
      const bool off = setting.hidden == "off";
      for (const bool seen : {true, false}) {
        const FigureGroup* group = groupOf(figure, seen ? "section-visible" : "section-hidden");
        QCOMPARE(group != nullptr, seen || !off);
        if (group) length[off ? 0 : seen ? 1 : 2] = lengthOf(*group);
      }
      QVERIFY(groupOf(figure, "section-marks"));
      // A torus cut across has marks behind it from everywhere.
      QCOMPARE(groupOf(figure, "section-marks-hidden") != nullptr, !off);
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
    driver_->exportTo(svg, {640, 480});
    QVERIFY(ExportDriver::comes(svg));
    QVERIFY(textOf(svg).contains("id=\"section-visible\""));
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
    QVERIFY(driver_->push(setting));
    driver_->document().setCamera(camera);
    QVERIFY(driver_->quiet());
    const QString name = driver_->path("it's one.svg");
    driver_->exportTo(name, {640, 480});
    QVERIFY(ExportDriver::comes(name));
    const QString exported = textOf(name);
    QString command = exported.section("<command>", 1).section("</command>", 0, 0);
    QVERIFY2(command.startsWith("flatland lines solid:bumpy-sphere:20 -o 'it'\\''s one.svg' "),
             qPrintable(command));
    QVERIFY(QFile::rename(name, driver_->path("window.svg")));
    QProcess shell;
    shell.setWorkingDirectory(QFileInfo(name).path());
    command.replace(0, 8, "\"$0\"").replace("&quot;", "\"");
    shell.start("sh", {"-c", command, FLATLAND_PROGRAM});
    QVERIFY(shell.waitForFinished(ExportDriver::kPatienceMs));
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

  /// Pictures are passed on; where their mesh lay is nobody's business.
  void picturesTellNoFolders() {
    const QString mesh = driver_->path("mesh.ply");
    driver_->exportTo(mesh);
    QVERIFY(ExportDriver::comes(mesh));
    driver_->window().surfaces().openFile(mesh);
    QVERIFY(driver_->quiet());
    const QByteArray folder = QFileInfo(mesh).path().toUtf8();
    for (const char* suffix : {"svg", "tex"}) {
      const QString name = driver_->path(QStringLiteral("told.") + suffix);
      driver_->exportTo(name, {640, 480});
      QVERIFY(ExportDriver::comes(name));
      const QByteArray text = textOf(name);
      QVERIFY2(text.contains("mesh.ply"), suffix);
      QVERIFY2(!text.contains(folder), suffix);
    }
  }

  void whatNoCommandMakesHasNone() {
    const auto hasCommand = [this](const char* what) {
      const QString name = driver_->path(QString(what) + ".svg");
      driver_->exportTo(name, {640, 480});
      if (!QTest::qWaitFor([&name] { return QFile::exists(name); }, ExportDriver::kPatienceMs))
        return false;
      return textOf(name).contains("<command>");
    };
    QVERIFY(hasCommand("plain"));
    const SurfaceSetting usual = *driver_->scene().surface;
    SurfaceSetting setting = usual;
    setting.ink = 0.03;
    QVERIFY(driver_->push(setting));
    QVERIFY(!hasCommand("ink"));
    SurfaceFamily ridges = familyOf(usual, LineFamily::ApparentRidges);
    ridges.colour = "#123456";
    QVERIFY(driver_->push(withFamily(usual, ridges)));
    QVERIFY(!hasCommand("colour"));
    ridges.colour.clear();
    ridges.widthPx += 1.0;
    QVERIFY(driver_->push(withFamily(usual, ridges)));
    QVERIFY(!hasCommand("width"));
    QVERIFY(driver_->push(usual));
    QVERIFY(hasCommand("again"));
    driver_->trigger("surface.compare.families");
    QVERIFY(driver_->quiet());
    QVERIFY(!hasCommand("views"));
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

  std::unique_ptr<ExportDriver> driver_;
};

QTEST_MAIN(SurfaceFigureTest)
#include "surface_figure_test.moc"
