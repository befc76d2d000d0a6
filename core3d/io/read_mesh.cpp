// SPDX-License-Identifier: MIT
#include "core3d/io/read_mesh.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>

#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The first word of a text, without a byte order mark.
std::string_view firstWord(std::string_view bytes) {
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  bytes.remove_prefix(begin);
  return bytes.substr(0, bytes.find_first_of(" \t\r\n"));
}

bool endsWithOff(std::string_view word) {
  return word.size() >= 3 && word.size() <= 7 && word.substr(word.size() - 3) == "OFF";
}

std::string readBytes(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw InputError(file.string(), "", "there is no such file");
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(file.string(), "", "is not a regular file");
  }
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw InputError(file.string(), "", error.message());
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), "", std::strerror(errno));
  std::string bytes;
  bytes.resize(size);
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  if (in.bad()) throw InputError(file.string(), "", "cannot be read");
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

PolygonSoup readByContent(const std::filesystem::path& file, std::string_view bytes) {
  const std::string source = file.string();
  const std::string extension = lowerCase(file.extension().string());
  if (bytes.empty()) throw InputError(source, "", "is empty");
  if (bytes.substr(0, 2) == "\x1f\x8b") {
    throw InputError(source, "byte 0", "is compressed (gzip); unpack it first");
  }
  if (bytes.substr(0, 4) == "glTF" || extension == ".glb") {
    return readGltf(bytes, source, file.parent_path().empty() ? "." : file.parent_path());
  }
  const std::string_view word = firstWord(bytes);
  if (word == "ply" || extension == ".ply") return readPly(bytes, source);
  if (extension == ".gltf" || (!word.empty() && word.front() == '{')) {
    return readGltf(bytes, source, file.parent_path().empty() ? "." : file.parent_path());
  }
  // An 80-byte header of a binary STL may begin with anything.
  if (extension == ".stl") return readStl(bytes, source);
  if (endsWithOff(word) || extension == ".off") return readOff(bytes, source);
  if (extension == ".obj") return readObj(bytes, source);
  if (word == "solid") return readStl(bytes, source);
  throw InputError(source, "", "is no mesh file: PLY, OBJ, STL, OFF, glTF and GLB can be read");
}

}  // namespace

std::string readWholeFile(const std::filesystem::path& file) {
  try {
    return readBytes(file);
  } catch (const std::bad_alloc&) {
    throw InputError(file.string(), "", "does not fit into memory");
  } catch (const std::length_error&) {
    throw InputError(file.string(), "", "does not fit into memory");
  }
}

PolygonSoup readPolygons(const std::filesystem::path& file) {
  const std::string bytes = readWholeFile(file);
  try {
    return readByContent(file, bytes);
  } catch (const std::bad_alloc&) {
    throw InputError(file.string(), "", "does not fit into memory");
  }
}

BuiltMesh loadMesh(const std::filesystem::path& file) {
  const PolygonSoup soup = readPolygons(file);
  try {
    return buildMesh(soup, file.string());
  } catch (const std::bad_alloc&) {
    throw InputError(file.string(), "", "does not fit into memory");
  }
}

}  // namespace flatland
