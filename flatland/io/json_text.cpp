// SPDX-License-Identifier: MIT
#include "flatland/io/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "flatland/io/input_error.h"
#include "flatland/io/utf8.h"

namespace flatland {

namespace {

using nlohmann::json;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// "line 3, column 7" of a byte; the end of the text counts as the byte after the last.
std::string placeOf(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t start = before.rfind('\n') + 1;  // npos + 1 is 0
  const std::string_view inLine = before.substr(start);
  const auto column =
      std::count_if(inLine.begin(), inLine.end(), [](char c) { return !isContinuation(c); }) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// Builds the value from the parser's events and knows the path it is at.
class Builder : public nlohmann::json_sax<json> {
 public:
  Builder(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in JSON text

  bool start_object(std::size_t) override { return open(json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    if (levels_.back()->contains(value)) {
      throw InputError(source_, path().empty() ? "top level" : path(),
                       "the key \"" + value + "\" is there twice");
    }
    key_ = value;
    return true;
  }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    // The parser counts the byte it stopped at from 1, and the end of the text as one more.
    const std::size_t byte = std::min(position > 0 ? position - 1 : 0, text_.size());
    throw InputError(source_, placeOf(text_, byte), reasonOf(error));
  }

 private:
  /// The parser's own words without its address: "not valid JSON: unexpected '}'; expected ..."
  static std::string reasonOf(const nlohmann::detail::exception& error) {
    constexpr int kOutOfRange = 406;
    constexpr std::size_t kLongest = 200;
    std::string words = error.what();
    if (error.id == kOutOfRange) {
      const std::size_t quote = words.find('\'');
      words = "number " + (quote == std::string::npos ? "" : words.substr(quote)) +
              " is too large for a double";
    } else {
      const std::size_t dash = words.find(" - ");
      if (dash != std::string::npos) words.erase(0, dash + 3);
      words.insert(0, "not valid JSON: ");
    }
    if (words.size() > kLongest) {
      std::size_t end = kLongest;
      while (end > 0 && isContinuation(words[end])) --end;
      words.resize(end);
      words += " ...";
    }
    return words;
  }

  std::string path() const {
    std::string path;
    for (std::size_t i = 0; i + 1 < levels_.size(); ++i) {
      path = levels_[i]->is_array() ? pathTo(path, levels_[i]->size() - 1)
                                    : pathTo(path, keys_[i + 1]);
    }
    return path;
  }

  template <class Value>
  bool add(Value&& value) {
    place(std::forward<Value>(value));
    return true;
  }

  json* place(json value) {
    if (levels_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    json& parent = *levels_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[key_] = std::move(value));
  }

  bool open(json value) {
    if (levels_.size() >= kDeepestJson) {
      throw InputError(source_, path(),
                       "nested deeper than " + std::to_string(kDeepestJson) + " levels");
    }
    json* const placed = place(std::move(value));
    levels_.push_back(placed);
    keys_.push_back(key_);
    return true;
  }

  bool close() {
    levels_.pop_back();
    keys_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& source_;
  json root_;
  std::vector<json*> levels_;      // open objects and arrays; a parent does not grow meanwhile
  std::vector<std::string> keys_;  // under which each was opened, if in an object
  std::string key_;
};

}  // namespace

nlohmann::json parseJson(const std::string& text, const std::string& source) {
  std::string_view body = text;
  if (body.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    body.remove_prefix(kByteOrderMark.size());
  }
  if (body.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw InputError(source, "", "the file is empty");
  }
  for (std::size_t i = 0; i < body.size();) {
    const std::size_t length = utf8Length(body.substr(i));
    if (length == 0) throw InputError(source, placeOf(body, i), "not UTF-8 text");
    i += length;
  }
  Builder builder(body, source);
  json::sax_parse(body, &builder);  // every error is thrown
  return builder.take();
}

std::string pathTo(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

std::string pathTo(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

}  // namespace flatland
