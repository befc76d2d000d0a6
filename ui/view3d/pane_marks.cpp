// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/pane_marks.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <cmath>

#include "ui/model/theme.h"
#include "ui/view3d/picture_legend.h"

namespace flatland::ui {

namespace {

struct PaneMarkWords {
  Q_DECLARE_TR_FUNCTIONS(PaneMarks)
};

// The eye stands so many radii from the middle of the surface, or nearer if that is outside the
// picture; its arrow ends at this share of the way out.
constexpr double kEyeRadii = 1.35, kTipShare = 0.8;
constexpr double kRimPx = 14.0;  ///< around the eye to the edge of the picture
constexpr double kEyePx = 5.0, kHeadPx = 8.0;

/// How far one can go from a place and stay in the room: at most 1; 0 if the place is outside.
double shareWithin(const QRectF& room, const QPointF& from, const QPointF& by) {
  if (!room.contains(from)) return 0.0;
  double share = 1.0;
  if (by.x() > 0.0) share = std::min(share, (room.right() - from.x()) / by.x());
  if (by.x() < 0.0) share = std::min(share, (room.left() - from.x()) / by.x());
  if (by.y() > 0.0) share = std::min(share, (room.bottom() - from.y()) / by.y());
  if (by.y() < 0.0) share = std::min(share, (room.top() - from.y()) / by.y());
  return share;
}

}  // namespace

QString seenByWords(const std::optional<SurfaceSetting>& setting) {
  return setting && camerasDiffer(*setting) ? PaneMarkWords::tr("As view 1 sees it:") : QString();
}

QStringList inkLines(const SurfaceModels& models) {
  if (!models.there() || !models.document.scene().surface->ink) return {};
  const PaneInk* ink = models.views.ink().of(models.pane);
  if (!ink) return {PaneMarkWords::tr("Solving for ink")};
  const QString factor = QLocale().toString(ink->factor, 'g', 3);
  // Where it cannot be reached, both numbers stand there.
  const double asked = *models.document.scene().surface->ink;
  const QString share = ink->reached ? PaneMarkWords::tr("Ink %1 %").arg(percentWords(ink->share))
                                     : PaneMarkWords::tr("Ink %1 % of %2 %")
                                           .arg(percentWords(ink->share), percentWords(asked));
  QStringList lines{share, PaneMarkWords::tr("Thresholds × %1").arg(factor)};
  if (models.views.ink().isStale()) lines.back() += QStringLiteral(" …");
  return lines;
}

void paintFirstCamera(QPainter& painter, const SurfaceModels& models,
                      const Projection& projection) {
  if (!models.there() || !models.setting().ownCamera || !models.source.surface()) return;
  const SurfaceCamera& first = models.document.scene().surface->camera;
  const double radius = models.source.surface()->ballRadius;
  const auto middle = projection.toScreen(first.centre);
  const auto eye = projection.toScreen(first.centre + kEyeRadii * radius * first.towards);
  if (!middle || !eye) return;
  const double scale = models.display.uiScale();
  const QRectF room =
      QRectF(0.0, 0.0, projection.width, projection.height)
          .adjusted(kRimPx * scale, kRimPx * scale, -kRimPx * scale, -kRimPx * scale);
  const QPointF centre(middle->x(), middle->y());
  QPointF away = QPointF(eye->x(), eye->y()) - centre;
  away *= shareWithin(room, centre, away);
  const QPointF from = centre + away, to = centre + kTipShare * away;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ink = painter.pen().color();
  const QColor ground = painter.background().color();
  if (first.towards.dot(Eigen::Vector3d(projection.axes.row(2))) < 0.0) ink.setAlphaF(0.5f);
  const QPointF along = to - from;
  const double length = std::hypot(along.x(), along.y());
  if (length > 2.0 * kEyePx * scale) {
    const QPointF unit = along / length, side(-unit.y(), unit.x());
    const QPointF back = to - kHeadPx * scale * unit;
    const QPolygonF head{to, back + 0.5 * kHeadPx * scale * side,
                         back - 0.5 * kHeadPx * scale * side};
    painter.setPen(QPen(ink, 2.0 * scale));
    painter.drawLine(from, back);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawPolygon(head);
  }
  painter.setPen(QPen(ink, 1.5 * scale));
  painter.setBrush(ground);
  painter.drawEllipse(from, 1.6 * kEyePx * scale, kEyePx * scale);
  painter.setBrush(ink);
  painter.drawEllipse(from, 0.45 * kEyePx * scale, 0.45 * kEyePx * scale);
  painter.restore();
}

}  // namespace flatland::ui
