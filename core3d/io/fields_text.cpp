// SPDX-License-Identifier: MIT
#include "core3d/io/fields_text.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core3d/diff/surface_jet.h"
#include "flatland/io/number_text.h"

namespace flatland {

namespace {

constexpr std::array kColumns = {"x",   "y",      "z",       "nx",     "ny",         "nz",
                                 "k1",  "k2",     "e1x",     "e1y",    "e1z",        "e2x",
                                 "e2y", "e2z",    "c111",    "c112",   "c122",       "c222",
                                 "nw",  "lambda", "feature", "offset", "perspective"};
using Row = std::array<double, kColumns.size()>;

// Its third power leaves 1e83 for what the terms are in units of the mesh.
constexpr double kLongestSide = 1e75;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Row rowOf(const TriangleMesh& mesh, const SurfaceFields& fields, const SurfaceView& view,
          std::uint32_t v) {
  const SurfacePoint point = fields.at(mesh, v);
  const Eigen::Vector3d p = mesh.positionInFile(v), w = view.towardsViewer(point.p);
  const Eigen::Vector3d e1 = point.frame.col(0), e2 = point.frame.col(1);
  const double perLength = 1.0 / mesh.unit, perSq = perLength * perLength;
  double lambda = kNone, feature = kNone, offset = kNone, perspective = kNone;
  if (const auto seen = apparentCurvature(seenFrom(point, w, view.distanceTo(point.p)))) {
    lambda = seen->lambda * perSq;
    feature = seen->feature * perSq * perLength;
    offset = seen->offset * perSq * perLength;
    perspective = seen->perspective * perSq * perLength;
  }
  const auto& c = point.C.coefficients;
  return {p.x(),
          p.y(),
          p.z(),
          point.n.x(),
          point.n.y(),
          point.n.z(),
          point.K(0, 0) * perLength,
          point.K(1, 1) * perLength,
          e1.x(),
          e1.y(),
          e1.z(),
          e2.x(),
          e2.y(),
          e2.z(),
          c[0] * perSq,
          c[1] * perSq,
          c[2] * perSq,
          c[3] * perSq,
          point.n.dot(w),
          lambda,
          feature,
          offset,
          perspective};
}

/// Appends the value's bytes, the lowest first.
template <typename Bits>
void appendBytes(std::string& bytes, Bits bits) {
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    bytes += static_cast<char>((bits >> (8 * i)) & 0xffU);
  }
}

}  // namespace

std::optional<std::string> whyNoFieldsFile(const TriangleMesh& mesh) {
  const double side = 2.0 * mesh.unit;
  if (side >= 1.0 / kLongestSide && side <= kLongestSide) return {};
  return "the longest side is " + numberText(side) +
         ": terms in 1/length^3 are written for sides from 1e-75 to 1e75";
}

std::string fieldsToPly(const TriangleMesh& mesh, const SurfaceFields& fields,
                        const SurfaceView& view) {
  assert(!whyNoFieldsFile(mesh));
  std::string ply = "ply\nformat binary_little_endian 1.0\ncomment flatland fields\n";
  ply += "element vertex " + std::to_string(mesh.vertexCount()) + "\n";
  for (const char* column : kColumns) ply += "property double " + std::string(column) + "\n";
  ply += "property uint file_vertex\n";
  ply += "element face " + std::to_string(mesh.triangleCount()) +
         "\nproperty list uchar uint vertex_indices\nend_header\n";
  ply.reserve(ply.size() + mesh.vertexCount() * (8 * kColumns.size() + 4) +
              mesh.triangleCount() * 13);
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    for (const double value : rowOf(mesh, fields, view, v)) {
      appendBytes(ply, std::bit_cast<std::uint64_t>(value));
    }
    appendBytes(ply, mesh.fileVertex[v]);
  }
  for (const auto& triangle : mesh.triangles) {
    ply += '\x03';
    for (const std::uint32_t v : triangle) appendBytes(ply, v);
  }
  return ply;
}

std::string fieldsToCsv(const TriangleMesh& mesh, const SurfaceFields& fields,
                        const SurfaceView& view) {
  assert(!whyNoFieldsFile(mesh));
  std::string csv;
  for (const char* column : kColumns) csv += std::string(column) + ",";
  csv += "file_vertex\r\n";
  for (std::uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    for (const double value : rowOf(mesh, fields, view, v)) csv += numberText(value, "") + ",";
    csv += std::to_string(mesh.fileVertex[v]) + "\r\n";
  }
  return csv;
}

}  // namespace flatland
