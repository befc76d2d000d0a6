// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_study.h"

#include <mutex>

#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

/// Keeps what one search lends to the next; searches of one surface take turns.
struct SurfaceStudy::Worker {
  explicit Worker(std::shared_ptr<const LoadedSurface> of) : surface(std::move(of)) {}

  std::mutex turn;
  std::shared_ptr<const LoadedSurface> surface;
  std::optional<TriangleStudy> study;  ///< made by the first search: it walks over the mesh
};

SurfaceStudy::SurfaceStudy(const Document& document, SurfacePick& pick, const SurfaceViews& views,
                           QObject* parent)
    : QObject(parent), document_(document), pick_(pick), views_(views), job_([this] { begin(); }) {
  connect(&views_.ink(), &InkSource::changed, this, &SurfaceStudy::search);
  connect(&job_, &LatestJob::failed, this, &SurfaceStudy::failed);
  connect(&pick_, &SurfacePick::changed, this, &SurfaceStudy::refresh);
  connect(&document_, &Document::changed, this, [this](const Change& change) {
    const bool seen = change.what == Change::What::Camera || change.touchesSurface();
    if (seen && pick_.hit()) refresh();
  });
}

SurfaceStudy::~SurfaceStudy() = default;

Projection SurfaceStudy::projection(double width, double height) const {
  return orbitProjection(document_.scene().surface->camera, pick_.surface()->ballRadius, width,
                         height);
}

void SurfaceStudy::setTriangleWanted(bool wanted) {
  if (wanted == wanted_) return;
  wanted_ = wanted;
  if (wanted_) search();
}

void SurfaceStudy::refresh() {
  place_.reset();
  const auto& surface = pick_.surface();
  if (pick_.hit() && surface->fields && document_.scene().surface) {
    const Projection seen = projection(1.0, 1.0);  // the size of the picture does not matter
    place_ = surfacePlaceAt(*surface->mesh, *surface->fields, seen.view(), seen.axes.row(0),
                            pick_.vertex());
  }
  emit changed();
  search();
}

void SurfaceStudy::search() {
  const auto& surface = pick_.surface();
  if (!pick_.hit() || !surface->fields || !document_.scene().surface) {
    job_.cancel();
    worker_.reset();
    if (!lesson_) return;
    lesson_.reset();
    emit lessonChanged();
    return;
  }
  if (!wanted_) return;
  if (!worker_ || worker_->surface != surface) {
    job_.cancel();
    worker_ = std::make_shared<Worker>(surface);
  }
  job_.wish();
}

void SurfaceStudy::begin() {
  if (!wanted_) return;
  using Data = std::shared_ptr<const TriangleLesson>;
  // Those of the picture, whose threshold equal ink moves.
  const SurfaceSetting setting = views_.setting(0).surface;
  const double threshold = *familyOf(setting, LineFamily::ApparentRidges).threshold;
  job_.start<Data>(
      [worker = worker_, triangle = pick_.hit()->triangle, view = projection(1.0, 1.0).view(),
       threshold, unfiltered = setting.unfiltered](const JobControl&) -> std::optional<Data> {
        const std::lock_guard lock(worker->turn);
        if (!worker->study) {
          worker->study.emplace(*worker->surface->mesh, *worker->surface->fields);
        }
        return std::make_shared<const TriangleLesson>(
            worker->study->lesson(triangle, view, threshold, unfiltered));
      },
      [this](const Data& lesson) {
        lesson_ = lesson;
        emit lessonChanged();
      });
}

}  // namespace flatland::ui
