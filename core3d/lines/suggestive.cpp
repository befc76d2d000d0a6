// SPDX-License-Identifier: MIT
// Suggestive contours and highlights (bibliography: decarlo2003, decarlo2004, decarlo2007).
#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core3d/lines/families.h"

namespace flatland {
namespace {

// (D_w K)(w, w) of the tangential w and its turning, over |w_T|^2:
//   C(w, w, w) - 2 (n.w) |K w|^2
// which is |w_T| times the derivative of radial curvature along w where that curvature is 0; in
// perspective too, for the turning of w with the place is along w_T and drops out there.
float growth(const SeenMesh& sight, std::uint32_t v) {
  const SurfaceFields& f = sight.fields;
  const Eigen::Vector3f w =
      sight.view.towardsViewer(sight.mesh.position(v).cast<double>()).cast<float>();
  const float w1 = f.e1(v).dot(w), w2 = f.e2(v).dot(w);
  const float square = w1 * w1 + w2 * w2;
  if (!(square > 0.0f)) return 0.0f;
  const float cubic = w1 * w1 * (f.c111[v] * w1 + 3.0f * f.c112[v] * w2) +
                      w2 * w2 * (f.c222[v] * w2 + 3.0f * f.c122[v] * w1);
  const float p1 = f.k1[v] * w1, p2 = f.k2[v] * w2;
  return (cubic - 2.0f * sight.seen.nw[v] * (p1 * p1 + p2 * p2)) / square;
}

}  // namespace

void addSuggestive(const SeenMesh& sight, std::uint32_t triangle, Segments* contours,
                   Segments* highlights) {
  const auto& v = sight.mesh.triangles[triangle];
  const Crossings found =
      zeroCrossings({sight.seen.radial[v[0]], sight.seen.radial[v[1]], sight.seen.radial[v[2]]});
  if (found.count != 2) return;
  const float perSize = sight.size() * sight.size();
  const float corner[3] = {perSize * growth(sight, v[0]), perSize * growth(sight, v[1]),
                           perSize * growth(sight, v[2])};
  float strength[2];
  for (int i = 0; i < 2; ++i) {
    const EdgePoint& point = found.points[i];
    strength[i] = point.between(corner[point.corner], corner[(point.corner + 1) % 3]);
  }
  const bool all = sight.options.unfiltered;
  const float* nw = all ? nullptr : sight.seen.nw.data();
  const auto add = [&](Segments* out, LineFamily family, float side, float a, float b) {
    const float least =
        all ? -std::numeric_limits<float>::infinity() : std::max(0.0f, sight.threshold(family));
    if (out && (all || a + b > 0.0f))
      addPiece(sight.mesh, triangle, {found.points[0], found.points[1]}, {a, b}, least, nw, *out, 0,
               side);
  };
  add(contours, LineFamily::SuggestiveContours, 1.0f, strength[0], strength[1]);
  add(highlights, LineFamily::SuggestiveHighlights, 1.0f, -strength[0], -strength[1]);
  if (all || !sight.sheets.has(triangle)) return;
  // Seen from behind, the normal and all curvatures change their signs.
  add(contours, LineFamily::SuggestiveContours, -1.0f, -strength[0], -strength[1]);
  add(highlights, LineFamily::SuggestiveHighlights, -1.0f, strength[0], strength[1]);
}

}  // namespace flatland
