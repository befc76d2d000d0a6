// SPDX-License-Identifier: MIT
#include "core3d/mesh/vertex_order.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core3d/mesh/hilbert.h"

namespace flatland {

namespace {

constexpr int kBits = 16;  // cells along each side: finer than the edges of 10^9 triangles

struct Place {
  std::uint64_t key;  // along the Hilbert curve
  float x, y, z;
  std::uint32_t fileVertex;
};

// By key, stable: four passes of 12 bits.
void radixSort(std::vector<Place>& places) {
  static_assert(3 * kBits <= 48);
  std::vector<Place> other(places.size());
  for (int shift = 0; shift < 48; shift += 12) {
    std::array<std::uint32_t, 4097> start{};
    for (const Place& p : places) ++start[((p.key >> shift) & 0xfff) + 1];
    for (std::size_t i = 0; i < 4096; ++i) start[i + 1] += start[i];
    for (const Place& p : places) other[start[(p.key >> shift) & 0xfff]++] = p;
    places.swap(other);
  }
}

std::uint32_t cell(float coordinate) {
  constexpr float kHalf = 1 << (kBits - 1);
  const float scaled = (coordinate + 1.0f) * kHalf;
  return static_cast<std::uint32_t>(std::clamp(scaled, 0.0f, 2.0f * kHalf - 1.0f));
}

}  // namespace

bool orderVertices(const PolygonSoup& soup, TriangleMesh& mesh, MeshReport& report) {
  const std::size_t vertices = soup.vertexCount();
  std::vector<char> used(vertices, 0);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) used[v] = 1;
  }
  // Halves of coordinates: their differences stay within the range of double.
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;
  std::size_t count = 0;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!used[v]) continue;
    const Eigen::Array3d p = 0.5 * Eigen::Map<const Eigen::Array3d>(&soup.positions[3 * v]);
    low = low.min(p);
    high = high.max(p);
    ++count;
  }
  report.isolatedVertices = vertices - count;
  if (count == 0 || !((high - low).maxCoeff() > 0.0)) return false;
  mesh.origin = (low + high).matrix();
  mesh.unit = (high - low).maxCoeff();
  // A bounding box of less than the smallest normal number has no digits to lose.
  mesh.unit = std::max(mesh.unit, std::numeric_limits<double>::min());

  std::vector<Place> places;
  places.reserve(count);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!used[v]) continue;
    const Eigen::Array3d p = Eigen::Map<const Eigen::Array3d>(&soup.positions[3 * v]);
    // Twice the difference of halves, for the same reason; + 0 turns -0 into 0.
    const Eigen::Array3f q =
        ((p * 0.5 - mesh.origin.array() * 0.5) / mesh.unit * 2.0).cast<float>() + 0.0f;
    places.push_back({hilbertKey(cell(q.x()), cell(q.y()), cell(q.z()), kBits), q.x(), q.y(), q.z(),
                      static_cast<std::uint32_t>(v)});
  }
  radixSort(places);
  const auto before = [](const Place& p, const Place& q) {
    return std::tie(p.x, p.y, p.z, p.fileVertex) < std::tie(q.x, q.y, q.z, q.fileVertex);
  };
  for (auto i = places.begin(); i != places.end();) {
    auto j = i + 1;
    while (j != places.end() && j->key == i->key) ++j;
    if (j - i > 1) std::sort(i, j, before);
    i = j;
  }

  for (auto* coordinates : {&mesh.x, &mesh.y, &mesh.z}) coordinates->reserve(count);
  mesh.fileVertex.reserve(count);
  mesh.meshVertex.assign(vertices, TriangleMesh::kNone);
  for (const Place& p : places) {
    const bool same =
        !mesh.x.empty() && p.x == mesh.x.back() && p.y == mesh.y.back() && p.z == mesh.z.back();
    if (same) {
      ++report.weldedVertices;
    } else {
      mesh.x.push_back(p.x);
      mesh.y.push_back(p.y);
      mesh.z.push_back(p.z);
      mesh.fileVertex.push_back(p.fileVertex);
    }
    mesh.meshVertex[p.fileVertex] = static_cast<std::uint32_t>(mesh.x.size() - 1);
  }
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& v : triangle) v = mesh.meshVertex[v];
  }
  return true;
}

}  // namespace flatland
