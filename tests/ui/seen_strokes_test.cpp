// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of the 3D panel are the strokes of the drawing of its camera.
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextStream>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <map>
#include <new>
#include <random>
#include <thread>
#include <tuple>

#include "core3d/draw/draughtsman.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/orbit.h"
#include "ui/model/seen_surface.h"
#include "ui/model/surface_look.h"
#include "ui/model/surface_panes.h"
#include "ui/view3d/surface_picture.h"

using namespace flatland;
using namespace flatland::ui;

namespace {

// Memory ends once for the work beside the window's thread, when it next asks for a larger piece.
constexpr std::size_t kLarger = 2048;
std::atomic<bool> memoryEnds = false;
const std::thread::id windowThread = std::this_thread::get_id();

}  // namespace

void* operator new(std::size_t size) {
  if (size >= kLarger && std::this_thread::get_id() != windowThread && memoryEnds.exchange(false)) {
    throw std::bad_alloc();
  }
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

constexpr int kPatienceMs = 60000;  // estimates on a crowded machine
constexpr double kWidth = 800.0, kHeight = 600.0;

using Place = std::tuple<float, float, float>;
using Piece = std::pair<Place, Place>;
/// Pieces of line in any order and direction, of each family and whether they are seen.
using Pieces = std::map<std::pair<LineFamily, bool>, std::vector<Piece>>;

Place placeOf(const Eigen::Vector3f& p) { return {p.x(), p.y(), p.z()}; }

void add(Pieces& pieces, LineFamily family, bool visible, const Place& a, const Place& b) {
  pieces[{family, visible}].push_back(std::minmax(a, b));
}

Pieces sorted(Pieces pieces) {
  for (auto& [key, all] : pieces) std::sort(all.begin(), all.end());
  return pieces;
}

Pieces piecesOf(const SeenSurface& seen) {
  Pieces pieces;
  for (const LineFamily family : allLineFamilies()) {
    const auto index = static_cast<std::size_t>(family);
    const std::vector<LineVertex>& ends = seen.lines[index];
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      const bool visible = !seen.visibleEnds || i < (*seen.visibleEnds)[index];
      add(pieces, family, visible, {ends[i].x, ends[i].y, ends[i].z},
          {ends[i + 1].x, ends[i + 1].y, ends[i + 1].z});
    }
  }
  return sorted(std::move(pieces));
}

Pieces piecesOf(const Drawing& drawing) {
  Pieces pieces;
  for (const Polyline& line : drawing.polylines) {
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
      add(pieces, line.family, line.visible, placeOf(line.points[i]),
          placeOf(line.points[(i + 1) % n]));
    }
  }
  return sorted(std::move(pieces));
}

/// The length on the screen of what hangs together, the shortest first.
std::vector<double> componentsOf(const std::vector<LineVertex>& ends,
                                 const Projection& projection) {
  std::map<Place, Place> parent;
  const auto rootOf = [&parent](Place at) {
    while (parent.at(at) != at) at = parent.at(at);
    return at;
  };
  const auto place = [&ends](std::size_t i) { return Place(ends[i].x, ends[i].y, ends[i].z); };
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    for (const std::size_t k : {i, i + 1}) parent.try_emplace(place(k), place(k));
    parent[rootOf(place(i))] = rootOf(place(i + 1));
  }
  std::map<Place, double> lengths;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
    const auto at = [&](std::size_t k) {
      return *projection.toScreen(Eigen::Vector3d(ends[k].x, ends[k].y, ends[k].z));
    };
    lengths[rootOf(place(i))] += (at(i + 1) - at(i)).norm();
  }
  std::vector<double> result;
  for (const auto& [root, length] : lengths) result.push_back(length);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

class SeenStrokesTest : public QObject {
  Q_OBJECT

