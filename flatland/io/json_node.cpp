// SPDX-License-Identifier: MIT
#include "flatland/io/json_node.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "flatland/io/json_text.h"
#include "flatland/io/number_text.h"
#include "flatland/io/scene_json.h"

namespace flatland {

namespace {

using nlohmann::json;

std::string nameOfType(const json& value) {
  switch (value.type()) {
    case json::value_t::null:
      return "null";
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
      return "a list";
    case json::value_t::string:
      return "a string";
    case json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    default:
      return "a number";
  }
}

}  // namespace

std::string lengthTooLarge(double length) {
  return numberText(length) + " is beyond " + numberText(kLargestLength) +
         ", the largest length supported";
}

void JsonNode::fail(const std::string& reason) const {
  throw InputError(source_, path_.empty() ? "top level" : path_, reason);
}

void JsonNode::failExpected(const std::string& what) const {
  fail("expected " + what + ", found " + nameOfType(value_));
}

void JsonNode::allowKeys(std::initializer_list<const char*> known) const {
  if (!value_.is_object()) failExpected("an object");
  for (const auto& [key, ignored] : value_.items()) {
    bool found = false;
    std::string names;
    for (const char* name : known) {
      found = found || key == name;
      names += (names.empty() ? "" : ", ") + std::string(name);
    }
    if (!found) fail("unknown key " + json(key).dump() + "; known here: " + names);
  }
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
  const auto found = value_.find(key);
  if (found == value_.end()) return std::nullopt;
  return JsonNode(*found, pathTo(path_, key), source_);
}

JsonNode JsonNode::at(const std::string& key) const {
  const std::optional<JsonNode> found = find(key);
  if (!found) fail("missing \"" + key + "\"");
  return *found;
}

JsonNode JsonNode::at(std::size_t index) const {
  return {value_[index], pathTo(path_, index), source_};
}

std::size_t JsonNode::listSize(const std::string& what) const {
  if (!value_.is_array()) failExpected(what);
  return value_.size();
}

double JsonNode::number() const {
  if (!value_.is_number()) failExpected("a number");
  return value_.get<double>();
}

double JsonNode::length() const {
  const double length = number();
  if (std::abs(length) > kLargestLength) fail(lengthTooLarge(length));
  return length;
}

bool JsonNode::boolean() const {
  if (!value_.is_boolean()) failExpected("true or false");
  return value_.get<bool>();
}

int JsonNode::wholeNumber() const {
  const double whole = number();
  if (whole != std::floor(whole) || std::abs(whole) > 1e9) {
    fail("expected a whole number, found " + numberText(whole));
  }
  return static_cast<int>(whole);
}

std::string JsonNode::text() const {
  if (!value_.is_string()) failExpected("a string");
  return value_.get<std::string>();
}

}  // namespace flatland
