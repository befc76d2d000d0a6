// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "flatland/io/svg_file.h"

namespace flatland::ui {

/// The window redoes marks and visibility at every step of a drag; visibility grows faster than the
/// square of the number of pieces (about 0.6 s for 500, 5 s for 2,000).
inline constexpr int kMostShownPieces = 1000;

/// A drawing for the window. Throws InputError as loadSvg() does, and for one with more pieces than
/// kMostShownPieces.
ImportedScene loadSvgToShow(const QString& name);

}  // namespace flatland::ui
