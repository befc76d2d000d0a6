// SPDX-License-Identifier: MIT
#include "core3d/study/line_distances.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace flatland {

double meanEdge(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum += static_cast<double>((mesh.position(t[k]) - mesh.position(t[(k + 1) % 3])).norm());
    }
  }
  return mesh.unit * sum / (3.0 * static_cast<double>(mesh.triangleCount()));
}

MeasuredPiece pieceOf(const TriangleMesh& mesh, const LineSegment& segment) {
  const Eigen::Vector3d a = segment.a.at.cast<double>(), b = segment.b.at.cast<double>();
  return {mesh.origin + mesh.unit * (0.5 * (a + b)), mesh.unit * (b - a).norm(), 0.0};
}

double distancePercentile(std::vector<MeasuredPiece>& pieces, double share) {
  std::sort(pieces.begin(), pieces.end(),
            [](const MeasuredPiece& a, const MeasuredPiece& b) { return a.distance < b.distance; });
  const double all =
      std::accumulate(pieces.begin(), pieces.end(), 0.0,
                      [](double sum, const MeasuredPiece& p) { return sum + p.length; });
  double below = 0.0;
  for (const MeasuredPiece& piece : pieces) {
    below += piece.length;
    if (below >= share * all) return piece.distance;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace flatland
