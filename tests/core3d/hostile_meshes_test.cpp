// SPDX-License-Identifier: GPL-3.0-or-later
// Files that lie, exaggerate or are merely odd: each is read or refused with a message of one
// printable line, quickly, and what is read is sound. Real ones stand in mesh_data_test.cpp.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <ctime>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "core3d/io/read_mesh.h"
#include "flatland/io/input_error.h"
#include "tests/core3d/mesh_check.h"

namespace flatland::test {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr double kSeconds = 10.0;
constexpr bool kSanitized = true;
#else
constexpr double kSeconds = 1.0;  // of processor time
constexpr bool kSanitized = false;
#endif

using Reader = std::function<PolygonSoup(const std::string&)>;

const Reader kPly = [](const std::string& bytes) { return readPly(bytes, "file"); };
const Reader kObj = [](const std::string& bytes) { return readObj(bytes, "file"); };
const Reader kStl = [](const std::string& bytes) { return readStl(bytes, "file"); };
const Reader kOff = [](const std::string& bytes) { return readOff(bytes, "file"); };
const Reader kGltf = [](const std::string& bytes) { return readGltf(bytes, "file", ""); };

// Every reason stands in tests/data/mesh_reasons.txt, by which the window's translations are
// tested.
void expectListed(const std::string& reason) {
  static const std::set<std::string> kListed = [] {
    std::set<std::string> lines;
    std::ifstream file(FLATLAND_TEST_DATA "/mesh_reasons.txt");
    for (std::string line; std::getline(file, line);) lines.insert(line);
    return lines;
  }();
  EXPECT_TRUE(kListed.contains(reason)) << "not in tests/data/mesh_reasons.txt: " << reason;
}

// "N" for a mesh of N triangles, else the message.
std::string outcome(const Reader& read, const std::string& bytes) {
  const std::clock_t start = std::clock();
  std::string result;
  try {
    const BuiltMesh built = buildMesh(read(bytes), "file");
    expectSound(built.mesh);
    result = std::to_string(built.mesh.triangleCount());
  } catch (const InputError& error) {
    result = error.what();
    expectListed(error.reason());
    EXPECT_EQ(result.rfind("file: ", 0), 0u) << result;
    for (const char c : result) EXPECT_TRUE(c >= ' ' && c <= '~') << result;
  }
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, kSeconds);
  return result;
}

struct Case {
  std::string bytes;
  std::string expected;  // the outcome, or a part of the message
};

void expectAll(const Reader& read, const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    SCOPED_TRACE(one.bytes.substr(0, 300));
    const std::string result = outcome(read, one.bytes);
    if (one.expected.find_first_not_of("0123456789") == std::string::npos) {
      EXPECT_EQ(result, one.expected);
    } else {
      EXPECT_NE(result.find(one.expected), std::string::npos) << result;
    }
  }
}

