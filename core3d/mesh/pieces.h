// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// How far a piece of a surface (its triangles connected over edges) bounds a body. Lengths are
/// those of the mesh.
struct PieceShape {
  double area = 0.0;
  /// Area of what would close each connected part of the border, however jagged; 0 if there is
  /// none.
  double holes = 0.0;
  /// Enclosed once each part of the border is joined to its middle; negative if inside out.
  double volume = 0.0;

  /// True if one side of it is the outside: the holes are at most 0.3 of the area, and the volume,
  /// at least 0.2 of their area^1.5, does not hang on how they are filled. So for a bust that
  /// stands open at the bottom, a scan with holes or a tube, not for a relief or a mask, which may
  /// bulge either way.
  bool hasOutside() const;
  /// True if the holes, more than 0.1 of the area, let a viewer see much of both sides: a relief, a
  /// mask, a tube.
  bool isSheet() const;
};

/// Collects into `piece` the triangles that are connected with `from` over edges; `seen` holds, by
/// triangle, what is collected already. `reached(h)` is told the half-edge over which each triangle
/// but the first is reached, in order. O(triangles of the piece).
template <typename Reached>
void collectPiece(const TriangleMesh& mesh, std::uint32_t from, std::vector<char>& seen,
                  std::vector<std::uint32_t>& piece, const Reached& reached) {
  piece.assign(1, from);
  seen[from] = 1;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (std::uint32_t h = 3 * piece[i]; h < 3 * piece[i] + 3; ++h) {
      if (!mesh.hasOpposite(h)) continue;
      const std::uint32_t neighbour = mesh.opposite[h] / 3;
      if (seen[neighbour]) continue;
      seen[neighbour] = 1;
      reached(h);
      piece.push_back(neighbour);
    }
  }
}

/// Precondition: a triangle at least. `turned[t]` not 0: triangle t counts the other way round;
/// empty: none does. O(n) and O(b log b) for b edges of the border.
PieceShape shapeOf(const TriangleMesh& mesh, std::span<const std::uint32_t> piece,
                   std::span<const char> turned);

/// Where the surface is a sheet: a piece that is not nearly closed, of which a viewer may see
/// either side. Which side the normal is on is a convention there.
class Sheets {
 public:
  /// No sheet anywhere.
  Sheets() = default;
  /// O(triangles), and O(b log b) for b edges of borders.
  explicit Sheets(const TriangleMesh& mesh);

  bool has(std::uint32_t triangle) const { return !of_.empty() && of_[triangle] != 0; }

 private:
  std::vector<std::uint8_t> of_;  // by triangle; empty if there is none
};

}  // namespace flatland
