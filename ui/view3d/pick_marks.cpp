// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/pick_marks.h"

#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <limits>
#include <vector>

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
constexpr double kNameAsidePx = 14.0, kNameGroundPx = 4.0;

/// What is drawn with: the ground below makes ink readable on any picture.
struct Pens {
  QColor ink, ground;
  double scale;
};

/// A name beside an arrow, at this share of its length.
struct ArrowName {
  QString text;
  QColor ink;
  QPointF from, along;
  double place;
};

void paintNamedArrow(QPainter& painter, const QPointF& from, const QPointF& to, const Pens& pens,
                     double width, double place, const QString& name,
                     std::vector<ArrowName>& names) {
  if (from == to) return;
  paintArrow(painter, from, to, QPen(pens.ground, (width + 2.0) * pens.scale), pens.scale);
  paintArrow(painter, from, to, QPen(pens.ink, width * pens.scale), pens.scale);
  names.push_back({name, pens.ink, from, to - from, place});
}

/// Each on that side of its arrow where the names before it are farther away: arrows may lie on
/// each other. Above all arrows, on a ground that makes them readable.
void paintNames(QPainter& painter, const std::vector<ArrowName>& names, const Pens& pens) {
  std::vector<QPointF> taken;
  const QFontMetricsF metrics(painter.font());
  for (const ArrowName& name : names) {
    const double length = std::hypot(name.along.x(), name.along.y());
    const QPointF aside =
        kNameAsidePx * pens.scale / length * QPointF(name.along.y(), -name.along.x());
    const QPointF beside = name.from + name.place * name.along;
    const auto room = [&taken](const QPointF& p) {
      double least = std::numeric_limits<double>::infinity();
      for (const QPointF& q : taken)
        least = std::min(least, std::hypot(p.x() - q.x(), p.y() - q.y()));
      return least;
    };
    const QPointF middle =
        room(beside + aside) >= room(beside - aside) ? beside + aside : beside - aside;
    taken.push_back(middle);
    QPainterPath letters;
    letters.addText(middle.x() - 0.5 * metrics.horizontalAdvance(name.text),
                    middle.y() + 0.5 * (metrics.ascent() - metrics.descent()), painter.font(),
                    name.text);
    painter.strokePath(letters, QPen(pens.ground, kNameGroundPx * pens.scale, Qt::SolidLine,
                                     Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(letters, name.ink);
  }
}

/// Principal directions on the surface, and t_A, which is a direction on the screen of view 0. From
/// elsewhere that is no direction of the picture: there it is r, the one on the surface that t_A is
/// the picture of.
void paintDirections(QPainter& painter, const SurfaceModels& models, const Projection& projection,
                     const Eigen::Vector3d& at, const QPointF& middle, const Pens& pens) {
  const auto& place = models.study.place();
  if (!place) return;
  std::vector<ArrowName> names;
  const double length = kArrowShare * models.pick.surface()->fields->size;
  const auto paintOnSurface = [&](const Eigen::Vector3d& along, const Pens& with, double width,
                                  double label, const char* name) {
    if (const auto px = projection.toScreen(at + length * along)) {
      paintNamedArrow(painter, middle, {px->x(), px->y()}, with, width, label,
                      QString::fromUtf8(name), names);
    }
  };
  paintOnSurface(place->point.frame.col(0), pens, 1.5, 1.0, "t₁");
  paintOnSurface(place->point.frame.col(1), pens, 1.5, 1.0, "t₂");
  const SurfaceMatrices matrices = surfaceMatrices(*place);
  if (matrices.seen && !matrices.tA.isZero()) {
    const MarkStyle& style = styleOf(MarkKind::ApparentRidge, themePalette());
    Pens orange = pens;
    orange.ink = toQColor(style.colour);
    if (models.setting().ownCamera) {
      const Eigen::Vector3d r = place->point.frame * matrices.seen->r;
      paintOnSurface(r.normalized(), orange, 2.5, 0.5, "r");
    } else {
      const QPointF tA = kArrowPx * pens.scale * QPointF(matrices.tA.x(), -matrices.tA.y());
      paintNamedArrow(painter, middle, middle + tA, orange, 2.5, 0.5, QStringLiteral("t_A"), names);
    }
    if (!names.empty() && names.back().ink == orange.ink)
      names.back().ink = toQColor(style.letterColour);
  }
  paintNames(painter, names, pens);
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
