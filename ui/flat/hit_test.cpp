// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flat/hit_test.h"

#include <QLineF>
#include <QRectF>
#include <algorithm>
#include <cmath>

#include "ui/export/flat_figure.h"
#include "ui/flat/probe_overlay.h"

namespace flatland::ui {

namespace {

// How far from a thing the pointer may be, in pixels: wide enough for a trackpad, narrow enough to
// tell neighbours apart.
constexpr double kHandleReach = 16.0;
constexpr double kPointReach = 9.0;
constexpr double kMarkReach = 8.0;
constexpr double kProbeReach = 9.0;
constexpr double kCurveReach = 6.0;

/// Distance of the edge handle from the edge of the canvas.
constexpr double kEdgeInset = 26.0;

std::optional<PointRef> nearestPointAt(const CanvasModels& models, const QPointF& position,
                                       double reach) {
  std::optional<PointRef> best;
  double bestDistance = reach;
  const auto& curves = models.document.scene().curves;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto& points = controlPoints(curves[c].shape);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double distance = QLineF(models.viewport.toWidget(points[i]), position).length();
      // Of points that lie on each other the selected one is meant.
      if (models.selection.points().contains({c, i})) distance -= 1.0;
      if (distance < bestDistance) {
        bestDistance = distance;
        best = PointRef{c, i};
      }
    }
  }
  return best;
}

std::optional<std::size_t> nearestMarkAt(const CanvasModels& models, const QPointF& position,
                                         double reach) {
  std::optional<std::size_t> best;
  double bestDistance = reach;
  const auto& marks = models.document.features().marks;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (!models.display.shows(marks[i].kind)) continue;
    if (!marks[i].visible && !models.display.showsHidden()) continue;
    double distance = QLineF(models.viewport.toWidget(marks[i].point), position).length();
    if (const auto onScreen = markOnScreen(models, marks[i]); onScreen && marks[i].visible) {
      distance = std::min(distance, QLineF(*onScreen, position).length());
    }
    if (distance < bestDistance) {
      bestDistance = distance;
      best = i;
    }
  }
  return best;
}

}  // namespace

double drawnScale(const Display& display, const QSizeF& canvas) {
  constexpr double kUsualPx = 560.0;  // the shorter side in a window of the usual size
  constexpr double kMost = 2.0;
  const double shorter = std::min(canvas.width(), canvas.height());
  return display.uiScale() * std::clamp(std::sqrt(shorter / kUsualPx), 1.0, kMost);
}

HandlePlace handlePlace(const CanvasModels& models, const QSizeF& canvas) {
  const QPointF wanted = models.viewport.toWidget(models.stage.handle());
  const double inset = kEdgeInset * drawnScale(models.display, canvas);
  const QRectF room = QRectF(QPointF(), canvas).adjusted(inset, inset, -inset, -inset);
  if (room.contains(wanted)) return {wanted, false};
  const QPointF nearest(std::clamp(wanted.x(), room.left(), std::max(room.left(), room.right())),
                        std::clamp(wanted.y(), room.top(), std::max(room.top(), room.bottom())));
  return {nearest, true};
}

std::optional<QPointF> markOnScreen(const CanvasModels& models, const Mark& mark) {
  const Scene& scene = models.document.scene();
  const ScreenLine screen = screenLine(scene, true, models.stage.screenOffset());
  const auto place = pointOnScreen(frameOf(scene.view), screen, mark.point);
  if (!place) return std::nullopt;
  return models.viewport.toWidget(*place);
}

Target targetAt(const CanvasModels& models, const QSizeF& canvas, const QPointF& position) {
  const double scale = drawnScale(models.display, canvas);
  if (const auto point = nearestPointAt(models, position, scale * kPointReach)) {
    return {.what = Target::What::Point, .point = *point};
  }
  if (QLineF(handlePlace(models, canvas).at, position).length() <= scale * kHandleReach) {
    return {.what = Target::What::ViewHandle};
  }
  const auto mark = nearestMarkAt(models, position, scale * kMarkReach);
  const auto probe = probeOnCanvas(models);
  if (probe && QLineF(*probe, position).length() <= scale * kProbeReach) {
    return {.what = Target::What::Probe, .below = mark};
  }
  if (mark) {
    return {.what = Target::What::Mark, .mark = *mark};
  }
  const Vec2 world = models.viewport.toWorld(position);
  const auto& curves = models.document.scene().curves;
  Target target;
  double bestDistance = scale * kCurveReach / models.viewport.scale();
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const Nearest nearest = nearestPoint(curves[c].shape, world);
    if (nearest.distance > bestDistance) continue;
    bestDistance = nearest.distance;
    target = {.what = Target::What::Curve, .point = {c, 0}, .t = nearest.t};
  }
  return target;
}

}  // namespace flatland::ui
