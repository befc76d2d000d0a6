// SPDX-License-Identifier: MIT
// Wavefront OBJ: the polygonal part of the format; free-form curves and surfaces are passed over.
#include <algorithm>
#include <array>

#include "core3d/io/read_mesh.h"
#include "core3d/io/text_cursor.h"

namespace flatland {

namespace {

// Records that are known and say nothing about points or faces.
constexpr std::array<std::string_view, 41> kOther = {
    "vt",       "vn",       "vp",     "p",          "l",         "curv",   "curv2",
    "surf",     "g",        "o",      "s",          "mg",        "mtllib", "usemtl",
    "usemap",   "maplib",   "cstype", "deg",        "bmat",      "step",   "parm",
    "trim",     "hole",     "scrv",   "sp",         "end",       "con",    "bevel",
    "c_interp", "d_interp", "lod",    "shadow_obj", "trace_obj", "ctech",  "stech",
    "call",     "csh",      "bzp",    "bsp",        "cdc",       "res"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& source)
      : text_(bytes.substr(0, 3) == "\xEF\xBB\xBF" ? bytes.substr(3) : bytes, source,
              {.hashComments = true, .continuations = true}) {}

  PolygonSoup read() {
    while (text_.nextLine()) {
      const std::string_view keyword = text_.word();
      if (keyword == "v") {
        vertex();
      } else if (keyword == "f" || keyword == "fo") {
        face();
      } else if (std::find(kOther.begin(), kOther.end(), keyword) == kOther.end()) {
        unknown(keyword);
      }
    }
    for (const Ahead& ahead : ahead_) {
      if (ahead.vertex >= soup_.vertexCount()) {
        text_.failAtLine(ahead.line, "a face uses vertex " + std::to_string(ahead.vertex + 1) +
                                         " of " + std::to_string(soup_.vertexCount()));
      }
    }
    if (soup_.corners.empty()) text_.fail("the file ends and has no faces");
    note(thinFaces_, "face", "with less than three corners left out");
    note(unknown_, "record", "of unknown kind passed over");
    return std::move(soup_);
  }

 private:
  struct Ahead {
    std::size_t vertex, line;
  };

  void vertex() {
    const double x = text_.number("x of a vertex"), y = text_.number("y of a vertex"),
                 z = text_.number("z of a vertex");
    soup_.addVertex(x, y, z);  // what may follow is a weight or a colour
  }

  void face() {
    corners_.clear();
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
      corners_.push_back(corner(word));
    }
    if (corners_.size() < 3) {
      ++thinFaces_;
    } else {
      soup_.addPolygon(corners_);
    }
  }

  // v, v/vt, v//vn or v/vt/vn. Of the other two only the form is looked at.
  std::uint32_t corner(std::string_view word) {
    const std::size_t slash = word.find('/');
    const std::int64_t index = text_.parseInteger(word.substr(0, slash), "vertex of a face");
    if (slash != std::string_view::npos) {
      const std::string_view rest = word.substr(slash + 1);
      const std::size_t second = rest.find('/');
      other(rest.substr(0, second));
      if (second != std::string_view::npos) other(rest.substr(second + 1));
    }
    const auto count = static_cast<std::int64_t>(soup_.vertexCount());
    const std::int64_t place = index > 0 ? index - 1 : count + index;
    constexpr std::int64_t kMost = 0xffffffff;
    if (index == 0) text_.fail("a face uses vertex 0, but the first one is 1");
    if (place < 0 || place >= kMost) {
      text_.fail("a face uses vertex " + std::to_string(index) + " of " + std::to_string(count));
    }
    // A vertex may still come.
    if (place >= count) ahead_.push_back({static_cast<std::size_t>(place), text_.line()});
    return static_cast<std::uint32_t>(place);
  }

  void other(std::string_view word) {
    if (!word.empty()) text_.parseInteger(word, "texture or normal of a face");
  }

  void unknown(std::string_view keyword) {
    const bool text = std::all_of(keyword.begin(), keyword.end(), [](char c) {
      return static_cast<unsigned char>(c) >= ' ' && c != '\x7f';
    });
    if (!text) text_.fail("not an OBJ file: " + inQuotes(keyword));
    ++unknown_;
  }

  void note(std::size_t count, const char* what, const char* rest) {
    if (count == 0) return;
    soup_.notes.push_back(std::to_string(count) + " " + what + (count == 1 ? " " : "s ") + rest);
  }

  TextCursor text_;
  PolygonSoup soup_;
  std::vector<std::uint32_t> corners_;
  std::vector<Ahead> ahead_;
  std::size_t thinFaces_ = 0, unknown_ = 0;
};

}  // namespace

PolygonSoup readObj(std::string_view bytes, const std::string& source) {
  return ObjReader(bytes, source).read();
}

}  // namespace flatland
