// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLineF>
#include <QPainter>

#include "ui/flat/gestures.h"
#include "ui/flat/probe_overlay.h"

namespace flatland::ui {

ProbeGesture::ProbeGesture(const CanvasModels& models, const Target& target, const Pointer& pressed)
    : models_(models), before_(models.probe.place()), mark_(target.below), pressed_(pressed.at) {}

void ProbeGesture::move(const Pointer& pointer) {
  if (!moved_ && QLineF(pressed_, pointer.at).length() < kDragThresholdPx) return;
  moved_ = true;
  if (!before_) return;
  const auto& curves = models_.document.scene().curves;
  if (before_->curve >= curves.size()) return;
  const Vec2 world = models_.viewport.toWorld(pointer.at);
  models_.probe.setPlace(
      Probe::Place{before_->curve, nearestPoint(curves[before_->curve].shape, world).t});
}

void ProbeGesture::finish(const Pointer& pointer) {
  move(pointer);
  // A click goes through to the mark that the probe covers.
  if (!moved_ && mark_) models_.selection.setMark(keyOf(models_.document.features(), *mark_));
}

void ProbeGesture::cancel() { models_.probe.setPlace(before_); }

QString ProbeGesture::status() const {
  return Gesture::tr("Sliding the probe along the curve. Esc: take it back.");
}

void ProbeGesture::paint(QPainter& painter) const {
  const auto& place = models_.probe.place();
  const auto at = probeOnCanvas(models_);
  if (moved_ && at) paintLabel(painter, *at, QStringLiteral("t = %1").arg(place->t, 0, 'f', 4));
}

}  // namespace flatland::ui
