// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/mark_style.h"

class QPalette;

namespace flatland::ui {

/// The colours of figures that suit the colours of a window.
Palette figurePaletteOf(const QPalette& palette);

/// The colours for marks and lines that suit the theme the window has now: for canvas, plots, icons
/// and text alike. Ask again when QEvent::PaletteChange or ApplicationPaletteChange comes.
Palette themePalette();

}  // namespace flatland::ui
