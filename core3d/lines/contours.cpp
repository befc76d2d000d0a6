// SPDX-License-Identifier: MIT
// Occluding contours: n.w = 0 for the interpolated normal (bibliography: hertzmann2000).
#include "core3d/lines/families.h"

namespace flatland {

void addContour(const Sight& sight, std::uint32_t triangle, Segments& out) {
  const auto& v = sight.mesh.triangles[triangle];
  const float nw[3] = {sight.seen.nw[v[0]], sight.seen.nw[v[1]], sight.seen.nw[v[2]]};
  const Crossings found = zeroCrossings(nw);
  if (found.count == 2)
    addPiece(sight.mesh, triangle, {found.points[0], found.points[1]}, {1.0f, 1.0f}, 0.0f, nullptr,
             out);
}

}  // namespace flatland
