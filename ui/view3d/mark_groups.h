// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core3d/draw/camera.h"
#include "ui/export/figure.h"
#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

/// What files have above the lines of a view, as the window does: ticks for predicted lines
/// ("predicted-ticks"), marks of the section ("section-marks") and numbered crosses where apparent
/// ridges go through its plane ("section-crossings"). What cannot be seen is paler and has ids that
/// end in "-hidden". Px of the projection, symbols `scale` times their usual size. Without a
/// surface there is nothing.
std::vector<FigureGroup> markGroups(const SurfacePicture& picture, const Projection& projection,
                                    double scale);

}  // namespace flatland::ui
