// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include "core3d/draw/camera.h"
#include "ui/view3d/surface_models.h"

class QPainter;

namespace flatland::ui {

/// Paints what belongs to predicted lines over the picture of the surface: ticks at its edge, with
/// the symbols of the marks, and a legend with its upper left corner at `corner`.
void paintBridge(QPainter& painter, const SurfaceModels& models, const Projection& projection,
                 const QPoint& corner);

}  // namespace flatland::ui
