// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_source.h"

#include <utility>

#include "flatland/io/input_error.h"
#include "ui/commands/scene_commands.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"
#include "ui/model/surface_panes.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

SurfaceSource::SurfaceSource(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document_, &Document::changed, this, &SurfaceSource::follow);
  connect(&job_, &Job::failed, this, [this](const QString& reason) {
    const bool wasReading = std::exchange(reading_, false);
    emit failed(reason);
    // What was to be replaced may have been without its fields yet.
    if (wasReading && surface_ && !surface_->fields) estimate();
  });
  connect(&job_, &Job::progressed, this, &SurfaceSource::progressed);
  connect(&job_, &Job::runningChanged, this, &SurfaceSource::tellBusy);
  connect(&sweep_, &SweepWork::longChanged, this, &SurfaceSource::tellBusy);
  connect(&sweep_, &SweepWork::progressed, this, &SurfaceSource::progressed);
  connect(&sweep_, &SweepWork::failed, this, &SurfaceSource::failed);
  connect(&sweep_, &SweepWork::made, this,
          [this](const std::shared_ptr<const LoadedSurface>& surface) { show(surface, false); });
}

void SurfaceSource::tellBusy() {
  if (isBusy() == toldBusy_) return;
  toldBusy_ = isBusy();
  emit busyChanged(toldBusy_);
}

void SurfaceSource::setActive(bool active) {
  active_ = active;
  update();
}

void SurfaceSource::open(const QString& reference) { start(reference.toStdString(), true); }

void SurfaceSource::cancel() {
  reading_ = false;
  job_.cancel();
  sweep_.cancel();
}

void SurfaceSource::follow(const Change& change) {
  // What is swept goes by the curve, and its outside by the view.
  const bool turns = change.touchesScene() || change.what == Change::What::Camera;
  if (change.touchesSurface() || (turns && isSwept(document_.scene()))) update();
}

void SurfaceSource::update() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  if (isSwept(document_.scene())) {
    if (active_) updateSwept();
    return;
  }
  sweep_.setWish(std::nullopt);
  if (!setting) {
    if (!surface_ && !reading_) return;
    cancel();
    wanted_.clear();
    surface_ = nullptr;
    emit changed();
  } else if (active_) {
    if (setting->mesh != wanted_) {
      start(setting->mesh, false);
    } else if (surface_ && surface_->fields && surface_->fitScale != setting->fitScale) {
      estimate();
    }
  }
}

void SurfaceSource::updateSwept() {
  if (wanted_ != kSweptMesh) {
    cancel();
    wanted_ = kSweptMesh;
  }
  const std::optional<SweptSurface> surface = sweptOf(document_.scene());
  // Another surface than the scene's is not shown, not even for a while.
  if (surface_ && (!surface || !surface_->swept)) {
    surface_ = nullptr;
    emit changed();
  }
  const SurfaceSetting& setting = *document_.scene().surface;
  if (surface) {
    sweep_.setWish(SweepWish{*surface, setting.swept->cells, setting.fitScale});
  } else {
    sweep_.setWish(std::nullopt);
  }
}

bool SurfaceSource::isPreview() const {
  const auto& setting = document_.scene().surface;
  return surface_ && surface_->swept && setting && setting->swept &&
         surface_->swept->cells < setting->swept->cells;
}

void SurfaceSource::start(const std::string& reference, bool isNew) {
  if (!isNew) {
    wanted_ = reference;
    // Another surface than the scene's is not shown, not even for a while.
    if (surface_ && surface_->reference != reference) {
      surface_ = nullptr;
      emit changed();
    }
  }
  reading_ = true;
  const double fitScale = document_.scene().surface ? document_.scene().surface->fitScale : 1.0;
  using Data = std::shared_ptr<const LoadedSurface>;
  job_.start<Data>(
      [this, reference, fitScale, isNew](const JobControl& control) -> std::optional<Data> {
        const auto mesh = std::make_shared<const LoadedSurface>(loadSurface(reference));
        if (control.isCancelled()) return std::nullopt;
        control.deliver([this, mesh, isNew] { show(mesh, isNew); });
        Data whole = withFields(*mesh, fitScale, [&control](double share) {
          control.setProgress(share);
          return !control.isCancelled();
        });
        if (!whole) return std::nullopt;
        return whole;
      },
      [this](const Data& whole) { show(whole, false); });
}

void SurfaceSource::estimate() {
  using Data = std::shared_ptr<const LoadedSurface>;
  job_.start<Data>(
      [mesh = surface_, scale = document_.scene().surface->fitScale](
          const JobControl& control) -> std::optional<Data> {
        Data whole = withFields(*mesh, scale, [&control](double share) {
          control.setProgress(share);
          return !control.isCancelled();
        });
        if (!whole) return std::nullopt;
        return whole;
      },
      [this](const Data& whole) { show(whole, false); });
}

void SurfaceSource::show(const std::shared_ptr<const LoadedSurface>& surface, bool isNew) {
  reading_ = false;
  surface_ = surface;
  wanted_ = surface->reference;
  if (isNew) {
    SurfaceSetting setting = document_.scene().surface.value_or(SurfaceSetting{});
    if (isSwept(document_.scene())) setting = withUsualRidges(std::move(setting));
    setting.mesh = surface->reference;
    setting = withCamera(std::move(setting), homeCamera(upAxisOf(setting)));
    setting.savedCameras.clear();
    setting.swept.reset();
    setting.plane.reset();
    document_.push(std::make_unique<SetSurface>(
        document_, std::move(setting),
        tr("open %1").arg(QString::fromStdString(surfaceName(surface->reference)))));
    emit opened(QString::fromStdString(surface->reference));
  }
  emit changed();
}

}  // namespace flatland::ui
