// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

#include "core3d/draw/camera.h"
#include "ui/export/mark_style.h"
#include "ui/view3d/surface_models.h"

class QPainter;

namespace flatland::ui {

/// Ticks at the edge of the picture, which is flatland's screen, for the marks of the curve, with
/// their symbols. Only in a view without a camera of its own: from elsewhere its edge is not that
/// screen.
std::vector<PathShape> tickShapes(const BridgeView& bridge, const Projection& projection,
                                  Palette palette, double scale);

/// Paints what belongs to predicted lines over the picture of the surface: ticks at its edge, with
/// the symbols of the marks, and a legend with its upper left corner at `corner`.
void paintBridge(QPainter& painter, const SurfaceModels& models, const Projection& projection,
                 const QPoint& corner);

}  // namespace flatland::ui
