// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flatland::test {

/// One element of an XML text.
struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< the character data directly in it, references resolved
};

/// The elements of an XML text in the order of their start tags, or why it is not well-formed.
/// Knows what the program writes: a declaration, elements, attributes in double quotes, the five
/// named references; no comments, CDATA, DTD or other references.
struct XmlReading {
  std::vector<XmlElement> elements;
  std::optional<std::string> error;
};

inline XmlReading readXml(std::string_view xml) {
  XmlReading reading;
  std::vector<std::size_t> open;
  std::size_t at = 0;
  bool rootSeen = false;
  const auto fail = [&](const std::string& why) {
    reading.error = why + " at byte " + std::to_string(at);
    return reading;
  };
  const auto resolved = [](std::string_view raw) -> std::optional<std::string> {
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      const auto byte = static_cast<unsigned char>(raw[i]);
      if (byte < 0x20U && raw[i] != '\n' && raw[i] != '\t') return std::nullopt;
      if (raw[i] == '<') return std::nullopt;
      if (raw[i] != '&') {
        text += raw[i];
        continue;
      }
      bool known = false;
      for (const auto& [reference, character] : {std::pair<std::string_view, char>{"&amp;", '&'},
                                                 {"&lt;", '<'},
                                                 {"&gt;", '>'},
                                                 {"&quot;", '"'},
                                                 {"&apos;", '\''}}) {
        if (raw.substr(i, reference.size()) == reference) {
          text += character;
          i += reference.size() - 1;
          known = true;
          break;
        }
      }
      if (!known) return std::nullopt;
    }
    return text;
  };

  constexpr std::string_view kDeclaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
  if (xml.substr(0, kDeclaration.size()) != kDeclaration) return fail("no declaration");
  at = kDeclaration.size();
  while (at < xml.size()) {
    if (xml[at] != '<') {
      const std::size_t end = std::min(xml.find('<', at), xml.size());
      const std::optional<std::string> text = resolved(xml.substr(at, end - at));
      if (!text) return fail("bad character data");
      if (open.empty()) {
        if (text->find_first_not_of(" \n") != std::string::npos) return fail("text outside");
      } else {
        reading.elements[open.back()].text += *text;
      }
      at = end;
      continue;
    }
    const bool closing = xml.substr(at, 2) == "</";
    at += closing ? 2 : 1;
    std::size_t nameEnd = at;
    while (nameEnd < xml.size() && (std::isalnum(static_cast<unsigned char>(xml[nameEnd])) != 0)) {
      ++nameEnd;
    }
    const std::string name(xml.substr(at, nameEnd - at));
    if (name.empty()) return fail("no name");
    at = nameEnd;
    if (closing) {
      if (open.empty() || reading.elements[open.back()].name != name)
        return fail("unmatched </" + name);
      open.pop_back();
      if (at >= xml.size() || xml[at] != '>') return fail("no > after </" + name);
      ++at;
      continue;
    }
    if (open.empty() && rootSeen) return fail("second root");
    rootSeen = true;
    XmlElement element{name, {}, {}};
    while (at < xml.size() && xml[at] == ' ') {
      ++at;
      const std::size_t equals = xml.find("=\"", at);
      if (equals == std::string_view::npos) return fail("bad attribute");
      const std::string key(xml.substr(at, equals - at));
      const std::size_t end = xml.find('"', equals + 2);
      if (end == std::string_view::npos) return fail("open attribute");
      const std::optional<std::string> value = resolved(xml.substr(equals + 2, end - equals - 2));
      if (!value) return fail("bad value of " + key);
      if (key.find_first_of(" <>&") != std::string::npos) return fail("bad key " + key);
      if (!element.attributes.emplace(key, *value).second) return fail("second " + key);
      at = end + 1;
    }
    reading.elements.push_back(std::move(element));
    if (xml.substr(at, 2) == "/>") {
      at += 2;
    } else if (at < xml.size() && xml[at] == '>') {
      open.push_back(reading.elements.size() - 1);
      ++at;
    } else {
      return fail("bad tag " + name);
    }
  }
  if (!open.empty()) return fail("open element");
  if (!rootSeen) return fail("no root");
  return reading;
}

}  // namespace flatland::test
