// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/view_turner.h"

#include <cmath>

#include "ui/commands/scene_commands.h"

namespace flatland::ui {

void ViewTurner::begin() {
  if (isActive()) return;
  start_ = document_.scene().view;
  gesture_ = document_.newGesture();
  stage_.hold();
}

void ViewTurner::turnTo(double angleDeg) {
  View view = document_.scene().view;
  view.angleDeg = normalizedDeg(angleDeg);
  document_.push(std::make_unique<SetView>(document_, view, isActive() ? gesture_ : 0));
}

void ViewTurner::turnByStep(double degrees) {
  constexpr double kOnMultiple = 1e-6;  // of a step: the angle stands on one, but for rounding
  const double ahead = degrees > 0.0 ? 1.0 : -1.0;
  const double now = ahead * document_.scene().view.angleDeg / std::abs(degrees);
  turnTo(degrees * (std::floor(now + kOnMultiple) + 1.0));
}

void ViewTurner::turnTo(double angleDeg, Probe& probe, const Probe::Place& place) {
  View view = document_.scene().view;
  view.angleDeg = normalizedDeg(angleDeg);
  document_.push(
      std::make_unique<SetViewAndProbe>(document_, view, probe, place, isActive() ? gesture_ : 0));
  probe.setPlace(place);  // also where the view was that already, so that there is no step
}

void ViewTurner::end() {
  if (!isActive()) return;
  start_.reset();
  stage_.release();
}

void ViewTurner::cancel() {
  if (!isActive()) return;
  document_.push(std::make_unique<SetView>(document_, *start_, gesture_));
  end();
}

}  // namespace flatland::ui
