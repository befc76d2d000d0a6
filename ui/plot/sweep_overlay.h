// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/sweep_axes.h"
#include "ui/flat/canvas_models.h"
#include "ui/plot/sweep_source.h"

class QPainter;

namespace flatland::ui {

/// What is under the pointer, in the px of the figure.
struct SweepHover {
  double width;            ///< of the figure: nothing is written beyond it
  const SweepEvent* fold;  ///< a birth or merge; null if none
  Vec2 pointer;
};

/// What moves above the diagram of `shown`: the view and the probe as lines, and what the ring
/// under the pointer is. A probe on a curve that the diagram does not know is left out.
void paintSweepOverlay(QPainter& painter, const CanvasModels& models, const SweepData& shown,
                       const SweepAxes& axes, const SweepHover& hover);

}  // namespace flatland::ui
