// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace flatland {

/// Length of the well-formed UTF-8 sequence at the start of `text`, 0 if there is none
/// (Unicode 15, table 3-7: no overlong forms, no surrogates, nothing above U+10FFFF).
inline std::size_t utf8Length(std::string_view text) {
  const auto byte = [text](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const auto in = [](unsigned value, unsigned low, unsigned high) {
    return low <= value && value <= high;
  };
  if (text.empty()) return 0;
  const unsigned first = byte(0);
  if (first < 0x80U) return 1;
  unsigned low = 0x80U;
  unsigned high = 0xBFU;
  std::size_t length = 0;
  if (in(first, 0xC2U, 0xDFU)) {
    length = 2;
  } else if (in(first, 0xE0U, 0xEFU)) {
    length = 3;
    if (first == 0xE0U) low = 0xA0U;
    if (first == 0xEDU) high = 0x9FU;
  } else if (in(first, 0xF0U, 0xF4U)) {
    length = 4;
    if (first == 0xF0U) low = 0x90U;
    if (first == 0xF4U) high = 0x8FU;
  } else {
    return 0;
  }
  if (!in(byte(1), low, high)) return 0;
  for (std::size_t i = 2; i < length; ++i) {
    if (!in(byte(i), 0x80U, 0xBFU)) return 0;
  }
  return length;
}

}  // namespace flatland
