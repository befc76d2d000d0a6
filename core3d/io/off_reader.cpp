// SPDX-License-Identifier: MIT
// Object File Format as Geomview writes it: counts, one vertex a line, one face a line.
#include "core3d/io/read_mesh.h"
#include "core3d/io/text_cursor.h"

namespace flatland {

namespace {

// True if the word is a header: [ST][C][N][4][n]OFF, of which 4 and n mean other dimensions.
bool isHeader(std::string_view word, TextCursor& text) {
  if (word.size() < 3 || word.substr(word.size() - 3) != "OFF") return false;
  std::string_view prefix = word.substr(0, word.size() - 3);
  for (const std::string_view part : {"ST", "C", "N"}) {
    if (prefix.substr(0, part.size()) == part) prefix.remove_prefix(part.size());
  }
  if (prefix == "4" || prefix == "n" || prefix == "4n") {
    text.fail(inQuotes(word) + " has points of other than three dimensions");
  }
  if (!prefix.empty()) text.fail("unknown kind of OFF file: " + inQuotes(word));
  return true;
}

}  // namespace

PolygonSoup readOff(std::string_view bytes, const std::string& source) {
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  TextCursor text(bytes, source, {.hashComments = true});
  PolygonSoup soup;
  if (!text.nextLine()) text.fail("the file has no counts");
  std::string_view word = text.word();
  if (isHeader(word, text)) {
    word = text.word();
    if (word == "BINARY") text.fail("binary OFF files cannot be read; save it as text");
    if (word.empty()) {
      if (!text.nextLine()) text.fail("the file ends before the counts");
      word = text.word();
    }
  } else {
    soup.notes.emplace_back("the word OFF at the beginning is missing");
  }
  const std::int64_t vertices = text.parseInteger(word, "number of vertices");
  const std::int64_t faces = text.integer("number of faces");
  // Every vertex takes six bytes ("0 0 0" and a line end), every face two.
  const auto left = static_cast<std::int64_t>(text.bytesLeft());
  if (vertices < 0 || faces < 0) text.fail("a count is negative");
  if (vertices > left / 5 || faces > left) {
    text.fail("the counts, " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
              " faces, are more than the file can hold");
  }
  soup.positions.reserve(3 * static_cast<std::size_t>(vertices));
  for (std::int64_t i = 0; i < vertices; ++i) {
    if (!text.nextLine()) {
      text.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(vertices) +
                " vertices");
    }
    const double x = text.number("x of a vertex"), y = text.number("y of a vertex"),
                 z = text.number("z of a vertex");
    soup.addVertex(x, y, z);  // what may follow is a normal or a colour
  }
  std::vector<std::uint32_t> corners;
  std::size_t thin = 0;
  for (std::int64_t i = 0; i < faces; ++i) {
    if (!text.nextLine()) {
      text.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(faces) +
                " faces");
    }
    const std::int64_t size = text.integer("number of corners of a face");
    if (size < 0) text.fail("a face has a negative number of corners");
    corners.clear();
    for (std::int64_t k = 0; k < size; ++k) {
      const std::int64_t v = text.integer("corner of a face");
      if (v < 0 || v >= vertices) {
        text.fail("a face uses vertex " + std::to_string(v) + ", but they are 0 to " +
                  std::to_string(vertices - 1));
      }
      corners.push_back(static_cast<std::uint32_t>(v));
    }
    if (corners.size() < 3) {
      ++thin;
    } else {
      soup.addPolygon(corners);  // what may follow is a colour
    }
  }
  if (soup.corners.empty()) text.fail("the file has no faces");
  if (thin > 0) {
    soup.notes.push_back(std::to_string(thin) + (thin == 1 ? " face" : " faces") +
                         " with less than three corners left out");
  }
  return soup;
}

}  // namespace flatland
