// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core3d/mesh/build_mesh.h"

namespace flatland::test {

/// A polygon pushed along z, with lids; its corners counter-clockwise seen from z.
inline TriangleMesh prism(const std::vector<Eigen::Vector2d>& polygon, double low = 0.0,
                          double high = 1.0) {
  PolygonSoup soup;
  std::vector<std::uint32_t> lid, floor;
  const auto count = static_cast<std::uint32_t>(polygon.size());
  for (const Eigen::Vector2d& p : polygon) {
    for (const double z : {low, high}) soup.addVertex(p.x(), p.y(), z);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    const std::uint32_t wall[] = {2 * i, 2 * next, 2 * next + 1, 2 * i + 1};
    soup.addPolygon(wall);
    lid.push_back(2 * i + 1);
    floor.push_back(2 * (count - 1 - i));
  }
  soup.addPolygon(lid);
  soup.addPolygon(floor);
  return buildMesh(soup).mesh;
}

}  // namespace flatland::test
