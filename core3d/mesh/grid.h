// SPDX-License-Identifier: MIT
#pragma once

#include "core3d/mesh/polygon_soup.h"

namespace flatland {

/// Vertices first, first + 1, ... in rows of `columns`.
struct Grid {
  int first = 0;
  int columns, rows;
  bool closedColumns = false;  ///< the last column is followed by the first
  bool closedRows = false;     ///< the last row is followed by the first
  bool turned = false;         ///< the other side is outside
};

/// Adds two triangles for every cell, counter-clockwise where columns go right and rows go up.
inline void addGrid(PolygonSoup& soup, const Grid& grid) {
  const auto vertex = [&](int column, int row) {
    return static_cast<std::uint32_t>(grid.first + row % grid.rows * grid.columns +
                                      column % grid.columns);
  };
  const int columns = grid.closedColumns ? grid.columns : grid.columns - 1;
  const int rows = grid.closedRows ? grid.rows : grid.rows - 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                          d = vertex(i, j + 1);
      if (grid.turned) {
        soup.addTriangle(a, c, b);
        soup.addTriangle(a, d, c);
      } else {
        soup.addTriangle(a, b, c);
        soup.addTriangle(a, c, d);
      }
    }
  }
}

}  // namespace flatland
