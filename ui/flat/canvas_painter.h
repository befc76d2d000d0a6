// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/flat/hit_test.h"

class QPainter;

namespace flatland::ui {

/// What the canvas shows beyond its models.
struct CanvasState {
  Target hovered;
  bool focused = false;  ///< draw the focus frame
};

/// Paints the whole canvas: the figure as in an exported file, below it the ring, above it control
/// points, view handle, and what is selected or hovered.
void paintCanvas(QPainter& painter, const CanvasModels& models, const QSize& canvas,
                 const CanvasState& state);

}  // namespace flatland::ui
