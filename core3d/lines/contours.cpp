// SPDX-License-Identifier: MIT
// Occluding contours: n.w = 0 for the interpolated normal (bibliography: hertzmann2000), and where
// the surface is creased the edges between what is turned to the viewer and what is not.
#include <array>

#include "core3d/lines/split_facing.h"

namespace flatland {
namespace {

// Adds the parts of an edge on which `wanted(front here, front there)`. They end at its vertices or
// where n.w of one side is zero, in the node in which a contour inside that side's triangle ends.
template <typename Wanted>
void addParts(const TriangleMesh& mesh, const TwoSides& sides, float strength, const Wanted& wanted,
              Segments& out) {
  const std::uint32_t h = sides.halfEdge, other = mesh.opposite[h];
  const std::uint32_t a = mesh.vertexOf(h), b = mesh.vertexOf(TriangleMesh::nextCorner(h));
  const Eigen::Vector3f from = mesh.position(a), way = mesh.position(b) - from;
  struct Stop {
    float t;
    LineNode node;
    bool ofHere;
  };
  Stop stops[2];
  int count = 0;
  const auto stop = [&](const float(&f)[2], std::uint32_t half, bool ofHere) {
    if ((f[0] > 0.0f) != (f[1] > 0.0f))
      stops[count++] = {f[0] / (f[0] - f[1]), sideNode(half), ofHere};
  };
  stop(sides.here, h, true);
  stop(sides.there, other, false);
  if (count == 2 && stops[1].t < stops[0].t) std::swap(stops[0], stops[1]);
  bool here = sides.here[0] > 0.0f, there = sides.there[0] > 0.0f;
  LineEnd begin{from, strength, vertexNode(a)};
  for (int i = 0; i <= count; ++i) {
    const LineEnd end = i < count ? LineEnd{from + stops[i].t * way, strength, stops[i].node}
                                  : LineEnd{mesh.position(b), strength, vertexNode(b)};
    if (wanted(here, there)) {
      const std::uint32_t front = here ? h : other;
      out.push_back({begin, end, front / 3, 0, true, mesh.opposite[front] / 3});
    }
    if (i < count) (stops[i].ofHere ? here : there) ^= true;
    begin = end;
  }
}

}  // namespace

void addContour(const SeenMesh& sight, std::uint32_t triangle, Segments& out) {
  const auto& v = sight.mesh.triangles[triangle];
  const float nw[3] = {sight.seen.nw[v[0]], sight.seen.nw[v[1]], sight.seen.nw[v[2]]};
  const Crossings found = zeroCrossings(nw);
  if (found.count == 2)
    addPiece(sight.mesh, triangle, {found.points[0], found.points[1]}, {1.0f, 1.0f}, 0.0f, nullptr,
             out);
}

void addSplitContours(const SeenMesh& sight, const SharpEdges& sharp, Segments& out) {
  for (const SplitTriangle& split : sharp.triangles()) {
    if (!isKnown(split)) continue;
    const std::array<float, 3> facing = facingOf(sight, split);
    LineEnd ends[2];
    const Crossings found = zeroCrossings({facing[0], facing[1], facing[2]});
    for (int i = 0; i < found.count; ++i)
      ends[i] = endOnSide(sight, sharp, split.triangle, found.points[i]);
    if (found.count == 2) out.push_back({ends[0], ends[1], split.triangle});
  }
  for (const SharpEdge& edge : sharp.edges()) {
    TwoSides sides;
    if (!sidesOf(sight, sharp, edge.halfEdge, sides)) continue;
    addParts(
        sight.mesh, sides, 1.0f, [](bool here, bool there) { return here != there; }, out);
  }
}

void addSeenEdges(const SeenMesh& sight, const SharpEdges& sharp, Segments& out) {
  for (const SharpEdge& edge : sharp.edges()) {
    TwoSides sides;
    if (!sidesOf(sight, sharp, edge.halfEdge, sides)) continue;
    const bool sheet = sight.sheets.has(edge.halfEdge / 3);
    addParts(
        sight.mesh, sides, kSharpStrength,
        [sheet](bool here, bool there) { return here == there && (here || sheet); }, out);
  }
}

}  // namespace flatland
