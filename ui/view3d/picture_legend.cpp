// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/picture_legend.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <cmath>

#include "ui/export/figure_qt.h"
#include "ui/view3d/surface_overlay.h"

namespace flatland::ui {

namespace {

struct LegendWords {
  Q_DECLARE_TR_FUNCTIONS(PictureLegend)
};

constexpr int kSamplePx = 18;   ///< of a line
constexpr QSize kBar(220, 14);  ///< of a colour map
constexpr int kTickPx = 3;

}  // namespace

QString percentWords(double share) { return QLocale().toString(100.0 * share, 'f', 1); }

QStringList differenceLines(const SurfacePicture& picture) {
  if (!picture.pane.difference || !picture.seen || !picture.seen->difference) return {};
  const SeenDifference& difference = *picture.seen->difference;
  return {LegendWords::tr("In both, within a mean edge"),
          LegendWords::tr("Only here: %1 % of these").arg(percentWords(difference.addedShare)),
          LegendWords::tr("Missing: %1 % of the first").arg(percentWords(difference.missingShare))};
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
    words << LegendWords::tr("linear to ±%1, then logarithmic").arg(shortNumber(scale.knee));
  } else if (scale.logarithmic) {
    words << LegendWords::tr("logarithmic");
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

}  // namespace flatland::ui
