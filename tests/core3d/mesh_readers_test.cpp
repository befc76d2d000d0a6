// SPDX-License-Identifier: GPL-3.0-or-later
// The readers of PLY, OBJ, STL and OFF on small files: every form that is promised, and the message
// for every way to break it.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "core3d/io/read_mesh.h"
#include "flatland/io/input_error.h"
#include "tests/support/temporary_folder.h"

namespace flatland::test {
namespace {

using Corners = std::vector<std::uint32_t>;
using Reader = std::function<PolygonSoup(std::string_view, const std::string&)>;

std::string messageOf(const Reader& read, const std::string& bytes) {
  try {
    read(bytes, "file");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

template <typename T>
std::string packed(T value, std::endian order) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (order != std::endian::native) bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

const std::string kPlyVertices =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kPlyFaces = "element face 2\nproperty list uchar int vertex_indices\n";
const std::string kFourPoints = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n";

TEST(Ply, AsciiWithTrianglesAndOthers) {
  const PolygonSoup soup = readPly("ply\nformat ascii 1.0\n" + kPlyVertices + kPlyFaces +
                                       "end_header\n" + kFourPoints + "3 0 1 2\n4 0 1 2 3\n",
                                   "");
  EXPECT_EQ(soup.positions[11], 0.5);
  EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 0, 1, 2, 3}));
  EXPECT_EQ(soup.ends, (Corners{3, 7}));
  EXPECT_TRUE(soup.notes.empty());
}

TEST(Ply, BothByteOrdersAndAllTypesAgree) {
  struct Type {
    const char* name;
    std::function<std::string(double, std::endian)> pack;
  };
  const std::vector<Type> types = {
      {"char", [](double v, std::endian e) { return packed(static_cast<std::int8_t>(v), e); }},
      {"uint8", [](double v, std::endian e) { return packed(static_cast<std::uint8_t>(v), e); }},
      {"short", [](double v, std::endian e) { return packed(static_cast<std::int16_t>(v), e); }},
      {"ushort", [](double v, std::endian e) { return packed(static_cast<std::uint16_t>(v), e); }},
      {"int32", [](double v, std::endian e) { return packed(static_cast<std::int32_t>(v), e); }},
      {"uint", [](double v, std::endian e) { return packed(static_cast<std::uint32_t>(v), e); }},
      {"float", [](double v, std::endian e) { return packed(static_cast<float>(v), e); }},
      {"float64", [](double v, std::endian e) { return packed(v, e); }}};
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    for (const Type& position : types) {
      for (const Type& index : types) {
        if (std::string(index.name).find("float") == 0) continue;
        SCOPED_TRACE(std::string(position.name) + " " + index.name);
        // Line ends of another system, properties in another order, others between and after.
        std::string file = std::string("ply\r\nformat binary_") +
                           (order == std::endian::little ? "little" : "big") +
                           "_endian 1.0\r\ncomment x\r\nelement vertex 3\r\n";
        file += "property double other\r\n";
        for (const char* axis : {"z", "y", "x"}) {
          file += std::string("property ") + position.name + " " + axis + "\r\n";
        }
        file += "property list uchar short more\r\nelement face 1\r\nproperty uchar red\r\n";
        file += std::string("property list ") + index.name + " " + index.name + " vertex_index\r\n";
        file += "property float last\r\nend_header\r\n";
        for (int v = 0; v < 3; ++v) {
          file += packed(-1.0, order) + position.pack(v * 7, order) + position.pack(v == 1, order) +
                  position.pack(v == 2, order);
          file += packed(std::uint8_t{2}, order) + packed(std::int16_t{-5}, order) +
                  packed(std::int16_t{-6}, order);
        }
        file += packed(std::uint8_t{9}, order) + index.pack(3, order) + index.pack(2, order) +
                index.pack(0, order) + index.pack(1, order) + packed(1.0f, order);
        const PolygonSoup soup = readPly(file, "");
        EXPECT_EQ(soup.positions, (std::vector<double>{0, 0, 0, 0, 1, 7, 1, 0, 14}));
        EXPECT_EQ(soup.corners, (Corners{2, 0, 1}));
        EXPECT_TRUE(soup.notes.empty());
        // Whatever is missing at the end is missed.
        for (std::size_t cut = 1; cut <= 8; ++cut) {
          EXPECT_THROW(readPly(file.substr(0, file.size() - cut), ""), InputError);
        }
      }
    }
  }
}

