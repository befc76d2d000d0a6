// SPDX-License-Identifier: MIT
#include "core3d/mesh/pieces.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "core3d/mesh/triangle_cross.h"

namespace flatland {
namespace {

using Eigen::Vector3d;

// Holes per area. An open tube that is four radii long has 0.25, a sphere with a hole of half its
// radius 0.07, a bust that stands open at the bottom 0.03.
constexpr double kLargestHoles = 0.3;
constexpr double kSheetHoles = 0.1;
// Volume per (hole area)^1.5: a hemisphere has 0.4, a flat relief nearly 0.
constexpr double kLeastVolume = 0.2;

// The border of a piece, each half-edge from `from` to `to` as its triangle runs.
struct BorderEdge {
  std::uint32_t from, to;
};

// Takes out the two sides of slits: edges that are there both ways, such as those that were cut
// where more than two triangles meet. Each side of a slit may have vertices of its own, which came
// from one of the file.
void closeSlits(const TriangleMesh& mesh, std::vector<BorderEdge>& border) {
  const auto place = [&mesh](const BorderEdge& e) {
    return std::pair(mesh.fileVertex[e.from], mesh.fileVertex[e.to]);
  };
  const auto key = [&place](const BorderEdge& e) {
    const auto [from, to] = place(e);
    return std::tuple(std::min(from, to), std::max(from, to), from);
  };
  std::sort(border.begin(), border.end(),
            [&key](const BorderEdge& a, const BorderEdge& b) { return key(a) < key(b); });
  std::vector<BorderEdge> open;
  for (const BorderEdge& edge : border) {
    const auto [from, to] = place(edge);
    if (!open.empty() && place(open.back()) == std::pair(to, from)) {
      open.pop_back();
    } else {
      open.push_back(edge);
    }
  }
  border = std::move(open);
}

// Connected parts of a border.
class BorderParts {
 public:
  explicit BorderParts(const std::vector<BorderEdge>& border) {
    for (const BorderEdge& edge : border) {
      vertices_.push_back(edge.from);
      vertices_.push_back(edge.to);
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    parent_.resize(vertices_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    for (const BorderEdge& edge : border) parent_[find(edge.from)] = find(edge.to);
  }

  std::size_t size() const { return parent_.size(); }
  std::size_t find(std::uint32_t vertex) {
    auto i = static_cast<std::size_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) -
                                      vertices_.begin());
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::vector<std::uint32_t> vertices_;
  std::vector<std::size_t> parent_;
};

// Part of a border, closed by the triangles from its edges to its middle. Their area vectors count
// by their parts along the main direction: not how jagged the border is, but both ends of a tube
// that is slit open from one to the other.
struct Hole {
  Vector3d middle = Vector3d::Zero();
  double length = 0.0;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vector3d direction = Vector3d::Zero();
};

void addHoles(const TriangleMesh& mesh, const std::vector<BorderEdge>& border, const Vector3d& base,
              PieceShape& shape) {
  const auto at = [&](std::uint32_t v) -> Vector3d {
    return mesh.position(v).cast<double>() - base;
  };
  BorderParts parts(border);
  std::vector<Hole> holes(parts.size());
  for (const auto& [from, to] : border) {
    Hole& hole = holes[parts.find(from)];
    const double length = (at(to) - at(from)).norm();
    hole.length += length;
    hole.middle += 0.5 * length * (at(from) + at(to));
  }
  for (Hole& hole : holes) {
    if (hole.length > 0.0) hole.middle /= hole.length;
  }
  // The triangle that fills runs the other way than the edge.
  const auto vectorOf = [&](const BorderEdge& edge, const Hole& hole) -> Vector3d {
    return 0.5 * (at(edge.to) - hole.middle).cross(at(edge.from) - hole.middle);
  };
  for (const BorderEdge& edge : border) {
    Hole& hole = holes[parts.find(edge.from)];
    const Vector3d vector = vectorOf(edge, hole);
    hole.spread += vector * vector.transpose();
    shape.volume += hole.middle.dot(at(edge.to).cross(at(edge.from))) / 6.0;
  }
  for (Hole& hole : holes) {
    if (hole.length > 0.0)
      hole.direction =
          Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(hole.spread).eigenvectors().col(2);
  }
  for (const BorderEdge& edge : border) {
    const Hole& hole = holes[parts.find(edge.from)];
    shape.holes += std::abs(vectorOf(edge, hole).dot(hole.direction));
  }
}

}  // namespace

bool PieceShape::hasOutside() const {
  return holes <= kLargestHoles * area &&
         std::abs(volume) >= kLeastVolume * holes * std::sqrt(holes);
}

bool PieceShape::isSheet() const { return holes > kSheetHoles * area; }

PieceShape shapeOf(const TriangleMesh& mesh, std::span<const std::uint32_t> piece,
                   std::span<const char> turned) {
  PieceShape shape;
  const Vector3d base = mesh.position(mesh.triangles[piece[0]][0]).cast<double>();
  std::vector<BorderEdge> border;
  for (const std::uint32_t t : piece) {
    const bool turn = !turned.empty() && turned[t] != 0;
    const Vector3d vector = crossOf(mesh, t);
    const Vector3d a = mesh.position(mesh.triangles[t][0]).cast<double>() - base;
    shape.area += 0.5 * vector.norm();
    shape.volume += (turn ? -1.0 : 1.0) * a.dot(vector) / 6.0;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      if (mesh.hasOpposite(h)) continue;
      const std::uint32_t from = mesh.vertexOf(h), to = mesh.vertexOf(TriangleMesh::nextCorner(h));
      border.push_back(turn ? BorderEdge{to, from} : BorderEdge{from, to});
    }
  }
  closeSlits(mesh, border);
  if (!border.empty()) addHoles(mesh, border, base, shape);
  return shape;
}

Sheets::Sheets(const TriangleMesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.triangleCount());
  if (std::all_of(mesh.opposite.begin(), mesh.opposite.end(),
                  [](std::uint32_t h) { return h < TriangleMesh::kCut; }))
    return;
  std::vector<char> seen(count, 0);
  std::vector<std::uint32_t> piece;
  for (std::uint32_t from = 0; from < count; ++from) {
    if (seen[from]) continue;
    collectPiece(mesh, from, seen, piece, [](std::uint32_t) {});
    if (!shapeOf(mesh, piece, {}).isSheet()) continue;
    of_.resize(count, 0);
    for (const std::uint32_t t : piece) of_[t] = 1;
  }
}

}  // namespace flatland
