// SPDX-License-Identifier: MIT
#include "core3d/lines/feature_lines.h"

#include <algorithm>

#include "core3d/mesh/crease_angles.h"

namespace flatland {
namespace {

// Edges, vertices and free nodes are told apart by the two highest bits.
constexpr LineNode kVertexNode = LineNode{1} << 62;
constexpr LineNode kFreeNode = LineNode{2} << 62;

}  // namespace

std::string_view nameOf(RidgeDerivative derivative) {
  return derivative == RidgeDerivative::ClosedForm ? "closed-form" : "one-ring";
}

LineNode edgeNode(const TriangleMesh& mesh, std::uint32_t halfEdge) {
  return mesh.hasOpposite(halfEdge) ? std::min(halfEdge, mesh.opposite[halfEdge]) : halfEdge;
}

LineNode vertexNode(std::uint32_t vertex) { return kVertexNode | vertex; }

LineNode freeNode(std::uint64_t number) { return kFreeNode | number; }

std::array<double, kLineFamilyCount> LineOptions::defaultThresholds() {
  std::array<double, kLineFamilyCount> thresholds{};
  const auto set = [&thresholds](LineFamily family, double value) {
    thresholds[static_cast<std::size_t>(family)] = value;
  };
  set(LineFamily::ApparentRidges, 2.0);
  set(LineFamily::Ridges, 2.0);
  set(LineFamily::Valleys, 2.0);
  set(LineFamily::SuggestiveContours, 1.0);
  set(LineFamily::SuggestiveHighlights, 1.0);
  set(LineFamily::PrincipalHighlights, 1.0);
  set(LineFamily::Parabolic, 0.1);
  set(LineFamily::ZeroMeanCurvature, 0.1);
  set(LineFamily::Creases, kCreaseDeg);
  return thresholds;
}

}  // namespace flatland