TEST(Ply, TriangleStripsTurnEverySecondTriangle) {
  const PolygonSoup soup =
      readPly("ply\nformat ascii 1.0\n" + kPlyVertices +
                  "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
                  kFourPoints + "13 0 1 2 3 -1 3 2 1 -1 0 1 1 2\n",
              "");
  EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 2, 1, 3, 3, 2, 1}));
}

TEST(Ply, HeadersAsOtherProgramsWriteThem) {
  // Blanks after the first word; an element of faces that is there for form's sake alone.
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string file = "ply \t\nformat ascii 1.0\n" + kPlyVertices +
                       "element face 0\nproperty int flags\nelement tristrips 1\n"
                       "property list int int vertex_indices\nend_header\n" +
                       kFourPoints + "4 0 1 2 3\n";
    for (std::size_t at = 0; (at = file.find('\n', at)) != std::string::npos; at += end.size()) {
      file.replace(at, 1, end);
    }
    EXPECT_EQ(readPly(file, "").corners, (Corners{0, 1, 2, 2, 1, 3}));
  }
  EXPECT_EQ(messageOf(readPly, "ply x\n"),
            "file: line 1: not a PLY file: it does not begin with the line 'ply'");
  EXPECT_EQ(messageOf(readPly, "ply "),
            "file: line 1: not a PLY file: it does not begin with the line 'ply'");
}

TEST(Ply, WhatIsWrongIsSaidWithItsPlace) {
  const std::string start = "ply\nformat ascii 1.0\n", data = "end_header\n" + kFourPoints;
  const auto ascii = [&](const std::string& faces) {
    return messageOf(readPly, start + kPlyVertices + kPlyFaces + data + faces);
  };
  EXPECT_EQ(ascii("3 0 1 2\n3 0 1 4\n"),
            "file: line 15: 'face' 1 uses vertex 4, but they are 0 to 3");
  EXPECT_EQ(ascii("3 0 1 2\n"), "file: line 15: the file ends too early");
  EXPECT_EQ(ascii("3 0 1\n3 0 1 2\n"), "file: line 14: a value is missing");
  EXPECT_EQ(ascii("3 0 1 2 3\n3 0 1 2\n"),
            "file: line 14: more values than the header announces: '3'");
  EXPECT_EQ(ascii("3 0 1 2.5\n3 0 1 2\n"), "file: line 14: a value is not a whole number: '2.5'");
  EXPECT_EQ(ascii("-3 0 1 2\n3 0 1 2\n"), "file: line 14: the length of a list is negative");
  EXPECT_EQ(messageOf(readPly, start + kPlyVertices + data),
            "file: line 11: there are no faces: a cloud of points is no mesh");
  EXPECT_EQ(messageOf(readPly, "solid"),
            "file: line 1: not a PLY file: it does not begin with the line 'ply'");
  EXPECT_EQ(
      messageOf(readPly, "ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\nend_header\n"),
      "file: line 4: unknown type of a property: 'half'");
  EXPECT_EQ(messageOf(readPly, start + "element vertex 9999999999\nproperty float x\nend_header\n"),
            "file: line 6: there are too many vertices");
  EXPECT_NE(messageOf(readPly, start + "element vertex 999\nproperty float x\nend_header\n0 0 0\n")
                .find("more than the file can hold"),
            std::string::npos);
  // Elements without properties take no space: their number must not cost time.
  EXPECT_NE(messageOf(readPly,
                      start + "element thing 999999999999999\n" + kPlyVertices + kPlyFaces + data),
            "no error");
}

TEST(Obj, AllFormsOfFaces) {
  const PolygonSoup soup = readObj(
      "# c\nmtllib a.mtl\nv 0 0 0\nv +1 0 0 0.5 0.5 0.5\nv 1 1 0\nv 0 1 1e-400 1.0\nvt 0 0\nvn 0 0 "
      "1\n"
      "g a b\nf 1 2 3\nf 1/1 2/1 3/1 4/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nf -4 -3 -1\n"
      "f 5 1 2\nv 3 3 3 # later\nf 1 2 \\\n 3\nodd record\nl 1 2\n",
      "");
  EXPECT_EQ(soup.vertexCount(), 5u);
  EXPECT_EQ(soup.corners,
            (Corners{0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 0, 1, 2, 0, 1, 3, 4, 0, 1, 0, 1, 2}));
  EXPECT_EQ(soup.polygonCount(), 7u);
  EXPECT_EQ(soup.notes, std::vector<std::string>{"1 record of unknown kind passed over"});
}

