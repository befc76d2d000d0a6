// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// The neighbours of every vertex in one array, and which vertices stop rings from growing.
struct VertexNeighbours {
  std::vector<std::uint32_t> start;     ///< of vertex v, in `vertices`; one more than vertices
  std::vector<std::uint32_t> vertices;  ///< counter-clockwise round v
  std::vector<char> onCrease;           ///< a triangle edge here has a sharp dihedral angle

  explicit VertexNeighbours(const TriangleMesh& mesh);

  std::span<const std::uint32_t> of(std::uint32_t v) const {
    return {vertices.data() + start[v], vertices.data() + start[v + 1]};
  }
};

/// Rings of vertices round one vertex, grown one by one. Owns buffers: one for each thread, used
/// for one vertex after the other.
class VertexRings {
 public:
  explicit VertexRings(const VertexNeighbours& neighbours);

  /// Ring 0: the vertex alone. Rings reach vertices on a crease and stop there, except at v itself.
  void startAt(std::uint32_t v);
  /// Adds the next ring; it is empty where the surface ends.
  void grow();

  int rings() const { return static_cast<int>(ends_.size()) - 1; }
  std::span<const std::uint32_t> ring(int k) const;

 private:
  const VertexNeighbours& neighbours_;
  std::vector<std::uint32_t> seenBy_;   // the round in which a vertex was reached last
  std::vector<std::uint32_t> reached_;  // ring after ring, then room for more
  std::vector<std::size_t> ends_;       // of the rings
  std::uint32_t round_ = 0;
};

}  // namespace flatland