 private slots:
  /// A bumpy ball, measured badly.
  void init() {
    const LoadedSurface clean = loadSurface("solid:bumpy-sphere:40");
    const QString name = folder_.filePath("rough.obj");
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QTextStream text(&file);
    std::mt19937 random(5);
    std::normal_distribution<float> noise(0.0f, 0.002f);
    for (std::uint32_t v = 0; v < clean.mesh->vertexCount(); ++v) {
      const Eigen::Vector3f p = clean.mesh->position(v) * (1.0f + noise(random));
      text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    for (const auto& [a, b, c] : clean.mesh->triangles) {
      text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
    text.flush();
    file.close();
    document_ = std::make_unique<Document>(defaultScene(), "preset");
    source_ = std::make_unique<SurfaceSource>(*document_);
    ink_ = std::make_unique<InkSource>(*document_, *source_);
    seen_ = std::make_unique<SeenSource>(*document_, *source_, 0, nullptr, ink_.get());
    other_ = std::make_unique<SeenSource>(*document_, *source_, 1, seen_.get(), ink_.get());
    source_->setActive(true);
    source_->open(name);
    QVERIFY(
        QTest::qWaitFor([this] { return !source_->isBusy() && source_->surface(); }, kPatienceMs));
    SurfaceCamera camera = setting().camera;
    camera.towards = Eigen::Vector3d(0.4, 0.3, 1.0).normalized();
    document_->setCamera(camera);
    QVERIFY(settled());
    draughtsman_ =
        std::make_unique<Draughtsman>(*source_->surface()->mesh, *source_->surface()->fields);
  }
  void cleanup() {
    draughtsman_.reset();
    other_.reset();
    seen_.reset();
    ink_.reset();
    source_.reset();
    document_.reset();
  }

  void theyAreThoseOfTheDrawing_data() {
    QTest::addColumn<QStringList>("families");
    QTest::addColumn<double>("zoom");
    QTest::addColumn<double>("perspective");
    const QStringList usual{"contours", "apparent-ridges", "boundaries"};
    QTest::newRow("usual") << usual << 1.0 << 0.0;
    QTest::newRow("near") << usual << 6.0 << 0.0;
    QTest::newRow("far") << usual << 0.3 << 0.0;
    QTest::newRow("perspective") << usual << 1.5 << 40.0;
    QTest::newRow("outline") << QStringList{"exterior-silhouette", "ridges"} << 1.0 << 0.0;
    QTest::newRow("levels") << QStringList{"isophotes", "valleys", "contours"} << 1.0 << 0.0;
  }
  void theyAreThoseOfTheDrawing() {
    QFETCH(const QStringList, families);
    QFETCH(const double, zoom);
    QFETCH(const double, perspective);
    show(families);
    SurfaceCamera camera = setting().camera;
    camera.zoom = zoom;
    camera.centre = Eigen::Vector3d(0.2, -0.1, 0.0);
    if (perspective > 0.0) camera.perspectiveDeg = perspective;
    document_->setCamera(camera);
    QVERIFY(settled());
    const Pieces there = piecesOf(*seen_->seen());
    const Pieces drawn = piecesOf(drawing({}));
    QVERIFY(drawn.size() > 1);
    QVERIFY(there == drawn);
    // As the mesh is rough, pieces alone are more than that.
    if (families.contains("apparent-ridges")) {
      QVERIFY(seen_->seen()->found->of(LineFamily::ApparentRidges).size() >
              there.at({LineFamily::ApparentRidges, true}).size());
    }
  }

  void inkChangesThemAsItDoesTheDrawing() {
    SurfaceSetting edited = setting();
    edited.ink = 0.012;
    push(edited);
    QVERIFY(settled());
    QVERIFY(ink_->of(0) && ink_->of(0)->reached && ink_->of(0)->factor < 0.99);
    StrokeOptions strokes;
    strokes.ink = edited.ink;
    QVERIFY(piecesOf(*seen_->seen()) == piecesOf(drawing(strokes)));
  }

  void nothingShortIsLeft() {
    const double least = StrokeOptions{}.minLengthPx;
    const auto shortest = [this] {
      const auto& lines =
          seen_->seen()->lines[static_cast<std::size_t>(LineFamily::ApparentRidges)];
      const std::vector<double> lengths = componentsOf(lines, projection());
      return lengths.empty() ? 0.0 : lengths.front();
    };
    QVERIFY2(shortest() >= least, qPrintable(QString::number(shortest())));
    // What is long from near is short from far.
    SurfaceCamera camera = setting().camera;
    camera.zoom = 0.2;
    document_->setCamera(camera);
    QVERIFY(settled());
    QVERIFY2(shortest() >= least, qPrintable(QString::number(shortest())));
    // Also where depth tells what is hidden.
    SurfaceSetting compared = setting();
    compared.panes.resize(1);
    compared.panes[0].camera = seenFrom(camera, StandardView::Right);
    push(compared);
    QVERIFY(settled());
    QVERIFY(!seen_->seen()->visibleEnds);
    QVERIFY2(shortest() >= least, qPrintable(QString::number(shortest())));
  }

  void unfilteredIsEveryPiece() {
    SurfaceSetting edited = setting();
    edited.unfiltered = true;
    push(edited);
    QVERIFY(settled());
    const SeenSurface& seen = *seen_->seen();
    LineFinder finder(*seen.surface->mesh, *seen.surface->fields);
    const FeatureLines all = finder.find(seen.view, lineOptionsOf(setting()));
    for (const LineFamily family : allLineFamilies()) {
      QCOMPARE(seen.lines[static_cast<std::size_t>(family)].size(), 2 * all.of(family).size());
    }
    QVERIFY(!seen.visibleEnds);
    QVERIFY(all.of(LineFamily::ApparentRidges).size() > 1000);
    // No stroke depends on the size.
    const int searches = seen_->searches();
    SurfaceCamera camera = setting().camera;
    camera.zoom = 3.0;
    document_->setCamera(camera);
    seen_->setAspect(2.0);
    QVERIFY(!seen_->isStale());
    QCOMPARE(seen_->searches(), searches);
  }

  void theShapeOfThePictureCounts() {
    const auto total = [this] {
      std::size_t count = 0;
      for (const auto& lines : seen_->seen()->lines) count += lines.size();
      return count;
    };
    const std::size_t usual = total();
    seen_->setAspect(10.0);  // so flat that all is small
    QVERIFY(seen_->isStale());
    QVERIFY(settled());
    QVERIFY(total() < usual);
  }

  void aViewOfAnotherShapeHasStrokesOfItsOwn() {
    SurfaceSetting edited = setting();
    edited.panes.resize(1);
    push(edited);
    QVERIFY(settled());
    QCOMPARE(other_->seen(), seen_->seen());
    const Pieces usual = piecesOf(*seen_->seen());
    // A pixel of the window that cannot be divided is no other shape.
    other_->setAspect(401.0 / 300.0);
    QVERIFY(settled());
    QCOMPARE(other_->seen(), seen_->seen());
    other_->setAspect(0.2);  // so narrow that all is small
    QVERIFY(settled());
    QVERIFY(piecesOf(*seen_->seen()) == usual);
    const Pieces narrow = piecesOf(*other_->seen());
    QVERIFY(narrow != usual);
    // The first becomes as narrow, and then they share again.
    seen_->setAspect(0.2);
    QVERIFY(settled());
    QVERIFY(piecesOf(*seen_->seen()) == narrow);
    QCOMPARE(other_->seen(), seen_->seen());
    // And where only the first changes, the other goes on as it was.
    seen_->setAspect(4.0 / 3.0);
    QVERIFY(settled());
    QVERIFY(piecesOf(*other_->seen()) == narrow);
  }

  void whatFailedIsLookedForAgain() {
    QSignalSpy failed(seen_.get(), &SeenSource::failed);
    SurfaceCamera camera = setting().camera;
    camera.towards = Eigen::Vector3d(1.0, 0.3, 0.1).normalized();
    memoryEnds = true;
    document_->setCamera(camera);
    QVERIFY(settled());
    QCOMPARE(failed.count(), 1);
    QVERIFY((seen_->seen()->view.towards - camera.towards).norm() > 0.1);
    // A change that the lines do not depend on.
    SurfaceSetting edited = setting();
    edited.savedCameras.push_back({"kept", camera});
    push(edited);
    QVERIFY(settled());
    QCOMPARE(failed.count(), 1);
    QVERIFY((seen_->seen()->view.towards - camera.towards).norm() < 1e-12);
  }

  void inkThatFailedIsSolvedForAgain() {
    // Nobody else works beside the window's thread, to whom memory could end.
    other_.reset();
    seen_.reset();
    const auto solved = [this] {
      return QTest::qWaitFor([this] { return !ink_->isStale(); }, kPatienceMs);
    };
    QSignalSpy failed(ink_.get(), &InkSource::failed);
    SurfaceSetting edited = setting();
    edited.ink = 0.012;
    memoryEnds = true;
    push(edited);
    QVERIFY(solved());
    QCOMPARE(failed.count(), 1);
    QVERIFY(!ink_->of(0));
    // A change that ink does not depend on.
    edited.savedCameras.push_back({"kept", setting().camera});
    push(edited);
    QVERIFY(solved());
    QCOMPARE(failed.count(), 1);
    QVERIFY(ink_->of(0));
  }

  void aDifferenceIsTheSameAtEveryZoom() {
    SeenSource& other = *other_;
    QVERIFY(showsDifference());
    QVERIFY(other.seen()->difference->addedShare > 0.0);
    const int own = other.searches(), first = seen_->searches();
    SurfaceCamera camera = setting().camera;
    camera.zoom = 0.3;
    camera.centre = Eigen::Vector3d(0.3, 0.1, 0.0);
    document_->setCamera(camera);
    other.setAspect(2.0);
    QVERIFY(!other.isStale());
    QVERIFY(settled());
    QCOMPARE(other.searches(), own);
    QCOMPARE(seen_->searches(), first + 1);
    // All of its pieces are long strokes, or were cut from one.
    const auto& all = other.seen()->lines[static_cast<std::size_t>(LineFamily::ApparentRidges)];
    SurfaceCamera fitted = camera;
    fitted.zoom = 1.0;
    fitted.centre.setZero();
    const Projection there =
        orbitProjection(fitted, source_->surface()->ballRadius, kWidth, kHeight);
    QVERIFY(componentsOf(all, there).front() >= StrokeOptions{}.minLengthPx);
  }

  /// The surface is gone through again for what changed, and not for what only looks different.
  void aDifferenceFindsNothingTwice() {
    SeenSource& other = *other_;
    QVERIFY(showsDifference());
    SurfaceSetting edited = setting();
    const int searches = other.searches(), before = other.findings();
    QVERIFY(before > 0);
    edited.style = "gooch";
    push(edited);
    QVERIFY(settled());
    edited.hidden = "dashed";
    SurfaceFamily ridges = familyOf(edited, LineFamily::ApparentRidges);
    ridges.colour = "#123456";
    edited = withFamily(edited, ridges);
    push(edited);
    QVERIFY(settled());
    QVERIFY(other.searches() > searches);
    QCOMPARE(other.findings(), before);
    // Those of the first view are still there, those of the second are new.
    edited.panes[0].derivative = kClosedForm;
    edited.panes[0].families = std::vector<std::string>{"apparent-ridges"};
    push(edited);
    QVERIFY(settled());
    QCOMPARE(other.findings(), before + 1);
    // And for another view both.
    SurfaceCamera camera = setting().camera;
    camera.towards = Eigen::Vector3d(0.1, 0.5, 0.7).normalized();
    document_->setCamera(camera);
    QVERIFY(settled());
    QCOMPARE(other.findings(), before + 3);
  }

  /// Where what is hidden is known, the picture shows just that.
  void thePictureHidesWhatTheDrawingHides() {
    SurfacePicture picture;
    picture.surface = source_->surface();
    picture.seen = seen_->seen();
    picture.setting = setting();
    picture.setting.style = "paper";
    const auto known = [&picture] {
      const std::vector<LineLayer> layers = lineLayers(picture);
      return std::all_of(layers.begin(), layers.end(),
                         [](const LineLayer& layer) { return layer.visibleEnds.has_value(); });
    };
    QVERIFY(known());
    const QImage shown = paintSurface(picture, {400, 300});
    // The hidden ones alone paint nothing, and all of them without a surface before them do.
    auto hiddenOnly = std::make_shared<SeenSurface>(*picture.seen);
    std::size_t hidden = 0;
    for (std::size_t i = 0; i < kLineFamilyCount; ++i) {
      auto& lines = hiddenOnly->lines[i];
      auto& visible = (*hiddenOnly->visibleEnds)[i];
      lines.erase(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(visible));
      visible = 0;
      hidden += lines.size();
    }
    QVERIFY(hidden > 0);
    picture.seen = hiddenOnly;
    const QImage none = paintSurface(picture, {400, 300});
    QVERIFY(none != shown);
    picture.setting.hidden = "shown";
    QVERIFY(paintSurface(picture, {400, 300}) != none);
    picture.setting.hidden.clear();
    // Every pixel of what is hidden is paper.
    QCOMPARE(none.convertToFormat(QImage::Format_RGB32), [&none] {
      QImage empty(none.size(), QImage::Format_RGB32);
      empty.fill(none.pixel(0, 0));
      return empty;
    }());
    // From elsewhere depth has to tell.
    picture.setting.camera = orbited(picture.setting.camera, {2, 0}, 500);
    QVERIFY(known());
    picture.setting.camera = orbited(picture.setting.camera, {60, 0}, 500);
    QVERIFY(!known());
  }

 private:
  const SurfaceSetting& setting() const { return *document_->scene().surface; }
  void push(const SurfaceSetting& edited) {
    document_->push(std::make_unique<SetSurface>(*document_, edited, "edit"));
  }
  void show(const QStringList& families) {
    SurfaceSetting edited = setting();
    for (const LineFamily family : allLineFamilies()) {
      SurfaceFamily look = familyOf(edited, family);
      look.on = families.contains(QString::fromStdString(look.name));
      edited = withFamily(std::move(edited), look);
    }
    push(edited);
  }
  /// The second view shows how neighbours differ from the closed form; false if it does not come.
  bool showsDifference() {
    SurfaceSetting edited = setting();
    edited.panes.resize(1);
    edited.panes[0].shows = kShowsDifference;
    edited.panes[0].derivative = kOneRing;
    push(edited);
    return settled() && other_->seen() && other_->seen()->difference;
  }
  bool settled() {
    return QTest::qWaitFor(
        [this] { return !ink_->isStale() && !seen_->isStale() && !other_->isStale(); },
        kPatienceMs);
  }
  Projection projection() const {
    return orbitProjection(setting().camera, source_->surface()->ballRadius, kWidth, kHeight);
  }
  Drawing drawing(StrokeOptions strokes) {
    strokes.hidden = true;
    strokes.tolerancePx = -1.0;  // every point stays
    return draughtsman_->draw(projection(), lineOptionsOf(setting()), strokes);
  }

  QTemporaryDir folder_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<SurfaceSource> source_;
  std::unique_ptr<InkSource> ink_;
  std::unique_ptr<SeenSource> seen_, other_;  // of the first view and of the second
  std::unique_ptr<Draughtsman> draughtsman_;
};

QTEST_MAIN(SeenStrokesTest)
#include "seen_strokes_test.moc"
