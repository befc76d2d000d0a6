// SPDX-License-Identifier: MIT
#include "flatland/io/svg_scanner.h"

#include <charconv>
#include <cmath>
#include <system_error>

#include "flatland/io/input_error.h"
#include "flatland/io/utf8.h"

namespace flatland {

namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

SvgScanner::SvgScanner(std::string_view text, std::string source, std::string place)
    : text_(text), source_(std::move(source)), place_(std::move(place)) {}

void SvgScanner::skipSpace() {
  while (isSpace(peek())) ++at_;
}

bool SvgScanner::skipCommaSpace() {
  skipSpace();
  if (peek() != ',') return false;
  ++at_;
  skipSpace();
  return true;
}

bool SvgScanner::skipToNextArgument() {
  const bool comma = skipCommaSpace();
  if (comma && !startsNumber()) fail("expected a number after the comma, found " + found());
  return startsNumber();
}

bool SvgScanner::startsNumber() const {
  const char c = peek();
  return isDigit(c) || c == '.' || c == '-' || c == '+';
}

double SvgScanner::number() {
  const std::size_t start = at_;
  std::size_t end = at_;
  const auto at = [&](std::size_t i) { return i < text_.size() ? text_[i] : '\0'; };
  if (at(end) == '+' || at(end) == '-') ++end;
  const std::size_t digits = end;
  while (isDigit(at(end))) ++end;
  bool any = end > digits;
  if (at(end) == '.') {
    const std::size_t point = ++end;
    while (isDigit(at(end))) ++end;
    any = any || end > point;
  }
  if (!any) fail("expected a number, found " + found());
  // "1em" is a number and a unit, "1e3" a number.
  if (at(end) == 'e' || at(end) == 'E') {
    std::size_t exponent = end + 1;
    if (at(exponent) == '+' || at(exponent) == '-') ++exponent;
    if (isDigit(at(exponent))) {
      while (isDigit(at(exponent))) ++exponent;
      end = exponent;
    }
  }
  std::string_view token = text_.substr(start, end - start);
  if (token.front() == '+') token.remove_prefix(1);  // which from_chars does not know
  double value = 0.0;
  const auto [rest, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error == std::errc::result_out_of_range) {
    // Too small is zero; too large is nothing that could be drawn.
    if (token.find_first_of("eE") == std::string_view::npos ||
        token.substr(token.find_first_of("eE") + 1).front() != '-') {
      fail("the number " + std::string(token.substr(0, 24)) + " is too large");
    }
    value = 0.0;
  } else if (error != std::errc() || rest != token.data() + token.size()) {
    fail("expected a number, found " + found());
  }
  at_ = end;
  return value;
}

Vec2 SvgScanner::pair() {
  const double x = number();
  skipCommaSpace();
  const double y = number();
  return {x, y};
}

bool SvgScanner::flag() {
  const char c = peek();
  if (c != '0' && c != '1') fail("expected a flag, 0 or 1, found " + found());
  ++at_;
  return c == '1';
}

std::string_view SvgScanner::word() {
  const std::size_t start = at_;
  while (isLetter(peek())) ++at_;
  return text_.substr(start, at_ - start);
}

std::string SvgScanner::found() const {
  if (atEnd()) return "the end";
  const std::string_view rest = text_.substr(at_);
  const std::size_t length = utf8Length(rest);
  const auto byte = static_cast<unsigned char>(rest.front());
  if (length == 0 || byte < 0x20U || byte == 0x7fU) {
    return "the byte " + std::to_string(static_cast<int>(byte));
  }
  return "'" + std::string(rest.substr(0, length)) + "'";
}

void SvgScanner::fail(const std::string& reason) const {
  throw InputError(source_, place_ + ", character " + std::to_string(at_ + 1), reason);
}

}  // namespace flatland
