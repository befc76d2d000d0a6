// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flat/gesture.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "ui/flat/gestures.h"
#include "ui/model/mark_words.h"

namespace flatland::ui {

namespace {

std::unique_ptr<Gesture> pressPoint(const CanvasModels& models, const PointRef& point,
                                    const Pointer& pressed) {
  const std::set<PointRef>& selected = models.selection.points();
  MovePointsGesture::Plan plan;
  plan.anchor = controlPoints(models.document.scene().curves[point.curve].shape)[point.point];
  const bool adding = pressed.modifiers.testFlag(Qt::ShiftModifier);
  plan.moving = adding || selected.contains(point) ? selected : std::set<PointRef>();
  plan.moving.insert(point);
  plan.selected = plan.moving;
  plan.clicked = adding ? plan.moving : std::set<PointRef>{point};
  if (adding && selected.contains(point)) plan.clicked.erase(point);
  return std::make_unique<MovePointsGesture>(models, std::move(plan), pressed);
}

std::unique_ptr<Gesture> pressCurve(const CanvasModels& models, const Target& target,
                                    const Pointer& pressed) {
  models.selection.setCurrentCurve(target.point.curve);
  const Curve& curve = models.document.scene().curves[target.point.curve].shape;
  MovePointsGesture::Plan plan;
  for (std::size_t i = 0; i < controlPoints(curve).size(); ++i) {
    plan.moving.insert({target.point.curve, i});
  }
  plan.selected = models.selection.points();
  plan.clicked = plan.selected;
  plan.anchor = pointAt(curve, target.t);
  if (plan.moving.empty()) plan.curve = target.point.curve;
  plan.probe = Probe::Place{target.point.curve, target.t};
  return std::make_unique<MovePointsGesture>(models, std::move(plan), pressed);
}

}  // namespace

std::unique_ptr<Gesture> beginGesture(const CanvasModels& models, const Target& target,
                                      const Pointer& pressed, const QSizeF& canvas) {
  switch (target.what) {
    case Target::What::ViewHandle:
      return std::make_unique<TurnViewGesture>(models, pressed, canvas);
    case Target::What::Point:
      return pressPoint(models, target.point, pressed);
    case Target::What::Probe:
      return std::make_unique<ProbeGesture>(models, target, pressed);
    case Target::What::Mark:
      return std::make_unique<PickMarkGesture>(models, target.mark);
    case Target::What::Curve:
      return pressCurve(models, target, pressed);
    case Target::What::Nothing:
      break;
  }
  return std::make_unique<RubberBandGesture>(models, pressed);
}

QString describe(const CanvasModels& models, const Target& target) {
  switch (target.what) {
    case Target::What::ViewHandle:
      return models.document.scene().view.distance
                 ? Gesture::tr(
                       "Drag to move the viewer; Shift steps by 15°, Ctrl keeps the distance.")
                 : Gesture::tr("Drag to turn the view; Shift steps by 15°.");
    case Target::What::Point: {
      const Curve& curve = models.document.scene().curves[target.point.curve].shape;
      const QString at = coordinates(models.viewport, controlPoints(curve)[target.point.point]);
      return Gesture::tr("Point %1 at (%2): drag to move it, Delete removes it.")
          .arg(target.point.point)
          .arg(at);
    }
    case Target::What::Probe:
      return Gesture::tr(
                 "Probe at t = %1: drag to slide it along the curve; M goes to the next mark.")
          .arg(models.probe.place()->t, 0, 'f', 4);
    case Target::What::Mark: {
      const Mark& mark = models.document.features().marks[target.mark];
      return Gesture::tr("%1 at t = %2%3: click to find it in the table.")
          .arg(nameForPeople(mark.kind))
          .arg(mark.t, 0, 'f', 4)
          .arg(mark.visible ? QString() : Gesture::tr(", hidden from the screen"));
    }
    case Target::What::Curve:
      return Gesture::tr(
          "Click to put the probe here, double-click to insert a point; drag to move the curve.");
    case Target::What::Nothing:
      break;
  }
  return Gesture::tr(
      "Drag a point to bend the curve, or the eye to turn the view. H shows all keys.");
}

QString coordinates(const Viewport& viewport, const Vec2& point) {
  // Clamped before the cast, for any zoom.
  const int decimals =
      static_cast<int>(std::clamp(std::ceil(std::log10(viewport.scale())) + 1.0, 0.0, 12.0));
  return QStringLiteral("%1, %2").arg(point.x(), 0, 'f', decimals).arg(point.y(), 0, 'f', decimals);
}

void paintLabel(QPainter& painter, const QPointF& at, const QString& text) {
  constexpr double kGap = 14.0;
  constexpr double kPadding = 4.0;
  const QPalette palette = QGuiApplication::palette();
  const QFontMetricsF metrics(painter.font());
  QRectF box(QPointF(), QSizeF(metrics.horizontalAdvance(text), metrics.height()));
  box.adjust(-kPadding, -kPadding / 2, kPadding, kPadding / 2);
  box.moveBottomLeft(at + QPointF(kGap, -kGap));
  const QRectF room = painter.viewport();
  if (box.right() > room.right() - kPadding) box.moveRight(at.x() - kGap);
  if (box.top() < room.top() + kPadding) box.moveTop(at.y() + kGap);
  painter.setPen(QPen(palette.color(QPalette::ToolTipText), 1.0));
  painter.setBrush(palette.color(QPalette::ToolTipBase));
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace flatland::ui
