// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "flatland/curve/vec2.h"

namespace flatland {

/// Reads the tokens of SVG's small languages (path data, transforms, lists of points) from left to
/// right. Everything that does not fit throws InputError with source, place and the character,
/// counted from 1. `text` must outlive the scanner.
class SvgScanner {
 public:
  SvgScanner(std::string_view text, std::string source, std::string place);

  bool atEnd() const { return at_ == text_.size(); }
  char peek() const { return atEnd() ? '\0' : text_[at_]; }
  void advance() { ++at_; }

  /// Spaces, tabs, line ends, form feeds.
  void skipSpace();
  /// The same with at most one comma among it; true if there was one.
  bool skipCommaSpace();
  /// True if another argument follows, be it after space, one comma or nothing ("1-2", ".5.5"). A
  /// comma must be followed by one.
  bool skipToNextArgument();

  bool startsNumber() const;
  /// A number as SVG writes it: sign, digits, point and exponent, each optional but one digit.
  /// Fails where it is not finite.
  double number();
  /// Two numbers with comma or space between, or nothing where that is clear.
  Vec2 pair();
  /// One character, 0 or 1.
  bool flag();
  /// Letters from here on, possibly none.
  std::string_view word();

  /// "'x'" or "the end", for messages.
  std::string found() const;
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  std::string_view text_;
  std::string source_;
  std::string place_;
  std::size_t at_ = 0;
};

}  // namespace flatland
