// SPDX-License-Identifier: GPL-3.0-or-later
// One reader (FUZZED_READER) on arbitrary bytes: it either refuses them with an InputError or gives
// a soup that buildMesh takes, again with an InputError at most, and whose mesh is finite.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core3d/io/read_mesh.h"
#include "flatland/io/input_error.h"

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const flatland::PolygonSoup& soup) {
  require(!soup.corners.empty());
  for (const std::uint32_t v : soup.corners) require(v < soup.vertexCount());
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) require(soup.polygon(i).size() >= 3);
  for (const double value : soup.positions) require(std::isfinite(value));
}

void check(const flatland::TriangleMesh& mesh) {
  for (const auto* coordinates : {&mesh.x, &mesh.y, &mesh.z}) {
    for (const float value : *coordinates) require(std::abs(value) <= 1.0f);
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    require(a < mesh.vertexCount() && b < mesh.vertexCount() && c < mesh.vertexCount());
    require(a != b && b != c && c != a);
  }
  for (std::uint32_t h = 0; h < mesh.opposite.size(); ++h) {
    require(!mesh.hasOpposite(h) || mesh.opposite[mesh.opposite[h]] == h);
  }
  require(mesh.cornersAt.size() == 3 * mesh.triangleCount());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
#ifdef FUZZED_FOLDER
    const flatland::PolygonSoup soup = flatland::FUZZED_READER(bytes, "fuzz", "");
#else
    const flatland::PolygonSoup soup = flatland::FUZZED_READER(bytes, "fuzz");
#endif
    check(soup);
    check(flatland::buildMesh(soup).mesh);
  } catch (const flatland::InputError&) {
  }
  return 0;
}
