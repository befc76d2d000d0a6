// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <optional>

#include "ui/export/label_placement.h"
#include "ui/flat/canvas_models.h"

class QPainter;

namespace flatland::ui {

/// The place of the probe on the canvas, in its pixels; nullopt without a probe.
std::optional<QPointF> probeOnCanvas(const CanvasModels& models);

/// The same for its image on the drawn screen; nullopt also where the viewer cannot look.
std::optional<QPointF> probeOnScreen(const CanvasModels& models);

/// What lies below the curve: curvature comb and osculating circle. The painter is in pixels of the
/// usual size, `scale` of which make one of the canvas (drawnScale()); `size` is the canvas in
/// them.
void paintBelowProbe(QPainter& painter, const CanvasModels& models, double scale,
                     const QSizeF& size);

/// What lies above it: the probe itself, n, t and k at it, its line of sight, dn/di on the screen.
/// Their names go where `labels` finds room beside what is there already.
void paintProbe(QPainter& painter, const CanvasModels& models, double scale, bool hovered,
                LabelPlacer& labels);

}  // namespace flatland::ui
