// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/mark_painting.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/export/figure_qt.h"
#include "ui/model/theme.h"

namespace flatland::ui {

namespace {

constexpr double kCrossPx = 5.0;

}  // namespace

void paintShape(QPainter& painter, const PathShape& shape) {
  painter.setPen(shape.stroke ? QPen(toQColor(shape.stroke->colour), shape.stroke->width)
                              : QPen(Qt::NoPen));
  painter.setBrush(shape.fill ? QBrush(toQColor(*shape.fill)) : QBrush(Qt::NoBrush));
  painter.drawPath(toPainterPath(shape.path));
}

void paintCrossing(QPainter& painter, const QPointF& at, int number, double scale, bool hidden) {
  const Palette palette = themePalette();
  const MarkStyle& style = styleOf(MarkKind::ApparentRidge, palette);
  const Rgb background = sceneColours(palette).background;
  const QColor colour =
      toQColor(hidden ? paler(style.letterColour, background) : style.letterColour);
  const double r = kCrossPx * scale;
  for (const bool halo : {true, false}) {
    painter.setPen(QPen(halo ? toQColor(background) : colour, (halo ? 5.0 : 2.2) * scale,
                        Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
    painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
  }
  const QString text = QString::number(number);
  QPainterPath letters;
  letters.addText(at + QPointF(1.6 * r, -1.2 * r), painter.font(), text);
  painter.strokePath(letters, QPen(toQColor(background), 3.0 * scale));
  painter.fillPath(letters, colour);
}

}  // namespace flatland::ui
