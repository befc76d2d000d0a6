// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cli/suggestion.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace flatland::ui {

std::size_t changesBetween(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string nearestName(const std::string& word, const std::vector<std::string>& names) {
  constexpr std::size_t kMostChanges = 3;
  std::string nearest;
  std::size_t fewest = kMostChanges + 1;
  for (const std::string& name : names) {
    const std::size_t changes = changesBetween(word, name);
    if (changes < fewest && 2 * changes <= name.size()) {
      fewest = changes;
      nearest = name;
    }
  }
  return nearest;
}

std::string whyNotNamed(const std::string& what, const std::string& word,
                        const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), word) != names.end()) return {};
  std::string why = "there is no " + what + " " + (word.empty() ? "\"\"" : word) + "; ";
  const std::string nearest = nearestName(word, names);
  if (!nearest.empty()) why += "did you mean " + nearest + "? ";
  why += nearest.empty() ? "there are " : "There are ";
  for (std::size_t i = 0; i < names.size(); ++i) why += (i == 0 ? "" : ", ") + names[i];
  return why;
}

CLI::Validator oneOf(const std::string& what, const std::vector<std::string>& names) {
  return CLI::Validator(
      [what, names](const std::string& word) { return whyNotNamed(what, word, names); }, "");
}

}  // namespace flatland::ui
