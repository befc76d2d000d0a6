// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/picture_legend.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <vector>

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
constexpr int kLegendMargin = 4;  ///< above and below; twice that at the sides

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

/// A number below the bar.
struct Label {
  QString text;
  int left, width;
};

/// Those of the ticks that there is room for, the ends of the scale before all others.
std::vector<Label> labelsOf(const ColourScale& scale, const QFontMetrics& metrics, int barWidth) {
  constexpr int kGapPx = 6;
  std::vector<Label> labels;
  for (const double tick : scale.ticks()) {
    const QString text = shortNumber(scale.logarithmic ? std::pow(10.0, tick) : tick);
    const int width = metrics.horizontalAdvance(text);
    const int middle = qRound(scale.share(tick) * (barWidth - 1));
    const int left = std::clamp(middle - width / 2, 0, std::max(barWidth - width, 0));
    const bool fits = std::none_of(labels.begin(), labels.end(), [left, width](const Label& other) {
      return left < other.left + other.width + kGapPx && other.left < left + width + kGapPx;
    });
    if (fits) labels.push_back({text, left, width});
  }
  return labels;
}

}  // namespace

QStringList legendWords(const ColourScale& scale) {
  QStringList words{quantityWords(scale.quantity)};
  if (scale.knee > 0.0) {
    words << LegendWords::tr("linear to ±%1, then logarithmic").arg(shortNumber(scale.knee));
  } else if (scale.logarithmic) {
    words << LegendWords::tr("logarithmic");
  }
  return words;
}

int colourLegendHeight(const QFontMetrics& metrics, double scale) {
  return std::max(2 * metrics.height(), qRound(kBar.height() * scale) + metrics.height()) +
         2 * kLegendMargin;
}

void paintColourLegend(QPainter& painter, const QRect& bounds, const SurfacePicture& picture) {
  const VertexColours* map = picture.surface ? picture.colours() : nullptr;
  if (!map) return;
  const ColourScale& scale = map->scale;
  const QFontMetrics metrics = painter.fontMetrics();
  const QRect inner = bounds.adjusted(2 * kLegendMargin, kLegendMargin, -2 * kLegendMargin, 0);
  const int width = std::min(qRound(kBar.width() * picture.lineScale), inner.width() * 3 / 5);
  const QRect bar(inner.right() + 1 - width, inner.top(), width,
                  qRound(kBar.height() * picture.lineScale));
  for (int x = 0; x < bar.width(); ++x) {
    const Rgb c = scale.at((x + 0.5) / bar.width(), picture.palette);
    painter.fillRect(bar.left() + x, bar.top(), 1, bar.height(), toQColor(c));
  }
  painter.drawRect(bar.adjusted(0, 0, -1, -1));
  for (const double tick : scale.ticks()) {
    const int x = bar.left() + qRound(scale.share(tick) * (bar.width() - 1));
    painter.drawLine(x, bar.bottom() - kTickPx, x, bar.bottom());
  }
  for (const Label& label : labelsOf(scale, metrics, bar.width())) {
    painter.drawText(
        QRect(bar.left() + label.left, bar.bottom() + 1, label.width, metrics.height()),
        Qt::AlignLeft | Qt::TextDontClip, label.text);
  }
  QStringList words = legendWords(scale);
  const QRect title(inner.left(), inner.top(), bar.left() - inner.left() - 10,
                    metrics.height() * static_cast<int>(words.size()));
  for (QString& line : words) line = metrics.elidedText(line, Qt::ElideRight, title.width());
  painter.drawText(title, Qt::AlignRight | Qt::AlignTop, words.join('\n'));
}

int paintDifferenceLegend(QPainter& painter, const QRect& bounds, const SurfacePicture& picture) {
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

}  // namespace flatland::ui
