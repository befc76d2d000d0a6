// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_study.h"

#include <mutex>

#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

/// Keeps what one search lends to the next; searches of one surface take turns.
struct SurfaceStudy::Worker {
  explicit Worker(std::shared_ptr<const LoadedSurface> of)
      : surface(std::move(of)), study(*surface->mesh, *surface->fields) {}

  std::mutex turn;
  std::shared_ptr<const LoadedSurface> surface;
  TriangleStudy study;
};

SurfaceStudy::SurfaceStudy(const Document& document, SurfacePick& pick, QObject* parent)
    : QObject(parent), document_(document), pick_(pick) {
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
    again_ = false;
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
  again_ = job_.isRunning();
  if (again_) return;
  using Data = std::shared_ptr<const TriangleLesson>;
  const double threshold =
      familyOf(*document_.scene().surface, LineFamily::ApparentRidges).threshold;
  job_.start<Data>(
      [worker = worker_, triangle = pick_.hit()->triangle, view = projection(1.0, 1.0).view(),
       threshold](const JobControl&) -> std::optional<Data> {
        const std::lock_guard lock(worker->turn);
        return std::make_shared<const TriangleLesson>(
            worker->study.lesson(triangle, view, threshold));
      },
      [this](const Data& lesson) {
        lesson_ = lesson;
        emit lessonChanged();
        if (again_) search();
      });
}

}  // namespace flatland::ui
