// SPDX-License-Identifier: MIT
// TinyGLTF is compiled here and used nowhere else. It reads the JSON and gathers the buffers; the
// ranges of accessors are checked below, for it does not check them.
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core3d/io/binary_bytes.h"
#include "core3d/io/gltf_file.h"
#include "core3d/io/read_mesh.h"
#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

namespace flatland {

namespace {

namespace fs = std::filesystem;

// A file may show one mesh many times, by nodes: a forest of one tree has 30 values for each of its
// bytes. With these a file of a few kilobytes still takes less than 200 MB and a second.
constexpr std::size_t kMaxGrowth = 32;
constexpr std::size_t kFreeValues = 1'000'000;

// The files beside a glTF file that it may name.
struct Neighbours {
  fs::path folder;
  std::set<fs::path> read;
  std::size_t bytes = 0;

  // The file of that name, if it lies in the folder or below, also after following links.
  std::optional<fs::path> find(const std::string& name) const {
    if (folder.empty()) return std::nullopt;
    std::error_code error;
    const fs::path home = fs::canonical(folder, error);
    if (error) return std::nullopt;
    const fs::path file = fs::canonical(home / name, error);
    if (error || !fs::is_regular_file(file, error)) return std::nullopt;
    const auto [end, rest] = std::mismatch(home.begin(), home.end(), file.begin(), file.end());
    if (end != home.end()) return std::nullopt;
    return file;
  }
};

tinygltf::FsCallbacks callbacksFor(Neighbours& neighbours) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.user_data = &neighbours;
  callbacks.FileExists = [](const std::string& name, void* data) {
    return static_cast<Neighbours*>(data)->find(name).has_value();
  };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error,
                               const std::string& name, void* data) {
    auto& known = *static_cast<Neighbours*>(data);
    const auto file = known.find(name);
    // Named a second time it would only take up memory.
    if (!file || !known.read.insert(*file).second) {
      *error = "named twice";
      return false;
    }
    const std::string bytes = readWholeFile(*file);
    known.bytes += bytes.size();
    out->assign(bytes.begin(), bytes.end());
    return true;
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                void*) { return false; };
  return callbacks;
}

// TinyGLTF takes a GLB from one block of memory.
std::string repacked(const GltfFile& file) {
  std::string json = file.json;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string all;
  const auto put = [&all](std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) all += static_cast<char>((value >> shift) & 0xff);
  };
  const std::size_t binary = file.binary.empty() ? 0 : 8 + (file.binary.size() + 3) / 4 * 4;
  all.reserve(20 + json.size() + binary);
  all += "glTF";
  put(2);
  put(20 + json.size() + binary);
  put(json.size());
  all += "JSON" + json;
  if (binary > 0) {
    put(binary - 8);
    all += std::string_view("BIN\0", 4);
    all += file.binary;
    all.resize(20 + json.size() + binary, '\0');
  }
  return all;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

class GltfReader {
 public:
  GltfReader(const tinygltf::Model& model, const std::string& source, std::size_t bytes)
      : model_(model), source_(source), room_(kFreeValues + kMaxGrowth * bytes) {}

  PolygonSoup read() {
    if (model_.nodes.empty()) {
      for (std::size_t i = 0; i < model_.meshes.size(); ++i) {
        addMesh(static_cast<int>(i), Eigen::Affine3d::Identity());
      }
    } else {
      walkNodes();
    }
    if (skipped_ > 0) {
      soup_.notes.push_back(std::to_string(skipped_) + (skipped_ == 1 ? " group" : " groups") +
                            " of points or lines passed over");
    }
    if (soup_.corners.empty()) fail("", "there are no triangles");
    return std::move(soup_);
  }

 private:
  // An accessor whose range has been checked.
  struct Values {
    const char* data;
    std::size_t count, stride;
    int component;    // glTF's number of the type
    bool normalized;  // whole numbers stand for fractions
  };
  struct Pending {
    int node;
    Eigen::Affine3d outer;
  };

  [[noreturn]] void fail(const std::string& place, const std::string& reason) const {
    throw InputError(source_, place, reason);
  }

  void spend(std::size_t count) {
    if (count > room_) fail("", "shows its meshes too many times over");
    room_ -= count;
  }