template <typename T>
std::string packed(std::initializer_list<T> values) {
  std::string bytes;
  for (const T& value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
  return bytes;
}

std::string repeated(std::size_t count, const std::function<std::string(std::size_t)>& part) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += part(i);
  return all;
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kList = "property list uchar int vertex_indices\n";
const std::string kThree = "0 0 0\n1 0 0\n0 1 0\n";

std::string ply(const std::string& header, const std::string& data,
                const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + header + "end_header\n" + data;
}
std::string plyFace(const std::string& face) {
  return ply("element vertex 3\n" + kXyz + "element face 1\n" + kList, kThree + face);
}

TEST(HostilePly, CountsAndIndices) {
  expectAll(
      kPly,
      {{plyFace("3 0 1 2\n"), "1"},
       {plyFace("3 0 1 9223372036854775807\n"), "uses vertex 9223372036854775808, but"},
       {plyFace("3 0 1 -9223372036854775808\n"), "uses vertex -9223372036854775808, but"},
       {plyFace("3 0 1 99999999999999999999\n"), "not a whole number of reasonable size"},
       {plyFace("4000000000 0 1 2\n"), "a list of 4000000000 values is longer than the file"},
       {plyFace("3 0 0 0\n"), "all faces lie at one point"},
       {ply("element vertex 3\n" + kXyz + "element face 0\n" + kList, kThree),
        "there are no faces"},
       {ply("element vertex 0\n" + kXyz + "element face 1\n" + kList, "3 0 1 2\n"),
        "uses vertex 0"},
       {ply("element vertex 3\n" + kXyz + "element vertex 3\n" + kXyz + "element face 1\n" + kList,
            kThree + kThree + "3 0 1 2\n"),
        "too many vertices"},
       {ply("element vertex 9223372036854775807\n" + kXyz, kThree), "too many vertices"},
       {ply("element vertex 3\n" + kXyz + "element face 18446744073709551615\n" + kList, kThree),
        "not a whole number of reasonable size"},
       {ply("element vertex 3\n" + kXyz + "element face 9223372036854775807\n" + kList, kThree),
        "more than the file can hold"},
       {ply("element thing 9223372036854775807\nelement vertex 3\n" + kXyz + "element face 1\n" +
                kList,
            kThree + "3 0 1 2\n"),
        "1"}});
}

TEST(HostilePly, HeadersThatLie) {
  const std::string vertices = "element vertex 3\n" + kXyz;
  expectAll(
      kPly,
      {{ply("property float x\n", ""), "before the first element"},
       {ply(vertices + "element face 1\nproperty list uchar float vertex_indices\n",
            kThree + "3 0 1 2\n"),
        "no list of whole numbers"},
       {ply(vertices + "element face 1\nproperty list float int vertex_indices\n",
            kThree + "3 0 1 2\n"),
        "length of a list is not a whole number"},
       {ply(vertices + "element face 1\nproperty int vertex_indices\n", kThree + "1\n"),
        "no list of whole numbers"},
       {ply("element vertex 3\nproperty list uchar float x\nproperty float y\nproperty float z\n",
            kThree),
        "no x"},
       {ply("comment end_header\ncomment \xff\xfe\n" + vertices + "element face 1\n" + kList,
            kThree + "3 0 1 2\n"),
        "1"},
       {"ply\r\nformat ascii 1.0\n" + vertices, "no end_header"},
       {"ply\nelement vertex 0\nend_header\n", "does not say the format"},
       {"ply\n" + std::string(3'000'000, 'x'), "no end_header"},
       {ply(repeated(20'000, [](std::size_t) { return "element e 0\nproperty int p\n"; }) +
                vertices + "element face 1\n" + kList,
            kThree + "3 0 1 2\n"),
        "1"},
       {ply("element vertex 1\n" +
                repeated(20'000,
                         [](std::size_t i) { return "property int p" + std::to_string(i) + "\n"; }),
            repeated(20'000, [](std::size_t) { return "0 "; })),
        "no x"}});
}

TEST(HostilePly, BinaryNumbers) {
  const auto binary = [](const std::string& type, const std::string& vertices,
                         const std::string& face) {
    std::string header = "element vertex 3\n";
    for (const char* axis : {"x", "y", "z"}) header += "property " + type + " " + axis + "\n";
    return ply(header + "element face 1\nproperty list uint int vertex_indices\n", vertices + face,
               "binary_little_endian");
  };
  const std::string face = packed<std::uint32_t>({3, 0, 1, 2});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const double least = std::numeric_limits<double>::min() / 1024.0;
  const double most = std::numeric_limits<double>::max();
  expectAll(
      kPly,
      {{binary("float", packed<float>({0, 0, 0, 1, 0, 0, 0, nan, 0}), face), "y of vertex 2"},
       {binary("float", packed<float>({0, 0, 0, -infinity, 0, 0, 0, 1, 0}), face), "x of vertex 1"},
       {binary("double", packed<double>({-most, 0, 0, most, 0, 0, 0, most, 0}), face), "1"},
       {binary("double", packed<double>({0, 0, 0, least, 0, 0, 0, least, 0}), face), "1"},
       {binary("double", packed<double>({most, 0, 0, most, least, 0, most, 0, least}), face), "1"},
       {binary("float", packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}),
               packed<std::uint32_t>({0xffffffff, 0, 1, 2})),
        "a list of 4294967295 values is longer than the file"},
       {binary("float", packed<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), ""),
        "more than the file can hold"}});
}

TEST(HostileObj, LinesOfEverySort) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectAll(kObj,
            {{"v 0 0 0\rv 1 0 0\r\nv 0 1 0\nf 1 2 3", "1"},
             {"\xEF\xBB\xBF# c\r\n\r\n" + points + "f 1 2 3 # c \\\n", "1"},
             {points + "f 1 2 \\\r\n3", "1"},
             {points + "f 1 2 3 \\", "not a whole number: '\\'"},
             {points + "f 1 2 3\nf 1\\\n 2 \\\n\\\n3", "1"},
             {points + "f 99999999999999999999 1 2\n", "not a whole number of reasonable size"},
             {points + "f 4294967294 1 2\n", "line 4: a face uses vertex 4294967294 of 3"},
             {points + "f -9223372036854775808 1 2\n", "a face uses vertex -9223372036854775808"},
             {points + "f 1/2/3/4 2 3\n", "not a whole number: '3/4'"},
             {points + "f 1// 2/ 3\n", "1"},
             {points + "f 1.0 2 3\n", "not a whole number: '1.0'"},
             {points + "v 0,5 1 2\n", "x of a vertex is not a number: '0,5'"},
             {points + "v 1 2 nan(3)\n", "not finite"},
             {points + "f 1 1 1\nf 1 2 2\n", "no face has an area"},
             {"f 1 2 3\n", "uses vertex 1 of 0"},
             {std::string("v 0 0 0\n\0\0\0", 11), "not an OBJ file"},
             {std::string("\xFF\xFEv\0 \0", 6) + points, "not an OBJ file"},
             {points + "f 1 2 3" + std::string(3'000'000, ' ') + "\n", "1"},
             {points + "o " + std::string(3'000'000, 'x') + "\nf 1 2 3", "1"},
             {points + repeated(200'000, [](std::size_t) { return "\\\n"; }) + "f 1 2 3", "1"},
             {"v 1e308 0 0\nv -1e308 0 0\nv 0 1e308 1e308\nf 1 2 3", "1"}});
}

TEST(HostileObj, PolygonsOfManyCorners) {
  constexpr std::size_t kCorners = 20'000;
  const auto corners = [](const std::function<std::size_t(std::size_t)>& at) {
    return "\nf" +
           repeated(kCorners, [&](std::size_t i) { return " " + std::to_string(at(i) + 1); });
  };
  const auto pointAt = [](double x, double y) {
    return "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
  };
  // A comb, whose teeth are long and thin; a star that crosses itself; one point many times.
  const std::string comb = repeated(kCorners, [&](std::size_t i) {
    return pointAt(static_cast<double>(i), i % 2 == 0 ? 0.0 : 1000.0 + static_cast<double>(i));
  });
  const std::string circle = repeated(kCorners, [&](std::size_t i) {
    const double angle = 6.283185307 * static_cast<double>(i) / kCorners;
    return pointAt(1000.0 * std::cos(angle), 1000.0 * std::sin(angle));
  });
  const auto same = [](std::size_t i) { return i; };
  EXPECT_EQ(outcome(kObj, comb + corners(same)), std::to_string(kCorners - 2));
  outcome(kObj, circle + corners([](std::size_t i) { return i * 7919 % kCorners; }));
  outcome(kObj, circle + corners([](std::size_t i) { return i * i % kCorners; }));
  EXPECT_EQ(outcome(kObj, circle + corners([](std::size_t) { return std::size_t{0}; })),
            "file: all faces lie at one point");
}

TEST(HostileStl, TextOrNot) {
  const std::string facet =
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  const std::string triangle = packed<float>({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + "ab";
  const std::string header = "solid binary" + std::string(68, ' ');
  expectAll(
      kStl,
      {{"solid\r\n" + facet, "1"},
       {"\xEF\xBB\xBFSOLID x\n" + facet + "endsolid", "1"},
       {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "vertex 1 1 0\nendloop\nendfacet\n",
        "'endloop' is missing, there is 'vertex'"},
       {"solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 nan 0\n", "y of a vertex is not finite"},
       {"solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0", "z of a vertex is missing"},
       {"solid\n" + facet + "garbage\n", "'facet' expected, there is 'garbage'"},
       {header + packed<std::uint32_t>({1}) + triangle, "1"},
       {header + packed<std::uint32_t>({1}) + triangle + "trailing", "1"},
       {header + packed<std::uint32_t>({2}) + triangle, "2 facets, but the file ends after 1"},
       {header + packed<std::uint32_t>({0}) + triangle, "there are no facets"},
       {header + packed<std::uint32_t>({0xffffffff}) + triangle, "4294967295 facets"},
       {header, "has no facets"},
       {"solid\n", "has no facets"}});
}

TEST(HostileOff, CountsAndLines) {
  const std::string data = kThree + "3 0 1 2\n";
  expectAll(kOff,
            {{"OFF\n3 1 0\n" + data, "1"},
             {"OFF # c\n\n# c\n3 1 # c\n" + data, "1"},
             {"OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2", "1"},
             {"OFF BINARY\n" + std::string(100, '\0'), "the file has no faces"},
             {"OFF BINARY\n" + std::string(100, '\xff'), "a count is negative"},
             {"OFF BINARY\n" + std::string(100, '\x7f'), "more than the file can hold"},
             {"OFF\n3.0 1 0\n" + data, "number of vertices is not a whole number"},
             {"OFF\n99999999999999999999 1 0\n" + data, "reasonable size"},
             {"OFF\n9223372036854775807 9223372036854775807 0\n" + data, "more than the file"},
             {"OFF\n3 1 0\n" + kThree + "1000000000 0 1 2\n", "corner of a face is missing"},
             {"OFF\n3 1 0\n" + kThree + "-3 0 1 2\n", "negative number of corners"},
             {"OFF\n3 1 0\n" + kThree + "3 0 1 9223372036854775807\n", "uses vertex"},
             {"OFF\n3 0 0\n" + kThree, "the file has no faces"},
             {"OFF\n0 0 0\n", "the file has no faces"},
             {"OFF", "the file ends before the counts"},
             {"nOFF\n3\n3 1 0\n" + data, "1"},
             {"nOFF\n9223372036854775807\n3 1 0\n" + data, "9223372036854775807 dimensions"},
             {"4OFF\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1e300 0 1e-300\n3 0 1 2\n", "at infinity"},
             {"STCNOFF\n3 1 0\n" + data, "1"},
             {std::string("OFF\n3 1 0\n0 0 0\0", 16) + data, "z of a vertex is not a number"}});
}

// A glTF file of text with one triangle, with parts of it replaced.
struct Gltf {
  std::string nodes = R"([{"mesh":0}])";
  std::string meshes = R"([{"primitives":[{"attributes":{"POSITION":0}}]}])";
  std::string accessors = R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}])";
  std::string views = R"([{"buffer":0,"byteLength":36}])";
  std::string buffers = R"([{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
                        R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}])";
  std::string more = {};

  std::string text() const {
    return R"({"asset":{"version":"2.0"},"nodes":)" + nodes + R"(,"meshes":)" + meshes +
           R"(,"accessors":)" + accessors + R"(,"bufferViews":)" + views + R"(,"buffers":)" +
           buffers + more + "}";
  }
};

