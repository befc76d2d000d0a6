// SPDX-License-Identifier: MIT
// Isophotes: n.w equal to one of the levels (i + 1) / (levels + 1), i from 0.
#include <algorithm>
#include <cmath>

#include "core3d/lines/families.h"

namespace flatland {

void addIsophotes(const SeenMesh& sight, std::uint32_t triangle, Segments& out) {
  const auto& v = sight.mesh.triangles[triangle];
  const int levels = std::max(sight.options.isophoteLevels, 1);
  const auto steps = static_cast<float>(levels + 1);
  const float nw[3] = {sight.seen.nw[v[0]], sight.seen.nw[v[1]], sight.seen.nw[v[2]]};
  const float low = std::min({nw[0], nw[1], nw[2]}) * steps,
              high = std::max({nw[0], nw[1], nw[2]}) * steps;
  const int first = std::max(1, static_cast<int>(std::floor(low)));
  const int last = std::min(levels, static_cast<int>(std::ceil(high)));
  for (int level = first; level <= last; ++level) {
    const float at = static_cast<float>(level) / steps;
    const Crossings found = zeroCrossings({nw[0] - at, nw[1] - at, nw[2] - at});
    if (found.count == 2)
      addPiece(sight.mesh, triangle, {found.points[0], found.points[1]}, {1.0f, 1.0f}, 0.0f,
               nullptr, out, static_cast<std::uint32_t>(level - 1));
  }
}

}  // namespace flatland
