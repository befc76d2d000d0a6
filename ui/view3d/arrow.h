// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <cmath>

namespace flatland::ui {

/// An arrow from one point to another with an open head; nothing if they are the same.
inline void paintArrow(QPainter& painter, const QPointF& from, const QPointF& to, const QPen& pen,
                       double uiScale) {
  const QPointF along = to - from;
  const double length = std::hypot(along.x(), along.y());
  if (!(length > 0.0)) return;
  const double head = std::min(9.0 * uiScale, 0.5 * length);
  const QPointF back = head / length * along, across(-0.5 * back.y(), 0.5 * back.x());
  painter.setPen(pen);
  painter.drawLine(from, to);
  QPen solid = pen;
  solid.setStyle(Qt::SolidLine);
  painter.setPen(solid);
  painter.drawPolyline(QPolygonF{to - back + across, to, to - back - across});
}

}  // namespace flatland::ui
