// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_words.h"

#include <sstream>

#include "ui/export/figure.h"

namespace flatland::ui {

std::string inWords(const FigureWords& words, const std::string& english,
                    const std::vector<std::string>& values) {
  std::string text = words ? words(english) : english;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string slot = "%" + std::to_string(i + 1);
    const std::size_t at = text.find(slot);
    if (at != std::string::npos) text.replace(at, slot.size(), values[i]);
  }
  return text;
}

std::vector<std::string> wrapped(const std::string& text, double textPx, double widthPx) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || estimatedWidth(longer, textPx) <= widthPx) {
      lines.back() = longer;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

}  // namespace flatland::ui
