// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/model/bridge_source.h"
#include "ui/model/section_source.h"

namespace flatland::ui {

/// Lines on the surface that are no family: what flatland predicts, and the section by the plane.
/// Hidden and drawn by depth like the families.
struct MarkLines {
  std::vector<LineVertex> ends;  ///< two in a row are a piece; dashes are gaps between pieces
  Rgb colour;
  double widthPx;
  float ink;  ///< opacity
};

/// A line that flatland predicts is dashed, in the colour of the mark; one that a limit applies to
/// is pale.
std::vector<MarkLines> predictedLines(const BridgeView& bridge, Palette palette);

MarkLines sectionLine(const SectionView& section, Palette palette);
Rgb sectionColour(Palette palette);

/// How a predicted line is drawn, for the legend.
inline constexpr double kPredictedWidthPx = 3.2, kSectionWidthPx = 2.4;
inline constexpr float kLimitedInk = 0.38f;

}  // namespace flatland::ui
