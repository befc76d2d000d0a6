// SPDX-License-Identifier: MIT
// Object File Format of Geomview, as text and binary. Most programs write one vertex or face a
// line, often with values that the header does not announce; Geomview's own files may break lines
// anywhere, with just the values that it does announce.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core3d/io/binary_bytes.h"
#include "core3d/io/read_mesh.h"
#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

constexpr std::size_t kMostColours = 4;  // values after the corners of a face

// What the header says of each vertex.
struct Kind {
  bool texture = false, colour = false, normal = false;
  bool homogeneous = false;  // x, y, z are to be divided by a fourth value
  bool anyDimension = false;

  std::size_t values() const {
    return 3 + (homogeneous ? 1u : 0u) + (normal ? 3u : 0u) + (colour ? kMostColours : 0u) +
           (texture ? 2u : 0u);
  }
};

// [ST][C][N][4][n]OFF, in any order, for programs differ; nullopt if the word is no header.
std::optional<Kind> kindNamed(std::string_view word, const TextCursor& text) {
  if (word == "off") return Kind{};
  if (word.size() < 3 || word.substr(word.size() - 3) != "OFF") return std::nullopt;
  std::string_view prefix = word.substr(0, word.size() - 3);
  Kind kind;
  while (!prefix.empty()) {
    bool* const flag = prefix[0] == 'C'              ? &kind.colour
                       : prefix[0] == 'N'            ? &kind.normal
                       : prefix[0] == '4'            ? &kind.homogeneous
                       : prefix[0] == 'n'            ? &kind.anyDimension
                       : prefix.substr(0, 2) == "ST" ? &kind.texture
                                                     : nullptr;
    if (flag == nullptr || *flag) text.fail("unknown kind of OFF file: " + inQuotes(word));
    *flag = true;
    prefix.remove_prefix(flag == &kind.texture ? 2 : 1);
  }
  return kind;
}

std::string whyNotThree(std::int64_t dimension) {
  return "has points of " + std::to_string(dimension) + " dimensions instead of 3";
}

// "3 vertices and 1 faces" of a file that is too short for them.
std::string tooMany(std::int64_t vertices, std::int64_t faces) {
  return "the counts, " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
         " faces, are more than the file can hold";
}

std::string noSuchVertex(std::int64_t v, std::int64_t vertices) {
  return "a face uses vertex " + std::to_string(v) + ", but they are 0 to " +
         std::to_string(vertices - 1);
}

// Adds a vertex; false if its fourth coordinate is zero.
bool addPoint(PolygonSoup& soup, const Kind& kind, const std::array<double, 4>& p) {
  const double w = kind.homogeneous ? p[3] : 1.0;
  const double x = p[0] / w, y = p[1] / w, z = p[2] / w;
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) return false;
  soup.addVertex(x, y, z);
  return true;
}

constexpr const char* kAtInfinity = "a vertex lies at infinity";

void noteThinFaces(PolygonSoup& soup, std::size_t thin) {
  if (thin == 0) return;
  soup.notes.push_back(std::to_string(thin) + (thin == 1 ? " face" : " faces") +
                       " with less than three corners left out");
}

class BinaryOff {
 public:
  BinaryOff(std::string_view bytes, std::size_t begin, const std::string& source)
      : bytes_(bytes), at_(begin), source_(source) {}

