// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>
#include <optional>

#include "ui/flat/canvas_models.h"

namespace flatland::ui {

/// What lies under a position of the canvas.
struct Target {
  enum class What { Nothing, ViewHandle, Point, Probe, Mark, Curve };
  What what = What::Nothing;
  PointRef point{};                    ///< Point: which; Curve: its curve
  std::size_t mark = 0;                ///< Mark: index in the features
  double t = 0.0;                      ///< Curve: the parameter nearest to the position
  std::optional<std::size_t> below{};  ///< Probe: the mark it covers

  bool operator==(const Target&) const = default;
};

/// How much larger than usual marks, points and lines are drawn, and how much farther the pointer
/// reaches: by the scale the person chose, and on a canvas larger than usual by the root of how
/// much larger it is.
double drawnScale(const Display& display, const QSizeF& canvas);

/// Where the view handle is drawn, in pixels: at Stage::handle(), or at the edge of the canvas on
/// the way there if that is outside.
struct HandlePlace {
  QPointF at;
  bool atEdge;
};
HandlePlace handlePlace(const CanvasModels& models, const QSizeF& canvas);

/// The place of a mark on the drawn screen, in pixels; nullopt if the viewer cannot look there.
std::optional<QPointF> markOnScreen(const CanvasModels& models, const Mark& mark);

/// The foremost thing within reach of `position` (pixels): control points (the selected ones
/// first), then the handle, the probe, marks that are shown (on the curve and on the screen),
/// curves.
Target targetAt(const CanvasModels& models, const QSizeF& canvas, const QPointF& position);

}  // namespace flatland::ui
