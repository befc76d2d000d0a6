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

SweepWork::SweepWork(QObject* parent)
    : QObject(parent), job_([this] { begin(); }), msPerSquare_(kFirstGuess) {
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, &job_, &LatestJob::wish);
  connect(&job_, &LatestJob::progressed, this, [this](double share) {
    if (isLong()) emit progressed(share);
  });
  connect(&job_, &LatestJob::failed, this, &SweepWork::failed);
  connect(&job_, &LatestJob::runningChanged, this, &SweepWork::longChanged);
}

void SweepWork::setWish(const std::optional<SweepWish>& wish) {
  if (wish == wish_) return;
  wish_ = wish;
  if (!wish) return cancel();
  rest_.start();
  // What is made for a hand that rested is of no use any more; what follows the hand is.
  if (job_.isRunning() && tried_->cells > liveCells()) job_.cancel();
  job_.wish();
}

void SweepWork::cancel() {
  rest_.stop();
  job_.cancel();
  tried_.reset();
}

int SweepWork::liveCells() const {
  const int most = static_cast<int>(std::sqrt(kLiveMs / msPerSquare_)) / kStep * kStep;
  return std::min(std::max(most, kFewestLive), wish_->cells);
}

void SweepWork::begin() {
  SweepWish next = *wish_;
  if (rest_.isActive()) next.cells = liveCells();
  if (tried_ == next) return;  // it is there, or cannot be made
  tried_ = next;
  const double square = static_cast<double>(next.cells) * next.cells;
  long_ = msPerSquare_ * square > kLongMs;
  using Data = std::shared_ptr<const LoadedSurface>;
  job_.start<Data>(
      [next](const JobControl& control) -> std::optional<Data> {
        const LoadedSurface mesh = loadSwept(next.surface, next.cells);
        if (control.isCancelled()) return std::nullopt;
        Data whole = withFields(mesh, next.fitScale, [&control](double share) {
          control.setProgress(share);
          return !control.isCancelled();
        });
        if (!whole) return std::nullopt;
        return whole;
      },
      [this, square](const Data& whole) {
        msPerSquare_ = std::max((whole->loadMs + whole->fieldMs) / square, 1e-9);
        emit made(whole);
      });
}

}  // namespace flatland::ui
