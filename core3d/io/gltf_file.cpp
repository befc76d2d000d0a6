// SPDX-License-Identifier: MIT
#include "core3d/io/gltf_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core3d/io/glb_chunks.h"
#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 64;
constexpr double kMostWhole = 4294967295.0;  // no file is longer

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
  for (const std::string_view key : kWhole) {
    const auto found = object.find(key);
    if (found == object.end() || found->is_structured()) continue;
    const double value = found->is_number() ? found->get<double>() : -1.0;
    if (!(value >= 0.0 && value <= kMostWhole && value == std::floor(value))) {
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

void checkVersion(const Json& all, const std::string& source) {
  const auto asset = all.find("asset");
  const bool known = asset != all.end() && asset->is_object() && asset->contains("version") &&
                     (*asset)["version"].is_string();
  if (!known) throw InputError(source, "", "is no glTF: it has no asset.version");
  const auto& version = (*asset)["version"].get_ref<const std::string&>();
  if (version != "2" && version.rfind("2.", 0) != 0) {
    throw InputError(source, "asset", "glTF version " + inQuotes(version) + " instead of 2.0");
  }
}

std::string placed(const char* list, std::size_t i) {
  return list + ("[" + std::to_string(i) + "]");
}

std::vector<std::uint32_t> indices(const Json& object, const char* key, const std::string& source,
                                   const std::string& place) {
  std::vector<std::uint32_t> result;
  const auto found = object.find(key);
  if (found == object.end()) return result;
  if (!found->is_array()) throw InputError(source, place, inQuotes(key) + " is no list");
  result.reserve(found->size());
  for (const Json& value : *found) {
    const double index = value.is_number() ? value.get<double>() : -1.0;
    if (!(index >= 0.0 && index <= kMostWhole && index == std::floor(index))) {
      throw InputError(
          source, place,
          inQuotes(key) + " has what is no index: " + inQuotes(value.dump(-1, ' ', true)));
    }
    result.push_back(static_cast<std::uint32_t>(index));
  }
  return result;
}

// The values of a part of a transform; false if the node does not have it.
template <std::size_t Size>
bool numbers(const Json& node, const char* key, std::array<double, Size>& values,
             const std::string& source, const std::string& place) {
  const auto found = node.find(key);
  if (found == node.end()) return false;
  const bool sound =
      found->is_array() && found->size() == Size &&
      std::all_of(found->begin(), found->end(), [](const Json& v) { return v.is_number(); });
  if (!sound) {
    throw InputError(source, place,
                     inQuotes(key) + " is no list of " + std::to_string(Size) + " numbers");
  }
  for (std::size_t i = 0; i < Size; ++i) values[i] = (*found)[i].get<double>();
  return true;
}

std::optional<Eigen::Affine3d> transformOf(const Json& node, const std::string& source,
                                           const std::string& place) {
  std::array<double, 16> matrix;
  std::array<double, 4> rotation;
  std::array<double, 3> translation, scale;
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  if (numbers(node, "matrix", matrix, source, place)) {
    result.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix.data());
    return result;
  }
  const bool moved = numbers(node, "translation", translation, source, place);
  const bool turned = numbers(node, "rotation", rotation, source, place);
  const bool stretched = numbers(node, "scale", scale, source, place);
  if (!moved && !turned && !stretched) return std::nullopt;
  if (moved) result.translate(Eigen::Map<const Eigen::Vector3d>(translation.data()));
  if (turned) {
    const Eigen::Quaterniond turn(rotation[3], rotation[0], rotation[1], rotation[2]);
    if (!(turn.norm() > 0.0)) throw InputError(source, place, "a rotation is zero");
    result.rotate(turn.normalized());
  }
  if (stretched) result.scale(Eigen::Map<const Eigen::Vector3d>(scale.data()));
  return result;
}

// TinyGLTF would take half a kilobyte for each node, and pass over values of the wrong type.
void readNodes(const Json& kept, const std::string& source, GltfFile& file) {
  if (const auto nodes = kept.find("nodes"); nodes != kept.end()) {
    file.nodes.reserve(nodes->size());
    for (const Json& json : *nodes) {
      const std::string place = placed("nodes", file.nodes.size());
      GltfNode node;
      if (const auto mesh = json.find("mesh"); mesh != json.end()) {
        if (!mesh->is_number()) throw InputError(source, place, "'mesh' is no index");
        node.mesh = mesh->get<std::uint32_t>();
      }
      if (const auto transform = transformOf(json, source, place)) {
        node.transform = static_cast<std::uint32_t>(file.transforms.size());
        file.transforms.push_back(*transform);
      }
      node.children = indices(json, "children", source, place);
      file.nodes.push_back(std::move(node));
    }
  }
  const auto scenes = kept.find("scenes");
  if (scenes != kept.end() && !scenes->empty()) {
    const auto scene = kept.find("scene");
    if (scene != kept.end() && !scene->is_number())
      throw InputError(source, "scene", "is no index");
    const std::size_t number = scene == kept.end() ? 0 : scene->get<std::size_t>();
    if (number >= scenes->size()) throw InputError(source, "scene", "does not exist");
    file.roots = indices((*scenes)[number], "nodes", source, placed("scenes", number));
    return;
  }
  std::vector<char> isChild(file.nodes.size(), 0);
  for (const GltfNode& node : file.nodes) {
    for (const std::uint32_t child : node.children) {
      if (child < isChild.size()) isChild[child] = 1;
    }
  }
  for (std::uint32_t i = 0; i < isChild.size(); ++i) {
    if (!isChild[i]) file.roots.push_back(i);
  }
  if (file.roots.empty() && !file.nodes.empty()) {
    throw InputError(source, "nodes", "each is the child of another");
  }
}

void readBuffers(Json& kept, bool isGlb, const std::string& source, GltfFile& file) {
  const auto buffers = kept.find("buffers");
  if (buffers == kept.end()) return;
  for (Json& json : *buffers) {
    const std::string place = placed("buffers", file.buffers.size());
    GltfBuffer buffer;
    const auto length = json.find("byteLength"), uri = json.find("uri");
    if (length == json.end() || !length->is_number()) {
      throw InputError(source, place, "'byteLength' is missing");
    }
    buffer.length = length->get<std::size_t>();
    if (uri != json.end()) {
      if (!uri->is_string()) throw InputError(source, place, "'uri' is no text");
      buffer.uri = std::move(uri->get_ref<std::string&>());
    } else if (!isGlb || !file.buffers.empty()) {
      // The chunk is the first one's.
      throw InputError(source, place, "has no data");
    }
    file.buffers.push_back(std::move(buffer));
  }
}

}  // namespace

GltfFile openGltf(std::string_view bytes, const std::string& source) {
  GltfFile file;
  std::string_view text = bytes;
  const bool isGlb = bytes.substr(0, 4) == "glTF";
  if (isGlb) {
    GlbChunks chunks = glbChunks(bytes, source);
    text = chunks.json;
    file.binary = chunks.binary;
    file.notes = std::move(chunks.notes);
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
  checkVersion(all, source);
  checkExtensions(all, source);
  Json kept = Json::object();
  for (const char* key :
       {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers"}) {
    if (const auto found = all.find(key); found != all.end()) kept[key] = std::move(*found);
  }
  all = nullptr;
  checkLists(kept, source);
  tidy(kept, source);
  readNodes(kept, source, file);
  readBuffers(kept, isGlb, source, file);
  for (const char* key : {"scene", "scenes", "nodes", "buffers"}) kept.erase(key);
  file.json = kept.dump(-1, ' ', false, Json::error_handler_t::replace);
  return file;
}

}  // namespace flatland
