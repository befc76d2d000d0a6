// SPDX-License-Identifier: MIT
#include "core3d/mesh/build_mesh.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core3d/mesh/triangulate.h"
#include "core3d/mesh/vertex_order.h"
#include "core3d/mesh/winding.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Leaves out triangles with a repeated vertex or with the vertices of another one, and orders the
// rest by their vertices, the smallest first. Keeps `polygonOf` in step.
void orderTriangles(std::vector<Triangle>& triangles, std::vector<std::uint32_t>& polygonOf,
                    std::size_t vertices, MeshReport& report) {
  // Buckets by smallest vertex.
  std::vector<std::uint32_t> start(vertices + 1, 0);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [a, b, c] = triangles[i];
    if (a == b || b == c || c == a) continue;
    if (a < b && a < c) {
      triangles[kept] = {a, b, c};
    } else if (b < c) {
      triangles[kept] = {b, c, a};
    } else {
      triangles[kept] = {c, a, b};
    }
    ++start[triangles[kept][0] + 1];
    polygonOf[kept++] = polygonOf[i];
  }
  report.collapsedTriangles = triangles.size() - kept;
  for (std::size_t v = 0; v < vertices; ++v) start[v + 1] += start[v];
  struct Entry {
    std::uint32_t small, large;  // the other two vertices
    std::uint32_t polygon;
    bool turned;  // the large one comes first
  };
  std::vector<Entry> entries(kept);
  {
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < kept; ++i) {
      const auto [a, b, c] = triangles[i];
      entries[fill[a]++] = {std::min(b, c), std::max(b, c), polygonOf[i], b > c};
    }
  }
  std::size_t out = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto begin = entries.begin() + start[v], end = entries.begin() + start[v + 1];
    // Of duplicates one winding stays wherever it stands in the file, and the first of those.
    std::sort(begin, end, [](const Entry& p, const Entry& q) {
      return std::tie(p.small, p.large, p.turned, p.polygon) <
             std::tie(q.small, q.large, q.turned, q.polygon);
    });
    for (auto i = begin; i != end; ++i) {
      if (i != begin && i->small == (i - 1)->small && i->large == (i - 1)->large) continue;
      const auto first = static_cast<std::uint32_t>(v);
      triangles[out] =
          i->turned ? Triangle{first, i->large, i->small} : Triangle{first, i->small, i->large};
      polygonOf[out++] = i->polygon;
    }
  }
  report.duplicateTriangles = kept - out;
  triangles.resize(out);
  polygonOf.resize(out);
}

// Finds for every half-edge the other one on its edge, whichever way that runs.
void matchEdges(TriangleMesh& mesh, MeshReport& report) {
  struct Side {
    std::uint32_t far;  // the larger vertex of the edge
    std::uint32_t halfEdge;
  };
  const std::size_t halfEdges = 3 * mesh.triangles.size();
  std::vector<std::uint32_t> start(mesh.vertexCount() + 1, 0);
  const auto ends = [&](std::uint32_t h) {
    const std::uint32_t a = mesh.vertexOf(h), b = mesh.vertexOf(TriangleMesh::nextCorner(h));
    return std::pair(std::min(a, b), std::max(a, b));
  };
  for (std::uint32_t h = 0; h < halfEdges; ++h) ++start[ends(h).first + 1];
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) start[v + 1] += start[v];
  std::vector<Side> sides(halfEdges);
  {
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::uint32_t h = 0; h < halfEdges; ++h) {
      const auto [near, far] = ends(h);
      sides[fill[near]++] = {far, h};
    }
  }
  mesh.opposite.assign(halfEdges, TriangleMesh::kBorder);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const auto begin = sides.begin() + start[v], end = sides.begin() + start[v + 1];
    std::sort(begin, end, [](const Side& p, const Side& q) {
      return std::tie(p.far, p.halfEdge) < std::tie(q.far, q.halfEdge);
    });
    for (auto i = begin; i != end;) {
      auto j = i + 1;
      while (j != end && j->far == i->far) ++j;
      ++report.edges;
      if (j - i == 1) {
        ++report.borderEdges;
      } else if (j - i == 2) {
        mesh.opposite[i->halfEdge] = i[1].halfEdge;
        mesh.opposite[i[1].halfEdge] = i->halfEdge;
      } else {
        ++report.nonManifoldEdges;
        for (; i != j; ++i) mesh.opposite[i->halfEdge] = TriangleMesh::kCut;
      }
      i = j;
    }
  }
}

