// SPDX-License-Identifier: MIT
#include "flatland/io/svg_style.h"

#include <algorithm>
#include <array>
#include <utility>

namespace flatland {

namespace {

constexpr std::string_view kSpace = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// Calls `use` with the words of a text.
template <typename Use>
void forEachWord(std::string_view text, const Use& use) {
  for (std::size_t at = text.find_first_not_of(kSpace); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, at), text.size());
    use(text.substr(at, end - at));
    at = text.find_first_not_of(kSpace, end);
  }
}

bool hasWord(std::string_view text, std::string_view word) {
  bool found = false;
  forEachWord(text, [&](std::string_view each) { found = found || each == word; });
  return found;
}

constexpr std::array kProperties{std::pair{std::string_view("display"), &SvgDrawn::display},
                                 std::pair{std::string_view("visibility"), &SvgDrawn::visibility},
                                 std::pair{std::string_view("fill"), &SvgDrawn::fill},
                                 std::pair{std::string_view("stroke"), &SvgDrawn::stroke}};

SvgDrawn drawnBy(std::string_view declarations) {
  SvgDrawn drawn;
  for (const auto& [property, member] : kProperties) {
    drawn.*member = svgDeclared(declarations, property);
  }
  return drawn;
}

bool saysNothing(const SvgDrawn& drawn) {
  return std::all_of(kProperties.begin(), kProperties.end(),
                     [&](const auto& property) { return (drawn.*property.second).empty(); });
}

/// A blank for each comment, and for the marks of XML around an old sheet.
std::string withoutComments(std::string_view text) {
  std::string plain;
  char quote = '\0';
  while (!text.empty()) {
    std::size_t skipped = 0;
    if (quote == '\0' && text.substr(0, 2) == "/*") {
      const std::size_t end = text.find("*/", 2);
      skipped = end == std::string_view::npos ? text.size() : end + 2;
    } else if (quote == '\0' && text.substr(0, 4) == "<!--") {
      skipped = 4;
    } else if (quote == '\0' && text.substr(0, 3) == "-->") {
      skipped = 3;
    }
    const char c = skipped > 0 ? ' ' : text.front();
    if (c == quote) {
      quote = '\0';
    } else if (quote == '\0' && (c == '"' || c == '\'')) {
      quote = c;
    }
    plain += c;
    text.remove_prefix(std::max<std::size_t>(skipped, 1));
  }
  return plain;
}

/// Walks over a text without comments.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  /// Without the blanks before it.
  std::string_view rest() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kSpace), rest_.size()));
    return rest_;
  }

  /// Up to one of the characters, which is taken too; to the end if there is none. Strings hide
  /// them.
  std::string_view upTo(std::string_view characters) {
    const std::string_view whole = rest_;
    while (!rest_.empty() && characters.find(rest_.front()) == std::string_view::npos) step();
    const std::string_view before = whole.substr(0, whole.size() - rest_.size());
    if (!rest_.empty()) rest_.remove_prefix(1);
    return before;
  }

  /// The text of a block whose brace was taken, with the blocks in it.
  std::string_view block() {
    const std::string_view whole = rest_;
    for (int depth = 1; !rest_.empty(); step()) {
      if (rest_.front() == '{') ++depth;
      if (rest_.front() == '}' && --depth == 0) break;
    }
    const std::string_view inside = whole.substr(0, whole.size() - rest_.size());
    if (!rest_.empty()) rest_.remove_prefix(1);
    return inside;
  }

 private:
  void step() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    if (c != '"' && c != '\'') return;
    const std::size_t end = rest_.find(c);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  }

  std::string_view rest_;
};

}  // namespace

std::string_view svgDeclared(std::string_view text, std::string_view property) {
  std::string_view found;
  Scanner scan(text);
  while (!scan.rest().empty()) {
    const std::string_view declaration = scan.upTo(";");
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos || trimmed(declaration.substr(0, colon)) != property) {
      continue;
    }
    found = trimmed(declaration.substr(colon + 1));
    found = trimmed(found.substr(0, found.find('!')));
  }
  return found;
}

