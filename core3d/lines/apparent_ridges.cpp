// SPDX-License-Identifier: MIT
// Apparent ridges: maxima of view-dependent curvature along t_A (bibliography: judd2007).
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core3d/lines/contrast.h"
#include "core3d/lines/families.h"

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

void addApparentRidge(const SeenMesh& sight, std::uint32_t triangle, ContrastMemory& memory,
                      Segments& out) {
  const SeenVertices& seen = sight.seen;
  const auto& v = sight.mesh.triangles[triangle];
  OrientedFace face;
  for (std::size_t k = 0; k < 3; ++k) {
    face.p[k] = sight.mesh.position(v[k]);
    face.r[k] = seen.r(v[k]);
    face.slope[k] = seen.slope[v[k]];
  }
  const auto strengthAt = [&](std::uint32_t a, std::uint32_t b, float t) {
    const float root = seen.root[a] + t * (seen.root[b] - seen.root[a]);
    const float nw = std::abs(seen.nw[a] + t * (seen.nw[b] - seen.nw[a]));
    return nw > 0.0f ? std::min(sight.size() * root / nw, 1e30f) : 1e30f;
  };
  if (sight.options.unfiltered) {
    addOriented(
        sight.mesh, triangle, face, false, false, 0.0f, strengthAt,
        [](const LineEnd&, const LineEnd&) { return true; }, out);
    return;
  }
  const CurvatureField field{sight.mesh,     seen.root.data(), seen.nw.data(),   seen.rx.data(),
                             seen.ry.data(), seen.rz.data(),   seen.flags.data()};
  const float reach = Contrast::kReach * sight.size();
  const bool closedForm = sight.options.derivative == RidgeDerivative::ClosedForm;
  // Of sqrt(lambda), per length on the surface: 1/2 D_tA lambda / (|r| sqrt(lambda)). The one-ring
  // derivative is one per length already.
  float derivative[3], curvature = 0.0f;
  for (std::size_t k = 0; k < 3; ++k) {
    const float nw = seen.nw[v[k]], root = seen.root[v[k]];
    const float below = closedForm ? nw * nw * root * face.r[k].norm() : root / nw;
    derivative[k] = below > 0.0f ? face.slope[k] / below : 0.0f;
    curvature += root / (3.0f * nw);
  }
  if (closedForm) {
    for (std::size_t k = 0; k < 3; ++k) face.slope[k] = screenSlope(seen, v[k]);
  }
  addOriented(
      sight.mesh, triangle, face, true, sight.options.flatToo,
      sight.threshold(LineFamily::ApparentRidges), strengthAt,
      [&](const LineEnd& a, const LineEnd& b) {
        if (!Contrast::mayFall(fallOfDerivative(face, derivative, a.at, b.at), curvature, reach))
          return false;
        for (const LineNode node : {a.node, b.node}) {
          if (const auto known = memory.recalled(node)) return *known;
        }
        const bool clear = standsOut(field, triangle, 0.5f * (a.at + b.at), reach);
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
    const Eigen::Vector3f p = mesh.position(v), r = seen.r(v);
    const Eigen::Vector3f across = fields.normal(v).cross(r).normalized();
    float sum = 0.0f;
    int sides = 0;
    for (std::uint32_t i = mesh.cornerStart[v]; i < mesh.cornerStart[v + 1]; ++i) {
      const std::uint32_t next = TriangleMesh::nextCorner(mesh.cornersAt[i]);
      const std::uint32_t a = mesh.vertexOf(next),
                          b = mesh.vertexOf(TriangleMesh::nextCorner(next));
      const float sa = across.dot(mesh.position(a) - p), sb = across.dot(mesh.position(b) - p);
      if ((sa > 0.0f) == (sb > 0.0f)) continue;
      const float t = sa / (sa - sb);
      const Eigen::Vector3f way = mesh.position(a) + t * (mesh.position(b) - mesh.position(a)) - p;
      const float distance = way.norm();
      if (!(distance > 0.0f)) continue;
      const float difference = lambda[a] + t * (lambda[b] - lambda[a]) - lambda[v];
      sum += (way.dot(r) > 0.0f ? difference : -difference) / distance;
      ++sides;
    }
    const float derivative = sides > 0 ? 0.5f * sum / static_cast<float>(sides) : 0.0f;
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
