// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/mark_painting.h"

#include <QPainter>
#include <QPainterPath>

#include "ui/export/figure_qt.h"
#include "ui/model/theme.h"

namespace flatland::ui {

namespace {

constexpr double kCrossPx = 5.0;
constexpr double kCrossWidthPx = 2.2, kHaloWidthPx = 5.0;
constexpr double kRingPx = 11.0, kRingWidthPx = 2.4, kRingHaloPx = 5.6;
constexpr double kNumberPx = 12.0;  ///< of the type in files

Rgb crossingColour(bool hidden, Palette palette) {
  const Rgb colour = styleOf(MarkKind::ApparentRidge, palette).letterColour;
  return hidden ? paler(colour, sceneColours(palette).background) : colour;
}

}  // namespace

void paintShape(QPainter& painter, const PathShape& shape) {
  painter.setPen(shape.stroke ? QPen(toQColor(shape.stroke->colour), shape.stroke->width)
                              : QPen(Qt::NoPen));
  painter.setBrush(shape.fill ? QBrush(toQColor(*shape.fill)) : QBrush(Qt::NoBrush));
  painter.drawPath(toPainterPath(shape.path));
}

void paintCrossing(QPainter& painter, const QPointF& at, int number, double scale, bool hidden,
                   Palette palette) {
  const Rgb background = sceneColours(palette).background;
  const QColor colour = toQColor(crossingColour(hidden, palette));
  const double r = kCrossPx * scale;
  for (const bool halo : {true, false}) {
    painter.setPen(QPen(halo ? toQColor(background) : colour,
                        (halo ? kHaloWidthPx : kCrossWidthPx) * scale, Qt::SolidLine,
                        Qt::RoundCap));
    painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
    painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
  }
  const QString text = QString::number(number);
  QPainterPath letters;
  letters.addText(at + QPointF(1.6 * r, -1.2 * r), painter.font(), text);
  painter.strokePath(letters, QPen(toQColor(background), 3.0 * scale));
  painter.fillPath(letters, colour);
}

void paintChosen(QPainter& painter, const QPointF& at, double scale) {
  const SceneColours colours = sceneColours(themePalette());
  painter.setBrush(Qt::NoBrush);
  for (const bool halo : {true, false}) {
    painter.setPen(QPen(toQColor(halo ? colours.background : colours.text),
                        (halo ? kRingHaloPx : kRingWidthPx) * scale));
    painter.drawEllipse(at, kRingPx * scale, kRingPx * scale);
  }
}

std::vector<Shape> crossingShapes(const Vec2& at, int number, double scale, bool hidden,
                                  Palette palette) {
  const Rgb colour = crossingColour(hidden, palette);
  const double r = kCrossPx * scale;
  PathData cross;
  cross.moveTo(at + Vec2(-r, -r));
  cross.lineTo(at + Vec2(r, r));
  cross.moveTo(at + Vec2(-r, r));
  cross.lineTo(at + Vec2(r, -r));
  std::vector<Shape> shapes;
  for (const bool halo : {true, false}) {
    shapes.emplace_back(PathShape{cross, std::nullopt,
                                  Stroke{.colour = halo ? sceneColours(palette).background : colour,
                                         .width = (halo ? kHaloWidthPx : kCrossWidthPx) * scale,
                                         .roundCaps = true}});
  }
  shapes.emplace_back(TextShape{.position = at + Vec2(1.6 * r, -1.8 * r),
                                .text = std::to_string(number),
                                .size = kNumberPx * scale,
                                .colour = colour,
                                .anchor = TextShape::Anchor::Start});
  return shapes;
}

}  // namespace flatland::ui
