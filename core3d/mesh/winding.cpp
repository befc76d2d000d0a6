// SPDX-License-Identifier: MIT
#include "core3d/mesh/winding.h"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "core3d/mesh/pieces.h"
#include "core3d/mesh/triangle_cross.h"

namespace flatland {

namespace {

// Sine below which the corners of a triangle lie in one line as far as float positions tell.
constexpr double kFlat = 1e-7;

struct Walker {
  TriangleMesh& mesh;
  MeshReport& report;
  std::vector<char> seen, turn, drop;
  std::vector<std::uint32_t> piece;  // triangles of the current piece, also the queue

  Walker(TriangleMesh& m, MeshReport& r)
      : mesh(m),
        report(r),
        seen(m.triangles.size(), 0),
        turn(m.triangles.size(), 0),
        drop(m.triangles.size(), 0) {}

  // True if the half-edge and its opposite run opposite ways once both triangles are turned as
  // marked.
  bool agrees(std::uint32_t h) const {
    const std::uint32_t g = mesh.opposite[h];
    const bool sameWay = mesh.vertexOf(h) == mesh.vertexOf(g);
    return sameWay == (turn[h / 3] != turn[g / 3]);
  }

  void collect(std::uint32_t from) {
    collectPiece(mesh, from, seen, piece, [this](std::uint32_t h) {
      if (!agrees(h)) turn[mesh.opposite[h] / 3] = 1;
    });
  }

  // Keeps the winding of the majority; of the first triangle if there is none.
  void followMajority() {
    std::size_t turned = 0;
    for (const std::uint32_t t : piece) turned += turn[t];
    if (2 * turned > piece.size()) {
      for (const std::uint32_t t : piece) turn[t] ^= 1;
      turned = piece.size() - turned;
    }
    report.turnedTriangles += turned;
  }

  void cutWhereImpossible() {
    for (const std::uint32_t t : piece) {
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (!mesh.hasOpposite(h) || agrees(h)) continue;
        mesh.opposite[mesh.opposite[h]] = TriangleMesh::kCut;
        mesh.opposite[h] = TriangleMesh::kCut;
        ++report.unorientableEdges;
      }
    }
  }

  // Turns a piece that has an outside that way, marks one without area.
  void measure() {
    std::size_t flat = 0;
    for (const std::uint32_t t : piece) flat += isFlat(t) ? 1 : 0;
    if (flat == piece.size()) {
      leaveOut();
      return;
    }
    ++report.pieces;
    report.flatTriangles += flat;
    const PieceShape shape = shapeOf(mesh, piece, turn);
    if (!shape.hasOutside() || shape.volume >= 0.0) return;
    for (const std::uint32_t t : piece) turn[t] ^= 1;
    ++report.invertedPieces;
  }

  bool isFlat(std::uint32_t t) const {
    const auto& [va, vb, vc] = mesh.triangles[t];
    const Eigen::Vector3d a = mesh.position(va).cast<double>(),
                          b = mesh.position(vb).cast<double>(),
                          c = mesh.position(vc).cast<double>();
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !(crossOf(mesh, t).norm() > kFlat * longest);
  }

  // Nothing of the piece counts any more, but for edges that it shares with others (cuts).
  void leaveOut() {
    std::size_t borders = 0, paired = 0;
    for (const std::uint32_t t : piece) {
      drop[t] = 1;
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (mesh.opposite[h] == TriangleMesh::kBorder) ++borders;
        if (mesh.hasOpposite(h)) ++paired;
      }
    }
    report.strayTriangles += piece.size();
    report.borderEdges -= borders;
    report.edges -= borders + paired / 2;
  }

  // Turning (a, b, c) to (a, c, b) exchanges its first and last half-edge.
  void apply() {
    const auto moved = [&](std::uint32_t h) { return turn[h / 3] ? h / 3 * 3 + (2 - h % 3) : h; };
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (turn[t]) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        std::swap(mesh.opposite[3 * t], mesh.opposite[3 * t + 2]);
      }
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (mesh.hasOpposite(h)) mesh.opposite[h] = moved(mesh.opposite[h]);
      }
    }
  }

  // Pieces are dropped as wholes, so no half-edge loses its opposite.
  void compact() {
    std::vector<std::uint32_t> place(mesh.triangles.size());
    std::uint32_t kept = 0;
    for (std::size_t t = 0; t < place.size(); ++t) {
      place[t] = kept;
      if (!drop[t]) ++kept;
    }
    for (std::size_t t = 0; t < place.size(); ++t) {
      if (drop[t]) continue;
      const std::size_t to = place[t];
      mesh.triangles[to] = mesh.triangles[t];
      mesh.filePolygon[to] = mesh.filePolygon[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t h = mesh.opposite[3 * t + k];
        mesh.opposite[3 * to + k] = h < TriangleMesh::kCut ? 3 * place[h / 3] + h % 3 : h;
      }
    }
    mesh.triangles.resize(kept);
    mesh.filePolygon.resize(kept);
    mesh.opposite.resize(3 * std::size_t{kept});
  }
};

}  // namespace

void agreeOnWinding(TriangleMesh& mesh, MeshReport& report) {
  Walker walker(mesh, report);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (walker.seen[t]) continue;
    walker.collect(t);
    walker.followMajority();
    walker.cutWhereImpossible();
    walker.measure();
  }
  walker.apply();
  if (report.strayTriangles > 0) walker.compact();
}

}  // namespace flatland
