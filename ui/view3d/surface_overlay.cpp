// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_overlay.h"

#include <QLocale>
#include <QPainter>
#include <cmath>

#include "ui/export/figure_qt.h"
#include "ui/model/bridge_ticks.h"
#include "ui/model/bridge_words.h"
#include "ui/model/core_words.h"
#include "ui/view3d/bridge_marks.h"
#include "ui/view3d/pane_marks.h"
#include "ui/view3d/pick_marks.h"
#include "ui/view3d/plane_marks.h"
#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

namespace {

constexpr int kMargin = 10;
constexpr double kBehindText = 0.72;  ///< opacity of the ground below words
constexpr QSize kBar(220, 14);
constexpr int kTickPx = 3;
constexpr double kNarrowWidth = 420.0;  ///< that does not hold reading and legend side by side

QString number(double value) { return QLocale().toString(value, 'g', 4); }

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

/// Lines of text on a pale ground, with their corner at `at`; `flags` says which corner.
void paintLines(QPainter& painter, const QRect& bounds, const QStringList& lines, int flags) {
  if (lines.isEmpty()) return;
  const QString text = lines.join('\n');
  const QRect inner = bounds.adjusted(kMargin, kMargin, -kMargin, -kMargin);
  const QRect box = painter.boundingRect(inner, flags, text);
  QColor ground = painter.background().color();
  ground.setAlphaF(static_cast<float>(kBehindText));
  painter.fillRect(box.adjusted(-4, -2, 4, 2), ground);
  painter.drawText(inner, flags, text);
}

}  // namespace

QString quantityWords(SurfaceQuantity quantity) {
  switch (quantity) {
    case SurfaceQuantity::K1:
      return SurfaceOverlay::tr("k₁, largest curvature");
    case SurfaceQuantity::K2:
      return SurfaceOverlay::tr("k₂, smallest curvature");
    case SurfaceQuantity::Lambda:
      return SurfaceOverlay::tr("λ, view-dependent curvature");
    case SurfaceQuantity::Feature:
      return SurfaceOverlay::tr("Feature term");
    case SurfaceQuantity::Offset:
      return SurfaceOverlay::tr("Offset term");
    case SurfaceQuantity::OffsetShare:
      break;
  }
  return SurfaceOverlay::tr("|Offset| / |feature|");
}

namespace {

QStringList legendWords(const ColourScale& scale) {
  QStringList words{quantityWords(scale.quantity)};
  if (scale.knee > 0.0) {
    words << SurfaceOverlay::tr("linear to ±%1, then logarithmic").arg(shortNumber(scale.knee));
  } else if (scale.logarithmic) {
    words << SurfaceOverlay::tr("logarithmic");
  }
  return words;
}

}  // namespace

SurfaceOverlay::SurfaceOverlay(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setObjectName("surface.overlay");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  const auto repaint = qOverload<>(&QWidget::update);
  connect(&models_.source, &SurfaceSource::changed, this, repaint);
  connect(&models_.seen, &SeenSource::changed, this, repaint);
  connect(&models_.display, &Display::changed, this, repaint);
  connect(&models_.pick, &SurfacePick::changed, this, repaint);
  connect(&models_.views.ink(), &InkSource::changed, this, repaint);
  connect(&models_.bridges.source, &BridgeSource::changed, this, repaint);
  connect(&models_.bridges.section, &SectionSource::changed, this, repaint);
  connect(&models_.bridges.grip, &PlaneGrip::changed, this, repaint);
}

void SurfaceOverlay::setFrameMs(double milliseconds) {
  // No update(): the words are painted after the picture below them, with every frame of it. An
  // update would ask for another frame, and so on for ever.
  frameMs_ = milliseconds;
}

void SurfaceOverlay::setReading(const std::optional<SurfaceReading>& reading) {
  if (!reading && !reading_) return;
  reading_ = reading;
  update();
}

QStringList SurfaceOverlay::titleLines() const {
  const auto& surface = models_.source.surface();
  if (!surface) return {};
  const QLocale locale;
  const std::string name = surfaceName(surface->reference);
  return {surface->swept ? coreWords(name) : QString::fromStdString(name),
          tr("%1 triangles").arg(locale.toString(surface->mesh->triangleCount()))};
}

