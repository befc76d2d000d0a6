// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/ink_source.h"

#include <algorithm>
#include <mutex>

#include "core3d/draw/compose.h"
#include "core3d/draw/draughtsman.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

namespace {

constexpr int kRestMs = 150;  ///< a camera that moves is not solved for
constexpr double kWidthPx = 800.0, kHeightPx = 600.0;

/// What the ink of a view depends on.
std::vector<PaneSetting> inkParts(const SurfaceSetting& setting) {
  std::vector<PaneSetting> views;
  for (std::size_t pane = 0; pane < paneCount(setting); ++pane) {
    PaneSetting view = paneSetting(setting, pane);
    view.surface.savedCameras.clear();
    view.surface.plane.reset();
    view.surface.style.clear();
    view.surface.quantity.clear();
    view.surface.hidden.clear();
    view.ownCamera = view.difference = false;
    view.camera = {};
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace

/// Keeps what one drawing lends to the next.
struct InkSource::Worker {
  explicit Worker(std::shared_ptr<const LoadedSurface> of) : surface(std::move(of)) {}

  /// Nothing if it was stopped.
  std::optional<std::vector<PaneInk>> solve(const std::vector<PaneSetting>& views,
                                            const std::stop_token& stop) {
    const std::lock_guard lock(turn);
    if (stop.stop_requested()) return std::nullopt;
    if (!draughtsman) draughtsman.emplace(*surface->mesh, *surface->fields);
    std::vector<PaneInk> found;
    for (std::size_t i = 0; i < views.size(); ++i) {
      const PaneSetting& view = views[i];
      // Views that show the same have the same ink.
      const auto same =
          std::find(views.begin(), views.begin() + static_cast<std::ptrdiff_t>(i), view);
      if (same != views.begin() + static_cast<std::ptrdiff_t>(i)) {
        found.push_back(found[static_cast<std::size_t>(same - views.begin())]);
        continue;
      }
      StrokeOptions strokes;
      strokes.ink = view.surface.ink;
      strokes.stop = stop;
      const Projection projection =
          orbitProjection(view.surface.camera, surface->ballRadius, kWidthPx, kHeightPx);
      const DrawingStats stats = draughtsman->draw(projection, lineOptionsOf(view), strokes).stats;
      if (stop.stop_requested()) return std::nullopt;
      found.push_back({stats.thresholdFactor, stats.ink, stats.inkReached});
    }
    return found;
  }

  std::mutex turn;
  std::shared_ptr<const LoadedSurface> surface;
  std::optional<Draughtsman> draughtsman;  ///< made by the first drawing
};

InkSource::InkSource(const Document& document, const SurfaceSource& source, QObject* parent)
    : QObject(parent), document_(document), source_(source) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, &InkSource::solve);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    if (change.touchesSurface() || change.what == Change::What::Camera) follow();
  });
  connect(&source_, &SurfaceSource::changed, this, &InkSource::follow);
  // What failed once, for want of memory perhaps, is tried again at the next change.
  connect(&job_, &Job::failed, this, [this] { asked_.clear(); });
  connect(&job_, &Job::failed, this, &InkSource::failed);
}

InkSource::~InkSource() { stop_.request_stop(); }

void InkSource::forget() {
  rest_.stop();
  stop_.request_stop();
  job_.cancel();
  asked_.clear();
  if (found_.empty()) return;
  found_.clear();
  emit changed();
}

void InkSource::follow() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  const auto& surface = source_.surface();
  const bool ready =
      surface && surface->fields && setting && setting->ink && setting->mesh == surface->reference;
  if (!ready || (worker_ && worker_->surface != surface)) {
    worker_.reset();
    forget();
  }
  if (!ready) return;
  if (!worker_) worker_ = std::make_shared<Worker>(surface);
  if (inkParts(*setting) == asked_) return;
  stop_.request_stop();
  job_.cancel();
  asked_.clear();
  rest_.start();
}

void InkSource::solve() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  if (!worker_ || !setting || !setting->ink) return;
  asked_ = inkParts(*setting);
  stop_ = std::stop_source();
  using Found = std::vector<PaneInk>;
  job_.start<Found>([worker = worker_, views = asked_, stop = stop_.get_token()](
                        const JobControl&) { return worker->solve(views, stop); },
                    [this](const Found& found) {
                      found_ = found;
                      ++solutions_;
                      emit changed();
                    });
}

const PaneInk* InkSource::of(std::size_t pane) const {
  return pane < found_.size() ? &found_[pane] : nullptr;
}

PaneSetting InkSource::withInk(PaneSetting view, std::size_t pane) const {
  const PaneInk* ink = of(pane);
  if (!ink || !view.surface.ink) return view;
  for (const LineFamily family : allLineFamilies()) {
    SurfaceFamily look = familyOf(view.surface, family);
    if (!(*look.threshold > 0.0) || !movesWithInk(family)) continue;
    *look.threshold *= ink->factor;
    view.surface = withFamily(std::move(view.surface), look);
  }
  return view;
}

}  // namespace flatland::ui
