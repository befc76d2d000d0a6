// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flatland {

/// A triangle mesh as plain arrays: an oriented surface, perhaps with borders, in which every
/// vertex has one fan of triangles. buildMesh makes it (build_mesh.h says how); after that
/// nothing changes it. docs/decisions/0018-mesh-arrays.md says why it is laid out like this.
///
/// Positions are normalised so that neither unit nor place of the file matters: the middle of the
/// bounding box is 0 and its longest side is 2. In the file's coordinates a vertex is at
/// origin + unit * (x, y, z).
///
/// Order: vertices along a Hilbert curve through the bounding box, triangles by their smallest
/// vertex, which is their first corner. It depends on the surface alone and not on the order of the
/// file, and neighbours in space are near each other in memory.
///
/// A corner c = 3 t + k is corner k of triangle t, and also the half-edge from there to the next
/// corner of t. Triangles are counter-clockwise seen from the side their normals point to.
struct TriangleMesh {
  std::vector<float> x, y, z;                           ///< of the vertices, each in [-1, 1]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertices

  /// The half-edge of the neighbour that runs the other way; kBorder where there is no neighbour;
  /// kCut where surfaces meet but no neighbour is the one (see build_mesh.h).
  std::vector<std::uint32_t> opposite;
  /// Corners at vertex v, counter-clockwise, without gap: cornersAt[cornerStart[v] ...
  /// cornerStart[v + 1]). If the fan is open, it starts at the half-edge without opposite.
  std::vector<std::uint32_t> cornerStart, cornersAt;

  /// One vertex of the file at the place of this one: the first, where several were welded.
  std::vector<std::uint32_t> fileVertex;
  /// For each vertex of the file the one here, kNone if no triangle uses it. Where one was cut into
  /// several, the first of them.
  std::vector<std::uint32_t> meshVertex;
  std::vector<std::uint32_t> filePolygon;  ///< the face of the file that a triangle is part of

  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< in the unit of the file
  double unit = 1.0;                                 ///< length in the file of 1 here, > 0

  static constexpr std::uint32_t kNone = 0xffffffff;
  static constexpr std::uint32_t kBorder = 0xffffffff;
  static constexpr std::uint32_t kCut = 0xfffffffe;
  static constexpr std::size_t kMaxCorners = 0xfffffff0;

  std::size_t vertexCount() const { return x.size(); }
  std::size_t triangleCount() const { return triangles.size(); }

  Eigen::Vector3f position(std::uint32_t v) const { return {x[v], y[v], z[v]}; }
  Eigen::Vector3d positionInFile(std::uint32_t v) const {
    return origin + unit * position(v).cast<double>();
  }

  static std::uint32_t nextCorner(std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static std::uint32_t previousCorner(std::uint32_t c) { return c % 3 == 0 ? c + 2 : c - 1; }
  std::uint32_t vertexOf(std::uint32_t corner) const { return triangles[corner / 3][corner % 3]; }
  bool hasOpposite(std::uint32_t halfEdge) const { return opposite[halfEdge] < kCut; }

  /// True if the fan of the vertex is open: it lies on a border or on a cut.
  bool isAtEdge(std::uint32_t v) const { return !hasOpposite(cornersAt[cornerStart[v]]); }
};

}  // namespace flatland
