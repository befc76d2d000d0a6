// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLineF>
#include <QPainter>
#include <QPalette>

#include "ui/commands/scene_commands.h"
#include "ui/flat/gestures.h"

namespace flatland::ui {

TurnViewGesture::TurnViewGesture(const CanvasModels& models, const Pointer& pressed,
                                 const QSizeF& canvas)
    : models_(models),
      hold_(models.stage),
      canvas_(canvas),
      start_(models.document.scene().view),
      pressed_(pressed.at),
      gesture_(models.document.newGesture()) {
  const HandlePlace handle = handlePlace(models, canvas);
  grip_ = handle.at - pressed.at;
  atEdge_ = handle.atEdge;
}

void TurnViewGesture::move(const Pointer& pointer) {
  if (!moved_ && QLineF(pressed_, pointer.at).length() < kDragThresholdPx) return;
  moved_ = true;
  const bool snap = pointer.modifiers.testFlag(Qt::ShiftModifier);
  const bool keepDistance = atEdge_ || pointer.modifiers.testFlag(Qt::ControlModifier);
  const Vec2 world = models_.viewport.toWorld(pointer.at + grip_);
  models_.document.push(std::make_unique<SetView>(
      models_.document, models_.stage.viewWithHandleAt(world, snap, keepDistance), gesture_));
}

void TurnViewGesture::finish(const Pointer& pointer) { move(pointer); }

void TurnViewGesture::cancel() {
  if (moved_) models_.document.push(std::make_unique<SetView>(models_.document, start_, gesture_));
}

QString TurnViewGesture::status() const {
  return start_.distance ? Gesture::tr(
                               "Moving the viewer. Shift: steps of 15°. Ctrl: same distance. Esc: "
                               "take it back.")
                         : Gesture::tr("Turning the view. Shift: steps of 15°. Esc: take it back.");
}

void TurnViewGesture::paint(QPainter& painter) const {
  const View& view = models_.document.scene().view;
  QString text = Gesture::tr("%1°").arg(view.angleDeg, 0, 'f', 1);
  if (view.distance) text += Gesture::tr("   distance %1").arg(*view.distance, 0, 'g', 6);
  const QPointF handle = handlePlace(models_, canvas_).at;
  paintLabel(painter, handle, text);
}

PanGesture::PanGesture(const CanvasModels& models, const Pointer& pressed)
    : models_(models), last_(pressed.at) {}

void PanGesture::move(const Pointer& pointer) {
  const QPointF step = pointer.at - last_;
  last_ = pointer.at;
  total_ += step;
  models_.viewport.panBy(step);
}

void PanGesture::cancel() { models_.viewport.panBy(-total_); }

QString PanGesture::status() const {
  return Gesture::tr("Moving the picture. F: fit it into the window.");
}

std::unique_ptr<Gesture> beginPan(const CanvasModels& models, const Pointer& pressed) {
  return std::make_unique<PanGesture>(models, pressed);
}

}  // namespace flatland::ui
