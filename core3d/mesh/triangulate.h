// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core3d/mesh/polygon_soup.h"

namespace flatland {

/// The triangles of a soup.
struct Triangulation {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> polygonOf;  ///< the polygon each triangle comes from
  std::size_t folded = 0;  ///< polygons that cross themselves: some of their triangles overlap
  std::size_t huge = 0;    ///< polygons that were made a fan because the proper way costs too much
};

/// Cuts every polygon of n corners into n - 2 triangles with its winding, without new vertices.
/// Polygons may be concave, and bent a little: they are judged in the plane across their mean
/// normal. Corners in a straight line give no triangle of zero area unless the whole polygon is a
/// line. A quadrilateral is cut at the diagonal that keeps its smallest angle larger.
///
/// Ears are cut in turns round the polygon. Cost n times the number of reflex corners for each
/// polygon, bounded for the whole soup: polygons that would exceed the bound become fans.
Triangulation triangulate(const PolygonSoup& soup);

}  // namespace flatland
