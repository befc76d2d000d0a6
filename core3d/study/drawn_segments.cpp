// SPDX-License-Identifier: MIT
#include "core3d/study/drawn_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core3d/study/line_distances.h"

namespace flatland {

namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// A mark at a joint of the curve lies on the edges of two strips of cells.
constexpr double kOnEdge = 1e-9;

Vector3d middleOf(const TriangleMesh& mesh, std::uint32_t triangle) {
  Vector3d sum = Vector3d::Zero();
  for (const std::uint32_t v : mesh.triangles[triangle]) sum += mesh.position(v).cast<double>();
  return sum / 3.0;
}

// True if the cell of a triangle reaches over t. `turn` is the period of a closed curve, 0 of an
// open one.
bool reachesOver(const std::array<double, 3>& at, double t, double turn) {
  auto [low, high] = std::minmax({at[0], at[1], at[2]});
  if (turn > 0.0 && high - low > 0.5 * turn) {
    // Over the joint of the curve: from the last parameters on to those of the next turn.
    double last = turn, first = 0.0;
    for (const double u : at) {
      if (u > 0.5 * turn) {
        last = std::min(last, u);
      } else {
        first = std::max(first, u);
      }
    }
    return t >= last - kOnEdge || t <= first + kOnEdge;
  }
  return t >= low - kOnEdge && t <= high + kOnEdge;
}

std::vector<std::uint32_t> cellsOver(double t, double turn, const SweptMesh& swept,
                                     const TriangleMesh& mesh) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i) {
    std::array<double, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] = swept.parameters[mesh.fileVertex[mesh.triangles[i][k]]];
    }
    if (reachesOver(at, t, turn)) found.push_back(i);
  }
  return found;
}

// Numbers its nodes one after the other.
class Walk {
 public:
  LineEnd end(const Vector3f& at) { return {at, 1.0f, freeNode(next_++)}; }

 private:
  std::uint64_t next_ = 0;
};

}  // namespace

std::vector<LineSegment> segmentsOf(const Slice& slice, const TriangleMesh& mesh) {
  std::vector<LineSegment> segments;
  Walk walk;
  for (const SliceLine& line : slice.lines) {
    std::vector<LineEnd> ends;
    for (const SlicePoint& point : line.points) {
      ends.push_back(walk.end(((point.at - mesh.origin) / mesh.unit).cast<float>()));
    }
    for (std::size_t i = 0; i < line.triangles.size(); ++i) {
      segments.push_back({ends[i], ends[(i + 1) % ends.size()], line.triangles[i]});
    }
  }
  return segments;
}

std::vector<LineSegment> segmentsOf(const PredictedLine& line, const SweptMesh& swept,
                                    const TriangleMesh& mesh, std::uint32_t level) {
  std::vector<Vector3f> corners = inMeshCoordinates(line.points, mesh);
  if (line.closed && !corners.empty()) corners.push_back(corners.front());
  if (corners.size() < 2 || mesh.triangleCount() == 0) return {};
  // A closed curve ends at a whole number of pieces, one step after its last sample.
  const double last = *std::max_element(swept.parameters.begin(), swept.parameters.end());
  const double turn = std::ceil(last) > last ? std::ceil(last) : 0.0;
  std::vector<std::uint32_t> below = cellsOver(line.t, turn, swept, mesh);
  if (below.empty()) {
    below.resize(mesh.triangleCount());
    std::iota(below.begin(), below.end(), 0u);
  }
  std::vector<Vector3d> middles;
  for (const std::uint32_t triangle : below) middles.push_back(middleOf(mesh, triangle));
  const auto nearest = [&](const Vector3d& p) {
    const auto at = std::min_element(middles.begin(), middles.end(),
                                     [&p](const Vector3d& a, const Vector3d& b) {
                                       return (a - p).squaredNorm() < (b - p).squaredNorm();
                                     });
    return below[static_cast<std::size_t>(at - middles.begin())];
  };
  const double edge = meanEdge(mesh) / mesh.unit;
  std::vector<LineSegment> segments;
  Walk walk;
  const LineEnd first = walk.end(corners.front());
  LineEnd from = first;
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    const Vector3f step = corners[k + 1] - corners[k];
    const int count = std::max(1, static_cast<int>(std::ceil(step.norm() / edge)));
    for (int i = 1; i <= count; ++i) {
      const bool closes = line.closed && k + 2 == corners.size() && i == count;
      const float share = static_cast<float>(i) / static_cast<float>(count);
      const LineEnd to = closes ? first : walk.end(corners[k] + share * step);
      segments.push_back({from, to, nearest((0.5f * (from.at + to.at)).cast<double>()), level});
      from = to;
    }
  }
  return segments;
}

}  // namespace flatland
