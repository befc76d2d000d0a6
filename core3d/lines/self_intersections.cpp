// SPDX-License-Identifier: MIT
// Where the surface passes through itself: pairs of triangles by a tree of boxes, then edges that
// pierce triangles.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core3d/lines/families.h"

namespace flatland {
namespace {

struct Box {
  Eigen::Array3f low = Eigen::Array3f::Constant(2.0f), high = Eigen::Array3f::Constant(-2.0f);

  void add(const Eigen::Array3f& p) {
    low = low.min(p);
    high = high.max(p);
  }
  bool meets(const Box& other) const {
    return (low <= other.high).all() && (other.low <= high).all();
  }
};

// A binary tree over the triangles in their order, which follows space already.
class BoxTree {
 public:
  explicit BoxTree(const TriangleMesh& mesh) : mesh_(mesh) {
    const auto count = static_cast<std::uint32_t>(mesh.triangleCount());
    while (leaves_ * kLeaf < count) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    for (std::uint32_t t = 0; t < count; ++t) {
      for (const std::uint32_t v : mesh.triangles[t])
        boxes_[leaves_ + t / kLeaf].add(mesh.position(v).array());
    }
    for (std::uint32_t node = leaves_ - 1; node > 0; --node) {
      for (const Box& child : {boxes_[2 * node], boxes_[2 * node + 1]}) {
        boxes_[node].low = boxes_[node].low.min(child.low);
        boxes_[node].high = boxes_[node].high.max(child.high);
      }
    }
  }

  // Calls visit(t, u), t < u, for all pairs whose leaves' boxes meet.
  template <typename Visit>
  void pairs(const Visit& visit) const {
    std::vector<std::array<std::uint32_t, 2>> open{{1, 1}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (a != b && !boxes_[a].meets(boxes_[b])) continue;
      if (a >= leaves_) {  // so is b: both are on the same level
        const std::uint32_t count = static_cast<std::uint32_t>(mesh_.triangleCount());
        const std::uint32_t aFirst = (a - leaves_) * kLeaf, bFirst = (b - leaves_) * kLeaf;
        for (std::uint32_t t = aFirst; t < std::min(aFirst + kLeaf, count); ++t) {
          for (std::uint32_t u = std::max(t + 1, bFirst); u < std::min(bFirst + kLeaf, count); ++u)
            visit(t, u);
        }
        continue;
      }
      open.push_back({2 * a, 2 * b});
      open.push_back({2 * a, 2 * b + 1});
      if (a != b) open.push_back({2 * a + 1, 2 * b});
      open.push_back({2 * a + 1, 2 * b + 1});
    }
  }

 private:
  static constexpr std::uint32_t kLeaf = 2;
  const TriangleMesh& mesh_;
  std::uint32_t leaves_ = 1;
  std::vector<Box> boxes_;
};

// Six times the signed volume of four vertices, positive if d lies on the side from which a, b, c
// are counter-clockwise. Whatever the order they are given in, it is computed in the order of their
// numbers, so that the triangles around an edge or a vertex never disagree: what pierces one of two
// neighbours' common edge pierces exactly one of them.
double volume(const TriangleMesh& mesh, std::array<std::uint32_t, 4> v) {
  double sign = 1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j + 1 < 4 - i; ++j) {
      if (v[j] > v[j + 1]) {
        std::swap(v[j], v[j + 1]);
        sign = -sign;
      }
    }
  }
  const Eigen::Vector3d a = mesh.position(v[0]).cast<double>();
  const Eigen::Vector3d b = mesh.position(v[1]).cast<double>() - a,
                        c = mesh.position(v[2]).cast<double>() - a,
                        d = mesh.position(v[3]).cast<double>() - a;
  const double six = b.cross(c).dot(d);
  // In one plane: as if it were positive in the order of the numbers.
  return sign * (six == 0.0 ? std::numeric_limits<double>::min() : six);
}

// Where half-edge h pierces triangle u.
std::optional<LineEnd> pierced(const TriangleMesh& mesh, std::uint32_t h, std::uint32_t u) {
  std::uint32_t p = mesh.vertexOf(h), q = mesh.vertexOf(TriangleMesh::nextCorner(h));
  if (p > q) std::swap(p, q);
  const auto& [a, b, c] = mesh.triangles[u];
  const double atP = volume(mesh, {a, b, c, p}), atQ = volume(mesh, {a, b, c, q});
  if ((atP > 0.0) == (atQ > 0.0)) return std::nullopt;
  const bool ab = volume(mesh, {p, q, a, b}) > 0.0, bc = volume(mesh, {p, q, b, c}) > 0.0,
             ca = volume(mesh, {p, q, c, a}) > 0.0;
  if (ab != bc || bc != ca) return std::nullopt;
  const auto t = static_cast<float>(atP / (atP - atQ));
  const Eigen::Vector3f from = mesh.position(p), to = mesh.position(q);
  return LineEnd{from + t * (to - from), 1.0f,
                 freeNode(edgeNode(mesh, h) * mesh.triangleCount() + u)};
}

// Neighbours, and what touches at a vertex, also where the mesh was cut.
bool touch(const TriangleMesh& mesh, std::uint32_t t, std::uint32_t u) {
  for (const std::uint32_t v : mesh.triangles[t]) {
    for (const std::uint32_t w : mesh.triangles[u]) {
      if (v == w || mesh.position(v) == mesh.position(w)) return true;
    }
  }
  return false;
}

}  // namespace

Segments findSelfIntersections(const TriangleMesh& mesh) {
  Segments out;
  const auto boxOf = [&mesh](std::uint32_t t) {
    Box box;
    for (const std::uint32_t v : mesh.triangles[t]) box.add(mesh.position(v).array());
    return box;
  };
  BoxTree(mesh).pairs([&](std::uint32_t t, std::uint32_t u) {
    if (!boxOf(t).meets(boxOf(u)) || touch(mesh, t, u)) return;
    LineEnd ends[6];
    int count = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (const auto end = pierced(mesh, 3 * t + k, u)) ends[count++] = *end;
      if (const auto end = pierced(mesh, 3 * u + k, t)) ends[count++] = *end;
    }
    // Two that are not in one plane meet in one piece or not at all.
    if (count == 2) out.push_back({ends[0], ends[1], t});
  });
  return out;
}

}  // namespace flatland
