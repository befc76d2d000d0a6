// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core3d/draw/camera.h"
#include "ui/view3d/surface_models.h"

class QPainter;

namespace flatland::ui {

/// Paints the picked place over the picture of the surface: a ring, the principal directions t1 and
/// t2 as they are seen, and t_A, which is a direction on the screen, of the vertex nearest to it:
/// the place that the derivation is about (SurfaceStudy::place). In a view with a camera of its
/// own, r on the surface instead of t_A, which belongs to the screen of view 0. Nothing where none
/// is picked or it lies behind the viewer.
void paintPick(QPainter& painter, const SurfaceModels& models, const Projection& projection);

}  // namespace flatland::ui
