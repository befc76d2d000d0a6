// SPDX-License-Identifier: MIT
#include "core3d/io/text_cursor.h"

#include <charconv>
#include <cmath>

#include "flatland/io/input_error.h"

namespace flatland {

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, kLongest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > kLongest ? "...'" : "'");
}

bool TextCursor::atLineEnd() const {
  return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r';
}

void TextCursor::skipLineEnd() {
  if (at_ == text_.size()) return;
  if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
  ++at_;
  ++line_;
}

void TextCursor::skipBlanks() {
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == ' ' || c == '\t' || c == '\v' || c == '\f') {
      ++at_;
    } else if (c == '\\' && style_.continuations) {
      const std::size_t backslash = at_++;
      if (!atLineEnd() || at_ == text_.size()) {
        at_ = backslash;
        return;
      }
      skipLineEnd();
    } else if (c == '#' && style_.hashComments) {
      while (!atLineEnd()) ++at_;
    } else {
      return;
    }
  }
}

bool TextCursor::nextLine() {
  if (begun_) {
    skipRestOfLine();
    skipLineEnd();
    begun_ = false;
  }
  for (;;) {
    skipBlanks();
    if (at_ == text_.size()) return false;
    if (!atLineEnd()) return true;
    skipLineEnd();
  }
}

void TextCursor::skipRestOfLine() {
  begun_ = true;
  while (!word().empty()) {
  }
}

std::string_view TextCursor::word() {
  begun_ = true;
  skipBlanks();
  const std::size_t begin = at_;
  while (!atLineEnd()) {
    const char c = text_[at_];
    if (c == ' ' || c == '\t' || c == '\v' || c == '\f') break;
    if (c == '#' && style_.hashComments) break;
    if (c == '\\' && style_.continuations && at_ > begin) {
      const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : ' ';
      if (next == '\n' || next == '\r') break;
    }
    ++at_;
  }
  return text_.substr(begin, at_ - begin);
}

double TextCursor::number(const char* what) { return parseNumber(word(), what); }

std::int64_t TextCursor::integer(const char* what) { return parseInteger(word(), what); }

double TextCursor::parseNumber(std::string_view word, const char* what) const {
  if (word.empty()) fail(std::string(what) + " is missing");
  std::string_view digits = word;
  if (digits.front() == '+' && digits.size() > 1 && digits[1] != '-') digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) {
    // Too small for a double is as good as zero; too large is not a coordinate.
    const auto exponent = digits.find_first_of("eE");
    const bool small = exponent != std::string_view::npos && exponent + 1 < digits.size()
                           ? digits[exponent + 1] == '-'
                           : digits.find_first_of("123456789") > digits.find('.');
    if (small && end == digits.data() + digits.size()) return 0.0;
  }
  if (error != std::errc() || end != digits.data() + digits.size()) {
    fail(std::string(what) + " is not a number: " + inQuotes(word));
  }
  if (!std::isfinite(value)) fail(std::string(what) + " is not finite: " + inQuotes(word));
  return value;
}

std::int64_t TextCursor::parseInteger(std::string_view word, const char* what) const {
  if (word.empty()) fail(std::string(what) + " is missing");
  std::string_view digits = word;
  if (digits.front() == '+' && digits.size() > 1 && digits[1] != '-') digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    fail(std::string(what) + " is not a whole number" +
         (error == std::errc::result_out_of_range ? " of reasonable size: " : ": ") +
         inQuotes(word));
  }
  return value;
}

void TextCursor::fail(const std::string& reason) const { failAtLine(line_, reason); }

void TextCursor::failAtLine(std::size_t line, const std::string& reason) const {
  throw InputError(source_, "line " + std::to_string(line), reason);
}

}  // namespace flatland
