// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core3d/io/binary_bytes.h"
#include "core3d/io/read_mesh.h"
#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

constexpr std::size_t kHeader = 84, kFacet = 50;  // bytes

bool sameWord(std::string_view word, std::string_view lower) {
  return word.size() == lower.size() &&
         std::equal(word.begin(), word.end(), lower.begin(), [](char a, char b) {
           return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b);
         });
}

PolygonSoup readAscii(std::string_view bytes, const std::string& source) {
  TextCursor text(bytes, source, {});
  PolygonSoup soup;
  const auto next = [&] {
    const std::string_view word = text.word();
    return word.empty() && text.nextLine() ? text.word() : word;
  };
  const auto expect = [&](std::string_view expected) {
    const std::string_view word = next();
    if (!sameWord(word, expected)) {
      text.fail("'" + std::string(expected) + "' is missing" +
                (word.empty() ? ": the file ends" : ", there is " + inQuotes(word)));
    }
  };
  bool begun = false;
  for (std::string_view word = next(); !word.empty(); word = next()) {
    // Names of solids are passed over, also one that is joined to the file's first word.
    const bool named = !std::exchange(begun, true) && sameWord(word.substr(0, 5), "solid");
    if (named || sameWord(word, "solid") || sameWord(word, "endsolid")) {
      text.skipRestOfLine();
      continue;
    }
    if (!sameWord(word, "facet")) text.fail("'facet' expected, there is " + inQuotes(word));
    // So are normals, which are often wrong or not a number.
    do {
      word = text.word();
    } while (!word.empty() && !sameWord(word, "outer"));
    if (word.empty()) expect("outer");
    expect("loop");
    const auto first = static_cast<std::uint32_t>(soup.vertexCount());
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      const double x = text.number("x of a vertex"), y = text.number("y of a vertex"),
                   z = text.number("z of a vertex");
      soup.addVertex(x, y, z);
    }
    soup.addTriangle(first, first + 1, first + 2);
    expect("endloop");
    expect("endfacet");
  }
  if (soup.corners.empty()) text.fail("the file ends and has no facets");
  return soup;
}

PolygonSoup readBinary(std::string_view bytes, const std::string& source) {
  if (bytes.size() < kHeader) {
    throw InputError(source, "byte " + std::to_string(bytes.size()),
                     "neither a text STL nor long enough for a binary one");
  }
  const auto count = loadAs<std::uint32_t>(bytes.data() + kHeader - 4, std::endian::little);
  const std::size_t room = (bytes.size() - kHeader) / kFacet;
  if (count > room) {
    throw InputError(source, "byte 80",
                     "says that there are " + std::to_string(count) +
                         " facets, but the file ends after " + std::to_string(room));
  }
  if (count == 0) throw InputError(source, "byte 80", "there are no facets");
  PolygonSoup soup;
  soup.positions.reserve(std::size_t{9} * count);
  soup.corners.reserve(std::size_t{3} * count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t facet = kHeader + kFacet * i;
    for (std::size_t k = 0; k < 9; ++k) {
      const std::size_t at = facet + 12 + 4 * k;  // after the normal, which is not used
      const auto value = loadAs<float>(bytes.data() + at, std::endian::little);
      if (!std::isfinite(value)) {
        throw InputError(source, "byte " + std::to_string(at),
                         "a coordinate of facet " + std::to_string(i) + " is not finite");
      }
      soup.positions.push_back(value);
    }
    soup.addTriangle(3 * i, 3 * i + 1, 3 * i + 2);
  }
  const std::size_t rest = bytes.size() - kHeader - kFacet * count;
  if (rest > 0) {
    soup.notes.push_back(std::to_string(rest) + " bytes after the last facet passed over");
  }
  return soup;
}

}  // namespace

PolygonSoup readStl(std::string_view bytes, const std::string& source) {
  // The header of a binary file may begin with "solid" too, but its length tells.
  const bool exact =
      bytes.size() >= kHeader &&
      bytes.size() ==
          kHeader + kFacet * loadAs<std::uint32_t>(bytes.data() + kHeader - 4, std::endian::little);
  if (exact) return readBinary(bytes, source);
  std::string_view start = bytes.substr(0, 1024);
  if (start.substr(0, 3) == "\xEF\xBB\xBF") start.remove_prefix(3);
  const std::size_t word = start.find_first_not_of(" \t\r\n");
  const std::string_view first =
      word == std::string_view::npos ? std::string_view() : start.substr(word, 5);
  const bool isText = sameWord(first, "solid") || sameWord(first, "facet");
  // A text has no zero bytes; the header of a binary file is filled up with them or with blanks.
  if (isText && start.find('\0') == std::string_view::npos) {
    return readAscii(bytes.substr(static_cast<std::size_t>(start.data() - bytes.data())), source);
  }
  return readBinary(bytes, source);
}

}  // namespace flatland
