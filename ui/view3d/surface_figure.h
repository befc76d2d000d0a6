// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "ui/export/figure.h"
#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

/// The lines of a picture as vectors, with what is hidden cast out exactly and not by pixels: the
/// families, thresholds, colours and widths that the window shows. Coordinates in px of `size`.
/// Works in any thread; seconds for a large mesh. Precondition: the picture's surface has fields.
Figure surfaceFigure(const SurfacePicture& picture, const QSize& size, std::stop_token stop = {});

}  // namespace flatland::ui
