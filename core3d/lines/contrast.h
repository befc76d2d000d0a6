// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// A curvature on a mesh and the directions (without sign) in which its maxima are looked for.
struct CurvatureField {
  const TriangleMesh& mesh;
  const float* value;    ///< per vertex
  const float* divisor;  ///< the curvature is value / divisor; nullptr: value alone
  const float *rx, *ry, *rz;
  const std::uint8_t* flags;  ///< VertexFlag::kSkipped ends a walk; nullptr: no flags
  float side = 1.0f;          ///< of the divisor; -1: the walk is where it is negative

  Eigen::Vector3f r(std::uint32_t v) const { return {rx[v], ry[v], rz[v]}; }
};

/// How far a curvature has to fall on both sides of a line of maxima, and within what distance:
/// otherwise it is a plain with noise on it and no ridge.
struct Contrast {
  static constexpr float kFall = 0.02f;   ///< share of the curvature on the line
  static constexpr float kReach = 0.25f;  ///< times SurfaceFields::size

  /// By its first derivatives alone: -(second derivative) / curvature that is enough for the fall
  /// within the reach, along a parabola. Costs nothing, and nearly all that is flat fails it.
  static bool mayFall(float fallOfDerivative, float curvature, float reach) {
    return 0.5f * fallOfDerivative * reach * reach >= kFall * curvature;
  }
};

/// True if the curvature, followed from a place inside a triangle along the field of directions,
/// both ways, falls by Contrast::kFall before it rises by as much and within `reach`. Neither noise
/// nor resolution matters to that as long as the noise is smaller. At a border of the mesh, or
/// where a culled cluster says that it is lower, the walk ends in favour of the line.
///
/// Cost: about 10 ns for each triangle passed through.
bool standsOut(const CurvatureField& field, std::uint32_t triangle, const Eigen::Vector3f& place,
               float reach);

/// Answers of standsOut(), kept by the edges that a piece ends on: the next piece of the same line
/// takes over the answer of its neighbour, the one after that asks again. Halves the walks. What is
/// kept depends on the order of the triangles alone.
class ContrastMemory {
 public:
  void clear() { answers_.assign(kSlots, {}); }
  std::optional<bool> recalled(std::uint64_t node) const {
    const Answer& answer = answers_[slot(node)];
    return answer.known && answer.node == node ? std::optional(answer.standsOut) : std::nullopt;
  }
  void keep(std::uint64_t node, bool standsOut) { answers_[slot(node)] = {node, true, standsOut}; }

 private:
  struct Answer {
    std::uint64_t node = 0;
    bool known = false, standsOut = false;
  };
  // Neighbouring triangles are near each other in the walk, so a few thousand suffice.
  static constexpr std::size_t kSlots = 8192;
  static std::size_t slot(std::uint64_t node) { return (node * 0x9e3779b97f4a7c15u) >> 51; }
  std::vector<Answer> answers_ = std::vector<Answer>(kSlots);
};

}  // namespace flatland