  void walkNodes() {
    std::vector<int> roots;
    if (!model_.scenes.empty()) {
      const int scene = std::max(model_.defaultScene, 0);
      if (static_cast<std::size_t>(scene) >= model_.scenes.size()) fail("scene", "does not exist");
      roots = model_.scenes[static_cast<std::size_t>(scene)].nodes;
    } else {
      std::set<int> children;
      for (const auto& node : model_.nodes) {
        children.insert(node.children.begin(), node.children.end());
      }
      for (int i = 0; i < static_cast<int>(model_.nodes.size()); ++i) {
        if (!children.contains(i)) roots.push_back(i);
      }
    }
    std::vector<Pending> pending;
    for (auto i = roots.rbegin(); i != roots.rend(); ++i) {
      pending.push_back({*i, Eigen::Affine3d::Identity()});
    }
    std::vector<char> seen(model_.nodes.size(), 0);
    while (!pending.empty()) {
      const auto [index, outer] = pending.back();
      pending.pop_back();
      const std::string place = "nodes[" + std::to_string(index) + "]";
      if (index < 0 || static_cast<std::size_t>(index) >= seen.size())
        fail(place, "does not exist");
      // Nodes form trees; without this check a loop would never end.
      if (std::exchange(seen[static_cast<std::size_t>(index)], 1)) fail(place, "has two parents");
      const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(index)];
      const Eigen::Affine3d here = outer * transformOf(node, place);
      if (node.mesh >= 0) addMesh(node.mesh, here);
      for (auto i = node.children.rbegin(); i != node.children.rend(); ++i) {
        pending.push_back({*i, here});
      }
    }
  }

  Eigen::Affine3d transformOf(const tinygltf::Node& node, const std::string& place) const {
    const auto sized = [&](const std::vector<double>& v, std::size_t size) {
      if (!v.empty() && v.size() != size) fail(place, "a transform has the wrong number of values");
      return !v.empty();
    };
    Eigen::Affine3d result = Eigen::Affine3d::Identity();
    if (sized(node.matrix, 16)) {
      result.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
      return result;
    }
    if (sized(node.translation, 3)) {
      result.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
    }
    if (sized(node.rotation, 4)) {
      const Eigen::Quaterniond turn(node.rotation[3], node.rotation[0], node.rotation[1],
                                    node.rotation[2]);
      if (!(turn.norm() > 0.0)) fail(place, "a rotation is zero");
      result.rotate(turn.normalized());
    }
    if (sized(node.scale, 3)) result.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
    return result;
  }

  Values valuesOf(int index, int type, const std::string& place) const {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) {
      fail(place, "accessor " + std::to_string(index) + " does not exist");
    }
    const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    const std::string here = "accessors[" + std::to_string(index) + "]";
    if (accessor.type != type) fail(here, "has the wrong type");
    if (accessor.sparse.isSparse) fail(here, "is sparse, which cannot be read");
    if (accessor.bufferView < 0 ||
        static_cast<std::size_t>(accessor.bufferView) >= model_.bufferViews.size()) {
      fail(here, "has no data");
    }
    const auto& view = model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size()) {
      fail(here, "has no buffer");
    }
    const auto& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    const int component =
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
    if (component <= 0 || components <= 0) fail(here, "has values of unknown type");
    const auto size = static_cast<std::size_t>(component) * static_cast<std::size_t>(components);
    const std::size_t stride = view.byteStride == 0 ? size : view.byteStride;
    // No sum here can pass the range of size_t, whatever the file says.
    const bool viewFits =
        view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
    const std::size_t length = viewFits ? view.byteLength : 0;
    const bool fits = accessor.count > 0 && stride >= size && accessor.byteOffset <= length &&
                      size <= length - accessor.byteOffset &&
                      accessor.count - 1 <= (length - accessor.byteOffset - size) / stride;
    if (!fits) fail(here, "reaches beyond its buffer");
    return {reinterpret_cast<const char*>(data.data()) + view.byteOffset + accessor.byteOffset,
            accessor.count, stride, accessor.componentType, accessor.normalized};
  }

  static double number(const Values& values, std::size_t i, std::size_t k) {
    const auto read = [&]<typename T>(T) -> double {
      const T value =
          loadAs<T>(values.data + i * values.stride + k * sizeof(T), std::endian::little);
      if constexpr (std::is_integral_v<T>) {
        if (values.normalized) {
          return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
        }
      }
      return static_cast<double>(value);
    };
    switch (values.component) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return read(std::int8_t{});
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read(std::uint8_t{});
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return read(std::int16_t{});
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read(std::uint16_t{});
      case TINYGLTF_COMPONENT_TYPE_INT:
        return read(std::int32_t{});
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return read(std::uint32_t{});
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return read(float{});
      default:
        return read(double{});
    }
  }

  void addMesh(int index, const Eigen::Affine3d& transform) {
    const std::string place = "meshes[" + std::to_string(index) + "]";
    if (index < 0 || static_cast<std::size_t>(index) >= model_.meshes.size()) {
      fail(place, "does not exist");
    }
    std::map<int, std::uint32_t> placed;  // accessors of this mesh that are in the soup, by number
    for (const auto& primitive : model_.meshes[static_cast<std::size_t>(index)].primitives) {
      addPrimitive(primitive, transform, placed, place);
    }
  }

  void addPrimitive(const tinygltf::Primitive& primitive, const Eigen::Affine3d& transform,
                    std::map<int, std::uint32_t>& placed, const std::string& place) {
    const int mode = primitive.mode;
    const auto positions = primitive.attributes.find("POSITION");
    const bool surface = mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                         mode == TINYGLTF_MODE_TRIANGLE_FAN;
    if (!surface || positions == primitive.attributes.end()) {
      ++skipped_;
      return;
    }
    const Values points = valuesOf(positions->second, TINYGLTF_TYPE_VEC3, place);
    const auto [entry, isNew] =
        placed.try_emplace(positions->second, static_cast<std::uint32_t>(soup_.vertexCount()));
    if (isNew) addPoints(points, transform, place);
    const std::uint32_t first = entry->second;

    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
      const Values indices = valuesOf(primitive.indices, TINYGLTF_TYPE_SCALAR, place);
      const bool whole = indices.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                         indices.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                         indices.component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
      if (!whole || indices.normalized) fail(place, "has indices that are not whole numbers");
      spend(indices.count);
      corners.reserve(indices.count);
      for (std::size_t i = 0; i < indices.count; ++i) {
        const double value = number(indices, i, 0);
        if (value >= static_cast<double>(points.count)) {
          fail(place, "index " + std::to_string(i) + " is " +
                          std::to_string(static_cast<std::uint64_t>(value)) + ", but there are " +
                          std::to_string(points.count) + " vertices");
        }
        corners.push_back(first + static_cast<std::uint32_t>(value));
      }
    } else {
      spend(points.count);
      for (std::size_t i = 0; i < points.count; ++i) {
        corners.push_back(first + static_cast<std::uint32_t>(i));
      }
    }
    addTriangles(mode, corners, transform.linear().determinant() < 0.0, place);
  }

  void addPoints(const Values& points, const Eigen::Affine3d& transform, const std::string& place) {
    spend(points.count);
    for (std::size_t i = 0; i < points.count; ++i) {
      const Eigen::Vector3d p =
          transform *
          Eigen::Vector3d(number(points, i, 0), number(points, i, 1), number(points, i, 2));
      if (!p.allFinite()) fail(place, "vertex " + std::to_string(i) + " is not finite");
      soup_.addVertex(p.x(), p.y(), p.z());
    }
  }

  void addTriangles(int mode, const std::vector<std::uint32_t>& corners, bool mirrored,
                    const std::string& place) {
    const std::size_t before = soup_.corners.size();
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
      soup_.addStrip(corners);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_FAN) {
      soup_.addFan(corners);
    } else {
      if (corners.size() % 3 != 0) fail(place, "the number of its indices is not a multiple of 3");
      for (std::size_t i = 0; i < corners.size(); i += 3) {
        soup_.addTriangle(corners[i], corners[i + 1], corners[i + 2]);
      }
    }
    // A mirror turns the winding round, and the format wants it turned back.
    if (!mirrored) return;
    for (std::size_t i = before; i < soup_.corners.size(); i += 3) {
      std::swap(soup_.corners[i + 1], soup_.corners[i + 2]);
    }
  }

  const tinygltf::Model& model_;
  const std::string& source_;
  PolygonSoup soup_;
  std::size_t room_;
  std::size_t skipped_ = 0;
};

}  // namespace

PolygonSoup readGltf(std::string_view bytes, const std::string& source,
                     const std::filesystem::path& folder) {
  if (bytes.size() > 0xffffffffu) throw InputError(source, "", "is longer than 4 GB");
  const GltfFile file = openGltf(bytes, source);
  Neighbours neighbours{folder, {}, bytes.size()};
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(callbacksFor(neighbours));
  tinygltf::Model model;
  std::string error, warning;
  bool read = false;
  try {
    if (file.isGlb) {
      const std::string glb = repacked(file);
      read = reader.LoadBinaryFromMemory(&model, &error, &warning,
                                         reinterpret_cast<const unsigned char*>(glb.data()),
                                         static_cast<unsigned int>(glb.size()));
    } else {
      read = reader.LoadASCIIFromString(&model, &error, &warning, file.json.data(),
                                        static_cast<unsigned int>(file.json.size()), "");
    }
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& thrown) {
    error = thrown.what();
  }
  if (!read) throw InputError(source, "", "is no valid glTF: " + firstLine(error));
  return GltfReader(model, source, neighbours.bytes).read();
}

}  // namespace flatland
