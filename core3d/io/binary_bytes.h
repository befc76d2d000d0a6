// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstring>

namespace flatland {

/// The value at `bytes` (any alignment), stored with this byte order.
template <typename T>
T loadAs(const char* bytes, std::endian order) {
  T value;
  if (order == std::endian::native) {
    std::memcpy(&value, bytes, sizeof(T));
  } else {
    char turned[sizeof(T)];
    std::reverse_copy(bytes, bytes + sizeof(T), turned);
    std::memcpy(&value, turned, sizeof(T));
  }
  return value;
}

}  // namespace flatland
