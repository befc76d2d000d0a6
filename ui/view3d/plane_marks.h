// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core3d/draw/camera.h"
#include "ui/view3d/surface_models.h"

class QPainter;

namespace flatland::ui {

/// Paints the handles of the cutting plane over the picture of the surface, the marks of the
/// section, and with numbers where apparent ridges of the surface go through the plane. Hidden
/// marks are paler.
void paintPlane(QPainter& painter, const SurfaceModels& models, const Projection& projection);

}  // namespace flatland::ui
