// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/seen_surface.h"

#include <chrono>
#include <mutex>

#include "core3d/draw/line_difference.h"
#include "core3d/study/line_distances.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::vector<LineVertex> verticesOf(const std::vector<LineSegment>& segments) {
  std::vector<LineVertex> vertices;
  vertices.reserve(2 * segments.size());
  for (const LineSegment& segment : segments) {
    for (const LineEnd& end : {segment.a, segment.b}) {
      vertices.push_back({end.at.x(), end.at.y(), end.at.z(), end.strength});
    }
  }
  return vertices;
}

std::vector<LineSegment> allOf(const FeatureLines& lines) {
  std::vector<LineSegment> all;
  for (const auto& family : lines.segments) all.insert(all.end(), family.begin(), family.end());
  return all;
}

/// What a search depends on: not from where its lines are looked at, nor what else is shown.
PaneSetting findingPart(PaneSetting pane) {
  SurfaceSetting& surface = pane.surface;
  surface.savedCameras.clear();
  surface.plane.reset();
  surface.swept.reset();  // another surface is told by its source
  surface.camera.zoom = 1.0;
  surface.camera.up = SurfaceCamera{}.up;
  // The viewer goes along with the centre; parallel lines of sight do not.
  if (!surface.camera.perspectiveDeg) surface.camera.centre.setZero();
  pane.ownCamera = false;
  pane.camera = {};
  return pane;
}

}  // namespace

/// Keeps what one search lends to the next; searches of one view take turns.
struct SeenSource::Worker : std::enable_shared_from_this<Worker> {
  explicit Worker(std::shared_ptr<const LoadedSurface> of) : surface(std::move(of)) {}

  std::shared_ptr<const SeenSurface> search(const Wanted& wanted, const SurfaceView& view) {
    const std::lock_guard lock(turn);
    const PaneSetting& pane = wanted.pane;
    if (!finder) finder.emplace(*surface->mesh, *surface->fields);
    auto seen = std::make_shared<SeenSurface>();
    seen->surface = surface;
    seen->view = view;
    const LineOptions options = lineOptionsOf(pane);
    const auto start = Clock::now();
    auto found = std::make_shared<const FeatureLines>(finder->find(view, options));
    seen->lineMs = millisecondsSince(start);
    if (wanted.first) {
      seen->difference = compared(*found, finder->find(view, lineOptionsOf(*wanted.first)));
    }
    for (const LineFamily family : allLineFamilies()) {
      seen->lines[static_cast<std::size_t>(family)] = verticesOf(found->of(family));
    }
    seen->compared =
        std::async(std::launch::deferred, [self = shared_from_this(), view, options, found] {
          return self->linesToCompare(view, options, found);
        }).share();
    seen->found = std::move(found);
    if (styleOf(pane.surface) == SurfaceStyle::Colours) {
      const auto colouring = Clock::now();
      seen->colours =
          vertexColours(*surface->mesh, *surface->fields, view, quantityOf(pane.surface));
      seen->colourMs = millisecondsSince(colouring);
    }
    return seen;
  }

  /// `found` where that is what was asked for, with `asked`.
  std::shared_ptr<const FeatureLines> linesToCompare(
      const SurfaceView& view, const LineOptions& asked,
      const std::shared_ptr<const FeatureLines>& found) {
    using enum LineFamily;
    const bool shown = asked[OccludingContours] && asked[ApparentRidges] &&
                       asked.thresholdOf(ApparentRidges) == 0.0 && !asked.unfiltered;
    if (shown) return found;
    LineOptions wanted;
    wanted[OccludingContours] = wanted[ApparentRidges] = true;
    wanted.threshold[static_cast<std::size_t>(ApparentRidges)] = 0.0;
    wanted.derivative = asked.derivative;
    const std::lock_guard lock(turn);
    return std::make_shared<const FeatureLines>(finder->find(view, wanted));
  }

  SeenDifference compared(const FeatureLines& lines, const FeatureLines& first) {
    if (!tolerance) tolerance = meanEdge(*surface->mesh) / surface->mesh->unit;
    SeenDifference seen;
    seen.tolerance = *tolerance;
    LineDifference found = differenceOf(allOf(lines), allOf(first), seen.tolerance);
    seen.addedShare = found.addedShare();
    seen.missingShare = found.missingShare();
    seen.pieces = {std::move(found.common), std::move(found.added), std::move(found.missing)};
    for (std::size_t i = 0; i < SeenDifference::kParts; ++i) {
      seen.lines[i] = verticesOf(seen.pieces[i]);
    }
    return seen;
  }

  std::mutex turn;
  std::shared_ptr<const LoadedSurface> surface;
  std::optional<LineFinder> finder;  ///< made by the first search
  std::optional<double> tolerance;   ///< likewise
};

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
  connect(&job_, &LatestJob::failed, this, &SeenSource::failed);
  if (ink_) connect(ink_, &InkSource::changed, this, &SeenSource::search);
  if (first_) {
    connect(first_, &SeenSource::changed, this, [this] {
      if (borrows_) borrow();
    });
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

void SeenSource::borrow() {
  if (seen_ == first_->seen_) return;
  seen_ = first_->seen_;
  emit changed();
}

void SeenSource::search() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  const bool there = setting && pane_ < paneCount(*setting);
  borrows_ = there && first_ && wantedOf(pane_) == wantedOf(0);
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

SeenSource::Wanted SeenSource::wanted() const {
  Wanted wanted{wantedOf(pane_), {}};
  if (first_ && wanted.pane.difference) wanted.first = wantedOf(0);
  return wanted;
}

PaneSetting SeenSource::wantedOf(std::size_t pane) const {
  const PaneSetting asked = paneSetting(*document_.scene().surface, pane);
  return findingPart(ink_ ? ink_->withInk(asked, pane) : asked);
}

void SeenSource::begin() {
  if (!isReady()) return;  // the fields of another surface are on their way
  asked_ = wanted();
  const SurfaceView view = orbitView(asked_->pane.surface.camera, worker_->surface->ballRadius);
  using Data = std::shared_ptr<const SeenSurface>;
  job_.start<Data>(
      [worker = worker_, wanted = *asked_, view](const JobControl&) -> std::optional<Data> {
        return worker->search(wanted, view);
      },
      [this](const Data& seen) {
        seen_ = seen;
        ++searches_;
        emit changed();
      });
}

}  // namespace flatland::ui
