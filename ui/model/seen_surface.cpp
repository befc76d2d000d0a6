// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/seen_surface.h"

#include <chrono>
#include <mutex>

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

}  // namespace

/// Keeps what one search lends to the next; searches of one surface take turns.
struct SeenSource::Worker {
  explicit Worker(std::shared_ptr<const LoadedSurface> of)
      : surface(std::move(of)), finder(*surface->mesh, *surface->fields) {}

  std::shared_ptr<const SeenSurface> search(const SurfaceSetting& setting,
                                            const SurfaceView& view) {
    const std::lock_guard lock(turn);
    auto seen = std::make_shared<SeenSurface>();
    seen->surface = surface;
    seen->view = view;
    const auto start = Clock::now();
    const FeatureLines lines = finder.find(view, lineOptionsOf(setting));
    seen->lineMs = millisecondsSince(start);
    for (const LineFamily family : allLineFamilies()) {
      seen->lines[static_cast<std::size_t>(family)] = verticesOf(lines.of(family));
    }
    if (styleOf(setting) == SurfaceStyle::Colours) {
      const auto colouring = Clock::now();
      seen->colours = vertexColours(*surface->mesh, *surface->fields, view, quantityOf(setting));
      seen->colourMs = millisecondsSince(colouring);
    }
    return seen;
  }

  std::mutex turn;
  std::shared_ptr<const LoadedSurface> surface;
  LineFinder finder;
};

SeenSource::SeenSource(const Document& document, const SurfaceSource& source, QObject* parent)
    : QObject(parent), document_(document), source_(source) {
  connect(&document_, &Document::changed, this, &SeenSource::follow);
  connect(&source_, &SurfaceSource::changed, this, &SeenSource::surfaceChanged);
  connect(&job_, &Job::failed, this, &SeenSource::failed);
}

SeenSource::~SeenSource() = default;

void SeenSource::follow(const Change& change) {
  if (change.touchesSurface() || change.what == Change::What::Camera) search();
}

void SeenSource::surfaceChanged() {
  const std::shared_ptr<const LoadedSurface>& surface = source_.surface();
  if (worker_ && worker_->surface == surface) return;
  job_.cancel();
  again_ = false;
  worker_.reset();
  // While the same surface is estimated at another scale, its lines stay.
  if (seen_ && (!surface || surface->mesh != seen_->surface->mesh)) {
    seen_.reset();
    emit changed();
  }
  if (!surface || !surface->fields) return;
  worker_ = std::make_shared<Worker>(surface);
  search();
}

void SeenSource::search() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  if (!worker_ || !setting || setting->mesh != worker_->surface->reference) return;
  again_ = job_.isRunning();
  if (again_) return;
  // The view depends on where the viewer stands, not on the size of the picture.
  constexpr double kAnySize = 100.0;
  const Projection projection =
      orbitProjection(setting->camera, worker_->surface->ballRadius, kAnySize, kAnySize);
  const SurfaceView view = projection.view();
  using Data = std::shared_ptr<const SeenSurface>;
  job_.start<Data>(
      [worker = worker_, setting = *setting, view](const JobControl&) -> std::optional<Data> {
        return worker->search(setting, view);
      },
      [this](const Data& seen) {
        seen_ = seen;
        ++searches_;
        emit changed();
        if (again_) search();
      });
}

}  // namespace flatland::ui
