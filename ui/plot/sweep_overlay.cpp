// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/sweep_overlay.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "ui/export/figure_qt.h"
#include "ui/model/theme.h"

namespace flatland::ui {

namespace {

struct SweepWords {
  Q_DECLARE_TR_FUNCTIONS(SweepWords)
};

}  // namespace

void paintSweepOverlay(QPainter& painter, const CanvasModels& models, const SweepData& shown,
                       const SweepAxes& axes, const SweepHover& hover) {
  const SceneColours& colours = sceneColours(themePalette());
  const SweepAxes::Box& box = axes.box();
  painter.save();
  painter.setClipRect(
      QRectF(QPointF(box.left - 1, box.top - 1), QPointF(box.right + 1, box.bottom + 1)));
  const double x = axes.x(normalizedDeg(models.document.scene().view.angleDeg));
  painter.setPen(QPen(toQColor(colours.screen), 2.0, Qt::DashLine));
  painter.drawLine(QPointF(x, box.top), QPointF(x, box.bottom));
  const auto& place = models.probe.place();
  // A probe on the new curve has no place on the axis of an earlier one.
  if (place && place->curve < shown.scene.curves.size() &&
      shown.scene.curves[place->curve] == models.document.scene().curves[place->curve]) {
    const int curve = static_cast<int>(place->curve);
    const double y = axes.y(curve, shown.lengthAt(curve, place->t));
    painter.setPen(QPen(toQColor(colours.text), 1.2, Qt::DotLine));
    painter.drawLine(QPointF(box.left, y), QPointF(box.right, y));
    painter.setBrush(toQColor(colours.background));
    painter.setPen(QPen(toQColor(colours.text), 1.6));
    painter.drawEllipse(QPointF(x, y), 3.5, 3.5);
  }
  painter.restore();
  const QString angle = SweepWords::tr("%1°").arg(models.document.scene().view.angleDeg, 0, 'f', 2);
  const auto label = [&](const QPointF& at, const QString& text) {
    QFont font = painter.font();
    font.setPixelSize(12);
    painter.setFont(font);
    QRectF around = QFontMetricsF(font).boundingRect(text).adjusted(-4, -2, 4, 2);
    around.moveCenter(at);
    const double left = std::max(2.0, std::min(around.left(), hover.width - around.width()));
    around.moveLeft(left);
    painter.setPen(QPen(toQColor(colours.text), 1.0));
    painter.setBrush(toQColor(colours.background));
    painter.drawRoundedRect(around, 3, 3);
    painter.drawText(around, Qt::AlignCenter, text);
  };
  if (x >= box.left - 1 && x <= box.right + 1) label({x, box.top - 11.0}, angle);
  if (hover.fold) {
    const Vec2 at = hover.pointer;
    label({at.x(), at.y() - 18.0},
          SweepWords::tr("born or merged at %1°").arg(hover.fold->angleDeg, 0, 'f', 3));
  }
}

}  // namespace flatland::ui
