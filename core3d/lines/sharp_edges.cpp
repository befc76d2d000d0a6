// SPDX-License-Identifier: MIT
#include "core3d/lines/sharp_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core3d/mesh/crease_angles.h"
#include "core3d/mesh/triangle_cross.h"

namespace flatland {
namespace {

using Eigen::Vector3f;

constexpr float kRad = std::numbers::pi_v<float> / 180.0f;
constexpr float kLeastRad = static_cast<float>(kCreaseDeg) * kRad;
// Between flat faces from here on (a round of seven sides) a prism is meant as one, below as round.
constexpr float kPrismRad = 50.0f * kRad;
constexpr float kFoldRad = static_cast<float>(kFoldDeg) * kRad;
// Two triangles of one flat polygon.
constexpr float kFlatRad = 1.0f * kRad;
// On a coarse sphere this ratio is near 1, between a flat face and any other large; noise makes
// both about as large.
constexpr float kStandsAlone = 2.0f;
// Where a sharp edge ends, the edge that goes on in its direction need not stand alone so clearly:
// along one crease some edges fail by accident.
constexpr float kGoesOn = 1.0f;
constexpr float kGoesOnCosine = 0.7f;
// Fewer edges in a row than that are noise of a scan, if no border and no fold is among them.
constexpr std::uint32_t kLeastInARow = 4;

class Finder {
 public:
  explicit Finder(const TriangleMesh& mesh) : mesh_(mesh), normals_(mesh.triangleCount()) {
    for (std::uint32_t t = 0; t < normals_.size(); ++t) {
      normals_[t] = crossOf(mesh, t).stableNormalized().cast<float>();
    }
  }

  const Vector3f& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  bool isConvex(std::uint32_t halfEdge) const { return turnAt(halfEdge) > 0.0f; }

  bool isFold(std::uint32_t h) const { return std::abs(turnAt(h)) >= kFoldRad; }

  // `times`: by how much an edge has to turn more than the surface beside it.
  bool isSharp(std::uint32_t h, float times = kStandsAlone) const {
    // Most edges are flat, which is known without an angle.
    const float cosine = normals_[h / 3].dot(normals_[mesh_.opposite[h] / 3]);
    if (cosine > std::cos(kLeastRad)) return false;
    const float turn = std::abs(turnAt(h));
    if (!(turn > 0.0f) || isUndone(h) || isUndone(mesh_.opposite[h])) return false;
    if (turn >= kFoldRad) return true;
    const Vector3f along = direction(h);
    const bool quads = turn < kPrismRad;
    const float beside =
        std::max(bendBeside(h, along, quads), bendBeside(mesh_.opposite[h], along, quads));
    return turn > times * beside;
  }

  Vector3f direction(std::uint32_t h) const {
    return (mesh_.position(mesh_.vertexOf(TriangleMesh::nextCorner(h))) -
            mesh_.position(mesh_.vertexOf(h)))
        .stableNormalized();
  }

 private:
  // Signed: positive where convex. 0 where there is nothing on the other side, or no area.
  float turnAt(std::uint32_t h) const {
    if (!mesh_.hasOpposite(h)) return 0.0f;
    const Vector3f &a = normals_[h / 3], &b = normals_[mesh_.opposite[h] / 3];
    if (a.isZero(0.0f) || b.isZero(0.0f)) return 0.0f;
    const Vector3f turn = a.cross(b);
    const float angle = std::atan2(turn.norm(), a.dot(b));
    return std::copysign(angle, turn.dot(direction(h)));
  }

  // True if the surface turns back at another edge of the same triangle: a sliver with a normal of
  // its own, as rounding and noise make them.
  bool isUndone(std::uint32_t h) const {
    const Vector3f& before = normals_[mesh_.opposite[h] / 3];
    for (std::uint32_t e = TriangleMesh::nextCorner(h); e != h; e = TriangleMesh::nextCorner(e)) {
      // Where both turn the same way, this is an ear of a face between two parts of its rim.
      if (!mesh_.hasOpposite(e) || !(turnAt(e) * turnAt(h) < 0.0f)) continue;
      if (before.dot(normals_[mesh_.opposite[e] / 3]) > std::cos(kLeastRad)) return true;
    }
    return false;
  }

