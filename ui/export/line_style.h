// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "core3d/lines/line_family.h"
#include "ui/export/figure.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

/// The order of painting, in the window and in every file: the first is the lowest. Levels, which
/// fill the surface evenly, come first. Contours and rims come last: other lines run into them, and
/// must not break them. The silhouette is a part of the contours, and told from them only where it
/// lies over them. What is hidden lies below all that is visible, of every family.
std::array<LineFamily, kLineFamilyCount> paintingOrder();

/// The colour that tells a family of lines from the others, wherever it is drawn. Ridges, valleys
/// and apparent ridges have those of the marks of flatland.
Rgb lineColour(LineFamily family, Palette palette);

/// The colour of lines that flatland predicts on a surface, of a kind that it predicts: one that no
/// family has by itself, so that a line found is told from the prediction that it lies on.
Rgb predictedColour(MarkKind kind, Palette palette);

/// For people, in English: "Apparent ridges".
std::string_view lineTitle(LineFamily family);

}  // namespace flatland::ui
