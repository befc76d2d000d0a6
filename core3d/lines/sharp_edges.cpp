// SPDX-License-Identifier: MIT
#include "core3d/lines/sharp_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core3d/mesh/crease_angles.h"

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

class Finder {
 public:
  explicit Finder(const TriangleMesh& mesh) : mesh_(mesh), normals_(mesh.triangleCount()) {
    for (std::uint32_t t = 0; t < normals_.size(); ++t) {
      const auto& v = mesh.triangles[t];
      const Vector3f p = mesh.position(v[0]);
      normals_[t] = (mesh.position(v[1]) - p).cross(mesh.position(v[2]) - p).stableNormalized();
      if (!normals_[t].allFinite()) normals_[t].setZero();
    }
  }

  const Vector3f& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  bool isConvex(std::uint32_t halfEdge) const { return turnAt(halfEdge) > 0.0f; }

  bool isSharp(std::uint32_t h) const {
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
    return turn > kStandsAlone * beside;
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
  std::vector<std::uint32_t> ends;
  std::vector<bool> sharp(mesh.opposite.size(), false);
  for (std::uint32_t h = 0; h < mesh.opposite.size(); ++h) {
    if (!mesh.hasOpposite(h) || mesh.opposite[h] < h || !finder.isSharp(h)) continue;
    sharp[h] = sharp[mesh.opposite[h]] = true;
    edges_.push_back({h, finder.isConvex(h)});
    ends.push_back(mesh.vertexOf(h));
    ends.push_back(mesh.vertexOf(TriangleMesh::nextCorner(h)));
  }
  if (edges_.empty()) return;
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
