// SPDX-License-Identifier: MIT
// Parabolic lines, K = 0, and the lines of zero mean curvature, H = 0.
#include <algorithm>
#include <cmath>

#include "core3d/lines/families.h"

namespace flatland {
namespace {

template <typename Function, typename Strength>
Segments zerosOf(const TriangleMesh& mesh, const SurfaceFields& fields, const Function& function,
                 const Strength& strength) {
  Segments out;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& v = mesh.triangles[t];
    const Crossings found = zeroCrossings({function(v[0]), function(v[1]), function(v[2])});
    if (found.count != 2) continue;
    if (std::any_of(v.begin(), v.end(), [&](std::uint32_t u) {
          return !(fields.normal(u).squaredNorm() > kKnownNormalSq);
        }))
      continue;
    float at[2];
    for (int i = 0; i < 2; ++i) {
      const auto corner = static_cast<std::size_t>(found.points[i].corner);
      at[i] = found.points[i].between(strength(v[corner]), strength(v[(corner + 1) % 3])) *
              static_cast<float>(fields.size);
    }
    addPiece(mesh, t, {found.points[0], found.points[1]}, {at[0], at[1]}, 0.0f, nullptr, out);
  }
  return out;
}

}  // namespace

Segments findParabolic(const TriangleMesh& mesh, const SurfaceFields& fields) {
  return zerosOf(
      mesh, fields, [&](std::uint32_t v) { return fields.k1[v] * fields.k2[v]; },
      [&](std::uint32_t v) { return std::max(std::abs(fields.k1[v]), std::abs(fields.k2[v])); });
}

Segments findZeroMeanCurvature(const TriangleMesh& mesh, const SurfaceFields& fields) {
  return zerosOf(
      mesh, fields, [&](std::uint32_t v) { return fields.k1[v] + fields.k2[v]; },
      [&](std::uint32_t v) { return 0.5f * (fields.k1[v] - fields.k2[v]); });
}

}  // namespace flatland
