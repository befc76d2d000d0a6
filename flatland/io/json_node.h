// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace flatland {

/// A value of a JSON file with the path that leads to it, read strictly: what is not as asked for
/// is an InputError with the path and the reason. Lives as long as the document and `source`.
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string path, const std::string& source)
      : value_(value), path_(std::move(path)), source_(source) {}

  const nlohmann::json& value() const { return value_; }

  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void failExpected(const std::string& what) const;

  /// It must be an object, and its keys among these.
  void allowKeys(std::initializer_list<const char*> known) const;

  std::optional<JsonNode> find(const std::string& key) const;
  /// The value of a key that must be there.
  JsonNode at(const std::string& key) const;
  JsonNode at(std::size_t index) const;

  std::size_t listSize(const std::string& what) const;
  double number() const;
  /// A coordinate or a distance: at most kLargestLength.
  double length() const;
  bool boolean() const;
  int wholeNumber() const;
  std::string text() const;

 private:
  const nlohmann::json& value_;
  std::string path_;
  const std::string& source_;
};

/// Why this is no length.
std::string lengthTooLarge(double length);

}  // namespace flatland
