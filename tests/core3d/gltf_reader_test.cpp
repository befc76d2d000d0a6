// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "core3d/io/read_mesh.h"
#include "flatland/io/input_error.h"
#include "tests/support/temporary_folder.h"

namespace flatland::test {
namespace {

using Corners = std::vector<std::uint32_t>;

void put(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
}

// Four points of a unit square as floats, then the indices 0 1 2 3 0 2 as 16-bit numbers.
std::string squareBytes() {
  std::string bytes;
  for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f, 0.f, 1.f, 0.f}) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  for (const int index : {0, 1, 2, 3, 0, 2}) {
    bytes += static_cast<char>(index);
    bytes += '\0';
  }
  return bytes;
}

std::string glb(const std::string& json, const std::string& binary) {
  std::string padded = json;
  padded.resize((json.size() + 3) / 4 * 4, ' ');
  std::string bytes = "glTF";
  put(bytes, 2);
  put(bytes, static_cast<std::uint32_t>(28 + padded.size() + binary.size()));
  put(bytes, static_cast<std::uint32_t>(padded.size()));
  bytes += "JSON" + padded;
  put(bytes, static_cast<std::uint32_t>(binary.size()));
  return bytes + std::string("BIN\0", 4) + binary;
}

const std::string kData =
    R"("asset":{"version":"2.0"},"bufferViews":[{"buffer":0,"byteLength":48},)"
    R"({"buffer":0,"byteOffset":48,"byteLength":12}],"accessors":[)"
    R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
    R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},)"
    R"({"bufferView":1,"componentType":5123,"count":4,"type":"SCALAR"}],)";
const std::string kBuffer = R"("buffers":[{"byteLength":60}])";

std::string meshWith(const std::string& primitives) {
  return R"("meshes":[{"primitives":[)" + primitives + "]}],";
}
const std::string kTriangles = R"({"attributes":{"POSITION":0},"indices":1})";

PolygonSoup read(const std::string& json) { return readGltf(glb(json, squareBytes()), "file", ""); }

