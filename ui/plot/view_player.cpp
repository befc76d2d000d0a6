// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/view_player.h"

#include <algorithm>

namespace flatland::ui {

namespace {

constexpr int kFrameMs = 16;
constexpr double kLongestFrameMs = 100.0;  // a slow frame slows the turn, it does not jump
constexpr double kFullTurnDeg = 360.0;

}  // namespace

ViewPlayer::ViewPlayer(Document& document, Stage& stage, QObject* parent)
    : QObject(parent), document_(document), turner_(document, stage) {
  timer_.setInterval(kFrameMs);
  connect(&timer_, &QTimer::timeout, this, &ViewPlayer::advance);
  connect(&document_, &Document::changed, this, &ViewPlayer::follow);
}

void ViewPlayer::play() {
  if (isPlaying()) return;
  turner_.begin();
  start_ = document_.scene().view.angleDeg;
  turned_ = 0.0;
  clock_.start();
  timer_.start();
  emit playingChanged(true);
}

void ViewPlayer::pause() {
  if (!isPlaying()) return;
  timer_.stop();
  turner_.end();
  emit playingChanged(false);
}

void ViewPlayer::cancel() {
  if (!isPlaying()) return;
  timer_.stop();
  turning_ = true;
  turner_.cancel();
  turning_ = false;
  emit playingChanged(false);
}

void ViewPlayer::advance() {
  const double ms = std::min(static_cast<double>(clock_.restart()), kLongestFrameMs);
  turned_ += speed_ * ms / 1000.0;
  if (turned_ >= kFullTurnDeg) return cancel();  // around: the view it began with
  turning_ = true;
  turner_.turnTo(start_ + turned_);
  turning_ = false;
}

void ViewPlayer::follow(const Change& change) {
  if (change.touchesScene() && !turning_) pause();
}

}  // namespace flatland::ui
