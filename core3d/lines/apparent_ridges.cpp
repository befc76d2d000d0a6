// SPDX-License-Identifier: MIT
// Apparent ridges: maxima of view-dependent curvature along t_A (bibliography: judd2007).
#include <algorithm>
#include <cmath>

#include "core3d/lines/apparent_ridge_parts.h"

namespace flatland {

namespace {

// The derivative of log sqrt(lambda) by length on the screen along t_A. It has the zeros of
// 1/2 D_tA lambda but is nearly straight across a ridge (exactly so where that has the shape of a
// Gaussian), so interpolating it between two vertices puts the line an order of magnitude nearer.
float screenSlope(const SeenVertices& seen, std::uint32_t v) {
  const float lambda = seen.nw[v] * seen.root[v] * seen.nw[v] * seen.root[v];
  return lambda > 0.0f ? std::min(seen.slope[v] / lambda, 1e30f) : 0.0f;
}

}  // namespace

OrientedFace apparentRidgeFace(const SeenMesh& sight, std::uint32_t triangle, bool placing) {
  const auto& v = sight.mesh.triangles[triangle];
  OrientedFace face;
  for (std::size_t k = 0; k < 3; ++k) {
    face.p[k] = sight.mesh.position(v[k]);
    face.r[k] = sight.seen.r(v[k]);
    face.slope[k] = placing ? screenSlope(sight.seen, v[k]) : sight.seen.slope[v[k]];
  }
  return face;
}

float apparentRidgeStrength(const SeenMesh& sight, std::uint32_t a, std::uint32_t b, float t) {
  const SeenVertices& seen = sight.seen;
  const float root = seen.root[a] + t * (seen.root[b] - seen.root[a]);
  const float nw = std::abs(seen.nw[a] + t * (seen.nw[b] - seen.nw[a]));
  return nw > 0.0f ? std::min(sight.size() * root / nw, 1e30f) : 1e30f;
}

RidgeFall apparentRidgeFall(const SeenMesh& sight, std::uint32_t triangle) {
  const SeenVertices& seen = sight.seen;
  const auto& v = sight.mesh.triangles[triangle];
  const bool closedForm = sight.options.derivative == RidgeDerivative::ClosedForm;
  // Of sqrt(lambda), per length on the surface: 1/2 D_tA lambda / (|r| sqrt(lambda)). The one-ring
  // derivative is one per length already.
  RidgeFall fall{{}, 0.0f};
  for (std::size_t k = 0; k < 3; ++k) {
    const float nw = std::abs(seen.nw[v[k]]), root = seen.root[v[k]];
    const float below = closedForm ? nw * nw * root * seen.r(v[k]).norm() : root / nw;
    fall.derivative[k] = below > 0.0f ? seen.slope[v[k]] / below : 0.0f;
    fall.curvature += root / (3.0f * nw);
  }
  return fall;
}

bool apparentRidgeStandsOut(const SeenMesh& sight, std::uint32_t triangle, const Eigen::Vector3f& a,
                            const Eigen::Vector3f& b) {
  const SeenVertices& seen = sight.seen;
  const bool front = (seen.flags[sight.mesh.triangles[triangle][0]] & VertexFlag::kFront) != 0;
  const CurvatureField field{sight.mesh,        seen.root.data(),    seen.nw.data(),
                             seen.rx.data(),    seen.ry.data(),      seen.rz.data(),
                             seen.flags.data(), front ? 1.0f : -1.0f};
  return standsOut(field, triangle, 0.5f * (a + b), Contrast::kReach * sight.size());
}

void addApparentRidge(const SeenMesh& sight, std::uint32_t triangle, ContrastMemory& memory,
                      Segments& out) {
  const auto strengthAt = [&](std::uint32_t a, std::uint32_t b, float t) {
    return apparentRidgeStrength(sight, a, b, t);
  };
  const bool placing =
      !sight.options.unfiltered && sight.options.derivative == RidgeDerivative::ClosedForm;
  const OrientedFace face = apparentRidgeFace(sight, triangle, placing);
  if (sight.options.unfiltered) {
    addOriented(
        sight.mesh, triangle, face, false, false, 0.0f, strengthAt,
        [](const LineEnd&, const LineEnd&) { return true; }, out);
    return;
  }
  const RidgeFall fall = apparentRidgeFall(sight, triangle);
  const float reach = Contrast::kReach * sight.size();
  addOriented(
      sight.mesh, triangle, face, true, sight.options.flatToo,
      sight.threshold(LineFamily::ApparentRidges), strengthAt,
      [&](const LineEnd& a, const LineEnd& b) {
        if (!Contrast::mayFall(fallOfDerivative(face, fall.derivative, a.at, b.at), fall.curvature,
                               reach))
          return false;
        for (const LineNode node : {a.node, b.node}) {
          if (const auto known = memory.recalled(node)) return *known;
        }
        const bool clear = apparentRidgeStandsOut(sight, triangle, a.at, b.at);
        memory.keep(a.node, clear);
        memory.keep(b.node, clear);
        return clear;
      },
      out);
}

void takeOneRingDerivative(const TriangleMesh& mesh, const SurfaceFields& fields,
                           SeenVertices& seen) {
  const auto count = static_cast<std::uint32_t>(mesh.vertexCount());
  std::vector<float> lambda(count);
  for (std::uint32_t v = 0; v < count; ++v) {
    const float q = seen.nw[v] != 0.0f ? seen.root[v] / seen.nw[v] : 0.0f;
    lambda[v] = std::isfinite(q * q) ? q * q : 0.0f;
  }
  for (std::uint32_t v = 0; v < count; ++v) {
    const Eigen::Vector3f r = seen.r(v);
    const float derivative =
        ringDifference(
            mesh, fields.normal(v), r, [&lambda](std::uint32_t u) { return lambda[u]; }, v)
            .derivative;
    const float sign = std::isfinite(derivative) ? std::copysign(1.0f, derivative) : 0.0f;
    seen.slope[v] = sign != 0.0f ? std::abs(derivative) : 0.0f;
    seen.rx[v] = sign * r.x();
    seen.ry[v] = sign * r.y();
    seen.rz[v] = sign * r.z();
    auto flags = static_cast<unsigned>(seen.flags[v] & ~VertexFlag::kOctant);
    flags |= (seen.rx[v] > 0.0f ? 1u : 0u) | (seen.ry[v] > 0.0f ? 2u : 0u) |
             (seen.rz[v] > 0.0f ? 4u : 0u);
    seen.flags[v] = static_cast<std::uint8_t>(flags);
  }
}

}  // namespace flatland
