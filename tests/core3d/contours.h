// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/feature_lines.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland::test {

/// Occluding contours in the plainest way, for tests of what is done with lines: n.w interpolated
/// along the edges, every triangle tried.
inline std::vector<LineSegment> interpolatedContours(const TriangleMesh& mesh,
                                                     const SurfaceFields& fields,
                                                     const SurfaceView& view) {
  const auto facing = [&](std::uint32_t v) {
    return fields.normal(v).cast<double>().dot(view.towardsViewer(mesh.position(v).cast<double>()));
  };
  std::vector<LineSegment> segments;
  for (std::uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    std::vector<LineEnd> ends;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      std::uint32_t a = mesh.vertexOf(h), b = mesh.vertexOf(TriangleMesh::nextCorner(h));
      if (a > b) std::swap(a, b);  // the same arithmetic from both sides
      const double fa = facing(a), fb = facing(b);
      if ((fa > 0.0) == (fb > 0.0)) continue;
      const auto share = static_cast<float>(fa / (fa - fb));
      ends.push_back({mesh.position(a) + share * (mesh.position(b) - mesh.position(a)), 1.0f,
                      edgeNode(mesh, h)});
    }
    if (ends.size() == 2) segments.push_back({ends[0], ends[1], t});
  }
  return segments;
}

}  // namespace flatland::test