TEST(Obj, WhatIsWrongIsSaidWithItsLine) {
  const auto obj = [](const std::string& text) { return messageOf(readObj, text); };
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(obj(points + "f 1 2 4\nf 1 2 3\n"), "file: line 4: a face uses vertex 4 of 3");
  EXPECT_EQ(obj(points + "f 1 2 -4\n"), "file: line 4: a face uses vertex -4 of 3");
  EXPECT_EQ(obj(points + "f 0 1 2\n"),
            "file: line 4: a face uses vertex 0, but the first one is 1");
  EXPECT_EQ(obj(points + "f 1 2 x\n"), "file: line 4: vertex of a face is not a whole number: 'x'");
  EXPECT_EQ(obj(points + "f 1/a 2 3\n"),
            "file: line 4: texture or normal of a face is not a whole number: 'a'");
  EXPECT_EQ(obj("\r\n\rv 1 2\n"), "file: line 3: z of a vertex is missing");
  EXPECT_EQ(obj("v 1 2 1e999\n"), "file: line 1: z of a vertex is not a number: '1e999'");
  EXPECT_EQ(obj("v 1 2 inf\n"), "file: line 1: z of a vertex is not finite: 'inf'");
  EXPECT_EQ(obj("v 1 2 0x10\n"), "file: line 1: z of a vertex is not a number: '0x10'");
  EXPECT_EQ(obj(points), "file: line 4: the file ends and has no faces");
  EXPECT_EQ(obj(""), "file: line 1: the file ends and has no faces");
}

TEST(Stl, AsciiInAnyCaseAndLayout) {
  const PolygonSoup soup = readStl(
      "SOLID my part\nfacet normal nan nan nan\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n"
      "  vertex 0 1 0\n endloop\nendfacet\nendsolid my part\n",
      "");
  EXPECT_EQ(soup.corners, (Corners{0, 1, 2}));
  EXPECT_EQ(soup.positions[3], 1.0);
}

TEST(Stl, AsciiAsOtherProgramsWriteIt) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  std::string oneLine = facet + facet;
  std::replace(oneLine.begin(), oneLine.end(), '\n', ' ');
  for (const std::string& file :
       {facet + facet, "solidpart\n" + facet + facet, "solid facet\n" + oneLine + "endsolid",
        "solid\n" + oneLine + "\nendsolid\nsolid\nendsolid"}) {
    SCOPED_TRACE(file);
    EXPECT_EQ(readStl(file, "").corners, (Corners{0, 1, 2, 3, 4, 5}));
  }
  EXPECT_EQ(messageOf(readStl, "solid\n" + facet + "solidpart\n"),
            "file: line 9: 'facet' expected, there is 'solidpart'");
}

TEST(Stl, BinaryWhateverItsHeaderSays) {
  std::string file = "solid" + std::string(75, ' ') + packed(std::uint32_t{1}, std::endian::little);
  for (const float value : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 2.f, 0.f}) {
    file += packed(value, std::endian::little);
  }
  file += std::string(2, '\x07');
  EXPECT_EQ(readStl(file, "").positions, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 2, 0}));
  const std::string more = std::string("x") + file.substr(1) + "rest";
  EXPECT_EQ(readStl(more, "").notes,
            std::vector<std::string>{"4 bytes after the last facet passed over"});
  std::string nan = file;
  nan.replace(96, 4, packed(std::numeric_limits<float>::quiet_NaN(), std::endian::little));
  EXPECT_EQ(messageOf(readStl, nan), "file: byte 96: a coordinate of facet 0 is not finite");
}

