// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace flatland::ui {

/// Levenshtein's distance: letters put in, taken out or exchanged.
std::size_t changesBetween(const std::string& a, const std::string& b);

/// The name that is nearest to a mistyped word; empty if none is near (three changes at most, and
/// at most half of its letters).
std::string nearestName(const std::string& word, const std::vector<std::string>& names);

/// Why a word is none of the names: "there is no WHAT countours; did you mean contours? There are
/// a, b, c". Empty if it is one.
std::string whyNotNamed(const std::string& what, const std::string& word,
                        const std::vector<std::string>& names);

/// The check of an option whose values are names.
CLI::Validator oneOf(const std::string& what, const std::vector<std::string>& names);

}  // namespace flatland::ui
