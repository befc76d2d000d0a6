// SPDX-License-Identifier: MIT
#include "core3d/io/ply_header.h"

#include <algorithm>

#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

// No real header comes near; a file without "end_header" is refused without reading all of it.
constexpr std::size_t kLongestHeader = 1 << 20;

PlyScalar scalarNamed(std::string_view name, const TextCursor& text) {
  struct Named {
    std::string_view name, other;
    PlyScalar type;
  };
  constexpr Named kTypes[] = {
      {"char", "int8", PlyScalar::Int8},        {"uchar", "uint8", PlyScalar::UInt8},
      {"short", "int16", PlyScalar::Int16},     {"ushort", "uint16", PlyScalar::UInt16},
      {"int", "int32", PlyScalar::Int32},       {"uint", "uint32", PlyScalar::UInt32},
      {"float", "float32", PlyScalar::Float32}, {"double", "float64", PlyScalar::Float64}};
  for (const Named& type : kTypes) {
    if (name == type.name || name == type.other) return type.type;
  }
  text.fail("unknown type of a property: " + inQuotes(name));
}

// The bytes up to and with the line "end_header"; throws if there is none.
std::size_t headerLength(std::string_view bytes, const std::string& source) {
  // The style of the first line is that of all: after a bare \r the data may begin with \n.
  const std::string_view firstEnd = bytes.substr(bytes.find_first_of("\r\n"), 2);
  const std::string_view lineEnd = firstEnd == "\r\n" ? firstEnd : firstEnd.substr(0, 1);
  const std::string_view start = bytes.substr(0, kLongestHeader);
  for (std::size_t line = 0; line < start.size();) {
    const std::size_t end = std::min(start.find(lineEnd, line), start.size());
    std::string_view text = start.substr(line, end - line);
    text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
    if (text == "end_header") return std::min(end + lineEnd.size(), bytes.size());
    line = end + lineEnd.size();
  }
  throw InputError(source, "", "the PLY header has no end_header");
}

}  // namespace

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (properties[i].name == property) return i;
  }
  return std::nullopt;
}

PlyHeader readPlyHeader(std::string_view bytes, const std::string& source) {
  const std::size_t afterWord = std::min(bytes.find_first_not_of(" \t", 3), bytes.size());
  if (bytes.substr(0, 3) != "ply" || afterWord == bytes.size() ||
      (bytes[afterWord] != '\n' && bytes[afterWord] != '\r')) {
    throw InputError(source, "line 1", "not a PLY file: it does not begin with the line 'ply'");
  }
  PlyHeader header;
  header.bytes = headerLength(bytes, source);
  TextCursor text(bytes.substr(0, header.bytes), source, {});
  text.nextLine();
  text.word();
  bool hasFormat = false;
  while (text.nextLine()) {
    const std::string_view keyword = text.word();
    if (keyword == "end_header") {
      break;
    } else if (keyword == "comment" || keyword == "obj_info") {
      text.skipRestOfLine();
    } else if (keyword == "format") {
      const std::string_view format = text.word();
      if (format == "binary_little_endian") {
        header.binary = std::endian::little;
      } else if (format == "binary_big_endian") {
        header.binary = std::endian::big;
      } else if (format != "ascii") {
        text.fail("unknown format " + inQuotes(format));
      }
      hasFormat = true;
      text.skipRestOfLine();
    } else if (keyword == "element") {
      PlyElement element;
      element.name = text.word();
      const std::int64_t count = text.integer("number of elements");
      if (count < 0) text.fail("the number of elements is negative");
      element.count = static_cast<std::uint64_t>(count);
      header.elements.push_back(std::move(element));
    } else if (keyword == "property") {
      if (header.elements.empty()) text.fail("a property stands before the first element");
      PlyProperty property{};
      std::string_view type = text.word();
      if (type == "list") {
        property.countType = scalarNamed(text.word(), text);
        if (!isWhole(*property.countType)) text.fail("the length of a list is not a whole number");
        type = text.word();
      }
      property.type = scalarNamed(type, text);
      property.name = text.word();
      if (property.name.empty()) text.fail("a property has no name");
      header.elements.back().properties.push_back(std::move(property));
    } else {
      text.fail("unknown word in the header: " + inQuotes(keyword));
    }
  }
  if (!hasFormat) text.fail("the header does not say the format");
  header.lines = text.line();
  return header;
}

}  // namespace flatland
