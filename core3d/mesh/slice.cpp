// SPDX-License-Identifier: MIT
#include "core3d/mesh/slice.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace flatland {

namespace {

constexpr double kOnePlace = 1e-9;  // of the mesh's half size; floats are known to 6e-8
constexpr double kAlong = 1e-9;     // w along the normal, as sine

class Slicer {
 public:
  Slicer(const TriangleMesh& mesh, const CutPlane& plane) : mesh_(mesh) {
    heights_.reserve(mesh.vertexCount());
    for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
      heights_.push_back(plane.height(mesh.positionInFile(v)));
    }
    walked_.assign(mesh.triangleCount(), false);
  }

  Slice run() {
    Slice slice;
    // Lines from border to border first: what is left then is closed.
    for (const bool closed : {false, true}) {
      for (std::uint32_t t = 0; t < mesh_.triangleCount(); ++t) {
        const std::uint32_t way = entry(t);
        if (way == TriangleMesh::kNone || walked_[t]) continue;
        if (!closed && mesh_.hasOpposite(way)) continue;
        SliceLine line = walk(t, closed);
        if (line.points.size() < (closed ? 3U : 2U)) {
          ++slice.touched;
        } else {
          slice.lines.push_back(std::move(line));
        }
      }
    }
    return slice;
  }

 private:
  bool above(std::uint32_t vertex) const { return heights_[vertex] >= 0.0; }

  /// The half-edge of a triangle that goes up (or down) through the plane; kNone if it does not
  /// cross. With the outside on the left a line enters over the one that goes up.
  std::uint32_t crossing(std::uint32_t triangle, bool up) const {
    for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
      const bool from = above(mesh_.vertexOf(h));
      const bool to = above(mesh_.vertexOf(TriangleMesh::nextCorner(h)));
      if (from != to && to == up) return h;
    }
    return TriangleMesh::kNone;
  }
  std::uint32_t entry(std::uint32_t triangle) const { return crossing(triangle, true); }

  SlicePoint pointOn(std::uint32_t halfEdge) const {
    const std::uint32_t h =
        mesh_.hasOpposite(halfEdge) ? std::min(halfEdge, mesh_.opposite[halfEdge]) : halfEdge;
    const std::uint32_t a = mesh_.vertexOf(h), b = mesh_.vertexOf(TriangleMesh::nextCorner(h));
    const double share = heights_[a] / (heights_[a] - heights_[b]);
    const Eigen::Vector3d from = mesh_.positionInFile(a), to = mesh_.positionInFile(b);
    // From the nearer end, so that a vertex in the plane is met exactly.
    const Eigen::Vector3d at = share <= 0.5 ? Eigen::Vector3d(from + share * (to - from))
                                            : Eigen::Vector3d(to + (1.0 - share) * (from - to));
    return {at, h, share};
  }

  SliceLine walk(std::uint32_t triangle, bool closed) {
    SliceLine line;
    line.closed = closed;
    const double near = kOnePlace * mesh_.unit;
    line.points.push_back(pointOn(entry(triangle)));
    while (!walked_[triangle]) {
      walked_[triangle] = true;
      const std::uint32_t exit = crossing(triangle, false);
      const SlicePoint next = pointOn(exit);
      if ((next.at - line.points.back().at).norm() > near) {
        line.points.push_back(next);
        line.triangles.push_back(triangle);
      }
      if (!mesh_.hasOpposite(exit)) break;
      triangle = mesh_.opposite[exit] / 3;
    }
    if (closed && line.points.size() > 1) {
      // The last point is where the line began, perhaps but for what was merged on the way.
      line.points.pop_back();
    }
    return line;
  }

  const TriangleMesh& mesh_;
  std::vector<double> heights_;
  std::vector<bool> walked_;
};

}  // namespace

CutPlane planeAcross(const Eigen::Vector3d& through, const Eigen::Vector3d& normal,
                     const Eigen::Vector3d& w) {
  CutPlane plane;
  plane.origin = through;
  plane.normal = normal.normalized();
  Eigen::Vector3d up = w - w.dot(plane.normal) * plane.normal;
  if (!(up.norm() > kAlong * w.norm())) up = plane.normal.unitOrthogonal();
  plane.up = up.normalized();
  plane.right = plane.up.cross(plane.normal).normalized();
  return plane;
}

CutPlane planeAlong(const Eigen::Vector3d& through, const Eigen::Vector3d& direction,
                    const Eigen::Vector3d& w) {
  return planeAcross(through, direction.cross(w), w);
}

double SliceLine::length() const {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i].at - points[i - 1].at).norm();
  if (closed && !points.empty()) sum += (points.front().at - points.back().at).norm();
  return sum;
}

Slice sliceMesh(const TriangleMesh& mesh, const CutPlane& plane) {
  return Slicer(mesh, plane).run();
}

std::vector<Vec2> inPlane(const SliceLine& line, const CutPlane& plane) {
  std::vector<Vec2> points;
  points.reserve(line.points.size());
  for (const SlicePoint& point : line.points) points.push_back(plane.inPlane(point.at));
  return points;
}

}  // namespace flatland
