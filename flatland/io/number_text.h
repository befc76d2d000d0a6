// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace flatland {

/// The shortest decimal text that reads back to the same double, in any locale. Minus zero keeps
/// its sign ("-0.0", since readers take "-0" for an integer). Precondition: finite.
inline std::string numberText(double value) {
  if (value == 0.0) return std::signbit(value) ? "-0.0" : "0";
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

/// As numberText; `absent` for a value that does not exist or is not finite.
inline std::string numberText(const std::optional<double>& value, const std::string& absent) {
  return value && std::isfinite(*value) ? numberText(*value) : absent;
}

}  // namespace flatland
