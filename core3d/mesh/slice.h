// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core3d/mesh/triangle_mesh.h"
#include "flatland/curve/vec2.h"

namespace flatland {

/// A plane with coordinates of its own, in the unit of the mesh's file: (x, y) is at origin +
/// x right + y up, and right x up = normal. All three are unit vectors.
struct CutPlane {
  Eigen::Vector3d origin, right, up, normal;

  double height(const Eigen::Vector3d& p) const { return normal.dot(p - origin); }
  Vec2 inPlane(const Eigen::Vector3d& p) const {
    return {right.dot(p - origin), up.dot(p - origin)};
  }
  Eigen::Vector3d inSpace(const Vec2& p) const { return origin + p.x() * right + p.y() * up; }
};

/// The plane through a point, across the normal. `up` is the part of w, the direction to the
/// viewer, within the plane: who looks at the section from 90 degrees looks along w as far as the
/// plane allows. Any direction where w is along the normal. Precondition: normal is not 0.
CutPlane planeAcross(const Eigen::Vector3d& through, const Eigen::Vector3d& normal,
                     const Eigen::Vector3d& w);

/// The plane through a point that holds w and another direction, which is not parallel to it.
CutPlane planeAlong(const Eigen::Vector3d& through, const Eigen::Vector3d& direction,
                    const Eigen::Vector3d& w);

/// A place where a cut crosses an edge: share of the way from the start of the half-edge to its
/// end. Neighbouring triangles have the very same one.
struct SlicePoint {
  Eigen::Vector3d at;  ///< in the unit of the file
  std::uint32_t halfEdge;
  double share;
};

/// One line of a section, walked so that the outside of the surface is on the left as seen with
/// right to the right and up upward.
struct SliceLine {
  std::vector<SlicePoint> points;        ///< no two in a row are at one place
  std::vector<std::uint32_t> triangles;  ///< from each point to the next; of a closed line also to
                                         ///< the first, which is not repeated
  bool closed = false;

  double length() const;
};

struct Slice {
  std::vector<SliceLine> lines;  ///< by their first triangle; open ones first
  std::size_t touched = 0;       ///< lines that are a single point, which are left out
};

/// The section of a mesh by a plane. A vertex in the plane counts as above it, so that each
/// triangle is crossed by two edges or none: every line is closed or goes from border to border,
/// without gap or branch, whatever lies in the plane. Of triangles in the plane only the edges to
/// what is below are a line. Points nearer to each other than 1e-9 of the mesh's size become one.
///
/// Cost: one pass over the triangles.
Slice sliceMesh(const TriangleMesh& mesh, const CutPlane& plane);

/// The points of a line in the plane's coordinates.
std::vector<Vec2> inPlane(const SliceLine& line, const CutPlane& plane);

}  // namespace flatland
