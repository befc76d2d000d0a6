// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/seen_surface.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include "core3d/draw/compose.h"
#include "core3d/draw/line_difference.h"
#include "core3d/draw/sight.h"
#include "core3d/study/line_distances.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void addVertices(const std::vector<LineSegment>& segments, std::vector<LineVertex>& vertices) {
  vertices.reserve(vertices.size() + 2 * segments.size());
  for (const LineSegment& segment : segments) {
    for (const LineEnd& end : {segment.a, segment.b}) {
      vertices.push_back({end.at.x(), end.at.y(), end.at.z(), end.strength});
    }
  }
}

std::vector<LineSegment> allOf(const StrokeLines& lines) {
  std::vector<LineSegment> all;
  for (const FeatureLines* part : {&lines.visible, &lines.hidden}) {
    for (const auto& family : part->segments) all.insert(all.end(), family.begin(), family.end());
  }
  return all;
}

constexpr double kHeightPx = 600.0;  ///< of a picture of any size: strokes are the same in all
constexpr double kUsualAspect = 4.0 / 3.0;
/// Views of one size differ by a pixel where the window cannot be divided; strokes by no more.
constexpr double kSameShape = 0.02;

bool isSameShape(double aspect, double other) {
  return std::abs(aspect - other) <= kSameShape * other;
}

/// The part of a camera that single pieces of line depend on.
SurfaceCamera foundFor(SurfaceCamera camera) {
  camera.zoom = 1.0;
  camera.up = SurfaceCamera{}.up;
  // The viewer goes along with the centre; parallel lines of sight do not.
  if (!camera.perspectiveDeg) camera.centre.setZero();
  return camera;
}

/// What a search depends on: not from where its lines are looked at, nor what else is shown.
PaneSetting findingPart(PaneSetting pane) {
  SurfaceSetting& surface = pane.surface;
  surface.savedCameras.clear();
  surface.plane.reset();
  surface.swept.reset();  // another surface is told by its source
  // Strokes are as long however the picture is turned.
  surface.camera.up = SurfaceCamera{}.up;
  if (surface.unfiltered) surface.camera = foundFor(surface.camera);
  pane.ownCamera = false;
  pane.camera = {};
  return pane;
}

/// What single pieces of line depend on: not how they are drawn, nor how large the picture is.
PaneSetting piecesPart(PaneSetting pane) {
  SurfaceSetting& surface = pane.surface;
  surface.camera = foundFor(surface.camera);
  surface.style = surface.quantity = surface.hidden = {};
  if (surface.ink) surface.ink = 1.0;  // as much as there is, for any of it
  std::vector<SurfaceFamily> families;
  for (const LineFamily family : allLineFamilies()) {
    const SurfaceFamily look = familyOf(surface, family);
    SurfaceFamily& sought = families.emplace_back();
    sought.name = look.name;
    sought.on = look.on;
    sought.threshold = look.threshold;
  }
  surface.families = std::move(families);
  pane.difference = false;
  return pane;
}

}  // namespace

/// Keeps what one search lends to the next; searches of one view take turns.
struct SeenSource::Worker : std::enable_shared_from_this<Worker> {
  explicit Worker(std::shared_ptr<const LoadedSurface> of) : surface(std::move(of)) {}

  std::shared_ptr<const SeenSurface> search(const Wanted& wanted) {
    const std::lock_guard lock(turn);
    const PaneSetting& pane = wanted.lines.pane;
    auto seen = std::make_shared<SeenSurface>();
    seen->surface = surface;
    const Projection projection = orbitProjection(pane.surface.camera, surface->ballRadius,
                                                  wanted.aspect * kHeightPx, kHeightPx);
    const SurfaceView& view = seen->view = projection.view();
    if (!finder) finder.emplace(*surface->mesh, *surface->fields);
    if (wanted.sight && !sight) sight.emplace(*surface->places, *surface->fields);
    const auto start = Clock::now();
    seen->found = find(wanted.lines);
    const StrokeLines strokes = strokesOf(*seen->found, wanted.lines, wanted.sight, projection);
    seen->lineMs = millisecondsSince(start);
    const bool hiddenKnown = wanted.sight && !pane.surface.unfiltered;
    if (hiddenKnown) seen->visibleEnds.emplace();
    for (std::size_t family = 0; family < kLineFamilyCount; ++family) {
      std::vector<LineVertex>& lines = seen->lines[family];
      addVertices(strokes.visible.segments[family], lines);
      if (hiddenKnown) (*seen->visibleEnds)[family] = lines.size();
      addVertices(strokes.hidden.segments[family], lines);
    }
    if (wanted.first) {
      const StrokeLines first =
          strokesOf(*find(*wanted.first), *wanted.first, wanted.sight, projection);
      seen->difference = compared(strokes, first);
    }
    seen->compared =
        std::async(std::launch::deferred, [self = shared_from_this(), view, found = seen->found,
                                           asked = lineOptionsOf(pane)] {
          return self->linesToCompare(view, asked, *found);
        }).share();
    if (styleOf(pane.surface) == SurfaceStyle::Colours) {
      const auto colouring = Clock::now();
      seen->colours =
          vertexColours(*surface->mesh, *surface->fields, view, quantityOf(pane.surface));
      seen->colourMs = millisecondsSince(colouring);
    }
    return seen;
  }

