// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "ui/export/mark_style.h"
#include "ui/model/bridges.h"

namespace flatland::ui {

/// Lines on the surface that are no family: what flatland predicts, and the section by the plane.
/// Hidden and drawn by depth like the families.
struct MarkLines {
  LineEnds ends;  ///< dashes are gaps between pieces
  Rgb colour;
  double widthPx;
  float ink;  ///< opacity
};

/// A line that flatland predicts is dashed, in a colour that no line found has; one that a limit
/// applies to is pale. Precondition: there is a prediction.
std::vector<MarkLines> predictedLines(Bridges& bridges, Palette palette);

MarkLines sectionLine(const std::shared_ptr<const SectionView>& section, Palette palette);
Rgb sectionColour(Palette palette);

/// How a predicted line is drawn, for the legend.
inline constexpr double kPredictedWidthPx = 3.2, kSectionWidthPx = 2.4;
inline constexpr float kLimitedInk = 0.38f;
/// Dash and gap on a flat picture, in widths.
inline constexpr std::array<double, 2> kPredictedDash = {2.2, 1.6};

}  // namespace flatland::ui
