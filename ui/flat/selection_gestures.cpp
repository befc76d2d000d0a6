// SPDX-License-Identifier: GPL-3.0-or-later
#include <QGuiApplication>
#include <QLineF>
#include <QPainter>
#include <QPalette>
#include <QRectF>

#include "ui/flat/gestures.h"

namespace flatland::ui {

RubberBandGesture::RubberBandGesture(const CanvasModels& models, const Pointer& pressed)
    : models_(models),
      before_(models.selection.points()),
      adding_(pressed.modifiers.testFlag(Qt::ShiftModifier)),
      pressed_(pressed.at),
      now_(pressed.at) {}

void RubberBandGesture::move(const Pointer& pointer) {
  now_ = pointer.at;
  if (state_ == State::Pressed && QLineF(pressed_, now_).length() < kDragThresholdPx) return;
  state_ = State::Banding;
  const QRectF band = QRectF(pressed_, now_).normalized();
  std::set<PointRef> inside = adding_ ? before_ : std::set<PointRef>();
  const auto& curves = models_.document.scene().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = controlPoints(curves[c].shape);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (band.contains(models_.viewport.toWidget(points[i]))) inside.insert({c, i});
    }
  }
  models_.selection.setPoints(std::move(inside));
}

void RubberBandGesture::finish(const Pointer& pointer) {
  move(pointer);
  if (state_ == State::Pressed && !adding_) models_.selection.clear();
}

void RubberBandGesture::cancel() { models_.selection.setPoints(before_); }

QString RubberBandGesture::status() const {
  return Gesture::tr("%n points selected. Shift: add to the selection. Esc: take it back.", nullptr,
                     static_cast<int>(models_.selection.points().size()));
}

void RubberBandGesture::paint(QPainter& painter) const {
  if (state_ != State::Banding) return;
  const QColor highlight = QGuiApplication::palette().color(QPalette::Highlight);
  QColor fill = highlight;
  fill.setAlpha(40);
  painter.setPen(QPen(highlight, 1.0, Qt::DashLine));
  painter.setBrush(fill);
  painter.drawRect(QRectF(pressed_, now_).normalized());
}

PickMarkGesture::PickMarkGesture(const CanvasModels& models, std::size_t mark)
    : models_(models), before_(models.selection.mark()) {
  models_.selection.setMark(keyOf(models.document.features(), mark));
}

void PickMarkGesture::cancel() { models_.selection.setMark(before_); }

QString PickMarkGesture::status() const {
  return Gesture::tr(
      "Marks follow from the curve and the view; the table tells this one's values.");
}

}  // namespace flatland::ui
