// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

// Text for the writers and for what files say of themselves; not for people.
namespace flatland::ui {

/// `value` with at most three decimals (a thousandth of a px is finer than any device), without
/// trailing zeros or a minus before zero.
std::string decimalText(double value);

/// The text with whatever is not valid UTF-8, and control characters other than newline, replaced
/// by U+FFFD: a file name may hold any byte, an XML or TeX file may not.
std::string cleanText(std::string_view text);

/// The text as one word of a POSIX shell, in quotes where it needs them.
std::string shellWord(const std::string& text);

}  // namespace flatland::ui