  PolygonSoup read(const Kind& kind) {
    if (kind.anyDimension) {
      if (const std::int32_t dimension = integer(); dimension != 3) fail(whyNotThree(dimension));
    }
    const std::int64_t vertices = integer(), faces = integer();
    integer();  // edges; often 0
    if (vertices < 0 || faces < 0) fail("a count is negative");
    const auto left = static_cast<std::int64_t>(bytes_.size() - at_);
    const auto size = static_cast<std::int64_t>(4 * kind.values());
    if (vertices > left / size || faces > left / 8) fail(tooMany(vertices, faces));
    PolygonSoup soup;
    soup.positions.reserve(3 * static_cast<std::size_t>(vertices));
    for (std::int64_t i = 0; i < vertices; ++i) {
      std::array<double, 4> p{};
      for (std::size_t k = 0; k < kind.values(); ++k) {
        const double value = loadAs<float>(take(4), std::endian::big);
        if (k >= 4) continue;
        p[k] = value;
        if (k < 3 && !std::isfinite(value)) fail("a coordinate of a vertex is not finite");
      }
      if (!addPoint(soup, kind, p)) fail(kAtInfinity);
    }
    std::vector<std::uint32_t> corners;
    std::size_t thin = 0;
    for (std::int64_t i = 0; i < faces; ++i) {
      corners.clear();
      const std::int32_t count = integer();
      if (count < 0) fail("a face has a negative number of corners");
      for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t v = integer();
        if (v < 0 || v >= vertices) fail(noSuchVertex(v, vertices));
        corners.push_back(static_cast<std::uint32_t>(v));
      }
      const std::int32_t colours = integer();
      if (colours < 0 || colours > static_cast<std::int32_t>(kMostColours)) {
        fail("a face has " + std::to_string(colours) + " values of colour");
      }
      take(4 * static_cast<std::size_t>(colours));
      if (corners.size() < 3) {
        ++thin;
      } else {
        soup.addPolygon(corners);
      }
    }
    if (soup.corners.empty()) fail("the file has no faces");
    noteThinFaces(soup, thin);
    if (at_ < bytes_.size()) {
      soup.notes.push_back(std::to_string(bytes_.size() - at_) +
                           " bytes after the last face passed over");
    }
    return soup;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(source_, "byte " + std::to_string(at_), reason);
  }
  const char* take(std::size_t size) {
    if (bytes_.size() - at_ < size) fail("the file ends too early");
    at_ += size;
    return bytes_.data() + at_ - size;
  }
  std::int32_t integer() { return loadAs<std::int32_t>(take(4), std::endian::big); }

  std::string_view bytes_;
  std::size_t at_;
  const std::string& source_;
};

class TextOff {
 public:
  /// `freely`: lines may break between any two values of the vertices, and of a face.
  TextOff(std::string_view bytes, const std::string& source, bool freely)
      : bytes_(bytes),
        source_(source),
        text_(bytes, source, {.hashComments = true}),
        freely_(freely) {}

  PolygonSoup read() {
    if (!text_.nextLine()) text_.fail("the file has no counts");
    std::string_view word = text_.word();
    if (const auto kind = kindNamed(word, text_)) {
      kind_ = *kind;
      word = text_.word();
      if (word == "BINARY") return BinaryOff(bytes_, nextLine(), source_).read(kind_);
      if (word.empty()) word = wordOfNextLine("the file ends before the counts");
      if (kind_.anyDimension) {
        const std::int64_t dimension = text_.parseInteger(word, "number of dimensions");
        if (dimension != 3) text_.fail(whyNotThree(dimension));
        word = text_.word();
        if (word.empty()) word = wordOfNextLine("the file ends before the counts");
      }
    } else {
      soup_.notes.emplace_back("the word OFF at the beginning is missing");
    }
    const std::size_t line = text_.line();
    vertices_ = text_.parseInteger(word, "number of vertices");
    faces_ = text_.parseInteger(value(), "number of faces");
    // The number of edges may be missing, but not where each count has a line.
    if (text_.line() > line) text_.parseInteger(value(), "number of edges");
    checkCounts();
    readVertices();
    readFaces();
    if (soup_.corners.empty()) text_.fail("the file has no faces");
    noteThinFaces(soup_, thin_);
    if (text_.nextLine()) soup_.notes.emplace_back("text after the last face passed over");
    return std::move(soup_);
  }