std::string accessor(const std::string& rest) {
  return R"([{"bufferView":0,"componentType":5126,"type":"VEC3",)" + rest + "}]";
}

TEST(HostileGltf, NumbersThatLie) {
  expectAll(
      kGltf,
      {{Gltf{}.text(), "1"},
       {Gltf{.nodes = R"([{"mesh":0,"scale":[1e999,1,1]}])"}.text(), "number that is too large"},
       {Gltf{.nodes =
                 R"([{"mesh":0,"scale":[1e308,1,1],"children":[1]},{"mesh":0,"scale":[1e9,1,1]}])"}
            .text(),
        "is not finite"},
       {Gltf{.nodes = R"([{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0]}])"}.text(),
        "'matrix' is no list of 16 numbers"},
       {Gltf{.nodes = R"([{"mesh":0,"translation":["1","2","3"]}])"}.text(),
        "nodes[0]: 'translation' is no list of 3 numbers"},
       {Gltf{.nodes = R"([{"mesh":0,"children":"1"}])"}.text(), "nodes[0]: 'children' is no list"},
       {Gltf{.nodes = R"([{"mesh":0,"children":[1.5]}])"}.text(), "no index: '1.5'"},
       {Gltf{.nodes = R"([{"mesh":[0]}])"}.text(), "nodes[0]: 'mesh' is no index"},
       {Gltf{.more = R"(,"scene":[0],"scenes":[{"nodes":[0]}])"}.text(), "scene: is no index"},
       {Gltf{.nodes = R"([{"mesh":0,"rotation":[0,0,0,0]}])"}.text(), "a rotation is zero"},
       {Gltf{.nodes = R"([{"mesh":0,"scale":[0,0,0]}])"}.text(), "all faces lie at one point"},
       {Gltf{.nodes = R"([{"mesh":7}])"}.text(), "meshes[7]: does not exist"},
       {Gltf{.views = R"([{"buffer":4294967296,"byteLength":36}])"}.text(),
        "'buffer' is not a whole number from 0 to 2^32 - 1: '4294967296'"},
       {Gltf{.accessors = accessor(R"("count":-3)")}.text(), "'count' is not a whole number"},
       {Gltf{.accessors = accessor(R"("count":9223372036854775807)")}.text(), "file: "},
       {Gltf{.accessors = accessor(R"("count":3,"byteOffset":18446744073709551600)")}.text(),
        "file: "},
       {Gltf{.accessors = accessor(R"("count":3,"byteOffset":-12)")}.text(),
        "'byteOffset' is not a whole number"},
       {Gltf{.accessors = accessor(R"("count":2.5)")}.text(), "'count' is not a whole number"},
       {Gltf{.accessors = accessor(R"("count":3,"componentType":9)")}.text(), "file: "},
       {Gltf{.accessors =
                 R"([{"componentType":5126,"type":"VEC3","count":3,"sparse":{"count":1,)"
                 R"("indices":{"bufferView":0,"componentType":5125},"values":{"bufferView":0}}}])"}
            .text(),
        "all faces lie at one point"},
       {Gltf{.accessors = R"([{"componentType":5126,"type":"VEC3","count":3}])"}.text(),
        "all faces lie at one point"},
       {Gltf{.accessors = R"([{"componentType":5126,"type":"VEC3","count":4294967295}])"}.text(),
        "too many times over"},
       {Gltf{.views = R"([{"buffer":0,"byteLength":36,"byteStride":-12}])"}.text(),
        "'byteStride' is not a whole number"},
       {Gltf{.views = R"([{"buffer":0.0,"byteLength":36.0}])"}.text(), "1"},
       {Gltf{.views = R"([{"buffer":0,"byteLength":36,"byteStride":4}])"}.text(), "file: "},
       {Gltf{.views = R"([{"buffer":0,"byteLength":4294967296,"byteOffset":12}])"}.text(),
        "file: "},
       {Gltf{.buffers = R"([{"byteLength":4294967295}])"}.text(), "has no data"},
       {Gltf{.buffers = R"([{"byteLength":4294967295,"uri":"data:;base64,AAAA"}])"}.text(),
        "file: "},
       {Gltf{.buffers = R"([{"byteLength":36,"uri":"data:application/octet-stream;base64,####"}])"}
            .text(),
        "file: "},
       {Gltf{.buffers = R"([{"byteLength":36,"uri":"../../etc/passwd"}])"}.text(), "file: "}});
}

TEST(HostileGltf, ShapesOfTheTree) {
  const auto list = [](std::size_t count, const std::function<std::string(std::size_t)>& part) {
    return "[" + repeated(count, [&](std::size_t i) { return (i == 0 ? "" : ",") + part(i); }) +
           "]";
  };
  // A chain of nodes far longer than a stack is deep.
  constexpr std::size_t kDeep = 50'000;
  const std::string chain = list(kDeep, [&](std::size_t i) {
    return i + 1 == kDeep ? std::string(R"({"mesh":0})")
                          : R"({"children":[)" + std::to_string(i + 1) + "]}";
  });
  EXPECT_EQ(outcome(kGltf, Gltf{.nodes = chain}.text()), "1");
  expectAll(
      kGltf,
      {{Gltf{.nodes = R"([{"mesh":0,"children":[0]}])", .more = R"(,"scenes":[{"nodes":[0]}])"}
            .text(),
        "has two parents"},
       {Gltf{.nodes = R"([{"mesh":0,"children":[1]},{"children":[0]}])"}.text(),
        "nodes: each is the child of another"},
       {Gltf{.nodes = R"([{"mesh":0,"children":[9]}])"}.text(), "nodes[9]: does not exist"},
       {Gltf{.nodes = R"({"mesh":0})"}.text(), "'nodes' is no list"},
       {Gltf{.accessors = "[null]"}.text(), "accessors[0]: is no object"},
       {Gltf{.meshes = "[]"}.text(), "meshes[0]: does not exist"},
       {Gltf{.meshes = R"([{"primitives":[{"attributes":{"POSITION":0},"mode":99}]}])"}.text(),
        "file: "},
       {Gltf{.meshes = R"([{"primitives":[{"attributes":{"POSITION":"0"}}]}])"}.text(), "file: "},
       {Gltf{.more = R"(,"scene":3,"scenes":[{"nodes":[0]}])"}.text(), "scene: does not exist"},
       {"{}", "is no glTF: it has no asset.version"},
       {R"({"asset":{"version":"1.0"}})", "glTF version '1.0' instead of 2.0"},
       {R"({"asset":{"version":2}})", "it has no asset.version"},
       {"{\"asset\":\"\xff\"}", "malformed"},
       {"", "malformed"}});
}

long peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

TEST(HostileGltf, ManyNodesOfFewBytes) {
  std::string nodes = R"([{"mesh":0})" + repeated(500'000, [](std::size_t) { return ",{}"; });
  EXPECT_EQ(outcome(kGltf, Gltf{.nodes = nodes + "]"}.text()), "1");
  if (!kSanitized) {
    EXPECT_LT(peakMegabytes(), 200);
  }
}

// A few kilobytes that unfold to many times as much.
TEST(HostileGltf, ManyMeshesOfFewBytes) {
  constexpr std::size_t kPoints = 3'000, kNodes = 2'000;
  const std::string nodes =
      "[" +
      repeated(kNodes,
               [](std::size_t i) { return std::string(i == 0 ? "" : ",") + R"({"mesh":0})"; }) +
      "]";
  const std::string data = R"([{"byteLength":9000,"uri":"data:application/octet-stream;base64,)" +
                           repeated(kPoints,
                                    [](std::size_t i) {
                                      return i % 3 == 0 ? "AAAA" : i % 3 == 1 ? "AQAA" : "AAEA";
                                    }) +
                           "\"}]";
  const std::string bytes =
      Gltf{.nodes = nodes,
           .accessors = R"([{"bufferView":0,"componentType":5121,"count":3000,"type":"VEC3"}])",
           .views = R"([{"buffer":0,"byteLength":9000}])",
           .buffers = data}
          .text();
  EXPECT_EQ(outcome(kGltf, bytes), "file: shows its meshes too many times over");
  if (!kSanitized) {
    EXPECT_LT(peakMegabytes(), 200);
  }
}

// The memory of a text file's vertices is not taken on trust.
TEST(HostilePly, CountsThatTheFileCouldNotHoldInDigits) {
  const std::string header = "element vertex 3000000\n" + kXyz + "element face 1\n" + kList;
  EXPECT_NE(outcome(kPly, ply(header, std::string(9'000'000, ' '))).find("file can hold"),
            std::string::npos);
}

}  // namespace
}  // namespace flatland::test
