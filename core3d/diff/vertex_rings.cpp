// SPDX-License-Identifier: MIT
#include "core3d/diff/vertex_rings.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace flatland {

namespace {

// Cosine of the dihedral angle from which on an edge is no sample of a smooth surface: two
// triangles that turn by more than 60 degrees. A sphere of a dozen edges round turns by half of
// that.
constexpr double kCreaseCosine = 0.5;
// A triangle flatter than this (height by longest edge) has no normal that could be trusted.
constexpr double kSliver = 1e-3;
// Of a vertex with more neighbours only every second, third, ... is used: a cone's tip has
// thousands, and every ring near it would have them all.
constexpr std::size_t kMostNeighbours = 48;

// 0 where the triangle is too flat to have one.
Eigen::Vector3d unitNormal(const TriangleMesh& mesh, std::uint32_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  const Eigen::Vector3d p = mesh.position(a).cast<double>();
  const Eigen::Vector3d e = mesh.position(b).cast<double>() - p,
                        f = mesh.position(c).cast<double>() - p;
  const Eigen::Vector3d cross = e.cross(f);
  const double longestSq = std::max({e.squaredNorm(), f.squaredNorm(), (f - e).squaredNorm()});
  const double twice = cross.norm();
  return twice > kSliver * longestSq ? Eigen::Vector3d(cross / twice) : Eigen::Vector3d::Zero();
}

}  // namespace

VertexNeighbours::VertexNeighbours(const TriangleMesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.vertexCount());
  start.reserve(count + 1);
  vertices.reserve(mesh.cornersAt.size() + mesh.cornersAt.size() / 16);
  onCrease.assign(count, 0);
  for (std::uint32_t v = 0; v < count; ++v) {
    start.push_back(static_cast<std::uint32_t>(vertices.size()));
    const std::uint32_t begin = mesh.cornerStart[v], end = mesh.cornerStart[v + 1];
    for (std::uint32_t i = begin; i < end; ++i)
      vertices.push_back(mesh.vertexOf(TriangleMesh::nextCorner(mesh.cornersAt[i])));
    if (mesh.isAtEdge(v))
      vertices.push_back(mesh.vertexOf(TriangleMesh::previousCorner(mesh.cornersAt[end - 1])));
  }
  start.push_back(static_cast<std::uint32_t>(vertices.size()));

  std::vector<Eigen::Vector3f> normals(mesh.triangleCount());
  for (std::uint32_t t = 0; t < normals.size(); ++t) normals[t] = unitNormal(mesh, t).cast<float>();
  for (std::uint32_t h = 0; h < mesh.opposite.size(); ++h) {
    if (!mesh.hasOpposite(h) || mesh.opposite[h] < h) continue;
    const Eigen::Vector3f &m = normals[h / 3], &n = normals[mesh.opposite[h] / 3];
    if (m.dot(n) >= kCreaseCosine || m.isZero(0.0f) || n.isZero(0.0f)) continue;
    onCrease[mesh.vertexOf(h)] = onCrease[mesh.vertexOf(TriangleMesh::nextCorner(h))] = 1;
  }
}

VertexRings::VertexRings(const VertexNeighbours& neighbours)
    : neighbours_(neighbours), seenBy_(neighbours.onCrease.size(), 0) {}

void VertexRings::startAt(std::uint32_t v) {
  if (++round_ == 0) {
    std::fill(seenBy_.begin(), seenBy_.end(), 0u);
    round_ = 1;
  }
  if (reached_.empty()) reached_.resize(1);
  reached_[0] = v;
  ends_.assign(1, 1);
  seenBy_[v] = round_;
}

void VertexRings::grow() {
  const std::size_t end = ends_.back(), begin = ends_.size() > 1 ? ends_[ends_.size() - 2] : 0;
  std::size_t count = end;
  for (std::size_t i = begin; i < end; ++i) {
    const std::uint32_t from = reached_[i];
    if (i > 0 && neighbours_.onCrease[from]) continue;
    const auto around = neighbours_.of(from);
    const std::size_t step = 1 + (around.size() - 1) / kMostNeighbours;
    // Room for all of them, so that each is written without a question and kept if it is new.
    if (reached_.size() < count + around.size()) reached_.resize(2 * (count + around.size()));
    for (std::size_t k = 0; k < around.size(); k += step) {
      const std::uint32_t q = around[k];
      reached_[count] = q;
      count += seenBy_[q] != round_ ? 1 : 0;
      seenBy_[q] = round_;
    }
  }
  ends_.push_back(count);
}

std::span<const std::uint32_t> VertexRings::ring(int k) const {
  const std::size_t begin = k > 0 ? ends_[static_cast<std::size_t>(k) - 1] : 0;
  return {reached_.data() + begin, reached_.data() + ends_[static_cast<std::size_t>(k)]};
}

}  // namespace flatland
