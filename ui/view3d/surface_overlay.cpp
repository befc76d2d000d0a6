// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_overlay.h"

#include <QLocale>
#include <QPainter>

#include "ui/export/figure_qt.h"
#include "ui/model/bridge_ticks.h"
#include "ui/model/bridge_words.h"
#include "ui/model/core_words.h"
#include "ui/view3d/bridge_marks.h"
#include "ui/view3d/pane_marks.h"
#include "ui/view3d/pick_marks.h"
#include "ui/view3d/picture_legend.h"
#include "ui/view3d/plane_marks.h"
#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

namespace {

constexpr int kMargin = 10;
constexpr double kNarrowWidth = 420.0;  ///< that does not hold reading and legend side by side

QString number(double value) { return QLocale().toString(value, 'g', 4); }

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
      return SurfaceOverlay::tr("Feature term, towards larger λ");
    case SurfaceQuantity::Offset:
      return SurfaceOverlay::tr("Offset term, towards larger λ");
    case SurfaceQuantity::OffsetShare:
      break;
  }
  return SurfaceOverlay::tr("|Offset| / |feature|");
}

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
  connect(&models_.bridges.section, &SectionSource::chosenChanged, this, repaint);
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
  // A class has no use for times.
  if (models_.display.isProjector()) return inkLines(models_);
  QStringList lines{tr("Frame %1 ms").arg(milliseconds(frameMs_))};
  if (const auto& seen = models_.seen.seen()) {
    lines << tr("Lines %1 ms").arg(milliseconds(seen->lineMs));
  }
  return lines + inkLines(models_);
}

QStringList SurfaceOverlay::differenceWords() const { return differenceLines(pictureOf(models_)); }

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
    if (const QString seenBy = seenByWords(models_.document.scene().surface); !seenBy.isEmpty()) {
      lines << seenBy;
    }
    lines << QStringLiteral("n·w %1   λ %2")
                 .arg(number(terms->nw), terms->lambda ? number(*terms->lambda) : tr("none"));
    lines << tr("feature %1").arg(number(terms->feature));
    lines << tr("offset %1").arg(number(terms->offset));
    if (models_.there() && models_.document.scene().surface->camera.perspectiveDeg) {
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
  const int taken = paintDifferenceLegend(
      painter, rect().adjusted(kMargin, kMargin, -kMargin, -kMargin), picture);
  // In a narrow view there is no room beside the legend.
  const bool narrow = width() < kNarrowWidth * models_.display.uiScale();
  paintLines(painter, rect().adjusted(0, 0, 0, narrow ? -taken : 0), readingLines(),
             Qt::AlignLeft | Qt::AlignBottom);
}

}  // namespace flatland::ui
