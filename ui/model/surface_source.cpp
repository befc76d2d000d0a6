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
  for (const Job* job : {&opening_, &fields_}) {
    connect(job, &Job::failed, this, &SurfaceSource::failed);
    connect(job, &Job::runningChanged, this, &SurfaceSource::tellBusy);
  }
  connect(&opening_, &Job::failed, this, [this] {
    const std::optional<SurfaceSetting>& setting = document_.scene().surface;
    if (!opensNew_) {
      unreadable_ = wanted_;
    } else if (!setting || setting->mesh != unreadable_) {
      // Reading that of the scene was given up for it; why that failed before has been told.
      readAgain();
    }
  });
  connect(&fields_, &Job::progressed, this, [this](double share) {
    if (!isReading()) emit progressed(share);
  });
  connect(&sweep_, &SweepWork::longChanged, this, &SurfaceSource::tellBusy);
  connect(&sweep_, &SweepWork::progressed, this, &SurfaceSource::progressed);
  connect(&sweep_, &SweepWork::failed, this, &SurfaceSource::failed);
  connect(&sweep_, &SweepWork::made, this,
          [this](const std::shared_ptr<const LoadedSurface>& surface) { show(surface, false); });
}

void SurfaceSource::tellBusy() {
  if (isBusy() == toldBusy_ && isReading() == toldReading_) return;
  toldBusy_ = isBusy();
  toldReading_ = isReading();
  emit busyChanged(toldBusy_);
}

void SurfaceSource::setActive(bool active) {
  active_ = active;
  update();
}

void SurfaceSource::open(const QString& reference) { start(reference.toStdString(), true); }

void SurfaceSource::close() {
  if (!document_.scene().surface) return;
  closedLook_ = *document_.scene().surface;
  if (isSwept(document_.scene())) closedLook_ = withUsualRidges(closedLook_);
  document_.push(std::make_unique<SetSurface>(document_, std::nullopt, tr("close surface")));
}

void SurfaceSource::cancel() {
  givenUp_ = true;
  if (opening_.isRunning()) {
    opening_.cancel();
    emit readingGivenUp(QString::fromStdString(reads_));
    return;
  }
  fields_.cancel();
  sweep_.cancel();
}

void SurfaceSource::drop() {
  givenUp_ = false;
  scale_.reset();
  opening_.cancel();
  fields_.cancel();
  sweep_.cancel();
}

bool SurfaceSource::isGivenUp() const {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  if (!givenUp_ || isBusy() || !setting) return false;
  if (isSwept(document_.scene())) return isPreview();
  return !surface_ || !surface_->fields || surface_->fitScale != setting->fitScale;
}

void SurfaceSource::goOn() {
  if (!isGivenUp()) return;
  sweep_.setWish(std::nullopt);
  scale_.reset();
  readAgain();
}

void SurfaceSource::readAgain() {
  // What is shown, or swept, needs no reading.
  if (!surface_ && !isSwept(document_.scene())) wanted_.clear();
  update();
}

void SurfaceSource::follow(const Change& change) {
  // Another file or preset begins. Steps of undo or of a lesson do not come here: where a surface
  // was closed, its step is on the stack, done or undone.
  if (change.what == Change::What::Scene && document_.undoStack().count() == 0) closedLook_ = {};
  // What was to be put into a scene that is gone is not wanted in the next one.
  if (change.what == Change::What::Scene && (givenUp_ || (opensNew_ && isReading()))) {
    opening_.cancel();
    scale_.reset();
    return readAgain();
  }
  // What another scene names is told of, though it could not be read before.
  if (change.what == Change::What::Scene && wanted_ == unreadable_) wanted_.clear();
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
    wanted_.clear();
    if (!surface_ && !isReading()) return;
    drop();
    surface_ = nullptr;
    emit changed();
  } else if (active_) {
    if (setting->mesh != wanted_) {
      start(setting->mesh, false);
    } else {
      wantFields();
    }
  }
}

void SurfaceSource::updateSwept() {
  if (wanted_ != kSweptMesh) {
    drop();
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
    unreadable_.clear();
    // Another surface than the scene's is not shown, not even for a while.
    if (surface_ && surface_->reference != reference) {
      fields_.cancel();
      scale_.reset();
      surface_ = nullptr;
      emit changed();
    }
  }
  opensNew_ = isNew;
  givenUp_ = false;
  reads_ = reference;
  using Data = std::shared_ptr<const LoadedSurface>;
  opening_.start<Data>(
      [reference](const JobControl&) {
        return std::optional<Data>(std::make_shared<const LoadedSurface>(loadSurface(reference)));
      },
      [this, isNew](const Data& mesh) {
        fields_.cancel();
        scale_.reset();
        show(mesh, isNew);
        wantFields();
      });
}

void SurfaceSource::wantFields() {
  const std::optional<SurfaceSetting>& setting = document_.scene().surface;
  if (!surface_ || surface_->swept || !setting || scale_ == setting->fitScale) return;
  scale_ = setting->fitScale;
  givenUp_ = false;
  // Back to what is there.
  if (surface_->fields && surface_->fitScale == *scale_) return fields_.cancel();
  using Data = std::shared_ptr<const LoadedSurface>;
  fields_.start<Data>(
      [mesh = surface_, scale = *scale_](const JobControl& control) -> std::optional<Data> {
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
  givenUp_ = false;
  surface_ = surface;
  wanted_ = surface->reference;
  if (isNew) {
    SurfaceSetting setting = document_.scene().surface.value_or(closedLook_);
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
