// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core3d/lines/line_family.h"
#include "ui/export/figure.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

/// The colour that tells a family of lines from the others, wherever it is drawn. Ridges, valleys
/// and apparent ridges have those of the marks of flatland.
Rgb lineColour(LineFamily family, Palette palette);

/// The colour of lines that flatland predicts on a surface, of a kind that it predicts: one that no
/// family has by itself, so that a line found is told from the prediction that it lies on.
Rgb predictedColour(MarkKind kind, Palette palette);

/// For people, in English: "Apparent ridges".
std::string_view lineTitle(LineFamily family);

}  // namespace flatland::ui
