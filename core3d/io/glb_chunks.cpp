// SPDX-License-Identifier: MIT
#include "core3d/io/glb_chunks.h"

#include <cstdint>
#include <utility>

#include "core3d/io/binary_bytes.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

[[noreturn]] void failAt(std::size_t byte, const std::string& source, const std::string& reason) {
  throw InputError(source, "byte " + std::to_string(byte), reason);
}

std::uint32_t word(std::string_view bytes, std::size_t at) {
  return loadAs<std::uint32_t>(bytes.data() + at, std::endian::little);
}

}  // namespace

GlbChunks glbChunks(std::string_view bytes, const std::string& source) {
  GlbChunks chunks;
  if (bytes.size() < 20) failAt(bytes.size(), source, "the GLB header is cut short");
  if (word(bytes, 4) != 2) {
    failAt(4, source, "GLB version " + std::to_string(word(bytes, 4)) + " instead of 2");
  }
  const std::size_t whole = word(bytes, 8);
  if (whole > bytes.size()) {
    failAt(8, source,
           "the GLB should have " + std::to_string(whole) + " bytes, but has " +
               std::to_string(bytes.size()));
  }
  if (whole < 20) failAt(8, source, "the GLB should have only " + std::to_string(whole) + " bytes");
  if (whole < bytes.size()) {
    chunks.notes.push_back(std::to_string(bytes.size() - whole) +
                           " bytes after the GLB passed over");
  }
  bool hasBinary = false;
  for (std::size_t at = 12; at + 8 <= whole;) {
    const std::size_t length = word(bytes, at);
    const std::uint32_t kind = word(bytes, at + 4);
    if (length > whole - at - 8) {
      failAt(at, source, "a chunk of " + std::to_string(length) + " bytes is longer than the file");
    }
    if (at == 12 && kind != kJsonChunk) failAt(at + 4, source, "the first chunk is not JSON");
    if (at == 12) chunks.json = bytes.substr(at + 8, length);
    if (kind == kBinaryChunk && !std::exchange(hasBinary, true)) {
      chunks.binary = bytes.substr(at + 8, length);
    }
    at += 8 + length;
  }
  return chunks;
}

}  // namespace flatland
