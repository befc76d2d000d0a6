// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flat/canvas_painter.h"

#include <QGuiApplication>
#include <QLineF>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <cmath>
#include <numbers>

#include "flatland/curve/curve_editing.h"
#include "ui/export/figure_qt.h"
#include "ui/export/flat_figure.h"
#include "ui/flat/probe_overlay.h"
#include "ui/model/theme.h"

namespace flatland::ui {

namespace {

constexpr int kInvitationMargin = 16;  ///< of the words on an empty canvas, px
constexpr double kPointSizePx = 9.0;
constexpr double kHaloPx = 8.0;  ///< radius of the ring around a hovered or selected mark

class CanvasPainter {
 public:
  CanvasPainter(QPainter& painter, const CanvasModels& models, const QSize& canvas,
                const CanvasState& state)
      : painter_(painter),
        models_(models),
        canvas_(canvas),
        scale_(drawnScale(models.display, canvas)),
        size_(QSizeF(canvas) / scale_),
        state_(state),
        palette_(themePalette()),
        colours_(sceneColours(palette_)),
        highlight_(QGuiApplication::palette().color(QPalette::Highlight)) {}

  void paint() {
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.fillRect(QRect(QPoint(), canvas_), toQColor(colours_.background));
    // All below is in pixels of the usual size.
    painter_.save();
    painter_.scale(scale_, scale_);
    // The application's font has grown already.
    QFont usual = painter_.font();
    usual.setPointSizeF(usual.pointSizeF() / models_.display.uiScale());
    painter_.setFont(usual);
    paintRing();
    if (models_.display.showsControlPolygon()) paintControlPolygons();
    paintHoveredCurve();
    paintBelowProbe(painter_, models_, scale_, size_);
    paintPoints(false);
    paintFigure();
    if (models_.display.showsPrintedRoots()) paintPrintedRoots();
    paintSelectedMark();
    paintHoveredMark();
    paintProbe(painter_, models_, scale_, state_.hovered.what == Target::What::Probe, labels_);
    paintPoints(true);
    paintHandle();
    painter_.restore();
    if (models_.document.scene().curves.empty()) paintInvitation();
    if (state_.focused) paintFocus();
  }

 private:
  QPointF at(const Vec2& world) const { return models_.viewport.toWidget(world) / scale_; }
  double pixelsPerLength() const { return models_.viewport.scale() / scale_; }

  void paintRing() {
    const bool active = state_.hovered.what == Target::What::ViewHandle;
    const double radius =
        (models_.stage.handle() - models_.stage.pivot()).norm() * pixelsPerLength();
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(
        QPen(active ? highlight_ : toQColor(colours_.faint), active ? 1.5 : 1.0, Qt::DotLine));
    painter_.drawEllipse(at(models_.stage.pivot()), radius, radius);
  }

  void paintControlPolygons() {
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(toQColor(colours_.controlPolygon), 1.0));
    for (const SceneCurve& curve : models_.document.scene().curves) {
      QPolygonF polygon;
      for (const Vec2& p : controlPoints(curve.shape)) polygon << at(p);
      if (!polygon.isEmpty() && isClosed(curve.shape)) polygon << polygon.front();
      painter_.drawPolyline(polygon);
    }
  }

