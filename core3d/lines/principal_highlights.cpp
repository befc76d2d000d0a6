// SPDX-License-Identifier: MIT
// Principal highlights: maxima of n.w along the direction of the larger curvature, which is where
// w_T is along the other principal direction (bibliography: decarlo2007).
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core3d/lines/families.h"

namespace flatland {

void seeHighlights(const TriangleMesh& mesh, const SurfaceFields& fields, const SurfaceView& view,
                   SeenVertices& highlights) {
  const auto count = static_cast<std::uint32_t>(mesh.vertexCount());
  highlights.resize(count, {.ridges = true});
  for (std::uint32_t v = 0; v < count; ++v) {
    const Eigen::Vector3d at = mesh.position(v).cast<double>();
    const Eigen::Vector3f w = view.towardsViewer(at).cast<float>(), n = fields.normal(v);
    const float nw = n.dot(w);
    const bool second = std::abs(fields.k2[v]) > std::abs(fields.k1[v]);
    const float k = second ? fields.k2[v] : fields.k1[v];
    const Eigen::Vector3f e = second ? fields.e2(v) : fields.e1(v);
    const auto distance = view.distanceTo(at);
    // D_e (n.w) = K(e, w) + n.D_e w, with D_e w = -(e - w (w.e)) / d.
    const float turning = distance && *distance > 0.0 ? nw / static_cast<float>(*distance) : 0.0f;
    const float derivative = (k + turning) * e.dot(w);
    const float sign = std::isfinite(derivative) ? std::copysign(1.0f, derivative) : 0.0f;
    highlights.nw[v] = nw;
    highlights.root[v] = std::abs(k);
    highlights.slope[v] = sign != 0.0f ? std::abs(derivative) : 0.0f;
    highlights.rx[v] = sign * e.x();
    highlights.ry[v] = sign * e.y();
    highlights.rz[v] = sign * e.z();
    const unsigned flags = (sign * e.x() > 0.0f ? 1u : 0u) | (sign * e.y() > 0.0f ? 2u : 0u) |
                           (sign * e.z() > 0.0f ? 4u : 0u) | (nw > 0.0f ? VertexFlag::kFront : 0u) |
                           (second ? VertexFlag::kRadial : 0u) |
                           (n.squaredNorm() > kKnownNormalSq ? VertexFlag::kKnown : 0u);
    highlights.flags[v] = static_cast<std::uint8_t>(flags);
  }
}

void addPrincipalHighlight(const SeenMesh& sight, const SeenVertices& highlights,
                           std::uint32_t triangle, Segments& out) {
  const auto& v = sight.mesh.triangles[triangle];
  // Seen from behind, |n.w| grows where n.w falls.
  const float side = highlights.flags[v[0]] & VertexFlag::kFront ? 1.0f : -1.0f;
  OrientedFace face;
  for (std::size_t k = 0; k < 3; ++k) {
    face.p[k] = sight.mesh.position(v[k]);
    face.r[k] = side * highlights.r(v[k]);
    face.slope[k] = highlights.slope[v[k]];
  }
  const bool all = sight.options.unfiltered;
  addOriented(
      sight.mesh, triangle, face, !all, false,
      all ? 0.0f : sight.threshold(LineFamily::PrincipalHighlights),
      [&](std::uint32_t a, std::uint32_t b, float t) {
        return sight.size() * (highlights.root[a] + t * (highlights.root[b] - highlights.root[a]));
      },
      [](const LineEnd&, const LineEnd&) { return true; }, out);
}

}  // namespace flatland
