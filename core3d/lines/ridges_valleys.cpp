// SPDX-License-Identifier: MIT
// Ridges: maxima of k1 along e1 with k1 > |k2|; valleys: minima of k2 along e2 with -k2 > |k1|
// (bibliography: ohtake2004). A valley is a ridge of the other side.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core3d/lines/contrast.h"
#include "core3d/lines/families.h"

namespace flatland {

Segments findRidges(const TriangleMesh& mesh, const SurfaceFields& fields, bool valleys,
                    bool unfiltered) {
  const auto count = static_cast<std::uint32_t>(mesh.vertexCount());
  std::vector<float> value(count), other(count), slope(count), rx(count), ry(count), rz(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const Eigen::Vector3f e = valleys ? fields.e2(v) : fields.e1(v);
    const float derivative = valleys ? -fields.c222[v] : fields.c111[v];
    const float sign = std::isfinite(derivative) ? std::copysign(1.0f, derivative) : 0.0f;
    value[v] = valleys ? -fields.k2[v] : fields.k1[v];
    other[v] = std::abs(valleys ? fields.k1[v] : fields.k2[v]);
    slope[v] = sign != 0.0f ? std::abs(derivative) : 0.0f;
    rx[v] = sign * e.x();
    ry[v] = sign * e.y();
    rz[v] = sign * e.z();
  }
  const CurvatureField field{mesh, value.data(), nullptr, rx.data(), ry.data(), rz.data(), nullptr};
  const auto size = static_cast<float>(fields.size);
  const float reach = Contrast::kReach * size;
  Segments out;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& v = mesh.triangles[t];
    OrientedFace face;
    float derivative[3];
    for (std::size_t k = 0; k < 3; ++k) {
      face.p[k] = mesh.position(v[k]);
      face.r[k] = field.r(v[k]);
      // Of the logarithm, which is straighter across a ridge.
      const float total = value[v[k]] * value[v[k]] + other[v[k]] * other[v[k]];
      derivative[k] = slope[v[k]];
      face.slope[k] = total > 0.0f ? derivative[k] / std::sqrt(total) : 0.0f;
    }
    // Where the other curvature wins, the strength is negative: no threshold lets it pass.
    const auto strengthAt = [&](std::uint32_t a, std::uint32_t b, float s) {
      const float here = value[a] + s * (value[b] - value[a]);
      const float there = other[a] + s * (other[b] - other[a]);
      return here > there || unfiltered ? size * here : -1.0f;
    };
    addOriented(
        mesh, t, face, !unfiltered, true,
        unfiltered ? -std::numeric_limits<float>::infinity() : 0.0f, strengthAt,
        [&](const LineEnd& a, const LineEnd& b) {
          if (unfiltered) return true;
          const float curvature = (value[v[0]] + value[v[1]] + value[v[2]]) / 3.0f;
          return Contrast::mayFall(fallOfDerivative(face, derivative, a.at, b.at), curvature,
                                   reach) &&
                 standsOut(field, t, 0.5f * (a.at + b.at), reach);
        },
        out);
  }
  return out;
}

}  // namespace flatland