  // By how much the surface turns about a direction at the other two edges of a triangle; with
  // `quads` at the edges of the triangle that makes one flat quadrilateral with it.
  float bendBeside(std::uint32_t h, const Vector3f& along, bool quads) const {
    float bend = 0.0f;
    for (std::uint32_t e = TriangleMesh::nextCorner(h); e != h; e = TriangleMesh::nextCorner(e)) {
      const float turn = turnAt(e);
      if (quads && mesh_.hasOpposite(e) && std::abs(turn) < kFlatRad) {
        bend += bendBeside(mesh_.opposite[e], along, false);
      } else {
        bend += std::abs(turn * direction(e).dot(along));
      }
    }
    return bend;
  }

  const TriangleMesh& mesh_;
  std::vector<Vector3f> normals_;  // of the triangles
};

// The sharp edges, and whether a half-edge is of one.
struct Edges {
  std::vector<SharpEdge> edges;
  std::vector<bool> sharp;
};

Edges edgesThatStandAlone(const TriangleMesh& mesh, const Finder& finder) {
  Edges found{{}, std::vector<bool>(mesh.opposite.size(), false)};
  for (std::uint32_t h = 0; h < mesh.opposite.size(); ++h) {
    if (!mesh.hasOpposite(h) || mesh.opposite[h] < h || !finder.isSharp(h)) continue;
    found.sharp[h] = found.sharp[mesh.opposite[h]] = true;
    found.edges.push_back({h, finder.isConvex(h)});
  }
  return found;
}

// The half-edge from a vertex that goes on with a sharp edge that ends there.
std::optional<std::uint32_t> continuation(const TriangleMesh& mesh, const Finder& finder,
                                          std::uint32_t vertex, const Vector3f& along,
                                          bool convex) {
  std::optional<std::uint32_t> best;
  float straightest = kGoesOnCosine;
  for (std::uint32_t i = mesh.cornerStart[vertex]; i < mesh.cornerStart[vertex + 1]; ++i) {
    const std::uint32_t h = mesh.cornersAt[i];
    if (!mesh.hasOpposite(h)) continue;
    const float cosine = finder.direction(h).dot(along);
    if (!(cosine > straightest) || finder.isConvex(h) != convex) continue;
    if (!finder.isSharp(h, kGoesOn)) continue;
    straightest = cosine;
    best = h;
  }
  return best;
}

// How many sharp edges meet at a vertex.
int meetingAt(const TriangleMesh& mesh, const Edges& found, std::uint32_t vertex) {
  int count = 0;
  for (std::uint32_t i = mesh.cornerStart[vertex]; i < mesh.cornerStart[vertex + 1]; ++i) {
    if (found.sharp[mesh.cornersAt[i]]) ++count;
  }
  return count;
}

// What is added goes on in its turn. A single edge leads nowhere: on coarse round surfaces some
// stand alone by accident.
void goOn(const TriangleMesh& mesh, const Finder& finder, Edges& found) {
  for (std::size_t i = 0; i < found.edges.size(); ++i) {
    const SharpEdge edge = found.edges[i];
    for (const std::uint32_t h : {edge.halfEdge, mesh.opposite[edge.halfEdge]}) {
      const std::uint32_t end = mesh.vertexOf(TriangleMesh::nextCorner(h));
      const std::uint32_t start = mesh.vertexOf(h);
      if (mesh.isAtEdge(end) || meetingAt(mesh, found, end) > 1) continue;
      if (!mesh.isAtEdge(start) && meetingAt(mesh, found, start) < 2) continue;
      const auto next = continuation(mesh, finder, end, finder.direction(h), edge.convex);
      if (!next || found.sharp[*next]) continue;
      found.sharp[*next] = found.sharp[mesh.opposite[*next]] = true;
      found.edges.push_back({std::min(*next, mesh.opposite[*next]), edge.convex});
    }
  }
}

// Forgets edges that hang together with few others.
void dropCrumbs(const TriangleMesh& mesh, const Finder& finder, Edges& found) {
  std::unordered_map<std::uint32_t, std::uint32_t> above;  // vertices, as a forest
  const auto root = [&above](std::uint32_t v) {
    for (auto at = above.try_emplace(v, v).first; at->second != v; at = above.find(v)) {
      v = at->second = above.at(at->second);
    }
    return v;
  };
  const auto ends = [&mesh](const SharpEdge& e) {
    return std::array{mesh.vertexOf(e.halfEdge),
                      mesh.vertexOf(TriangleMesh::nextCorner(e.halfEdge))};
  };
  for (const SharpEdge& edge : found.edges) {
    const auto [a, b] = ends(edge);
    above[root(a)] = root(b);
  }
  std::unordered_map<std::uint32_t, std::uint32_t> size;
  for (const SharpEdge& edge : found.edges) {
    const auto [a, b] = ends(edge);
    const bool sure = finder.isFold(edge.halfEdge) || mesh.isAtEdge(a) || mesh.isAtEdge(b);
    size[root(a)] += sure ? kLeastInARow : 1;
  }
  std::erase_if(found.edges, [&](const SharpEdge& edge) {
    if (size[root(ends(edge)[0])] >= kLeastInARow) return false;
    found.sharp[edge.halfEdge] = found.sharp[mesh.opposite[edge.halfEdge]] = false;
    return true;
  });
}

// The angle of a triangle at one of its corners.
float angleAt(const TriangleMesh& mesh, std::uint32_t corner) {
  const Vector3f p = mesh.position(mesh.vertexOf(corner));
  const Vector3f a = mesh.position(mesh.vertexOf(TriangleMesh::nextCorner(corner))) - p;
  const Vector3f b = mesh.position(mesh.vertexOf(TriangleMesh::previousCorner(corner))) - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

SharpEdges::SharpEdges(const TriangleMesh& mesh, const SurfaceFields& fields) {
  const Finder finder(mesh);
  Edges found = edgesThatStandAlone(mesh, finder);
  goOn(mesh, finder, found);
  dropCrumbs(mesh, finder, found);
  edges_ = std::move(found.edges);
  const std::vector<bool>& sharp = found.sharp;
  if (edges_.empty()) return;
  std::vector<std::uint32_t> ends;
  for (const SharpEdge& edge : edges_) {
    ends.push_back(mesh.vertexOf(edge.halfEdge));
    ends.push_back(mesh.vertexOf(TriangleMesh::nextCorner(edge.halfEdge)));
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

  places_.assign(mesh.triangleCount(), TriangleMesh::kNone);
  std::vector<bool> split(mesh.vertexCount(), false);
  for (const std::uint32_t v : ends) {
    const auto fan =
        std::span(mesh.cornersAt)
            .subspan(mesh.cornerStart[v], mesh.cornerStart[v + 1] - mesh.cornerStart[v]);
    // The sectors start at sharp edges, the first of an open fan at its border.
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      if (sharp[fan[i]] || (i == 0 && mesh.isAtEdge(v))) starts.push_back(i);
    }
    if (starts.size() < 2) continue;
    split[v] = true;
    for (std::size_t s = 0; s < starts.size(); ++s) {
      const std::size_t from = starts[s];
      const std::size_t to = s + 1 < starts.size() ? starts[s + 1] : starts[0] + fan.size();
      Vector3f sum = Vector3f::Zero();
      for (std::size_t i = from; i < to; ++i) {
        const std::uint32_t corner = fan[i % fan.size()];
        sum += angleAt(mesh, corner) * finder.normal(corner / 3);
      }
      const Vector3f normal = sum.norm() > 0.0f ? Vector3f(sum.normalized()) : sum;
      for (std::size_t i = from; i < to; ++i) {
        const std::uint32_t corner = fan[i % fan.size()];
        std::uint32_t& place = places_[corner / 3];
        if (place == TriangleMesh::kNone) {
          place = static_cast<std::uint32_t>(triangles_.size());
          SplitTriangle added{corner / 3, {}, {false, false, false}};
          for (std::size_t k = 0; k < 3; ++k) {
            added.normal[k] = fields.normal(mesh.triangles[corner / 3][k]);
          }
          triangles_.push_back(added);
        }
        triangles_[place].normal[corner % 3] = normal;
        triangles_[place].own[corner % 3] = true;
      }
    }
  }
  std::erase_if(edges_, [&](const SharpEdge& e) {
    return !split[mesh.vertexOf(e.halfEdge)] &&
           !split[mesh.vertexOf(TriangleMesh::nextCorner(e.halfEdge))];
  });
  std::sort(triangles_.begin(), triangles_.end(),
            [](const SplitTriangle& a, const SplitTriangle& b) { return a.triangle < b.triangle; });
  for (std::uint32_t i = 0; i < triangles_.size(); ++i) places_[triangles_[i].triangle] = i;
  if (triangles_.empty()) places_.clear();
}

}  // namespace flatland
