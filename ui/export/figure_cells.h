// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/export/figure.h"

namespace flatland::ui {

/// One of several figures side by side, and what stands above it.
struct FigureCell {
  Figure figure;
  std::string title;
};

/// Where cell `index` of `count` lies in a picture: two columns, the first row first, all of one
/// size, with a gap between them and a row for the title above each. A single cell has all of it
/// and no title.
struct CellPlace {
  double left, top;      ///< of the figure, px
  double width, height;  ///< of the figure, px, at least 1
  double titleHeight;    ///< above it; 0: none
};
CellPlace cellPlace(std::size_t index, std::size_t count, double width, double height);

/// The figures in one, each cut off at the edge of its cell. The ids of the groups of cell i begin
/// with "view-i-", from 1, if there are several. Precondition: each figure has the size of its
/// place, and outlines without Beziers, as drawings of meshes do; a filled path is kept or left out
/// as a whole. The background is that of the first.
Figure sideBySide(std::vector<FigureCell> cells, double width, double height, Rgb titleColour);

}  // namespace flatland::ui
