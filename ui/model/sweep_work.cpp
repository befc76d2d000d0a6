// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/sweep_work.h"

#include <algorithm>
#include <cmath>

namespace flatland::ui {

namespace {

constexpr int kRestMs = 150;       ///< without a new wish: the hand rests
constexpr int kFewestLive = 16;    ///< below, a surface is not to be recognised
constexpr int kStep = 8;           ///< so that times that differ a little make equal meshes
constexpr double kLongMs = 500.0;  ///< above, progress is told
constexpr double kFirstGuess = kFewestLive * 1e-3;  ///< ms over cells squared

}  // namespace

bool SweepWish::operator==(const SweepWish& other) const {
  return cells == other.cells && fitScale == other.fitScale && surface.kind == other.surface.kind &&
         surface.amount == other.surface.amount && surface.turned == other.surface.turned &&
         surface.curve == other.surface.curve;
}

SweepWork::SweepWork(QObject* parent) : QObject(parent), msPerSquare_(kFirstGuess) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (!wish_ || job_.isRunning()) return;
    const bool made = made_ && *made_ == *wish_ && madeCells_ == wish_->cells;
    const bool tried = making_ && *making_ == *wish_;
    if (!made && !tried) start(wish_->cells);
  });
  connect(&job_, &Job::progressed, this, [this](double share) {
    if (isLong()) emit progressed(share);
  });
  connect(&job_, &Job::failed, this, [this](const QString& reason) {
    emit failed(reason);
    if (!wish_ || !making_ || job_.isRunning()) return;
    SweepWish tried = *making_;
    tried.cells = wish_->cells;
    if (!(tried == *wish_)) {
      start(rest_.isActive() ? liveCells() : wish_->cells);
    } else if (!rest_.isActive() && making_->cells < wish_->cells) {
      start(wish_->cells);
    }
  });
  connect(&job_, &Job::runningChanged, this, &SweepWork::longChanged);
}

void SweepWork::setWish(const std::optional<SweepWish>& wish) {
  if (wish == wish_) return;
  wish_ = wish;
  if (!wish) {
    made_.reset();
    madeCells_ = 0;
    return cancel();
  }
  rest_.start();
  // What is made for a hand that rested is of no use any more; what follows the hand is.
  if (!job_.isRunning() || making_->cells > liveCells()) start(liveCells());
}

void SweepWork::cancel() {
  rest_.stop();
  job_.cancel();
  making_.reset();
}

int SweepWork::liveCells() const {
  const int most = static_cast<int>(std::sqrt(kLiveMs / msPerSquare_)) / kStep * kStep;
  return std::min(std::max(most, kFewestLive), wish_->cells);
}

void SweepWork::start(int cells) {
  making_ = *wish_;
  making_->cells = cells;
  long_ = msPerSquare_ * cells * cells > kLongMs;
  using Data = std::shared_ptr<const LoadedSurface>;
  job_.start<Data>(
      [make = *making_](const JobControl& control) -> std::optional<Data> {
        const LoadedSurface mesh = loadSwept(make.surface, make.cells);
        if (control.isCancelled()) return std::nullopt;
        Data whole = withFields(mesh, make.fitScale, [&control](double share) {
          control.setProgress(share);
          return !control.isCancelled();
        });
        if (!whole) return std::nullopt;
        return whole;
      },
      [this, of = *wish_](const Data& whole) { finish(of, whole); });
}

void SweepWork::finish(const SweepWish& of, const std::shared_ptr<const LoadedSurface>& surface) {
  made_ = of;
  madeCells_ = surface->swept->cells;
  const double square = static_cast<double>(madeCells_) * madeCells_;
  msPerSquare_ = std::max((surface->loadMs + surface->fieldMs) / square, 1e-9);
  emit made(surface);
  if (!wish_ || job_.isRunning()) return;
  if (!(*wish_ == of)) {
    start(rest_.isActive() ? liveCells() : wish_->cells);
  } else if (!rest_.isActive() && madeCells_ < wish_->cells) {
    start(wish_->cells);
  }
}

}  // namespace flatland::ui
