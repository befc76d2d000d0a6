// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace flatland::ui {

/// Turns the English of a figure into the reader's language; empty: as it is.
using FigureWords = std::function<std::string(const std::string&)>;

/// The English in the reader's language, "%1", "%2", ... replaced by the values.
std::string inWords(const FigureWords& words, const std::string& english,
                    const std::vector<std::string>& values = {});

/// The text in lines of at most `widthPx`, broken at spaces; a single word may be longer. At least
/// one line.
std::vector<std::string> wrapped(const std::string& text, double textPx, double widthPx);

}  // namespace flatland::ui
