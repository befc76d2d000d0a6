// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/pane_marks.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <cmath>

#include "ui/export/figure_qt.h"
#include "ui/view3d/surface_overlay.h"

namespace flatland::ui {

namespace {

struct PaneMarkWords {
  Q_DECLARE_TR_FUNCTIONS(PaneMarks)
};

constexpr double kBehindText = 0.72;  ///< opacity of the ground below words, as in the overlay
constexpr int kSamplePx = 18;         ///< of a line in the legend
constexpr QSize kBar(220, 14);        ///< of a colour map
constexpr int kTickPx = 3;
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

QString percent(double share) { return QLocale().toString(100.0 * share, 'f', 1); }

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
  const QString share =
      ink->reached ? PaneMarkWords::tr("Ink %1 %").arg(percent(ink->share))
                   : PaneMarkWords::tr("Ink %1 % of %2 %").arg(percent(ink->share), percent(asked));
  QStringList lines{share, PaneMarkWords::tr("Thresholds × %1").arg(factor)};
  if (models.views.ink().isStale()) lines.back() += QStringLiteral(" …");
  return lines;
}

QStringList differenceLines(const SurfacePicture& picture) {
  if (!picture.pane.difference || !picture.seen || !picture.seen->difference) return {};
  const SeenDifference& difference = *picture.seen->difference;
  return {PaneMarkWords::tr("In both, within a mean edge"),
          PaneMarkWords::tr("Only here: %1 % of these").arg(percent(difference.addedShare)),
          PaneMarkWords::tr("Missing: %1 % of the first").arg(percent(difference.missingShare))};
}

namespace {

/// Of a legend: two digits, and powers of ten as a hand writes them.
QString shortNumber(double value) {
  const double size = std::abs(value);
  if (size == 0.0 || (size >= 1e-3 && size < 1e5)) {
    const QString text =
        size < 100.0 ? QLocale().toString(size, 'g', 2) : QLocale().toString(size, 'f', 0);
    return value < 0.0 ? QChar(0x2212) + text : text;
  }
  const int exponent = static_cast<int>(std::floor(std::log10(size)));
  QString power;
  for (const QChar c : QString::number(exponent)) {
    power += c == '-' ? QChar(0x207B) : QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹")[c.digitValue()];
  }
  const QString sign = value < 0.0 ? QString(QChar(0x2212)) : QString();
  return sign + QStringLiteral("%1·10%2").arg(
                    QLocale().toString(size / std::pow(10.0, exponent), 'g', 2), power);
}

QStringList legendWords(const ColourScale& scale) {
  QStringList words{quantityWords(scale.quantity)};
  if (scale.knee > 0.0) {
    words << SurfaceOverlay::tr("linear to ±%1, then logarithmic").arg(shortNumber(scale.knee));
  } else if (scale.logarithmic) {
    words << SurfaceOverlay::tr("logarithmic");
  }
  return words;
}

/// The bar of a colour map with its ends.
int paintBar(QPainter& painter, const QRect& bounds, const SurfacePicture& picture) {
  const VertexColours* map = picture.surface ? picture.colours() : nullptr;
  if (!map) return 0;
  const ColourScale& scale = map->scale;
  const int line = painter.fontMetrics().height();
  const QSize bar = kBar * picture.lineScale;
  const QRect box(bounds.right() + 1 - bar.width(), bounds.bottom() + 1 - line - bar.height(),
                  bar.width(), bar.height());
  QColor ground = painter.background().color();
  ground.setAlphaF(static_cast<float>(kBehindText));
  const QStringList title = legendWords(scale);
  int width = bar.width();
  for (const QString& words : title) {
    width = std::max(width, painter.fontMetrics().horizontalAdvance(words));
  }
  const int height = line * static_cast<int>(title.size());
  const QRect name(bounds.right() + 1 - width, box.top() - height - 2, width, height);
  painter.fillRect(name.adjusted(-4, -2, 4, 2), ground);
  painter.drawText(name, Qt::AlignRight | Qt::AlignVCenter, title.join('\n'));
  for (int x = 0; x < box.width(); ++x) {
    const Rgb c = scale.at((x + 0.5) / box.width(), picture.palette);
    painter.fillRect(box.left() + x, box.top(), 1, box.height(), toQColor(c));
  }
  painter.drawRect(box.adjusted(0, 0, -1, -1));
  for (const double tick : scale.ticks()) {
    const int x = box.left() + qRound(scale.share(tick) * (box.width() - 1));
    painter.drawLine(x, box.bottom() - kTickPx, x, box.bottom());
  }
  const auto end = [&scale](double value) {
    return shortNumber(scale.logarithmic ? std::pow(10.0, value) : value);
  };
  const QRect words(box.left(), box.bottom() + 1, box.width(), line);
  painter.fillRect(words, ground);
  painter.drawText(words, Qt::AlignLeft, end(scale.low));
  if (scale.diverging) painter.drawText(words, Qt::AlignHCenter, scale.logarithmic ? "1" : "0");
  painter.drawText(words, Qt::AlignRight, end(scale.high));
  return bounds.bottom() - name.top() + 6;
}

/// The colours of a difference, each with its share.
int paintShares(QPainter& painter, const QRect& bounds, const SurfacePicture& picture) {
  const QStringList lines = differenceLines(picture);
  if (lines.isEmpty()) return 0;
  const QFontMetrics metrics = painter.fontMetrics();
  int width = 0;
  for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
  const int height = metrics.height(), gap = 6;
  QRect box(0, 0, width + kSamplePx + gap, height * static_cast<int>(lines.size()));
  box.moveBottomRight(bounds.bottomRight());
  QColor ground = painter.background().color();
  ground.setAlphaF(static_cast<float>(kBehindText));
  painter.fillRect(box.adjusted(-4, -2, 4, 2), ground);
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const int top = box.top() + static_cast<int>(i) * height;
    const Rgb c = differenceColour(static_cast<std::size_t>(i), picture.palette);
    painter.fillRect(box.left(), top + height / 2 - 1, kSamplePx, 3, toQColor(c));
    painter.drawText(QRect(box.left() + kSamplePx + gap, top, width, height), Qt::AlignLeft,
                     lines[i]);
  }
  return box.height() + gap;
}

}  // namespace

int paintLegend(QPainter& painter, const QRect& bounds, const SurfacePicture& picture) {
  const int taken = paintBar(painter, bounds, picture);
  return taken + paintShares(painter, bounds.adjusted(0, 0, 0, -taken), picture);
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