TEST(Stl, WhatIsWrongIsSaidWithItsLine) {
  const auto stl = [](const std::string& text) { return messageOf(readStl, text); };
  EXPECT_EQ(stl("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"),
            "file: line 6: 'vertex' is missing, there is 'endloop'");
  EXPECT_EQ(stl("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
            "file: line 5: 'vertex' is missing: the file ends");
  EXPECT_EQ(stl("solid\nendsolid\n"), "file: line 3: the file ends and has no facets");
  EXPECT_EQ(stl("hello"), "file: byte 5: neither a text STL nor long enough for a binary one");
}

TEST(Off, AllKinds) {
  const Corners expected{0, 1, 2, 0, 1, 2, 3};
  const std::string faces = "3 0 1 2\n4 0 1 2 3 0.5 0.5 0.5\n";
  for (const std::string& file :
       {"OFF\n4 2 0\n" + kFourPoints + faces, "\n# c\nOFF 4 2\n" + kFourPoints + faces,
        "4 2 0\n" + kFourPoints + faces, "off\n4 2 0\n" + kFourPoints + faces,
        std::string("\xEF\xBB\xBF") + "OFF\r\n4 2 0\r\n" + kFourPoints + faces,
        "CNOFF\n4 2 0\n0 0 0 0 0 1 9 9 9 9\n1 0 0 0 0 1 9 9 9 9\n1 1 0 0 0 1 9 9 9 9\n"
        "0 1 0.5 0 0 1 9 9 9 9\n" +
            faces}) {
    SCOPED_TRACE(file);
    const PolygonSoup soup = readOff(file, "");
    EXPECT_EQ(soup.corners, expected);
    EXPECT_EQ(soup.positions[11], 0.5);
  }
}

const std::vector<double> kFour = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5};

TEST(Off, LinesMayBreakAnywhere) {
  const std::vector<double>& four = kFour;
  for (const std::string& file :
       {std::string(
            "OFF 4 2 0\n0 0 0 1 0 0\n1 1\n0 0 1 0.5\n3 0 1 2\n4 0 1\n2 # c\n3 0.5 0.5 0.5\n"),
        "OFF\n4\n2\n0\n" + kFourPoints + "3 0 1 2\n4\n0 1 2 3",
        std::string("NCOFF\n4 2 0\n0 0 0 0 0 1 9 9 9 9 1 0 0 0 0 1 9 9 9 9 "
                    "1 1 0 0 0 1\n9 9 9 9\n0 1 0.5 0 0 1 9 9 9 9\n3 0 1 2\n4 0 1 2 3")}) {
    SCOPED_TRACE(file);
    const PolygonSoup soup = readOff(file, "");
    EXPECT_EQ(soup.positions, four);
    EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 0, 1, 2, 3}));
  }
  // One value less, and the first face could give it: no mesh is better than another one.
  EXPECT_EQ(messageOf(readOff, "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1\n4 3 2 1 0\n3 0 1 2\n"),
            "file: line 6: z of a vertex is missing");
  EXPECT_EQ(messageOf(readOff, "OFF\n4 2 0\n0 0 0 1 0 0\n1 1 0 0 1\n4 3 2 1 0\n3 0 1 2\n"),
            "file: line 7: the file ends after 0 of 2 faces");
}

TEST(Off, PointsWithAFourthCoordinateAndOfStatedDimension) {
  const std::string faces = "3 0 1 2\n4 0 1 2 3\n";
  for (const std::string& file :
       {"4OFF\n4 2 0\n0 0 0 1\n2 0 0 2\n-1 -1 0 -1\n0 4 2 4\n" + faces,
        "nOFF 3\n4 2 0\n" + kFourPoints + faces, "nOFF\n3\n4 2\n" + kFourPoints + faces}) {
    SCOPED_TRACE(file);
    const PolygonSoup soup = readOff(file, "");
    EXPECT_EQ(soup.positions, kFour);
    EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 0, 1, 2, 3}));
  }
}

