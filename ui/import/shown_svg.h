// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "flatland/io/svg_file.h"

namespace flatland::ui {

/// The window redoes marks and visibility at every step of a drag: 0.04 s for 5,000 segments in one
/// path, 0.5 s for a scribble of as many cubics (35,000 marks). Both grow little faster than the
/// number of pieces.
inline constexpr int kMostShownPieces = 5000;

/// A drawing for the window. Throws InputError as loadSvg() does, and for one with more pieces than
/// kMostShownPieces.
ImportedScene loadSvgToShow(const QString& name);

}  // namespace flatland::ui
