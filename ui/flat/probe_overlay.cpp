// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flat/probe_overlay.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLineF>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "flatland/study/probe_geometry.h"
#include "ui/export/figure_qt.h"
#include "ui/export/flat_figure.h"
#include "ui/model/theme.h"

namespace flatland::ui {

namespace {

struct OverlayWords {
  Q_DECLARE_TR_FUNCTIONS(ProbeOverlay)
};

constexpr double kUnitPx = 46.0;      ///< a unit vector
constexpr double kLongestPx = 170.0;  ///< an arrow; beyond, only its number tells
constexpr double kHandlePx = 7.0;
constexpr double kToothSpacingPx = 7.0;
/// Length of a tooth at curvature 1 / R on a scene of radius R, in R.
constexpr double kToothLength = 0.06;
constexpr double kLongestTooth = 1.5;  ///< in R

QColor curvatureColour() {
  return themePalette() != Palette::Light ? QColor(0x56, 0xB4, 0xE9) : QColor(0x00, 0x72, 0xB2);
}

/// An arrow and where its name would best be.
struct Arrow {
  QPointF from, along;
  QColor colour;
  double width;
  QString name;
  QPointF side;  ///< of the tip: direction; null for beyond it
};

void paintArrow(QPainter& painter, const Arrow& arrow) {
  const auto& [from, along, colour, width, name, side] = arrow;
  const double length = std::hypot(along.x(), along.y());
  if (length < 1.0) return;
  const QPointF to = from + along, unit = along / length, across(-unit.y(), unit.x());
  const double head = std::min(8.0, 0.7 * length);
  painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(from, to - unit * head * 0.8);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawPolygon(QPolygonF{to, to - unit * head + across * head * 0.4,
                                to - unit * head - across * head * 0.4});
}

/// Keeps names off the arrow.
void keepClear(LabelPlacer& labels, const Arrow& arrow) {
  constexpr double kStepPx = 3.0;
  const double length = std::hypot(arrow.along.x(), arrow.along.y());
  for (double s = 0.0; s < length; s += kStepPx) {
    const QPointF p = arrow.from + arrow.along * (s / length);
    labels.discourage({p.x(), p.y()});
  }
}

/// Its name at the tip, on a veil that keeps it readable, where there is room.
void paintName(QPainter& painter, const Arrow& arrow, LabelPlacer& labels) {
  constexpr double kNearestRingPx = 14.0;  // of the placer, from the anchor to the middle
  const double length = std::hypot(arrow.along.x(), arrow.along.y());
  if (length < 1.0) return;
  const auto& [from, along, colour, width, name, side] = arrow;
  QFont font = painter.font();
  font.setBold(true);
  painter.save();
  painter.setFont(font);
  const QFontMetricsF metrics(font);
  QRectF box(QPointF(), QSizeF(metrics.horizontalAdvance(name) + 4.0, metrics.height()));
  const Vec2 half(0.5 * box.width(), 0.5 * box.height());
  const QPointF wanted = side.isNull() ? along / length : side / std::hypot(side.x(), side.y());
  const Vec2 unit(wanted.x(), wanted.y());
  // A long name begins where a short one would.
  const double shift = std::max(0.0, unit.cwiseAbs().dot(half) + 4.0 - kNearestRingPx);
  const QPointF tip = from + along;
  const Vec2 centre = labels.place(Vec2(tip.x(), tip.y()) + shift * unit, half, unit);
  box.moveCenter({centre.x(), centre.y()});
  QColor veil = toQColor(sceneColours(themePalette()).background);
  veil.setAlpha(190);
  painter.fillRect(box, veil);
  painter.setPen(colour);
  painter.drawText(box, Qt::AlignCenter, name);
  painter.restore();
}

/// The number 1, 2 or 5 times a power of ten that is nearest below `value`. Precondition: > 0.
double roundBelow(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= value) return factor * power;
  }
  return power;
}

QString shortNumber(double value) {
  return QString::number(value, 'g', 3).replace('-', QChar(u'−'));
}

class ProbePainter {
 public:
  ProbePainter(QPainter& painter, const CanvasModels& models, double scale,
               LabelPlacer* labels = nullptr)
      : painter_(painter),
        models_(models),
        scale_(scale),
        labels_(labels),
        perLength_(models.viewport.scale() / scale),
        colours_(sceneColours(themePalette())) {}