TEST(Off, BinaryOfEveryKind) {
  const auto integers = [](std::initializer_list<std::int32_t> values) {
    std::string bytes;
    for (const std::int32_t value : values) bytes += packed(value, std::endian::big);
    return bytes;
  };
  const auto file = [&](const std::string& head, std::size_t more, const std::string& dimension) {
    std::string bytes = head + " BINARY # c\r\n" + dimension + integers({4, 2, 0});
    for (std::size_t i = 0; i < kFour.size(); ++i) {
      bytes += packed(static_cast<float>(kFour[i]), std::endian::big);
      for (std::size_t k = 0; i % 3 == 2 && k < more; ++k) bytes += packed(1.0f, std::endian::big);
    }
    return bytes + integers({3, 0, 1, 2, 1, 77, 4, 0, 1, 2, 3, 0});
  };
  for (const auto& [head, more] : std::vector<std::pair<std::string, std::size_t>>{
           {"OFF", 0}, {"NOFF", 3}, {"COFF", 4}, {"STOFF", 2}, {"4OFF", 1}, {"STCN4OFF", 10}}) {
    SCOPED_TRACE(head);
    const std::string bytes = file(head, more, "");
    const PolygonSoup soup = readOff(bytes, "");
    EXPECT_EQ(soup.positions, kFour);
    EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 0, 1, 2, 3}));
    EXPECT_TRUE(soup.notes.empty());
    for (std::size_t left = 0; left < bytes.size(); ++left) {
      EXPECT_THROW(readOff(bytes.substr(0, left), ""), InputError) << left;
    }
  }
  EXPECT_EQ(readOff(file("nOFF", 0, integers({3})), "").positions, kFour);
  EXPECT_EQ(messageOf(readOff, file("nOFF", 0, integers({5}))),
            "file: byte 21: has points of 5 dimensions instead of 3");
  EXPECT_EQ(readOff(file("OFF", 0, "") + "xy", "").notes,
            std::vector<std::string>{"2 bytes after the last face passed over"});
  EXPECT_EQ(messageOf(readOff, "OFF BINARY\n" + integers({0x7fffffff, 1, 0}) + "1234"),
            "file: byte 23: the counts, 2147483647 vertices and 1 faces, are more than the file "
            "can hold");
  EXPECT_EQ(messageOf(readOff, "OFF BINARY\n" + integers({1, 1, 0, 0, 0, 0, 3, 0, 0, 1, 0})),
            "file: byte 51: a face uses vertex 1, but they are 0 to 0");
  EXPECT_EQ(messageOf(readOff, "OFF BINARY\n" + integers({1, 1, 0, 0, 0, 0, 3, 0, 0, 0, 5})),
            "file: byte 55: a face has 5 values of colour");
  EXPECT_EQ(messageOf(readOff, "OFF BINARY\n" + integers({1, 1, 0, 0, 0, 0x7f800000, 0, 0})),
            "file: byte 35: a coordinate of a vertex is not finite");
}

TEST(Off, WhatIsWrongIsSaidWithItsLine) {
  const auto off = [](const std::string& text) { return messageOf(readOff, text); };
  EXPECT_EQ(off("OFF\n4 1 0\n" + kFourPoints + "3 0 1 4\n"),
            "file: line 7: a face uses vertex 4, but they are 0 to 3");
  EXPECT_EQ(off("OFF\n4 1 0\n" + kFourPoints + "3 0 1\n"),
            "file: line 7: corner of a face is missing");
  EXPECT_EQ(off("OFF\n4 1 0\n" + kFourPoints), "file: line 7: the file ends after 0 of 1 faces");
  EXPECT_EQ(
      off("OFF\n99999999 1 0\n" + kFourPoints),
      "file: line 2: the counts, 99999999 vertices and 1 faces, are more than the file can hold");
  EXPECT_EQ(off("nOFF\n4\n1 1 0\n"), "file: line 2: has points of 4 dimensions instead of 3");
  EXPECT_EQ(off("4OFF\n1 1 0\n1 1 1 0\n3 0 0 0"), "file: line 3: a vertex lies at infinity");
  EXPECT_EQ(off("COCOFF\n1 1 0\n"), "file: line 1: unknown kind of OFF file: 'COCOFF'");
  EXPECT_EQ(off("OFF\n-4 1 0\n"), "file: line 2: a count is negative");
  EXPECT_EQ(off("OFF\n4 1 0\n" + kFourPoints + "2 0 1\n"), "file: line 7: the file has no faces");
}

TEST(ReadMesh, ContentGoesBeforeTheExtension) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const std::string& bytes) {
    std::ofstream(folder.path() / name, std::ios::binary) << bytes;
    return folder.path() / name;
  };
  const std::string off = "OFF\n4 2 0\n" + kFourPoints + "3 0 1 2\n3 0 2 3\n";
  EXPECT_EQ(readPolygons(write("mesh.obj", off)).polygonCount(), 2u);
  EXPECT_EQ(readPolygons(write("mesh", off)).polygonCount(), 2u);
  EXPECT_EQ(readPolygons(write("MESH.OBJ", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).polygonCount(),
            1u);
  const auto message = [](const std::filesystem::path& file) {
    try {
      readPolygons(file);
    } catch (const InputError& error) {
      return error.reason();
    }
    return std::string("no error");
  };
  EXPECT_EQ(message(write("text.txt", "hello")),
            "is no mesh file: PLY, OBJ, STL, OFF, glTF and GLB can be read");
  EXPECT_EQ(message(folder.path() / "missing.ply"), "there is no such file");
  EXPECT_EQ(message(folder.path()), "is not a regular file");
  EXPECT_EQ(message(write("empty.obj", "")), "is empty");
}

}  // namespace
}  // namespace flatland::test
