// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

// Text for the writers; not for others.
namespace flatland::ui {

/// `value` with at most three decimals (a thousandth of a px is finer than any device), without
/// trailing zeros or a minus before zero.
std::string decimalText(double value);

/// The text with whatever is not valid UTF-8, and control characters other than newline, replaced
/// by U+FFFD: a file name may hold any byte, an XML or TeX file may not.
std::string cleanText(std::string_view text);

}  // namespace flatland::ui
