// SPDX-License-Identifier: MIT
#pragma once

#include <list>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace flatland {

/// What of an element a style sheet may choose it by.
struct SvgElement {
  std::string_view name, id;
  std::string_view classes;  ///< words set apart by blanks
};

/// The four properties that say whether a shape is drawn; "" where nothing is said.
struct SvgDrawn {
  std::string_view display, visibility, fill, stroke;
};

/// The value of a property in a text "name: value; ...", as an attribute `style` or a rule holds
/// it; "" if it is not there. The last one counts, "!important" is dropped. A part of the text.
std::string_view svgDeclared(std::string_view text, std::string_view property);

/// The style sheets of a drawing, as far as they say what is drawn: rules whose selectors are a
/// name, `*`, `.class`, `#id`, or several of them without a space (CSS 2.1, sections 5 and 6.4).
class SvgStyleSheet {
 public:
  /// Reads a sheet. Cost: linear.
  void add(std::string_view text);

  /// What the rules say of an element; of two the more specific counts, then the later one.
  SvgDrawn of(const SvgElement& element) const;

  /// Rules that say something of the four properties but have another selector, or stand in @media
  /// and the like.
  int passedOver() const { return passedOver_; }

  static constexpr std::size_t kMostRules = 2000;  ///< further ones are passed over

 private:
  struct Rule {
    std::string_view name;  ///< "" for any
    std::vector<std::string_view> ids, classes;
    SvgDrawn drawn;

    bool fits(const SvgElement& element) const;
    /// Ids count most, then classes, then the name.
    std::size_t weight() const;
  };

  void addRule(std::string_view selector, const SvgDrawn& drawn);

  std::list<std::string> texts_;  ///< what the views below are parts of
  std::vector<Rule> rules_;
  /// Rules by an id, else a class, else the name that they ask for: "#a", ".a", "a", "*".
  std::unordered_map<std::string, std::vector<std::size_t>> byKey_;
  int passedOver_ = 0;
};

}  // namespace flatland
