// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/pick_marks.h"

#include <QPainter>

#include "core3d/study/surface_derivation.h"
#include "ui/export/figure_qt.h"
#include "ui/export/mark_style.h"
#include "ui/model/theme.h"
#include "ui/view3d/arrow.h"

namespace flatland::ui {

namespace {

constexpr double kRingPx = 5.0;
constexpr double kArrowShare = 0.22;  ///< of the surface's size: a direction on the surface
constexpr double kArrowPx = 46.0;     ///< of a direction on the screen

/// What is drawn with: the ground below makes ink readable on any picture.
struct Pens {
  QColor ink, ground;
  double scale;
};

/// The name stands beside the arrow at this share of its length.
void paintNamedArrow(QPainter& painter, const QPointF& from, const QPointF& to, const Pens& pens,
                     double width, double place, const QString& name) {
  if (from == to) return;
  paintArrow(painter, from, to, QPen(pens.ground, (width + 2.0) * pens.scale), pens.scale);
  paintArrow(painter, from, to, QPen(pens.ink, width * pens.scale), pens.scale);
  // Beside the arrow and not at its tip, where two that lie on each other would share the room.
  const QPointF along = to - from;
  const double length = std::hypot(along.x(), along.y());
  const QPointF middle =
      from + place * along + 13.0 * pens.scale / length * QPointF(along.y(), -along.x());
  painter.drawText(QRectF(middle.x() - 20.0, middle.y() - 12.0, 40.0, 24.0), Qt::AlignCenter, name);
}

/// Principal directions on the surface, and t_A, which is a direction on the screen of view 0. From
/// elsewhere that is no direction of the picture: there it is r, the one on the surface that t_A is
/// the picture of.
void paintDirections(QPainter& painter, const SurfaceModels& models, const Projection& projection,
                     const Eigen::Vector3d& at, const QPointF& middle, const Pens& pens) {
  const auto& place = models.study.place();
  if (!place) return;
  const double length = kArrowShare * models.pick.surface()->fields->size;
  const auto paintOnSurface = [&](const Eigen::Vector3d& along, const Pens& with, double width,
                                  double label, const char* name) {
    if (const auto px = projection.toScreen(at + length * along)) {
      paintNamedArrow(painter, middle, {px->x(), px->y()}, with, width, label,
                      QString::fromUtf8(name));
    }
  };
  paintOnSurface(place->point.frame.col(0), pens, 1.5, 1.0, "t₁");
  paintOnSurface(place->point.frame.col(1), pens, 1.5, 1.0, "t₂");
  const SurfaceMatrices matrices = surfaceMatrices(*place);
  if (!matrices.seen || matrices.tA.isZero()) return;
  Pens orange = pens;
  orange.ink = toQColor(styleOf(MarkKind::ApparentRidge, themePalette()).colour);
  if (models.setting().ownCamera) {
    const Eigen::Vector3d r = place->point.frame * matrices.seen->r;
    return paintOnSurface(r.normalized(), orange, 2.5, 0.5, "r");
  }
  const QPointF tA = kArrowPx * pens.scale * QPointF(matrices.tA.x(), -matrices.tA.y());
  paintNamedArrow(painter, middle, middle + tA, orange, 2.5, 0.5, QStringLiteral("t_A"));
}

}  // namespace

void paintPick(QPainter& painter, const SurfaceModels& models, const Projection& projection) {
  const auto& hit = models.pick.hit();
  if (!hit) return;
  const auto px = projection.toScreen(hit->at);
  if (!px) return;
  const Pens pens{painter.pen().color(), painter.background().color(), models.display.uiScale()};
  const QPointF middle(px->x(), px->y());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  paintDirections(painter, models, projection, hit->at, middle, pens);
  const double radius = kRingPx * pens.scale;
  painter.setPen(QPen(pens.ground, 4.0 * pens.scale));
  painter.drawEllipse(middle, radius, radius);
  painter.setPen(QPen(pens.ink, 2.0 * pens.scale));
  painter.drawEllipse(middle, radius, radius);
  painter.restore();
}

}  // namespace flatland::ui
