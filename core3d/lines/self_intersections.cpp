// SPDX-License-Identifier: MIT
// Where the surface passes through itself: pairs of triangles by a tree of boxes, then edges that
// pierce triangles.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>

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

// The places that all triangles of a node have a vertex at, as vertices; none is kNone.
struct CommonPlaces {
  std::array<std::uint32_t, 3> vertices{TriangleMesh::kNone, TriangleMesh::kNone,
                                        TriangleMesh::kNone};

  bool has(const TriangleMesh& mesh, std::uint32_t vertex) const {
    return std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
      return v != TriangleMesh::kNone && mesh.position(v) == mesh.position(vertex);
    });
  }
  // Keeps what the other has too.
  void keep(const TriangleMesh& mesh, const CommonPlaces& other) {
    for (std::uint32_t& v : vertices) {
      if (v != TriangleMesh::kNone && !other.has(mesh, v)) v = TriangleMesh::kNone;
    }
  }
  bool meets(const TriangleMesh& mesh, const CommonPlaces& other) const {
    return std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t v) {
      return v != TriangleMesh::kNone && other.has(mesh, v);
    });
  }
};

// A binary tree over the triangles in their order, which follows space already.
class BoxTree {
 public:
  explicit BoxTree(const TriangleMesh& mesh) : mesh_(mesh) {
    const auto count = static_cast<std::uint32_t>(mesh.triangleCount());
    while (leaves_ * kLeaf < count) leaves_ *= 2;
    boxes_.resize(2 * leaves_);
    places_.resize(2 * leaves_);
    for (std::uint32_t t = 0; t < count; ++t) {
      const std::uint32_t node = leaves_ + t / kLeaf;
      for (const std::uint32_t v : mesh.triangles[t]) boxes_[node].add(mesh.position(v).array());
      if (t % kLeaf == 0) {
        places_[node].vertices = mesh.triangles[t];
      } else {
        places_[node].keep(mesh, {mesh.triangles[t]});
      }
    }
    for (std::uint32_t node = leaves_ - 1; node > 0; --node) {
      for (const Box& child : {boxes_[2 * node], boxes_[2 * node + 1]}) {
        boxes_[node].low = boxes_[node].low.min(child.low);
        boxes_[node].high = boxes_[node].high.max(child.high);
      }
      places_[node] = places_[2 * node];
      // Leaves beyond the last triangle say nothing.
      if (boxes_[2 * node + 1].low.x() <= boxes_[2 * node + 1].high.x()) {
        places_[node].keep(mesh, places_[2 * node + 1]);
      }
    }
  }

  // Calls visit(t, u), t < u, for all pairs whose leaves' boxes meet, but for some that touch:
  // where thousands of triangles meet in a vertex, their boxes do, and so do those of all nodes
  // above.
  template <typename Visit>
  void pairs(const Visit& visit) const {
    std::vector<std::array<std::uint32_t, 2>> open{{1, 1}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (a != b && !boxes_[a].meets(boxes_[b])) continue;
      if (places_[a].meets(mesh_, places_[b])) continue;
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
  std::vector<CommonPlaces> places_;
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

// How far a stored position may be from where it was meant to be: coordinates are floats of size
// up to one, and two of them make a difference.
constexpr double kRounding = 2.0 * std::numeric_limits<float>::epsilon();

// Whether t has vertices on both sides of the plane of u, further from it than the rounding of the
// positions can have moved them or the plane. Nothing crosses a plane that u is too thin to have.
bool crossesPlane(const TriangleMesh& mesh, std::uint32_t t, std::uint32_t u) {
  const auto at = [&mesh](std::uint32_t v) {
    return Eigen::Vector3d(mesh.position(v).cast<double>());
  };
  const auto& [a, b, c] = mesh.triangles[u];
  const Eigen::Vector3d ab = at(b) - at(a), ac = at(c) - at(a), normal = ab.cross(ac);
  const double twiceArea = normal.norm();
  if (!(twiceArea > 0.0)) return false;
  const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
  bool above = false, below = false;
  for (const std::uint32_t v : mesh.triangles[t]) {
    const Eigen::Vector3d from = at(v) - at(a);
    const double height = normal.dot(from) / twiceArea;
    // The plane turns by the rounding over the least height of u.
    const double unsure = kRounding * (1.0 + from.norm() * longest / twiceArea);
    above = above || height > unsure;
    below = below || height < -unsure;
  }
  return above && below;
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

// Takes away what is no longer than the rounding, where triangles touch in a point. Pieces as short
// that join longer ones stay: a line leads through them.
void removeTouchingPoints(Segments& segments) {
  const auto isPoint = [](const LineSegment& s) { return (s.a.at - s.b.at).norm() <= kRounding; };
  std::set<LineNode> onLines;
  for (const LineSegment& s : segments) {
    if (!isPoint(s)) onLines.insert({s.a.node, s.b.node});
  }
  for (std::size_t before = 0; before != onLines.size();) {
    before = onLines.size();
    for (const LineSegment& s : segments) {
      if (onLines.count(s.a.node) != 0 || onLines.count(s.b.node) != 0) {
        onLines.insert({s.a.node, s.b.node});
      }
    }
  }
  std::erase_if(segments, [&](const LineSegment& s) { return onLines.count(s.a.node) == 0; });
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
    // What lies in one plane, or only touches, does not pass through.
    if (!crossesPlane(mesh, t, u) || !crossesPlane(mesh, u, t)) return;
    LineEnd ends[6];
    int count = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (const auto end = pierced(mesh, 3 * t + k, u)) ends[count++] = *end;
      if (const auto end = pierced(mesh, 3 * u + k, t)) ends[count++] = *end;
    }
    // Two that are not in one plane meet in one piece or not at all.
    if (count == 2) out.push_back({ends[0], ends[1], t, 0, true, u});
  });
  removeTouchingPoints(out);
  return out;
}

}  // namespace flatland
