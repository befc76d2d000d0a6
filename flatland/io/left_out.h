// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace flatland {

/// "1 curve", "2 curves".
inline std::string countText(const std::string& what, int count) {
  std::string text = std::to_string(count) + " ";
  if (count == 1) return text + what;
  // The plural goes to the first noun: "shapes with neither ...", "segments of zero length".
  for (const char* link : {" with", " of ", " to "}) {
    const std::size_t at = what.find(link);
    if (at != std::string::npos) return text + what.substr(0, at) + "s" + what.substr(at);
  }
  return text + what + "s";
}

/// Counts what an import leaves out, for one clause to the person.
class LeftOut {
 public:
  void count(const std::string& what, int howMany = 1) {
    if (howMany == 0) return;
    for (auto& [name, number] : counts_) {
      if (name == what) {
        number += howMany;
        return;
      }
    }
    counts_.emplace_back(what, howMany);
  }

  /// "left out: 2 texts, 1 image"; empty if nothing was counted.
  std::string text() const {
    std::string list;
    for (const auto& [what, number] : counts_) {
      list += (list.empty() ? "left out: " : ", ") + countText(what, number);
    }
    return list;
  }

 private:
  std::vector<std::pair<std::string, int>> counts_;
};

}  // namespace flatland