QStringList SurfaceOverlay::timeLines() const {
  if (!models_.source.surface()) return {};
  const QLocale locale;
  const auto milliseconds = [&locale](double ms) {
    return locale.toString(ms, 'f', ms < 10.0 ? 1 : 0);
  };
  QStringList lines{tr("Frame %1 ms").arg(milliseconds(frameMs_))};
  if (const auto& seen = models_.seen.seen()) {
    lines << tr("Lines %1 ms").arg(milliseconds(seen->lineMs));
  }
  return lines + inkLines(models_);
}

QStringList SurfaceOverlay::differenceWords() const { return differenceLines(models_); }
void SurfaceOverlay::setPredicted(const std::optional<std::size_t>& line) {
  if (line == predicted_) return;
  predicted_ = line;
  update();
}

QStringList SurfaceOverlay::predictedLines() const {
  const auto& bridge = models_.bridges.source.view();
  if (!predicted_ || !bridge || *predicted_ >= bridge->limits.size()) return {};
  return predictedWords(*bridge, *predicted_);
}

QStringList SurfaceOverlay::readingLines() const {
  if (!reading_) return predictedLines();
  const Eigen::Vector3d& at = reading_->inFile;
  QStringList lines{
      QStringLiteral("%1, %2, %3").arg(number(at.x()), number(at.y()), number(at.z()))};
  if (const auto& terms = reading_->terms) {
    lines << QStringLiteral("k₁ %1   k₂ %2").arg(number(terms->k1), number(terms->k2));
    lines << QStringLiteral("n·w %1   λ %2")
                 .arg(number(terms->nw), terms->lambda ? number(*terms->lambda) : tr("none"));
    lines << tr("feature %1").arg(number(terms->feature));
    lines << tr("offset %1").arg(number(terms->offset));
    if (models_.there() && models_.camera().perspectiveDeg) {
      lines << tr("perspective %1").arg(number(terms->perspective));
    }
    if (const std::optional<double> share = terms->offsetShare()) {
      lines << tr("|offset| / |feature| %1").arg(number(*share));
    }
  }
  return predictedLines() + lines;
}

void SurfaceOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const SurfacePicture picture = pictureOf(models_);
  const SceneColours& colours = sceneColours(picture.palette);
  painter.setPen(toQColor(colours.text));
  painter.setBackground(toQColor(colours.background));
  if (picture.surface) {
    const Projection projection =
        orbitProjection(picture.setting.camera, picture.surface->ballRadius, width(), height());
    const int below = painter.fontMetrics().lineSpacing() * static_cast<int>(titleLines().size());
    paintBridge(painter, models_, projection, {kMargin, 2 * kMargin + below});
    paintPlane(painter, models_, projection);
    paintPick(painter, models_, projection);
    paintFirstCamera(painter, models_, projection);
  }
  // Beside other views the name stands in the first one alone.
  if (models_.pane == 0) paintLines(painter, rect(), titleLines(), Qt::AlignLeft | Qt::AlignTop);
  paintLines(painter, rect(), timeLines(), Qt::AlignRight | Qt::AlignTop);
  int taken = paintLegend(painter);
  taken += paintDifferenceLegend(
      painter, rect().adjusted(kMargin, kMargin, -kMargin, -kMargin - taken), models_);
  // In a narrow view there is no room beside the legend.
  const bool narrow = width() < kNarrowWidth * models_.display.uiScale();
  paintLines(painter, rect().adjusted(0, 0, 0, narrow ? -taken : 0), readingLines(),
             Qt::AlignLeft | Qt::AlignBottom);
}

int SurfaceOverlay::paintLegend(QPainter& painter) {
  const SurfacePicture picture = pictureOf(models_);
  const VertexColours* map = picture.surface ? picture.colours() : nullptr;
  if (!map) return 0;
  const ColourScale& scale = map->scale;
  const int line = painter.fontMetrics().height();
  const QSize bar = kBar * models_.display.uiScale();
  const QRect box(width() - kMargin - bar.width(), height() - kMargin - line - bar.height(),
                  bar.width(), bar.height());
  paintLines(painter, QRect(0, 0, width(), box.top() + kMargin - 2), legendWords(scale),
             Qt::AlignRight | Qt::AlignBottom);
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
  QColor ground = painter.background().color();
  ground.setAlphaF(static_cast<float>(kBehindText));
  painter.fillRect(words, ground);
  painter.drawText(words, Qt::AlignLeft, end(scale.low));
  if (scale.diverging) painter.drawText(words, Qt::AlignHCenter, scale.logarithmic ? "1" : "0");
  painter.drawText(words, Qt::AlignRight, end(scale.high));
  return height() - box.top() + line * static_cast<int>(legendWords(scale).size());
}

}  // namespace flatland::ui