// One vertex for every fan, and the corners at each in order. Precondition: opposite half-edges run
// opposite ways.
void separateFans(TriangleMesh& mesh, MeshReport& report) {
  const std::size_t corners = 3 * mesh.triangles.size(), before = mesh.vertexCount();
  std::vector<char> seen(corners, 0);
  std::vector<std::uint32_t> walk, fanStart, fanVertex;
  walk.reserve(corners);
  for (std::uint32_t c = 0; c < corners; ++c) {
    if (seen[c]) continue;
    // Back to the start of the fan, or once round.
    std::uint32_t first = c;
    while (mesh.hasOpposite(first)) {
      const std::uint32_t back = TriangleMesh::nextCorner(mesh.opposite[first]);
      if (back == c) {
        first = c;
        break;
      }
      first = back;
    }
    fanStart.push_back(static_cast<std::uint32_t>(walk.size()));
    fanVertex.push_back(mesh.vertexOf(c));
    for (std::uint32_t i = first;;) {
      seen[i] = 1;
      walk.push_back(i);
      const std::uint32_t entering = TriangleMesh::previousCorner(i);
      if (!mesh.hasOpposite(entering) || mesh.opposite[entering] == first) break;
      i = mesh.opposite[entering];
    }
  }
  fanStart.push_back(static_cast<std::uint32_t>(walk.size()));

  // Fans in the order of their vertices; those of one vertex in the order of their triangles.
  const std::size_t fans = fanVertex.size();
  std::vector<std::uint32_t> place(before + 1, 0), order(fans);
  for (const std::uint32_t v : fanVertex) ++place[v + 1];
  for (std::size_t v = 0; v < before; ++v) {
    if (place[v + 1] > 1) ++report.nonManifoldVertices;
    place[v + 1] += place[v];
  }
  std::vector<std::uint32_t> firstFan(place.begin(), place.end() - 1);
  for (std::uint32_t f = 0; f < fans; ++f) order[place[fanVertex[f]]++] = f;

  TriangleMesh old;
  old.x.swap(mesh.x);
  old.y.swap(mesh.y);
  old.z.swap(mesh.z);
  old.fileVertex.swap(mesh.fileVertex);
  for (auto* coordinates : {&mesh.x, &mesh.y, &mesh.z}) coordinates->reserve(fans);
  mesh.fileVertex.reserve(fans);
  mesh.cornerStart.reserve(fans + 1);
  mesh.cornersAt.reserve(corners);
  mesh.cornerStart.push_back(0);
  for (std::uint32_t v = 0; v < fans; ++v) {
    const std::uint32_t fan = order[v], from = fanVertex[fan];
    mesh.x.push_back(old.x[from]);
    mesh.y.push_back(old.y[from]);
    mesh.z.push_back(old.z[from]);
    mesh.fileVertex.push_back(old.fileVertex[from]);
    for (std::uint32_t i = fanStart[fan]; i < fanStart[fan + 1]; ++i) {
      mesh.cornersAt.push_back(walk[i]);
      mesh.triangles[walk[i] / 3][walk[i] % 3] = v;
    }
    mesh.cornerStart.push_back(static_cast<std::uint32_t>(mesh.cornersAt.size()));
  }
  for (std::uint32_t& v : mesh.meshVertex) {
    if (v != TriangleMesh::kNone) {
      v = firstFan[v] < fans && fanVertex[order[firstFan[v]]] == v ? firstFan[v]
                                                                   : TriangleMesh::kNone;
    }
  }
}

}  // namespace

BuiltMesh buildMesh(const PolygonSoup& soup, const std::string& source) {
  BuiltMesh built;
  TriangleMesh& mesh = built.mesh;
  MeshReport& report = built.report;
  report.fileVertices = soup.vertexCount();
  report.filePolygons = soup.polygonCount();
  report.notes = soup.notes;

  Triangulation triangulation = triangulate(soup);
  report.foldedPolygons = triangulation.folded;
  report.hugePolygons = triangulation.huge;
  mesh.triangles = std::move(triangulation.triangles);
  mesh.filePolygon = std::move(triangulation.polygonOf);
  if (!orderVertices(soup, mesh, report)) {
    throw InputError(source, "",
                     mesh.triangles.empty() ? "there are no faces" : "all faces lie at one point");
  }
  orderTriangles(mesh.triangles, mesh.filePolygon, mesh.vertexCount(), report);
  matchEdges(mesh, report);
  agreeOnWinding(mesh, report);
  if (mesh.triangles.empty()) throw InputError(source, "", "no face has an area");
  separateFans(mesh, report);
  return built;
}

}  // namespace flatland
