// SPDX-License-Identifier: MIT
#include "core3d/io/gltf_buffers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "core3d/io/read_mesh.h"
#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

namespace fs = std::filesystem;

// Where each letter stands in the alphabet of base64; -1 for others.
constexpr std::array<std::int8_t, 256> kSextets = [] {
  std::array<std::int8_t, 256> sextets{};
  sextets.fill(-1);
  std::int8_t next = 0;
  for (const auto& [first, last] : {std::pair('A', 'Z'), std::pair('a', 'z'), std::pair('0', '9'),
                                    std::pair('+', '+'), std::pair('/', '/')}) {
    for (int c = first; c <= last; ++c) sextets[static_cast<std::size_t>(c)] = next++;
  }
  return sextets;
}();

std::optional<std::string> decodedBase64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int held = 0;  // bits not yet written
  for (const char c : text) {
    const std::int8_t sextet = kSextets[static_cast<unsigned char>(c)];
    if (sextet < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(sextet);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xff);
  }
  return bytes;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// "a%20b" as "a b"; a percent sign that begins no escape stays.
std::string unescaped(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escape = uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 &&
                        hexDigit(uri[i + 2]) >= 0;
    name += escape ? static_cast<char>(16 * hexDigit(uri[i + 1]) + hexDigit(uri[i + 2])) : uri[i];
    if (escape) i += 2;
  }
  return name;
}

}  // namespace

GltfBuffers::GltfBuffers(GltfFile& file, const std::string& source, fs::path folder)
    : buffers_(std::move(file.buffers)),
      chunk_(file.binary),
      source_(source),
      folder_(std::move(folder)),
      loaded_(buffers_.size()) {}

std::string_view GltfBuffers::bytes(std::size_t index) {
  if (loaded_[index].data() == nullptr) loaded_[index] = load(buffers_[index], index);
  return loaded_[index];
}

std::string_view GltfBuffers::load(const GltfBuffer& buffer, std::size_t index) {
  const std::string place = "buffers[" + std::to_string(index) + "]";
  std::string_view all = chunk_;
  if (buffer.uri) {
    const std::string& uri = *buffer.uri;
    if (uri.rfind("data:", 0) == 0) {
      constexpr std::string_view kMark = ";base64,";
      const std::size_t mark = uri.find(kMark), comma = uri.find(',');
      if (mark == std::string::npos || mark > comma) {
        throw InputError(source_, place, "its data URI is not base64");
      }
      auto decoded = decodedBase64(std::string_view(uri).substr(mark + kMark.size()));
      if (!decoded) throw InputError(source_, place, "the base64 of its data URI is malformed");
      const std::string& kept = decoded_[index] = std::move(*decoded);
      bytesRead_ += kept.size();
      all = kept;
    } else {
      all = neighbour(uri, place);
    }
  }
  // More is allowed: a chunk is filled up to a multiple of four bytes, a file may be shared.
  if (all.size() < buffer.length) {
    throw InputError(source_, place,
                     "should have " + std::to_string(buffer.length) + " bytes, but has " +
                         std::to_string(all.size()));
  }
  return {all.empty() ? "" : all.data(), buffer.length};
}

const std::string& GltfBuffers::neighbour(const std::string& uri, const std::string& place) {
  if (uri.find("://") != std::string::npos) {
    throw InputError(source_, place,
                     inQuotes(uri) + " is an address; only files beside this one are read");
  }
  const std::string name = unescaped(uri);
  std::error_code error;
  const fs::path home = folder_.empty() ? fs::path() : fs::canonical(folder_, error);
  const auto inside = [&](const fs::path& file) {
    return std::mismatch(home.begin(), home.end(), file.begin(), file.end()).first == home.end();
  };
  fs::path file;
  // A zero byte would end the name early for the system.
  if (!home.empty() && name.find('\0') == std::string::npos) {
    file = fs::canonical(home / name, error);
  }
  if (file.empty() || error || !inside(file) || !fs::is_regular_file(file, error)) {
    throw InputError(source_, place,
                     "there is no file " + inQuotes(uri) + " beside this one or in a folder below");
  }
  const auto [entry, isNew] = files_.try_emplace(file);
  if (isNew) {
    entry->second = readWholeFile(file);
    bytesRead_ += entry->second.size();
  }
  return entry->second;
}

}  // namespace flatland
