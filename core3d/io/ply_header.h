// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flatland {

/// Types of values in a PLY file.
enum class PlyScalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

inline std::size_t sizeOf(PlyScalar type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

inline bool isWhole(PlyScalar type) {
  return type != PlyScalar::Float32 && type != PlyScalar::Float64;
}

struct PlyProperty {
  std::string name;
  PlyScalar type;
  std::optional<PlyScalar> countType;  ///< of a list; empty for a single value
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;

  /// Place of the property, or empty.
  std::optional<std::size_t> find(std::string_view property) const;
};

/// What stands before the data of a PLY file (bibliography: turk1994).
struct PlyHeader {
  std::optional<std::endian> binary;  ///< byte order; empty for a text file
  std::vector<PlyElement> elements;
  std::size_t bytes;  ///< length of the header: the data begin there
  std::size_t lines;  ///< how many it has
};

/// Throws InputError with the line. The header's own promises are checked (known types and format,
/// counts that are numbers), not those about the data.
PlyHeader readPlyHeader(std::string_view bytes, const std::string& source);

}  // namespace flatland
