// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace flatland {

/// Reads JSON text strictly: UTF-8 (a byte order mark is skipped), one value, no comments, no key
/// twice in an object, numbers within the range of double, nested at most kDeepestJson levels.
/// `source` names the text in errors. Throws InputError with the place: "line L, column C" (columns
/// count characters), or the JSON path for a repeated key.
nlohmann::json parseJson(const std::string& text, const std::string& source);

inline constexpr int kDeepestJson = 16;

/// `path` extended by a key or an index: "curves[0].bezier"; the top level is the empty path.
std::string pathTo(const std::string& path, const std::string& key);
std::string pathTo(const std::string& path, std::size_t index);

}  // namespace flatland
