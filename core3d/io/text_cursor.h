// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace flatland {

/// Text as it stands in a file's message: what cannot be printed as '?', cut at 40 characters, in
/// quotes.
std::string inQuotes(std::string_view text);

/// Walks over the words of a text file, line by line, and knows where it is. Words are set apart by
/// blanks and tabs; lines end in \n, \r\n or \r. No copy is made of the text.
class TextCursor {
 public:
  struct Style {
    bool hashComments = false;   ///< '#' begins a comment that ends with the line
    bool continuations = false;  ///< a backslash at its end joins a line with the next one
  };

  TextCursor(std::string_view text, std::string source, Style style, std::size_t firstLine = 1)
      : text_(text), source_(std::move(source)), style_(style), line_(firstLine) {}

  /// Goes to the next line that has a word, beginning with the one it is on if no word of that was
  /// taken. False at the end of the text.
  bool nextLine();

  /// The next word of this line; empty at its end.
  std::string_view word();

  /// The next word as a finite number. `what` names it in the message: "x of a vertex".
  double number(const char* what);

  /// The same for a whole number without fraction or exponent.
  std::int64_t integer(const char* what);

  double parseNumber(std::string_view word, const char* what) const;
  std::int64_t parseInteger(std::string_view word, const char* what) const;

  void skipRestOfLine();
  std::size_t line() const { return line_; }
  std::size_t bytesLeft() const { return text_.size() - at_; }

  /// Throws InputError with the line.
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void failAtLine(std::size_t line, const std::string& reason) const;

 private:
  bool atLineEnd() const;
  void skipBlanks();
  void skipLineEnd();

  std::string_view text_;
  std::string source_;
  Style style_;
  std::size_t line_;
  std::size_t at_ = 0;
  bool begun_ = false;  // something of this line was taken
};

}  // namespace flatland
