// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/pick_marks.h"

#include <QPainter>

namespace flatland::ui {

namespace {

constexpr double kRingPx = 5.0;

}  // namespace

void paintPick(QPainter& painter, const SurfaceModels& models, const Projection& projection) {
  const auto& hit = models.pick.hit();
  if (!hit) return;
  const auto at = projection.toScreen(hit->at);
  if (!at) return;
  const double radius = kRingPx * models.display.uiScale();
  const QPointF middle(at->x(), at->y());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QColor ink = painter.pen().color();
  painter.setPen(QPen(painter.background().color(), 4.0));
  painter.drawEllipse(middle, radius, radius);
  painter.setPen(QPen(ink, 2.0));
  painter.drawEllipse(middle, radius, radius);
  painter.restore();
}

}  // namespace flatland::ui
