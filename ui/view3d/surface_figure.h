// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "ui/export/figure.h"
#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

/// The lines of all views as vectors side by side (figure_cells.h), with what is hidden cast out
/// exactly and not by pixels: the families, thresholds, colours and widths that the window shows.
/// Thresholds for ink are solved for the picture at hand. Coordinates in px of `size`. Works in any
/// thread; seconds for a large mesh. Preconditions: all are of one surface, which has fields; what
/// shows a difference has it.
Figure surfaceFigure(const std::vector<SurfacePicture>& pictures, const QSize& size,
                     std::stop_token stop = {});

}  // namespace flatland::ui
