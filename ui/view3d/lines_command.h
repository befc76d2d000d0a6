// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <string>
#include <vector>

#include "ui/view3d/surface_picture.h"

namespace flatland::ui {

/// The command line that draws surfaceFigure(pictures, size) to `file`, without folders: for a
/// file's account of itself. Empty where no command draws that: several views, a swept surface,
/// marks of bridges, families with colours, widths or fading of their own, thresholds for ink.
std::string linesCommand(const std::vector<SurfacePicture>& pictures, const QSize& size,
                         const std::string& file);

}  // namespace flatland::ui