 private:
  // Where the line after the current one begins, in bytes.
  std::size_t nextLine() {
    text_.skipRestOfLine();
    std::size_t at = bytes_.size() - text_.bytesLeft();
    if (bytes_.substr(at, 2) == "\r\n") ++at;
    return std::min(at + 1, bytes_.size());
  }

  std::string_view wordOfNextLine(const std::string& whyNot) {
    if (!text_.nextLine()) text_.fail(whyNot);
    return text_.word();
  }

  // The next word: of this line, or also of another one.
  std::string_view value() {
    const std::string_view word = text_.word();
    return word.empty() && freely_ && text_.nextLine() ? text_.word() : word;
  }

  void checkCounts() {
    if (vertices_ < 0 || faces_ < 0) text_.fail("a count is negative");
    // Every vertex takes six bytes ("0 0 0" and a line end), every face two.
    const auto left = static_cast<std::int64_t>(text_.bytesLeft());
    if (vertices_ > left / 5 || faces_ > left) text_.fail(tooMany(vertices_, faces_));
  }

  void beginRow(std::int64_t i, std::int64_t count, const char* what) {
    if (text_.nextLine()) return;
    text_.fail("the file ends after " + std::to_string(i) + " of " + std::to_string(count) + what);
  }

  void readVertices() {
    constexpr std::array kNames = {"x of a vertex", "y of a vertex", "z of a vertex",
                                   "w of a vertex"};
    soup_.positions.reserve(3 * static_cast<std::size_t>(vertices_));
    if (freely_) text_.skipRestOfLine();
    for (std::int64_t i = 0; i < vertices_; ++i) {
      if (!freely_) beginRow(i, vertices_, " vertices");
      std::array<double, 4> p{};
      for (std::size_t k = 0; k < (kind_.homogeneous ? 4u : 3u); ++k) {
        p[k] = text_.parseNumber(value(), kNames[k]);
      }
      if (!addPoint(soup_, kind_, p)) text_.fail(kAtInfinity);
      // What follows is a normal or a colour. A line ends it, or else the header tells its length.
      for (std::size_t k = kind_.homogeneous ? 4 : 3; freely_ && k < kind_.values(); ++k) {
        text_.parseNumber(value(), "a value of a vertex");
      }
    }
    // Else a missing value would let the first face give one.
    if (freely_ && !text_.word().empty()) text_.fail("the vertices end within a line");
  }

  void readFaces() {
    std::vector<std::uint32_t> corners;
    for (std::int64_t i = 0; i < faces_; ++i) {
      beginRow(i, faces_, " faces");
      const std::int64_t size = text_.integer("number of corners of a face");
      if (size < 0) text_.fail("a face has a negative number of corners");
      corners.clear();
      for (std::int64_t k = 0; k < size; ++k) {
        const std::int64_t v = text_.parseInteger(value(), "corner of a face");
        if (v < 0 || v >= vertices_) text_.fail(noSuchVertex(v, vertices_));
        corners.push_back(static_cast<std::uint32_t>(v));
      }
      if (corners.size() >= 3) {
        soup_.addPolygon(corners);
      } else if (freely_) {
        text_.fail("a face has less than three corners");
      } else {
        ++thin_;
      }
      if (!freely_) continue;  // what may follow is a colour
      for (std::size_t k = 0; !text_.word().empty(); ++k) {
        if (k == kMostColours) text_.fail("a face has too many values");
      }
    }
  }

  std::string_view bytes_;
  const std::string& source_;
  TextCursor text_;
  bool freely_;
  Kind kind_;
  std::int64_t vertices_ = 0, faces_ = 0;
  std::size_t thin_ = 0;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup readOff(std::string_view bytes, const std::string& source) {
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  try {
    return TextOff(bytes, source, false).read();
  } catch (const InputError& asLines) {
    try {
      return TextOff(bytes, source, true).read();
    } catch (const InputError&) {
      throw asLines;  // what most files are meant to be
    }
  }
}

}  // namespace flatland
