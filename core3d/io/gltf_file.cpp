// SPDX-License-Identifier: MIT
#include "core3d/io/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>

#include "core3d/io/binary_bytes.h"
#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 64;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

[[noreturn]] void failAt(std::size_t byte, const std::string& source, const std::string& reason) {
  throw InputError(source, "byte " + std::to_string(byte), reason);
}

std::uint32_t word(std::string_view bytes, std::size_t at) {
  return loadAs<std::uint32_t>(bytes.data() + at, std::endian::little);
}

// The JSON text and the binary chunk of a GLB.
std::pair<std::string_view, std::string_view> chunks(std::string_view bytes,
                                                     const std::string& source) {
  if (bytes.size() < 20) failAt(bytes.size(), source, "the GLB header is cut short");
  if (word(bytes, 4) != 2) {
    failAt(4, source, "GLB version " + std::to_string(word(bytes, 4)) + " instead of 2");
  }
  if (word(bytes, 8) > bytes.size()) {
    failAt(8, source,
           "the GLB should have " + std::to_string(word(bytes, 8)) + " bytes, but has " +
               std::to_string(bytes.size()));
  }
  std::string_view json, binary;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::size_t length = word(bytes, at);
    const std::uint32_t kind = word(bytes, at + 4);
    if (length > bytes.size() - at - 8) {
      failAt(at, source, "a chunk of " + std::to_string(length) + " bytes is longer than the file");
    }
    if (at == 12 && kind != kJsonChunk) failAt(at + 4, source, "the first chunk is not JSON");
    if (at == 12) json = bytes.substr(at + 8, length);
    if (kind == kBinaryChunk && binary.empty()) binary = bytes.substr(at + 8, length);
    at += 8 + length;
  }
  return {json, binary};
}

// Recursive code must not run out of stack.
void checkDepth(std::string_view json, const std::string& source) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (inString) {
      if (c == '\\') ++i;
      if (c == '"') inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kDeepest) throw InputError(source, "", "the JSON is nested too deeply");
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

void checkExtensions(const Json& all, const std::string& source) {
  // Those that change how shapes are stored, and are understood.
  constexpr std::string_view kUnderstood[] = {"KHR_mesh_quantization"};
  const auto required = all.find("extensionsRequired");
  if (required == all.end() || !required->is_array()) return;
  for (const Json& name : *required) {
    if (!name.is_string()) continue;
    const auto& text = name.get_ref<const std::string&>();
    const bool aboutLooks = text.rfind("KHR_materials_", 0) == 0 ||
                            text.rfind("KHR_texture_", 0) == 0 ||
                            text.rfind("KHR_lights_", 0) == 0 || text.rfind("EXT_texture_", 0) == 0;
    const bool understood =
        std::find(std::begin(kUnderstood), std::end(kUnderstood), text) != std::end(kUnderstood);
    if (!aboutLooks && !understood) {
      throw InputError(source, "",
                       "needs the extension " + inQuotes(text) + ", which cannot be read");
    }
  }
}

// TinyGLTF passes over a number that is no whole one, takes 2^32 for 0, and what is no list for an
// empty one; each would read another mesh than the file's.
void checkNumbers(Json& object, const std::string& source) {
  constexpr std::string_view kWhole[] = {"buffer",     "bufferView",    "byteLength", "byteOffset",
                                         "byteStride", "componentType", "count",      "indices",
                                         "mesh",       "mode",          "scene"};
  constexpr double kMost = 4294967295.0;  // and no file is longer
  for (const std::string_view key : kWhole) {
    const auto found = object.find(key);
    if (found == object.end() || found->is_structured()) continue;
    const double value = found->is_number() ? found->get<double>() : -1.0;
    if (!(value >= 0.0 && value <= kMost && value == std::floor(value))) {
      throw InputError(source, "",
                       inQuotes(key) + " is not a whole number from 0 to 2^32 - 1: " +
                           inQuotes(found->dump(-1, ' ', true)));
    }
    *found = static_cast<std::uint64_t>(value);
  }
}

void checkLists(const Json& all, const std::string& source) {
  for (const auto& [key, list] : all.items()) {
    if (key == "asset" || key == "scene") continue;
    if (!list.is_array()) throw InputError(source, "", inQuotes(key) + " is no list");
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].is_object()) continue;
      throw InputError(source, key + "[" + std::to_string(i) + "]", "is no object");
    }
  }
}

// Leaves out everything that recursive code might visit without being asked.
void tidy(Json& value, const std::string& source) {
  if (value.is_object()) {
    value.erase("extras");
    value.erase("extensions");
    checkNumbers(value, source);
  }
  if (value.is_structured()) {
    for (Json& child : value) tidy(child, source);
  }
}

}  // namespace

GltfFile openGltf(std::string_view bytes, const std::string& source) {
  GltfFile file;
  std::string_view text = bytes;
  file.isGlb = bytes.substr(0, 4) == "glTF";
  if (file.isGlb) {
    std::tie(text, file.binary) = chunks(bytes, source);
  } else if (text.substr(0, 3) == "\xEF\xBB\xBF") {
    text.remove_prefix(3);
  }
  checkDepth(text, source);
  Json all;
  try {
    all = Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InputError(source, "byte " + std::to_string(error.byte), "the JSON is malformed");
  } catch (const Json::out_of_range&) {
    throw InputError(source, "", "the JSON has a number that is too large");
  }
  if (!all.is_object()) throw InputError(source, "", "the JSON is no glTF object");
  checkExtensions(all, source);
  Json kept = Json::object();
  for (const char* key :
       {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers"}) {
    if (const auto found = all.find(key); found != all.end()) kept[key] = std::move(*found);
  }
  checkLists(kept, source);
  tidy(kept, source);
  // Only the first buffer of a GLB may be its own chunk; more would each get a copy of it.
  const auto buffers = kept.find("buffers");
  if (buffers != kept.end() && buffers->is_array()) {
    for (std::size_t i = 0; i < buffers->size(); ++i) {
      const Json& buffer = (*buffers)[i];
      if (!buffer.is_object() || ((i > 0 || !file.isGlb) && !buffer.contains("uri"))) {
        throw InputError(source, "buffers[" + std::to_string(i) + "]", "has no data");
      }
    }
  }
  file.json = kept.dump(-1, ' ', false, Json::error_handler_t::replace);
  return file;
}

}  // namespace flatland