std::string messageOf(const std::string& bytes, const std::filesystem::path& folder = "") {
  try {
    readGltf(bytes, "file", folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Gltf, TrianglesStripsAndFans) {
  EXPECT_EQ(read("{" + kData + meshWith(kTriangles) + kBuffer + "}").corners,
            (Corners{0, 1, 2, 3, 0, 2}));
  EXPECT_EQ(read("{" + kData + meshWith(R"({"attributes":{"POSITION":0},"indices":2,"mode":5})") +
                 kBuffer + "}")
                .corners,
            (Corners{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(
      read("{" + kData + meshWith(R"({"attributes":{"POSITION":0},"mode":6})") + kBuffer + "}")
          .corners,
      (Corners{0, 1, 2, 0, 2, 3}));
  const PolygonSoup mixed =
      read("{" + kData + meshWith(kTriangles + R"(,{"attributes":{"POSITION":0},"mode":1})") +
           kBuffer + "}");
  EXPECT_EQ(mixed.corners.size(), 6u);
  EXPECT_EQ(mixed.notes, std::vector<std::string>{"1 group of points or lines passed over"});
}

TEST(Gltf, NodesMoveTheirMeshes) {
  // A parent moved by (10, 0, 0); a child turned by 90 degrees about z and stretched by 2; another
  // one mirrored, whose winding is turned back.
  const PolygonSoup soup =
      read("{" + kData + meshWith(kTriangles) +
           R"("nodes":[{"translation":[10,0,0],"children":[1,2]},)"
           R"({"mesh":0,"rotation":[0,0,0.70710678118654757,0.70710678118654757],"scale":[2,2,2]},)"
           R"({"mesh":0,"matrix":[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,5,0,1]},{"mesh":0}],)"
           R"("scenes":[{"nodes":[0]}],"scene":0,)" +
           kBuffer + "}");
  ASSERT_EQ(soup.vertexCount(), 8u);
  const std::vector<double> expected = {10, 0, 0, 10, 2, 0, 8, 2, 0, 8,  0, 0,
                                        10, 5, 0, 9,  5, 0, 9, 6, 0, 10, 6, 0};
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(soup.positions[i], expected[i], 1e-14);
  EXPECT_EQ(soup.corners, (Corners{0, 1, 2, 3, 0, 2, 4, 6, 5, 7, 6, 4}));
}

TEST(Gltf, BuffersComeFromTheFolderAlone) {
  const TemporaryFolder folder;
  const auto inside = folder.path() / "a" / "b";
  std::filesystem::create_directories(inside);
  for (const auto& place : {folder.path() / "secret.bin", inside / "my data.bin"}) {
    std::ofstream(place, std::ios::binary) << squareBytes();
  }
  std::filesystem::create_symlink(folder.path() / "secret.bin", inside / "link.bin");
  const auto gltf = [&](const std::string& uri) {
    return "{" + kData + meshWith(kTriangles) + R"("buffers":[{"byteLength":60,"uri":")" + uri +
           "\"}]}";
  };
  const auto home = folder.path() / "a";
  EXPECT_EQ(messageOf(gltf("b/my%20data.bin"), home), "no error");
  EXPECT_EQ(messageOf(gltf("./b/../b/my%20data.bin"), home), "no error");
  for (const std::string& uri : {std::string("../secret.bin"), std::string("b/link.bin"),
                                 (folder.path() / "secret.bin").string(), std::string("b")}) {
    EXPECT_EQ(messageOf(gltf(uri), home).find("file: buffers[0]: there is no file '"), 0u) << uri;
  }
  EXPECT_NE(messageOf(gltf("b/my%20data.bin"), ""), "no error");
  EXPECT_EQ(messageOf(gltf("b/my data.bin"), home), "no error");
  EXPECT_EQ(
      messageOf(gltf("b/my%20data.bin%00"), home),
      "file: buffers[0]: there is no file 'b/my%20data.bin%00' beside this one or in a folder "
      "below");
  EXPECT_EQ(
      messageOf(gltf("http://example.org/b.bin"), home),
      "file: buffers[0]: 'http://example.org/b.bin' is an address; only files beside this one "
      "are read");
  // Written out in the file itself.
  EXPECT_EQ(
      messageOf(
          "{" + kData + meshWith(R"({"attributes":{"POSITION":0}})") +
          R"("buffers":[{"byteLength":3,"uri":"data:application/octet-stream;base64,AAAA"}]})"),
      "file: accessors[0]: reaches beyond its buffer");
}

TEST(Gltf, BuffersMayBeLongerSharedOrUnused) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.bin", std::ios::binary) << squareBytes() << "and more";
  const auto gltf = [&](const std::string& buffers, int second) {
    std::string data = kData;
    data.replace(data.find(R"({"buffer":0,"byteOffset":48)"), 11,
                 R"({"buffer":)" + std::to_string(second));
    return "{" + data + meshWith(kTriangles) + "\"buffers\":[" + buffers + "]}";
  };
  const std::string one = R"({"byteLength":60,"uri":"a.bin"})";
  EXPECT_EQ(messageOf(gltf(one, 0), folder.path()), "no error");
  EXPECT_EQ(messageOf(gltf(one + "," + one, 1), folder.path()), "no error");
  EXPECT_EQ(messageOf(gltf(one + R"(,{"byteLength":9,"uri":"missing"})", 0), folder.path()),
            "no error");
  EXPECT_EQ(messageOf(gltf(R"({"byteLength":69,"uri":"a.bin"})", 0), folder.path()),
            "file: buffers[0]: should have 69 bytes, but has 68");
  // What lies beyond the stated length does not count.
  EXPECT_EQ(messageOf(gltf(R"({"byteLength":59,"uri":"a.bin"})", 0), folder.path()),
            "file: accessors[1]: reaches beyond its buffer");
}

TEST(Gltf, DataUris) {
  const auto message = [](const std::string& uri) {
    return messageOf(
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5121,"count":3,"type":"VEC3"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":9}],"buffers":[{"byteLength":9,"uri":")" +
        uri + "\"}]}");
  };
  // Nine bytes: 0 0 0, 1 0 0, 0 1 255; with each of the letters of base64 that is not one or digit.
  EXPECT_EQ(message("data:application/octet-stream;base64,AAAAAQAAAAH/"), "no error");
  EXPECT_EQ(message("data:application/gltf-buffer;base64,AAAAAQAAAAH/"), "no error");
  EXPECT_EQ(message("data:;base64,AAAAAQAAAAH/AA=="), "no error");
  EXPECT_EQ(message("data:;base64,AAAAAQAAAAE="),
            "file: buffers[0]: should have 9 bytes, but has 8");
  EXPECT_EQ(message("data:;base64,AAAAAQAAAA-/"),
            "file: buffers[0]: the base64 of its data URI is malformed");
  EXPECT_EQ(message("data:text/plain,AAAAAQAAAAEA"),
            "file: buffers[0]: its data URI is not base64");
}

// Of four points two are replaced; then all but the first, of points that stand nowhere; then some
// indices.
TEST(Gltf, SparseAccessors) {
  const auto binary = [](int first, int second) {
    std::string bytes = squareBytes();
    for (const int place : {first, second}) {
      bytes += static_cast<char>(place);
      bytes += '\0';
    }
    for (const float value : {7.f, 8.f, 9.f, 4.f, 5.f, 6.f}) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return bytes;
  };
  const auto json = [](const std::string& base, const std::string& count,
                       const std::string& indexType = "5123", const std::string& offset = "0") {
    return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":88}],"bufferViews":[)"
           R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":60,"byteLength":4},)"
           R"({"buffer":0,"byteOffset":64,"byteLength":24}],"accessors":[{)" +
           base + R"("componentType":5126,"count":4,"type":"VEC3","sparse":{"count":)" + count +
           R"(,"indices":{"bufferView":1,"componentType":)" + indexType +
           R"(},"values":{"bufferView":2,"byteOffset":)" + offset +
           R"(}}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}]})";
  };
  const std::string view = R"("bufferView":0,)";
  EXPECT_EQ(readGltf(glb(json(view, "2"), binary(1, 3)), "", "").positions,
            (std::vector<double>{0, 0, 0, 7, 8, 9, 1, 1, 0, 4, 5, 6}));
  EXPECT_EQ(readGltf(glb(json("", "2"), binary(0, 2)), "", "").positions,
            (std::vector<double>{7, 8, 9, 0, 0, 0, 4, 5, 6, 0, 0, 0}));
  EXPECT_EQ(readGltf(glb(json(view, "1", "5123", "12"), binary(3, 0)), "", "").positions,
            (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 4, 5, 6}));
  const auto message = [&](const std::string& text, int first, int second) {
    return messageOf(glb(text, binary(first, second)));
  };
  const std::string astray = "file: accessors[0]: its sparse indices do not rise, or lead nowhere";
  EXPECT_EQ(message(json(view, "2"), 1, 4), astray);
  EXPECT_EQ(message(json(view, "2"), 3, 1), astray);
  EXPECT_EQ(message(json(view, "2"), 2, 2), astray);
  EXPECT_EQ(message(json(view, "5"), 1, 3), "file: accessors[0]: replaces more values than it has");
  EXPECT_EQ(message(json(view, "4294967295"), 1, 3),
            "file: accessors[0]: reaches beyond its buffer");
  EXPECT_EQ(message(json(view, "3"), 1, 2), "file: accessors[0]: reaches beyond its buffer");
  EXPECT_EQ(message(json(view, "2", "5123", "4"), 1, 3),
            "file: accessors[0]: reaches beyond its buffer");
  EXPECT_EQ(message(json(view, "2", "5126"), 1, 3),
            "file: accessors[0]: has sparse indices that are not whole numbers");
  // The indices of a mesh: of 0 1 2 3 0 2 the second and the fifth are replaced by 3 and 1.
  const std::string indices =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":68}],"bufferViews":[)"
      R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12},)"
      R"({"buffer":0,"byteOffset":60,"byteLength":2},{"buffer":0,"byteOffset":64,"byteLength":4}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
      R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR","sparse":{"count":2,)"
      R"("indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}]})";
  const std::string tail("\x01\x04\0\0\x03\0\x01\0", 8);
  EXPECT_EQ(readGltf(glb(indices, squareBytes() + tail), "", "").corners,
            (Corners{0, 3, 2, 3, 1, 2}));
}

