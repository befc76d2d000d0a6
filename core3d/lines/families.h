// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core3d/lines/contrast.h"
#include "core3d/lines/crossings.h"
#include "core3d/lines/feature_lines.h"
#include "core3d/lines/seen_vertices.h"
#include "core3d/lines/sharp_edges.h"
#include "core3d/mesh/pieces.h"

// The families of lines, each in a file of its own. Part of LineFinder, which walks over the mesh
// once and calls those of the view for the triangles whose flags say that something may be there.
// Definitions, signs and thresholds: docs/math/lines.md.

namespace flatland {

using Segments = std::vector<LineSegment>;

/// What a family looks at in one view.
struct SeenMesh {
  const TriangleMesh& mesh;
  const SurfaceFields& fields;
  const SurfaceView& view;
  const LineOptions& options;
  const SeenVertices& seen;
  const Sheets& sheets;

  /// True if a triangle whose corners agree on the side that faces the viewer shows one: its front,
  /// or on a sheet either. `front`: kFront of the corners.
  bool shows(std::uint32_t triangle, bool allFront, bool someFront) const {
    return allFront || (!someFront && sheets.has(triangle));
  }
  float size() const { return static_cast<float>(fields.size); }
  float threshold(LineFamily family) const {
    return static_cast<float>(options.thresholdOf(family));
  }
};

/// A sharp edge is the limit of a rounded one, so it is a ridge (convex), a valley (concave) and an
/// apparent ridge (both sides turned to the viewer). Its strength is that of an edge rounded by a
/// hundredth of the surface's size, less than is seen.
constexpr float kSharpStrength = 100.0f;

/// Contours of all split triangles, and of the sharp edges between them where one side is turned to
/// the viewer and the other is not. With those of addContour they are closed wherever the mesh is.
void addSplitContours(const SeenMesh& sight, const SharpEdges& sharp, Segments& out);
/// Isophotes of all split triangles, each side of a sharp edge by its own normals.
void addSplitIsophotes(const SeenMesh& sight, const SharpEdges& sharp, Segments& out);
/// The sharp edges, as far as both sides are turned to the viewer, or on a sheet away from him.
void addSeenEdges(const SeenMesh& sight, const SharpEdges& sharp, Segments& out);

// Of the view, for one triangle.
void addContour(const SeenMesh& sight, std::uint32_t triangle, Segments& out);
/// Suggestive contours and suggestive highlights; nullptr: not wanted.
void addSuggestive(const SeenMesh& sight, std::uint32_t triangle, Segments* contours,
                   Segments* highlights);
void addApparentRidge(const SeenMesh& sight, std::uint32_t triangle, ContrastMemory& memory,
                      Segments& out);
void addIsophotes(const SeenMesh& sight, std::uint32_t triangle, Segments& out);
void addPrincipalHighlight(const SeenMesh& sight, const SeenVertices& highlights,
                           std::uint32_t triangle, Segments& out);

/// Replaces slope and r of vertices by what the thesis practised: the difference quotient of lambda
/// to the one-ring along t_A and against it, slope = half of it per length on the surface. Needs
/// everything of seeVertices() everywhere.
void takeOneRingDerivative(const TriangleMesh& mesh, const SurfaceFields& fields,
                           SeenVertices& seen);

/// Per vertex for principal highlights: the direction of the larger |curvature|, along which n.w
/// grows by slope (r, slope), its curvature (root), and flags; kRadial tells e2 from e1.
void seeHighlights(const TriangleMesh& mesh, const SurfaceFields& fields, const SurfaceView& view,
                   SeenVertices& highlights);

// Of the mesh alone, whole.
Segments findRidges(const TriangleMesh& mesh, const SurfaceFields& fields, bool valleys,
                    bool unfiltered);
Segments findParabolic(const TriangleMesh& mesh, const SurfaceFields& fields);
Segments findZeroMeanCurvature(const TriangleMesh& mesh, const SurfaceFields& fields);
/// Edges whose triangles turn by more than 0 and at least so much.
Segments findCreases(const TriangleMesh& mesh, double leastDeg);
Segments findBoundaries(const TriangleMesh& mesh);
/// Where triangles that share no vertex pass through each other's planes by more than rounding. Not
/// found: a sheet that is pierced exactly along a chain of mesh edges, each of whose triangles lies
/// on one side.
Segments findSelfIntersections(const TriangleMesh& mesh);
/// The sharp edges, convex or concave.
Segments findSharpEdges(const TriangleMesh& mesh, const SharpEdges& sharp, bool convex);
Segments findTopographic(const TriangleMesh& mesh, const Eigen::Vector3d& up, int levels);

/// The end of a piece at a point of an edge.
LineEnd endAt(const TriangleMesh& mesh, std::uint32_t triangle, const EdgePoint& point,
              float strength);

/// Nodes that are no crossing of an edge by itself: one inside each triangle, and one on each side
/// of each edge, where lines of the two sides cross it at different places. No two are the same.
inline LineNode innerNode(const TriangleMesh& mesh, std::uint32_t triangle) {
  return freeNode(std::uint64_t{3} * mesh.triangleCount() + triangle);
}
inline LineNode sideNode(std::uint32_t halfEdge) { return freeNode(halfEdge); }

/// Adds the piece of a line between two edges of a triangle; with `nw` (per vertex) only as far as
/// side * n.w > 0. Does nothing if neither end reaches the threshold.
void addPiece(const TriangleMesh& mesh, std::uint32_t triangle, const EdgePoint (&points)[2],
              const float (&strength)[2], float threshold, const float* nw, Segments& out,
              std::uint32_t level = 0, float side = 1.0f);

/// The maxima among the oriented crossings of a triangle, or all of them. `strengthAt(a, b, t)` is
/// the strength between two vertices, `standsOut(a, b)` has the last word on a piece between two
/// ends, or with `flatToo` marks it.
template <typename Strength, typename Accepts>
void addOriented(const TriangleMesh& mesh, std::uint32_t triangle, const OrientedFace& face,
                 bool maximaOnly, bool flatToo, float threshold, const Strength& strengthAt,
                 const Accepts& standsOut, Segments& out) {
  const Crossings found = orientedCrossings(face);
  if (found.count == 0 || (maximaOnly && !directionsAgree(face))) return;
  const auto& v = mesh.triangles[triangle];
  LineEnd ends[3];
  for (int i = 0; i < found.count; ++i) {
    const EdgePoint& point = found.points[i];
    ends[i] = endAt(mesh, triangle, point,
                    strengthAt(v[static_cast<std::size_t>(point.corner)],
                               v[static_cast<std::size_t>((point.corner + 1) % 3)], point.t));
  }
  if (found.count == 2) {
    const auto& [a, b, unused] = ends;
    if (!(std::max(a.strength, b.strength) >= threshold)) return;
    if (maximaOnly && !isMaximum(face, a.at, b.at)) return;
    const bool clear = standsOut(a, b);
    if (clear || flatToo) out.push_back({a, b, triangle, 0, clear});
    return;
  }
  const LineEnd middle{(face.p[0] + face.p[1] + face.p[2]) / 3.0f,
                       (ends[0].strength + ends[1].strength + ends[2].strength) / 3.0f,
                       innerNode(mesh, triangle)};
  for (int i = 0; i < 3; ++i) {
    if (!(std::max(ends[i].strength, middle.strength) >= threshold)) continue;
    const int a = found.points[i].corner, b = (a + 1) % 3;
    if (maximaOnly && !(pointsTowards(face.p[a], face.r[a], ends[i].at, middle.at) &&
                        pointsTowards(face.p[b], face.r[b], ends[i].at, middle.at)))
      continue;
    const bool clear = standsOut(ends[i], middle);
    if (clear || flatToo) out.push_back({ends[i], middle, triangle, 0, clear});
  }
}

}  // namespace flatland
