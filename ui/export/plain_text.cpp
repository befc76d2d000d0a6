// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/plain_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "flatland/io/utf8.h"

namespace flatland::ui {

std::string decimalText(double value) {
  // Rounded first: beyond 1e12 px, where no figure reaches, whole numbers do.
  const double rounded = std::abs(value) < 1e12 ? std::round(value * 1000.0) / 1000.0 : value;
  std::array<char, 400> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                    rounded == 0.0 ? 0.0 : rounded, std::chars_format::fixed, 3);
  std::string text(buffer.data(), result.ptr);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string cleanText(std::string_view text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const auto first = static_cast<unsigned char>(text.front());
    const bool isControl = (first < 0x20U && first != '\n') || first == 0x7FU;
    if (length == 0 || isControl) {
      clean += kReplacement;
      text.remove_prefix(1);
    } else {
      clean += text.substr(0, length);
      text.remove_prefix(length);
    }
  }
  return clean;
}

std::string shellWord(const std::string& text) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=.,:/@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return text;
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'') {
      word += "'\\''";
    } else {
      word += c;
    }
  }
  return word + "'";
}

}  // namespace flatland::ui
