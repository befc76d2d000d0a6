// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core3d/lines/feature_lines.h"

namespace flatland {

/// Segments of one family and level, end to end.
struct LineChain {
  LineFamily family{};
  std::uint32_t level = 0;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
  std::vector<Eigen::Vector3f> points;  ///< coordinates of the mesh, 2 or more
  std::vector<float> strength;          ///< of each point
  /// The triangle of the piece from point i to the next; as many as there are pieces.
  std::vector<std::uint32_t> triangles;
  std::vector<bool> standsOut;        ///< of each piece, see LineSegment
  std::vector<std::uint32_t> others;  ///< of each piece, see LineSegment; empty: none has one

  std::uint32_t otherOf(std::size_t piece) const {
    return others.empty() ? TriangleMesh::kNone : others[piece];
  }
  std::size_t pieceCount() const { return closed ? points.size() : points.size() - 1; }
};

/// Joins segments that share nodes into chains as long as possible. Every segment is used once;
/// segments between the same two nodes count as one, segments without length are left out, their
/// ends being joined. Where more than two meet, pairs go on straight, the straightest first, if
/// they turn by less than 60 degrees; the others end there. Sorted by level and first node, so the
/// result does not depend on the order or direction of the segments.
///
/// O(n log n) in the segments; a node where any number of them meet as straightPairs says.
std::vector<LineChain> chainSegments(LineFamily family, std::span<const LineSegment> segments);

}  // namespace flatland
