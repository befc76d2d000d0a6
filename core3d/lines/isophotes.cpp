// SPDX-License-Identifier: MIT
// Isophotes: n.w equal to one of the levels (i + 1) / (levels + 1), i from 0. Where the surface is
// creased, of the normals of each side.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core3d/lines/split_facing.h"

namespace flatland {
namespace {

// Calls add(level, crossings) for each level between the corners' n.w; on a sheet, which is lit on
// either side, also those of -n.w.
template <typename Add>
void forLevels(const SeenMesh& sight, std::uint32_t triangle, const std::array<float, 3>& nw,
               const Add& add) {
  const int levels = std::max(sight.options.isophoteLevels, 1);
  const auto steps = static_cast<float>(levels + 1);
  const auto [least, most] = std::minmax({nw[0], nw[1], nw[2]});
  if (most - least <= kFlatFacing) return;
  const int lowest = sight.sheets.has(triangle) ? -levels : 1;
  const int first = std::max(lowest, static_cast<int>(std::floor(least * steps)));
  const int last = std::min(levels, static_cast<int>(std::ceil(most * steps)));
  for (int level = first; level <= last; ++level) {
    if (level == 0) continue;  // a contour
    const float at = static_cast<float>(level) / steps;
    const Crossings found = zeroCrossings({nw[0] - at, nw[1] - at, nw[2] - at});
    if (found.count == 2) add(static_cast<std::uint32_t>(std::abs(level) - 1), found);
  }
}

}  // namespace

void addIsophotes(const SeenMesh& sight, std::uint32_t triangle, Segments& out) {
  const auto& v = sight.mesh.triangles[triangle];
  const std::vector<float>& nw = sight.seen.nw;
  forLevels(sight, triangle, {nw[v[0]], nw[v[1]], nw[v[2]]},
            [&](std::uint32_t level, const Crossings& found) {
              addPiece(sight.mesh, triangle, {found.points[0], found.points[1]}, {1.0f, 1.0f}, 0.0f,
                       nullptr, out, level);
            });
}

void addSplitIsophotes(const SeenMesh& sight, const SharpEdges& sharp, Segments& out) {
  for (const SplitTriangle& split : sharp.triangles()) {
    if (!isKnown(split)) continue;
    forLevels(sight, split.triangle, facingOf(sight, split),
              [&](std::uint32_t level, const Crossings& found) {
                out.push_back({endOnSide(sight, sharp, split.triangle, found.points[0]),
                               endOnSide(sight, sharp, split.triangle, found.points[1]),
                               split.triangle, level});
              });
  }
}

}  // namespace flatland
