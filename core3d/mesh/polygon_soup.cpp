// SPDX-License-Identifier: MIT
#include "core3d/mesh/polygon_soup.h"

#include <cassert>

#include "core3d/mesh/triangle_mesh.h"
#include "flatland/io/input_error.h"

namespace flatland {

std::span<const std::uint32_t> PolygonSoup::polygon(std::size_t i) const {
  if (ends.empty()) return std::span(corners).subspan(3 * i, 3);
  const std::size_t begin = i == 0 ? 0 : ends[i - 1];
  return std::span(corners).subspan(begin, ends[i] - begin);
}

void PolygonSoup::addVertex(double x, double y, double z) {
  positions.insert(positions.end(), {x, y, z});
}

void PolygonSoup::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t triangle[3] = {a, b, c};
  addPolygon(triangle);
}

void PolygonSoup::addPolygon(std::span<const std::uint32_t> polygon) {
  assert(polygon.size() >= 3);
  // The triangles of a polygon have at most three times its corners.
  if (corners.size() + polygon.size() > TriangleMesh::kMaxCorners / 3) {
    throw InputError("", "",
                     "more than " + std::to_string(TriangleMesh::kMaxCorners / 3) +
                         " corners of faces, which is too many");
  }
  if (polygon.size() != 3 && ends.empty()) {
    ends.reserve(corners.size() / 3 + 1);
    for (std::size_t end = 3; end <= corners.size(); end += 3) {
      ends.push_back(static_cast<std::uint32_t>(end));
    }
  }
  const bool onlyTriangles = polygon.size() == 3 && ends.empty();
  corners.insert(corners.end(), polygon.begin(), polygon.end());
  if (!onlyTriangles) ends.push_back(static_cast<std::uint32_t>(corners.size()));
}

void PolygonSoup::addStrip(std::span<const std::uint32_t> strip) {
  for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
    const std::uint32_t a = strip[i], b = strip[i + 1], c = strip[i + 2];
    if (a == b || b == c || c == a) continue;
    if (i % 2 == 0) {
      addTriangle(a, b, c);
    } else {
      addTriangle(b, a, c);
    }
  }
}

void PolygonSoup::addFan(std::span<const std::uint32_t> fan) {
  for (std::size_t i = 1; i + 1 < fan.size(); ++i) {
    const std::uint32_t a = fan[0], b = fan[i], c = fan[i + 1];
    if (a != b && b != c && c != a) addTriangle(a, b, c);
  }
}

}  // namespace flatland
