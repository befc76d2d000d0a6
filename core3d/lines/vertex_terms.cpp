// SPDX-License-Identifier: MIT
#include "core3d/lines/vertex_terms.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace flatland {

std::optional<double> SurfaceTerms::offsetShare() const {
  if (feature == 0.0 && offset == 0.0) return std::nullopt;
  if (feature == 0.0) return std::numeric_limits<double>::infinity();
  return std::abs(offset / feature);
}

SurfaceTerms SurfaceTerms::towardsGrowth() const {
  SurfaceTerms turned = *this;
  if (feature + offset + perspective >= 0.0) return turned;
  turned.feature = -feature;
  turned.offset = -offset;
  turned.perspective = -perspective;
  turned.r = -r;
  return turned;
}

std::optional<SurfaceTerms> termsAt(const TriangleMesh& mesh, const SurfaceFields& fields,
                                    const SurfaceView& view, std::uint32_t vertex) {
  const SurfacePoint point = fields.at(mesh, vertex);
  if (point.n.isZero()) return std::nullopt;
  SurfaceTerms terms{};
  const double size = fields.size;
  terms.k1 = point.K(0, 0) * size;
  terms.k2 = point.K(1, 1) * size;
  terms.n = point.n;
  const Eigen::Vector3d w = view.towardsViewer(point.p);
  terms.nw = point.n.dot(w);
  terms.r.setZero();
  if (const auto seen = apparentCurvature(seenFrom(point, w, view.distanceTo(point.p)))) {
    terms.lambda = seen->lambda * size * size;
    const double third = size * size * size;
    terms.feature = seen->feature * third;
    terms.offset = seen->offset * third;
    terms.perspective = seen->perspective * third;
    terms.r = point.frame * seen->r;
  }
  return terms;
}

std::uint32_t SurfaceHit::nearestVertex(const TriangleMesh& mesh) const {
  const auto largest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  return mesh.triangles[triangle][static_cast<std::size_t>(largest)];
}

}  // namespace flatland