  void paintComb(const QSizeF& size) {
    const auto& place = models_.probe.place();
    const auto curve = place ? std::optional(place->curve) : models_.selection.currentCurve();
    const auto& curves = models_.document.scene().curves;
    if (!curve || *curve >= curves.size()) return;
    const double radius = models_.stage.radius();
    const double perCurvature = models_.display.combScale() * kToothLength * radius * radius;
    const auto combs = curvatureComb(curves[*curve].shape, kToothSpacingPx / perLength_,
                                     perCurvature, kLongestTooth * radius);
    QColor tooth = curvatureColour();
    tooth.setAlpha(110);
    painter_.setBrush(Qt::NoBrush);
    for (const auto& comb : combs) {
      QPolygonF tips;
      painter_.setPen(QPen(tooth, 0.9));
      for (const CombTooth& t : comb) {
        painter_.drawLine(at(t.foot), at(t.tip));
        tips << at(t.tip);
      }
      painter_.setPen(QPen(curvatureColour(), 1.2));
      painter_.drawPolyline(tips);
    }
    paintCombScale(perCurvature * perLength_, size);
  }

  void paintCircle() {
    const auto reading = models_.probe.reading();
    if (!reading) return;
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(curvatureColour(), 1.2, Qt::DashLine));
    // A circle far larger than the canvas is its tangent to the eye, and to the painter too.
    constexpr double kLargestPx = 2e4;
    if (const auto circle = osculatingCircle(reading->jet, kLargestPx / perLength_)) {
      const double r = circle->radius * perLength_;
      painter_.drawEllipse(at(circle->centre), r, r);
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(curvatureColour());
      painter_.drawEllipse(at(circle->centre), 2.0, 2.0);
    } else {
      const QPointF p = at(reading->jet.p), along = onCanvas(reading->frame.tangent) * kLargestPx;
      painter_.drawLine(p - along, p + along);
    }
  }

  void paintVectors() {
    const auto reading = models_.probe.reading();
    if (!reading) return;
    const QPointF p = at(reading->jet.p);
    const QColor ink = toQColor(colours_.text);
    // k = dn/du lies along t: wider, and below it.
    QColor k = curvatureColour();
    k.setAlpha(200);
    add({p, onCanvas(reading->frame.tangent) * pixels(reading->frame.k), k, 5.0,
         OverlayWords::tr("k"), -onCanvas(reading->frame.normal)});
    add({p, onCanvas(reading->frame.tangent) * kUnitPx, ink, 1.6, OverlayWords::tr("t"), {}});
    add({p, onCanvas(reading->frame.normal) * kUnitPx, ink, 1.6, OverlayWords::tr("n"), {}});
  }

  /// The names of all arrows, when all arrows are known.
  void paintNames() {
    if (const auto at = probeOnCanvas(models_)) {
      labels_->block({at->x() / scale_, at->y() / scale_}, Vec2::Constant(kHandlePx + 2.0));
    }
    for (const Arrow& arrow : arrows_) keepClear(*labels_, arrow);
    for (const Arrow& arrow : arrows_) paintName(painter_, arrow, *labels_);
  }

  void paintScreenTurn() {
    const auto reading = models_.probe.reading();
    const auto image = probeOnScreen(models_);
    if (!reading || !image) return;
    const QPointF at = *image / scale_;
    painter_.setPen(QPen(toQColor(colours_.screen), 1.2, Qt::DashDotLine));
    painter_.drawLine(this->at(reading->jet.p), at);
    const auto turn = screenTurnAt(reading->terms);
    const ViewFrame view = frameOf(models_.document.scene().view);
    // Beside the screen line, on the side of the curve, so that neither hides the other.
    const QPointF beside = at - onCanvas(view.towards) * 9.0;
    if (turn) {
      add({beside, onCanvas(view.axis) * pixels(*turn), curvatureColour(), 4.0,
           OverlayWords::tr("dn/di = %1").arg(shortNumber(*turn)), -onCanvas(view.towards)});
    }
    painter_.setPen(QPen(toQColor(colours_.background), 1.5));
    painter_.setBrush(toQColor(colours_.screen));
    painter_.drawEllipse(at, 4.5, 4.5);
  }

  void paintHandle(bool hovered) {
    const auto& place = models_.probe.place();
    if (!place) return;
    const QPointF p = *probeOnCanvas(models_) / scale_;
    if (hovered) {
      QColor glow = QGuiApplication::palette().color(QPalette::Highlight);
      glow.setAlpha(110);
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(glow);
      painter_.drawEllipse(p, kHandlePx + 5.0, kHandlePx + 5.0);
    }
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(toQColor(colours_.background), 5.0));
    painter_.drawEllipse(p, kHandlePx, kHandlePx);
    painter_.setPen(QPen(toQColor(colours_.screen), 2.6));
    painter_.drawEllipse(p, kHandlePx, kHandlePx);
  }

 private:
  void add(Arrow arrow) {
    paintArrow(painter_, arrow);
    arrows_.push_back(std::move(arrow));
  }

  QPointF at(const Vec2& world) const { return models_.viewport.toWidget(world) / scale_; }
  static QPointF onCanvas(const Vec2& v) { return {v.x(), -v.y()}; }

  /// A curvature as the length of an arrow: as long as a unit vector at the curvature of a circle
  /// of half the scene's radius.
  double pixels(double curvature) const {
    return std::clamp(kUnitPx * 0.5 * models_.stage.radius() * curvature, -kLongestPx, kLongestPx);
  }

  /// A bar as long as a tooth of a round curvature, in the lower left corner.
  void paintCombScale(double pxPerCurvature, const QSizeF& size) {
    constexpr double kBarPx = 70.0, kInset = 14.0, kEnd = 4.0;
    if (!(pxPerCurvature > 0.0)) return;
    const double k = roundBelow(kBarPx / pxPerCurvature);
    const double length = k * pxPerCurvature;
    const QPointF from(kInset, size.height() - kInset), to = from + QPointF(length, 0.0);
    painter_.setPen(QPen(curvatureColour(), 1.6));
    painter_.drawLine(from, to);
    for (const QPointF& end : {from, to}) {
      painter_.drawLine(end - QPointF(0.0, kEnd), end + QPointF(0.0, kEnd));
    }
    painter_.drawText(from - QPointF(0.0, kEnd + 3.0),
                      OverlayWords::tr("comb: k = %1").arg(shortNumber(k)));
  }

  QPainter& painter_;
  const CanvasModels& models_;
  double scale_;
  LabelPlacer* labels_;
  std::vector<Arrow> arrows_;  ///< whose names are still to come
  double perLength_;
  const SceneColours& colours_;
};

}  // namespace