TEST(Gltf, BytesAfterAGlb) {
  const std::string bytes = glb("{" + kData + meshWith(kTriangles) + kBuffer + "}", squareBytes());
  EXPECT_EQ(readGltf(bytes + "trailing junk", "", "").notes,
            std::vector<std::string>{"13 bytes after the GLB passed over"});
}

TEST(Gltf, WhatIsWrongIsSaid) {
  const auto message = [](const std::string& json) { return messageOf(glb(json, squareBytes())); };
  const std::string asset = R"("asset":{"version":"2.0"},)";
  const auto withAccessor = [&](const std::string& accessor) {
    return message("{" + asset +
                   R"("bufferViews":[{"buffer":0,"byteLength":48},)"
                   R"({"buffer":0,"byteOffset":59,"byteLength":2},{"buffer":7,"byteLength":48}],)"
                   R"("accessors":[)" +
                   accessor + "]," + meshWith(R"({"attributes":{"POSITION":0}})") + kBuffer + "}");
  };
  const std::string beyond = "file: accessors[0]: reaches beyond its buffer";
  EXPECT_EQ(withAccessor(R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})"),
            beyond);
  EXPECT_EQ(withAccessor(
                R"({"bufferView":0,"byteOffset":4,"componentType":5126,"count":4,"type":"VEC3"})"),
            beyond);
  EXPECT_EQ(withAccessor(R"({"bufferView":1,"componentType":5120,"count":1,"type":"VEC3"})"),
            beyond);
  EXPECT_EQ(
      withAccessor(
          R"({"bufferView":0,"componentType":5126,"count":1537228672809129302,"type":"VEC3"})"),
      "file: 'count' is not a whole number from 0 to 2^32 - 1: '1537228672809129302'");
  EXPECT_EQ(
      withAccessor(R"({"bufferView":0,"componentType":5126,"count":4294967295,"type":"VEC3"})"),
      beyond);
  EXPECT_EQ(withAccessor(R"({"bufferView":2,"componentType":5126,"count":4,"type":"VEC3"})"),
            "file: accessors[0]: has no buffer");
  EXPECT_EQ(withAccessor(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})"),
            "file: accessors[0]: has the wrong type");
  EXPECT_EQ(message("{" + kData + meshWith(R"({"attributes":{"POSITION":9}})") + kBuffer + "}"),
            "file: meshes[0]: accessor 9 does not exist");
  EXPECT_EQ(
      message("{" + kData + meshWith(kTriangles) +
              R"("nodes":[{"mesh":0,"children":[1]},{"children":[0]}],"scenes":[{"nodes":[0]}],)" +
              kBuffer + "}"),
      "file: nodes[0]: has two parents");
  EXPECT_EQ(message("{" + kData + R"("extensionsRequired":["KHR_draco_mesh_compression"],)" +
                    meshWith(kTriangles) + kBuffer + "}"),
            "file: needs the extension 'KHR_draco_mesh_compression', which cannot be read");
  EXPECT_EQ(messageOf("{" + std::string(100000, '[')), "file: the JSON is nested too deeply");
  EXPECT_EQ(messageOf("{\"asset\":"), "file: byte 10: the JSON is malformed");
  EXPECT_EQ(messageOf("[1]"), "file: the JSON is no glTF object");
  // A picture's faults are not the mesh's.
  EXPECT_EQ(message("{" + kData + R"("images":[{"bufferView":99,"mimeType":"image/png"}],)" +
                    meshWith(kTriangles) + kBuffer + "}"),
            "no error");
  std::string cut = glb("{" + kData + meshWith(kTriangles) + kBuffer + "}", squareBytes());
  for (std::size_t left = 0; left < cut.size(); ++left) {
    EXPECT_NE(messageOf(cut.substr(0, left)), "no error") << left;
  }
}

TEST(Gltf, AMeshIsNotShownEndlesslyOften) {
  std::string nodes, roots;
  for (int i = 0; i < 200000; ++i) {
    nodes += i == 0 ? R"({"mesh":0})" : R"(,{"mesh":0})";
  }
  // Few bytes for each node, but many for the file: this one is allowed.
  EXPECT_EQ(read("{" + kData + meshWith(kTriangles) + "\"nodes\":[" + nodes + "]," + kBuffer + "}")
                .polygonCount(),
            400000u);
}

}  // namespace
}  // namespace flatland::test
