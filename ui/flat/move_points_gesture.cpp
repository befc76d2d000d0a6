// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLineF>
#include <QPainter>
#include <cmath>

#include "ui/commands/curve_commands.h"
#include "ui/flat/gestures.h"

namespace flatland::ui {

MovePointsGesture::MovePointsGesture(const CanvasModels& models, Plan plan, const Pointer& pressed)
    : models_(models),
      hold_(models.stage),
      plan_(std::move(plan)),
      before_(models.selection.points()),
      start_(models.document.scene()),
      pressed_(pressed.at),
      gesture_(models.document.newGesture()) {
  models_.selection.setPoints(plan_.selected);
}

void MovePointsGesture::move(const Pointer& pointer) {
  const QPointF drag = pointer.at - pressed_;
  if (state_ == State::Pressed && std::hypot(drag.x(), drag.y()) < kDragThresholdPx) return;
  state_ = State::Dragging;
  Vec2 delta = models_.viewport.toWorld(pointer.at) - models_.viewport.toWorld(pressed_);
  if (pointer.modifiers.testFlag(Qt::ControlModifier)) {
    (std::abs(drag.x()) >= std::abs(drag.y()) ? delta.y() : delta.x()) = 0.0;
  }
  const bool alone = pointer.modifiers.testFlag(Qt::AltModifier);
  moveTo(delta, alone ? JointMode::Break : JointMode::Keep);
}

void MovePointsGesture::finish(const Pointer& pointer) {
  move(pointer);
  if (state_ != State::Pressed) return;
  models_.selection.setPoints(plan_.clicked);
  if (plan_.probe) models_.probe.setPlace(plan_.probe);
}

void MovePointsGesture::cancel() {
  if (state_ == State::Dragging) moveTo(Vec2::Zero(), JointMode::Break);
  models_.selection.setPoints(before_);
}

void MovePointsGesture::moveTo(const Vec2& delta, JointMode mode) {
  delta_ = delta;
  if (plan_.curve) {
    models_.document.push(
        std::make_unique<MoveCurve>(models_.document, start_, *plan_.curve, delta, gesture_));
    return;
  }
  models_.document.push(
      std::make_unique<MovePoints>(models_.document, start_, plan_.moving, delta, mode, gesture_));
}

QString MovePointsGesture::status() const {
  if (plan_.curve) {
    return Gesture::tr("Moving the curve by (%1). Ctrl: along one axis. Esc: take it back.")
        .arg(coordinates(models_.viewport, delta_));
  }
  return Gesture::tr(
             "Moving %1 by (%2). Ctrl: along one axis. Alt: leave the handles. Esc: take it back.")
      .arg(plan_.moving.size() == 1
               ? Gesture::tr("the point")
               : Gesture::tr("%n points", nullptr, static_cast<int>(plan_.moving.size())),
           coordinates(models_.viewport, delta_));
}

void MovePointsGesture::paint(QPainter& painter) const {
  if (state_ != State::Dragging) return;
  const Vec2 at = plan_.anchor + delta_;
  paintLabel(painter, models_.viewport.toWidget(at), coordinates(models_.viewport, at));
}

}  // namespace flatland::ui