  static StrokeOptions strokeOptionsOf(const Lines& lines) {
    StrokeOptions strokes;
    strokes.hidden = true;
    strokes.ink = lines.pane.surface.ink;
    return strokes;
  }

  /// Pieces of line, as many as strokes are judged by. Kept while only the picture changes.
  std::shared_ptr<const FeatureLines> find(const Lines& lines) {
    const PaneSetting asked = piecesPart(lines.pane);
    const auto same = [&asked](const Pieces& pieces) { return pieces.of == asked; };
    if (const auto at = std::find_if(kept.begin(), kept.end(), same); at != kept.end()) {
      std::rotate(kept.begin(), at, at + 1);
      return kept.front().found;
    }
    LineOptions options = lineOptionsOf(lines.pane);
    if (!options.unfiltered) options = linesToFind(options, strokeOptionsOf(lines));
    const SurfaceView view = orbitView(lines.pane.surface.camera, surface->ballRadius);
    auto found = std::make_shared<const FeatureLines>(finder->find(view, options));
    ++findings;
    if (kept.size() == kKept) kept.pop_back();
    kept.insert(kept.begin(), {asked, found});
    return found;
  }

  StrokeLines strokesOf(const FeatureLines& found, const Lines& lines, bool withSight,
                        const Projection& projection) {
    if (lines.pane.surface.unfiltered) return {found, {}};
    return strokeLines(found, withSight ? &*sight : nullptr, projection, lineOptionsOf(lines.pane),
                       strokeOptionsOf(lines), lines.factor);
  }

  /// From `all` where that is what was asked for, with `asked`.
  std::shared_ptr<const FeatureLines> linesToCompare(const SurfaceView& view,
                                                     const LineOptions& asked,
                                                     const FeatureLines& all) {
    using enum LineFamily;
    const bool shown = asked[OccludingContours] && asked[ApparentRidges] &&
                       asked.thresholdOf(ApparentRidges) == 0.0 && !asked.unfiltered;
    if (shown) {
      auto clear = std::make_shared<FeatureLines>(all);
      for (auto& family : clear->segments) {
        std::erase_if(family, [](const LineSegment& piece) { return !piece.standsOut; });
      }
      return clear;
    }
    LineOptions wanted;
    wanted[OccludingContours] = wanted[ApparentRidges] = true;
    wanted.threshold[static_cast<std::size_t>(ApparentRidges)] = 0.0;
    wanted.derivative = asked.derivative;
    const std::lock_guard lock(turn);
    return std::make_shared<const FeatureLines>(finder->find(view, wanted));
  }

  SeenDifference compared(const StrokeLines& lines, const StrokeLines& first) {
    if (!tolerance) tolerance = meanEdge(*surface->mesh) / surface->mesh->unit;
    SeenDifference seen;
    seen.tolerance = *tolerance;
    LineDifference parts = differenceOf(allOf(lines), allOf(first), seen.tolerance);
    seen.addedShare = parts.addedShare();
    seen.missingShare = parts.missingShare();
    seen.pieces = {std::move(parts.common), std::move(parts.added), std::move(parts.missing)};
    for (std::size_t i = 0; i < SeenDifference::kParts; ++i) {
      addVertices(seen.pieces[i], seen.lines[i]);
    }
    return seen;
  }

  std::mutex turn;
  std::shared_ptr<const LoadedSurface> surface;
  std::optional<LineFinder> finder;      ///< made by the first search
  std::optional<flatland::Sight> sight;  ///< by the first that asks what is hidden
  std::optional<double> tolerance;       ///< likewise
  struct Pieces {
    PaneSetting of;
    std::shared_ptr<const FeatureLines> found;
  };
  /// A difference takes turns with the view that it is from.
  static constexpr std::size_t kKept = 2;
  std::vector<Pieces> kept;  ///< newest first
  std::atomic<int> findings = 0;
};

