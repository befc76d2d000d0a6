// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string>

namespace flatland::ui {

// What numbers an option takes. These stand in place of CLI::Range, which lets "nan" through and
// leaves what is no number to a message without advice. Each value of a list is checked. A message
// says what is wanted and what was found: "expected a number from 0.1 to 179, found nan". All
// return the option.

/// A finite number.
CLI::Option* isNumber(CLI::Option* option);

/// A finite number from `least` to `most`; the help says so too.
CLI::Option* isNumber(CLI::Option* option, double least, double most);

/// A whole number, in decimal digits, from `least` to `most`; the help says so too, if `most` is
/// not just what the type of the number holds. Left out it is not told: "a whole number from 0".
CLI::Option* isWhole(CLI::Option* option, std::int64_t least,
                     std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// Why a list that is separated by commas has an empty entry ("contours,,ridges"), or empty. CLI11
/// drops such entries before any check sees them, so this reads the arguments of `app`, which has
/// parsed them.
std::string whyNotLists(const CLI::App& app, int argc, const char* const* argv);

}  // namespace flatland::ui