  void paintHoveredCurve() {
    if (state_.hovered.what != Target::What::Curve) return;
    QColor glow = highlight_;
    glow.setAlpha(90);
    painter_.setPen(QPen(glow, 9.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPath(pathOf(models_.document.scene().curves[state_.hovered.point.curve].shape));
  }

  QPainterPath pathOf(const Curve& curve) const {
    QPainterPath path;
    const double tolerance = 0.25 / pixelsPerLength();
    for (const CubicStretch& stretch : cubicsWithin(curve, 0.0, pieceCount(curve), tolerance)) {
      const std::vector<Vec2>& p = stretch.cubic.points;
      if (path.isEmpty()) path.moveTo(at(p[0]));
      path.cubicTo(at(p[1]), at(p[2]), at(p[3]));
    }
    return path;
  }

  void paintFigure() {
    FlatFigureOptions options;
    options.width = size_.width();
    options.height = size_.height();
    const QPointF origin = at(Vec2::Zero());
    options.transform = FigureTransform{pixelsPerLength(), Vec2(origin.x(), origin.y())};
    options.screenOffset = models_.stage.screenOffset();
    options.kinds = models_.display.families();
    options.palette = palette_;
    options.hidden = models_.display.showsHidden() ? FlatFigureOptions::Hidden::Pale
                                                   : FlatFigureOptions::Hidden::Remove;
    options.legend = false;
    const QPointF eye = handlePlace(models_, canvas_).at / scale_;
    options.eye = Vec2(eye.x(), eye.y());
    options.transparent = true;  // the ring is below
    Figure figure = flatFigure(models_.document.scene(), models_.document.features(),
                               models_.document.visibility(), options);
    std::erase_if(figure.groups, [](const FigureGroup& group) { return group.id == "viewer"; });
    flatland::ui::paintFigure(painter_, figure);
    blockLetters(figure);
  }

  /// The names of the probe's vectors keep clear of letters and symbols, the eye and the screen.
  void blockLetters(const Figure& figure) {
    constexpr double kLetterPx = 13.0, kSymbolPx = 7.0, kEyePx = 17.0;
    for (const FigureGroup& group : figure.groups) {
      for (const Shape& shape : group.shapes) {
        if (const auto* letter = std::get_if<TextShape>(&shape)) {
          labels_.block(letter->position, Vec2(0.5, 0.55) * kLetterPx);
        }
      }
    }
    for (const Mark& mark : models_.document.features().marks) {
      if (!contains(models_.display.families(), mark.kind)) continue;
      const QPointF p = at(mark.point);
      labels_.block({p.x(), p.y()}, Vec2::Constant(kSymbolPx));
    }
    constexpr int kSamples = 32;  // of a piece
    for (const SceneCurve& curve : models_.document.scene().curves) {
      for (const Vec2& point : sampledPoints(curve.shape, kSamples)) {
        const QPointF p = at(point);
        labels_.discourage({p.x(), p.y()});
      }
    }
    const QPointF eye = handlePlace(models_, canvas_).at / scale_;
    labels_.block({eye.x(), eye.y()}, Vec2::Constant(kEyePx));
    if (const auto seen = probeOnScreen(models_)) {
      constexpr double kReachPx = 240.0, kStepPx = 6.0, kHalfPx = 3.0;
      const Vec2 axis = frameOf(models_.document.scene().view).axis;
      for (double s = -kReachPx; s <= kReachPx; s += kStepPx) {
        labels_.block({seen->x() / scale_ + s * axis.x(), seen->y() / scale_ - s * axis.y()},
                      Vec2::Constant(kHalfPx));
      }
    }
  }

  /// Where (3.13) as printed would put apparent ridges: hollow, dashed, never like a real mark.
  void paintPrintedRoots() {
    const Scene& scene = models_.document.scene();
    const MarkStyle& style = styleOf(MarkKind::ApparentRidge, palette_);
    const PrintedRootStyle look;
    for (const PrintedRoot& root : models_.document.printedRoots().roots) {
      const QPointF centre = at(root.point);
      painter_.setBrush(Qt::NoBrush);
      if (root.screen) {
        Mark mark{};
        mark.point = root.point;
        mark.screen = root.screen;
        if (const auto seen = markOnScreen(models_, mark)) {
          painter_.setPen(QPen(toQColor(style.colour), look.line, Qt::DashLine));
          painter_.drawLine(centre, *seen / scale_);
        }
      }
      const Curve& curve = scene.curves[static_cast<std::size_t>(root.curve)].shape;
      const Vec2 along = jetAt(curve, root.t).d1;
      painter_.save();
      painter_.translate(centre);
      painter_.rotate(-std::atan2(along.y(), along.x()) * 180.0 / std::numbers::pi);
      const QRectF bar(-look.barWidth / 2.0, -look.barLength / 2.0, look.barWidth, look.barLength);
      painter_.fillRect(bar, toQColor(colours_.background));
      painter_.setPen(QPen(toQColor(style.letterColour), look.outline, Qt::DashLine));
      painter_.drawRect(bar);
      painter_.restore();
    }
  }

  /// Points lie below the marks, which often coincide with them; those that are `picked`, selected
  /// or hovered, above.
  void paintPoints(bool picked) {
    const auto& curves = models_.document.scene().curves;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      for (std::size_t i = 0; i < controlPoints(curves[c].shape).size(); ++i) {
        if (isPicked({c, i}) == picked) paintPoint({c, i}, curves[c].shape);
      }
    }
  }

  bool isPicked(const PointRef& ref) const {
    return models_.selection.points().contains(ref) ||
           (state_.hovered.what == Target::What::Point && state_.hovered.point == ref);
  }

  /// Joints are squares, handles circles; selected ones filled with the highlight colour.
  void paintPoint(const PointRef& ref, const Curve& curve) {
    const bool selected = models_.selection.points().contains(ref);
    const bool hovered = state_.hovered.what == Target::What::Point && state_.hovered.point == ref;
    const bool joint = isJoint(curve, ref.point);
    if (!models_.display.showsControlPolygon() && !joint && !selected && !hovered) return;
    const QPointF centre = at(controlPoints(curve)[ref.point]);
    if (hovered) {
      QColor glow = highlight_;
      glow.setAlpha(90);
      painter_.setPen(Qt::NoPen);
      painter_.setBrush(glow);
      painter_.drawEllipse(centre, kPointSizePx, kPointSizePx);
    }
    painter_.setPen(QPen(
        selected ? highlight_.darker(130) : toQColor(paler(colours_.text, colours_.faint)), 1.5));
    painter_.setBrush(selected ? highlight_ : toQColor(colours_.background));
    const double half = kPointSizePx / 2.0;
    if (joint) {
      painter_.drawRect(QRectF(centre - QPointF(half, half), QSizeF(2 * half, 2 * half)));
    } else {
      painter_.drawEllipse(centre, half, half);
    }
  }

  void paintSelectedMark() {
    if (!models_.selection.mark()) return;
    const auto index = indexOf(models_.document.features(), *models_.selection.mark());
    if (index) paintHalo(models_.document.features().marks[*index], 2.5, true);
  }

  void paintHoveredMark() {
    if (state_.hovered.what != Target::What::Mark) return;
    const auto& marks = models_.document.features().marks;
    if (state_.hovered.mark < marks.size()) paintHalo(marks[state_.hovered.mark], 1.5, false);
  }

  void paintHalo(const Mark& mark, double width, bool line) {
    painter_.setPen(QPen(highlight_, width));
    painter_.setBrush(Qt::NoBrush);
    const QPointF onCurve = at(mark.point);
    painter_.drawEllipse(onCurve, kHaloPx, kHaloPx);
    const auto place = markOnScreen(models_, mark);
    if (!place) return;
    const QPointF onScreen = *place / scale_;
    painter_.drawEllipse(onScreen, kHaloPx, kHaloPx);
    QLineF between(onCurve, onScreen);
    if (!line || between.length() <= 2.0 * kHaloPx) return;
    between.setLength(between.length() - kHaloPx);
    between.setP1(between.pointAt(kHaloPx / between.length()));
    painter_.setPen(QPen(highlight_, 1.5));
    painter_.drawLine(between);
  }

  /// An eye that looks at the scene.
  void paintHandle() {
    HandlePlace place = handlePlace(models_, canvas_);
    place.at /= scale_;
    const bool hovered = state_.hovered.what == Target::What::ViewHandle;
    painter_.save();
    painter_.translate(place.at);
    const QColor ink = hovered ? highlight_.darker(120) : toQColor(colours_.text);
    painter_.setPen(QPen(ink, 1.8));
    painter_.setBrush(toQColor(colours_.background));
    painter_.drawEllipse(QPointF(), 14.0, 14.0);
    QPainterPath lids(QPointF(-9.5, 0.0));
    lids.quadTo(QPointF(0.0, -11.0), QPointF(9.5, 0.0));
    lids.quadTo(QPointF(0.0, 11.0), QPointF(-9.5, 0.0));
    painter_.setPen(QPen(ink, 1.4));
    painter_.drawPath(lids);
    // The pupil looks towards the scene; the eye itself stays upright.
    QLineF gaze(QPointF(), at(models_.stage.pivot()) - place.at);
    if (gaze.length() > 0.0) gaze.setLength(2.2);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(ink);
    painter_.drawEllipse(gaze.p2(), 3.2, 3.2);
    painter_.restore();
    if (place.atEdge) paintWayOut(place.at, ink);
  }

  /// The viewer is farther out than the canvas: an arrow says where.
  void paintWayOut(const QPointF& from, const QColor& ink) {
    QLineF way(from, at(models_.stage.handle()));
    if (way.length() <= 0.0) return;
    way.setLength(19.0);
    const QLineF tip = way;
    QLineF left(tip.p2(), tip.p1());
    left.setLength(6.0);
    QLineF right = left;
    left.setAngle(left.angle() + 40.0);
    right.setAngle(right.angle() - 40.0);
    painter_.setPen(QPen(ink, 1.8));
    painter_.drawLine(left);
    painter_.drawLine(right);
  }

  void paintInvitation() {
    painter_.setPen(toQColor(colours_.text));
    // In the upper part: the eye stands in the middle of the height.
    const QRect upper(kInvitationMargin, 0, canvas_.width() - 2 * kInvitationMargin,
                      canvas_.height() * 2 / 5);
    painter_.drawText(upper, Qt::AlignCenter | Qt::TextWordWrap,
                      QCoreApplication::translate(
                          "FlatCanvas", "Nothing here yet. Curve > Add Curve draws one."));
  }

  void paintFocus() {
    painter_.setPen(QPen(highlight_, 2.0));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(
        QRectF(QPointF(1.0, 1.0), QSizeF(canvas_.width() - 2.0, canvas_.height() - 2.0)));
  }

  QPainter& painter_;
  const CanvasModels& models_;
  QSize canvas_;
  double scale_;  ///< of everything drawn
  QSizeF size_;   ///< of the canvas, in pixels of the usual size
  const CanvasState& state_;
  Palette palette_;
  const SceneColours& colours_;
  QColor highlight_;
  LabelPlacer labels_;  ///< what the names at the probe keep clear of
};

}  // namespace

void paintCanvas(QPainter& painter, const CanvasModels& models, const QSize& canvas,
                 const CanvasState& state) {
  painter.save();
  CanvasPainter(painter, models, canvas, state).paint();
  painter.restore();
}

}  // namespace flatland::ui