bool SeenSurface::knowsHidden(const SurfaceView& from) const {
  constexpr double kNearlySame = 0.05;  // 3 degrees
  if (!visibleEnds || view.eye.has_value() != from.eye.has_value()) return false;
  const Eigen::Vector3d here = from.eye.value_or(from.towards);
  const Eigen::Vector3d there = view.eye.value_or(view.towards);
  return (here - there).norm() <= kNearlySame * there.norm();
}

SeenSource::SeenSource(const Document& document, const SurfaceSource& source, std::size_t pane,
                       const SeenSource* first, const InkSource* ink, QObject* parent)
    : QObject(parent),
      document_(document),
      source_(source),
      pane_(pane),
      first_(first),
      ink_(ink),
      job_([this] { begin(); }) {
  connect(&document_, &Document::changed, this, &SeenSource::follow);
  connect(&source_, &SurfaceSource::changed, this, &SeenSource::surfaceChanged);
  // What failed once, for want of memory perhaps, is tried again at the next change.
  connect(&job_, &LatestJob::failed, this, [this] { asked_.reset(); });
  connect(&job_, &LatestJob::failed, this, &SeenSource::failed);
  if (ink_) connect(ink_, &InkSource::changed, this, &SeenSource::search);
  if (first_) {
    // Its picture may have got another shape.
    connect(first_, &SeenSource::changed, this, &SeenSource::search);
  }
}

SeenSource::~SeenSource() = default;

void SeenSource::follow(const Change& change) {
  if (change.touchesSurface() || change.what == Change::What::Camera) search();
}

void SeenSource::surfaceChanged() {
  const std::shared_ptr<const LoadedSurface>& surface = source_.surface();
  if (worker_ && worker_->surface == surface) return;
  worker_.reset();
  asked_.reset();
  // While the same surface is estimated at another scale, or swept anew, its lines stay; and those
  // that are being looked for are waited for, else a surface in motion would never have any.
  const bool stays = surface && seen_ && isSameSurface(*surface, *seen_->surface);
  if (!stays) {
    job_.cancel();
    drop();
  }
  if (!surface || !surface->fields) return;
  worker_ = std::make_shared<Worker>(surface);
  search();
}

void SeenSource::drop() {
  if (!seen_) return;
  seen_.reset();
  emit changed();
}

int SeenSource::findings() const { return worker_ ? worker_->findings.load() : 0; }

void SeenSource::borrow() {
  if (seen_ == first_->seen_) return;
  seen_ = first_->seen_;
  emit changed();
}

void SeenSource::search() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  const bool there = setting && pane_ < paneCount(*setting);
  borrows_ = there && first_ && linesOf(pane_) == linesOf(0) &&
             (setting->unfiltered || isSameShape(aspect_, first_->aspect_));
  if (borrows_ || !there) {
    job_.cancel();
    asked_.reset();
    return borrows_ ? borrow() : drop();
  }
  if (!isReady()) return;
  if (asked_ == wanted()) return job_.forgetWish();
  job_.wish();
}

bool SeenSource::isReady() const {
  return worker_ && document_.scene().surface->mesh == worker_->surface->reference;
}

void SeenSource::setAspect(double aspect) {
  if (aspect == aspect_) return;
  aspect_ = aspect;
  search();
}

SeenSource::Wanted SeenSource::wanted() const {
  Wanted wanted{linesOf(pane_), {}, aspect_, true};
  PaneSetting& pane = wanted.lines.pane;
  if (first_ && pane.difference) {
    // A difference is that of the surface from there, at every zoom: of strokes of the usual size.
    wanted.first = linesOf(0);
    pane.surface.camera = wanted.first->pane.surface.camera = foundFor(pane.surface.camera);
    wanted.aspect = kUsualAspect;
  }
  // A camera elsewhere sees other parts of the lines.
  wanted.sight = !wanted.first && !camerasDiffer(*document_.scene().surface);
  if (pane.surface.unfiltered) wanted.aspect = kUsualAspect;
  return wanted;
}

SeenSource::Lines SeenSource::linesOf(std::size_t pane) const {
  const SurfaceSetting& setting = *document_.scene().surface;
  const PaneInk* ink = ink_ && setting.ink ? ink_->of(pane) : nullptr;
  return {findingPart(paneSetting(setting, pane)), ink ? ink->factor : 1.0};
}

void SeenSource::begin() {
  if (!isReady()) return;  // the fields of another surface are on their way
  asked_ = wanted();
  using Data = std::shared_ptr<const SeenSurface>;
  job_.start<Data>([worker = worker_, wanted = *asked_](
                       const JobControl&) -> std::optional<Data> { return worker->search(wanted); },
                   [this](const Data& seen) {
                     seen_ = seen;
                     ++searches_;
                     emit changed();
                   });
}

}  // namespace flatland::ui