bool SvgStyleSheet::Rule::fits(const SvgElement& element) const {
  return (name.empty() || name == element.name) &&
         std::all_of(ids.begin(), ids.end(),
                     [&](std::string_view id) { return id == element.id; }) &&
         std::all_of(classes.begin(), classes.end(),
                     [&](std::string_view one) { return hasWord(element.classes, one); });
}

std::size_t SvgStyleSheet::Rule::weight() const {
  constexpr std::size_t kMore = 1000;
  return (ids.size() * kMore + classes.size()) * kMore + (name.empty() ? 0 : 1);
}

void SvgStyleSheet::add(std::string_view text) {
  Scanner scan(texts_.emplace_back(withoutComments(text)));
  while (!scan.rest().empty()) {
    if (scan.rest().front() == '@') {
      const std::size_t before = scan.rest().size();
      const std::string_view start = scan.rest();
      const std::string_view prelude = scan.upTo("{;");
      const std::size_t end = before - scan.rest().size();
      const bool hasBlock = prelude.size() < end && start[prelude.size()] == '{';
      const std::string_view inside = hasBlock ? scan.block() : std::string_view();
      passedOver_ += std::any_of(kProperties.begin(), kProperties.end(), [&](const auto& property) {
        return inside.find(property.first) != std::string_view::npos;
      });
      continue;
    }
    const std::string_view selectors = scan.upTo("{");
    const SvgDrawn drawn = drawnBy(scan.block());
    if (saysNothing(drawn)) continue;
    Scanner list(selectors);
    while (!list.rest().empty()) addRule(trimmed(list.upTo(",")), drawn);
  }
}

void SvgStyleSheet::addRule(std::string_view selector, const SvgDrawn& drawn) {
  Rule rule{{}, {}, {}, drawn};
  const auto isPlain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 0x80;
  };
  bool understood = !selector.empty() && rules_.size() < kMostRules;
  for (std::size_t at = 0; at < selector.size() && understood;) {
    const char first = selector[at];
    const bool marked = first == '.' || first == '#';
    const std::size_t begin = marked || first == '*' ? at + 1 : at;
    std::size_t end = begin;
    while (end < selector.size() && isPlain(selector[end])) ++end;
    const std::string_view word = selector.substr(begin, end - begin);
    // `*` and a name stand at the beginning alone, a name or mark is followed by a word.
    understood = first == '*' ? at == 0 && word.empty() : !word.empty() && (marked || at == 0);
    if (first == '.') rule.classes.push_back(word);
    if (first == '#') rule.ids.push_back(word);
    if (!marked && first != '*') rule.name = word;
    at = end;
  }
  if (!understood) {
    ++passedOver_;
    return;
  }
  std::string key = "*";
  if (!rule.name.empty()) key = rule.name;
  if (!rule.classes.empty()) key = "." + std::string(rule.classes.front());
  if (!rule.ids.empty()) key = "#" + std::string(rule.ids.front());
  byKey_[key].push_back(rules_.size());
  rules_.push_back(std::move(rule));
}

SvgDrawn SvgStyleSheet::of(const SvgElement& element) const {
  SvgDrawn drawn;
  if (rules_.empty()) return drawn;
  std::vector<std::size_t> fitting;
  const auto look = [&](const std::string& key) {
    const auto found = byKey_.find(key);
    if (found == byKey_.end()) return;
    for (const std::size_t i : found->second) {
      if (rules_[i].fits(element)) fitting.push_back(i);
    }
  };
  look("*");
  look(std::string(element.name));
  forEachWord(element.classes, [&](std::string_view one) { look("." + std::string(one)); });
  look("#" + std::string(element.id));
  std::sort(fitting.begin(), fitting.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(rules_[a].weight(), a) < std::pair(rules_[b].weight(), b);
  });
  for (const std::size_t i : fitting) {
    for (const auto& [property, member] : kProperties) {
      if (!(rules_[i].drawn.*member).empty()) drawn.*member = rules_[i].drawn.*member;
    }
  }
  return drawn;
}

}  // namespace flatland
