// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "core3d/lines/families.h"

namespace flatland {

/// A flat face seen edge-on counts as turned away, all of it, and no isophote runs over a flat
/// face: n.w at its corners differs by roundings.
constexpr float kFlatFacing = 1e-6f;

/// n.w at the corners of a split triangle, 0 within kFlatFacing where the normal is the corner's
/// own. Where a vertex is whole the same number as everywhere.
std::array<float, 3> facingOf(const SeenMesh& sight, const SplitTriangle& split);

/// True if the normals of all corners are known.
bool isKnown(const SplitTriangle& split);

/// An edge between split triangles with n.w on both sides of it.
struct TwoSides {
  std::uint32_t halfEdge;
  float here[2], there[2];  ///< at the first and the second vertex of the half-edge

  bool jumps() const { return here[0] != there[0] || here[1] != there[1]; }
};

/// False if there is nothing on the other side, or nothing known.
bool sidesOf(const SeenMesh& sight, const SharpEdges& sharp, std::uint32_t halfEdge,
             TwoSides& sides);

/// The end of a line of n.w inside a split triangle: where n.w jumps across the edge the lines of
/// its two sides end in nodes of their own.
LineEnd endOnSide(const SeenMesh& sight, const SharpEdges& sharp, std::uint32_t triangle,
                  const EdgePoint& point);

}  // namespace flatland
