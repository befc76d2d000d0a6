// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace flatland {

/// What a mesh file says, before anything is checked or repaired: points, and polygons of any
/// number of corners. Every reader of core3d/io and every generator of meshes makes one; buildMesh
/// takes it from there.
///
/// Promised by whoever makes one: coordinates are finite, corners are vertices that exist, a
/// polygon has three corners or more.
struct PolygonSoup {
  std::vector<double> positions;       ///< x, y, z of each vertex, in the unit of the file
  std::vector<std::uint32_t> corners;  ///< vertices of all polygons, one polygon after the other
  /// Where each polygon ends in `corners`. Empty as long as all of them are triangles.
  std::vector<std::uint32_t> ends;
  std::vector<std::string> notes;  ///< what the reader passed over, one sentence each

  std::size_t vertexCount() const { return positions.size() / 3; }
  std::size_t polygonCount() const { return ends.empty() ? corners.size() / 3 : ends.size(); }
  std::span<const std::uint32_t> polygon(std::size_t i) const;

  void addVertex(double x, double y, double z);
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  /// Precondition: three corners or more. Throws InputError when there are more corners than the
  /// program can number.
  void addPolygon(std::span<const std::uint32_t> polygon);

  /// The triangles of a strip, every second one turned round. Those that use a vertex twice, with
  /// which strips are stitched together, are left out. A strip of less than three is nothing.
  void addStrip(std::span<const std::uint32_t> strip);

  /// The triangles of a fan about its first vertex; those that use a vertex twice are left out.
  void addFan(std::span<const std::uint32_t> fan);
};

}  // namespace flatland