std::optional<QPointF> probeOnCanvas(const CanvasModels& models) {
  const auto& place = models.probe.place();
  if (!place) return std::nullopt;
  const Curve& curve = models.document.scene().curves[place->curve].shape;
  return models.viewport.toWidget(pointAt(curve, place->t));
}

std::optional<QPointF> probeOnScreen(const CanvasModels& models) {
  const auto& place = models.probe.place();
  if (!place) return std::nullopt;
  const Scene& scene = models.document.scene();
  const ScreenLine screen = screenLine(scene, true, models.stage.screenOffset());
  const auto image = pointOnScreen(frameOf(scene.view), screen,
                                   pointAt(scene.curves[place->curve].shape, place->t));
  if (!image) return std::nullopt;
  return models.viewport.toWidget(*image);
}

void paintBelowProbe(QPainter& painter, const CanvasModels& models, double scale,
                     const QSizeF& size) {
  ProbePainter overlay(painter, models, scale);
  if (models.display.shows(Overlay::Comb)) overlay.paintComb(size);
  if (models.display.shows(Overlay::Circle)) overlay.paintCircle();
}

void paintProbe(QPainter& painter, const CanvasModels& models, double scale, bool hovered,
                LabelPlacer& labels) {
  ProbePainter overlay(painter, models, scale, &labels);
  if (models.display.shows(Overlay::ScreenTurn)) overlay.paintScreenTurn();
  if (models.display.shows(Overlay::Vectors)) overlay.paintVectors();
  overlay.paintNames();
  overlay.paintHandle(hovered);
}

}  // namespace flatland::ui
