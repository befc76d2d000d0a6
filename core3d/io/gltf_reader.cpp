// SPDX-License-Identifier: MIT
// TinyGLTF is compiled here and used nowhere else. It reads the JSON of meshes and accessors; what
// their ranges are in is checked below, for it does not check them.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core3d/io/binary_bytes.h"
#include "core3d/io/gltf_buffers.h"
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

// A file may show one mesh many times, by nodes: a forest of one tree has 30 values for each of its
// bytes. With these a file of a few kilobytes still takes less than 200 MB and a second.
constexpr std::size_t kMaxGrowth = 32;
constexpr std::size_t kFreeValues = 1'000'000;

// Of TinyGLTF's messages, which may quote any amount of the file.
std::string firstLine(const std::string& text) {
  constexpr std::size_t kLongest = 200;
  std::string line = text.substr(0, std::min(text.find('\n'), kLongest));
  for (char& c : line) {
    if (c < ' ' || c > '~') c = '?';
  }
  return line;
}

class GltfReader {
 public:
  /// `bytes` is the length of the file itself.
  GltfReader(const tinygltf::Model& model, const GltfFile& file, GltfBuffers& buffers,
             const std::string& source, std::size_t bytes)
      : model_(model), file_(file), buffers_(buffers), source_(source), bytes_(bytes) {
    soup_.notes = file.notes;
  }

  PolygonSoup read() {
    if (file_.nodes.empty()) {
      for (std::size_t i = 0; i < model_.meshes.size(); ++i) {
        addMesh(i, Eigen::Affine3d::Identity());
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
    int component;          // glTF's number of the type
    bool normalized;        // whole numbers stand for fractions
    std::vector<char> own;  // what `data` leads to, if that stands nowhere in the file
  };
  struct Pending {
    std::uint32_t node;
    Eigen::Affine3d outer;
  };

  [[noreturn]] void fail(const std::string& place, const std::string& reason) const {
    throw InputError(source_, place, reason);
  }

  void spend(std::size_t count) {
    const std::size_t room = kFreeValues + kMaxGrowth * (bytes_ + buffers_.bytesRead());
    if (count > room || spent_ > room - count) {
      fail("", "shows its meshes too many times over");
    }
    spent_ += count;
  }

  void walkNodes() {
    std::vector<Pending> pending;
    const auto push = [&](const std::vector<std::uint32_t>& nodes, const Eigen::Affine3d& outer) {
      for (auto i = nodes.rbegin(); i != nodes.rend(); ++i) {
        const std::string place = "nodes[" + std::to_string(*i) + "]";
        if (*i >= seen_.size()) fail(place, "does not exist");
        // Nodes form trees; without this check a loop would never end.
        if (std::exchange(seen_[*i], 1)) fail(place, "has two parents");
        pending.push_back({*i, outer});
      }
    };
    seen_.assign(file_.nodes.size(), 0);
    push(file_.roots, Eigen::Affine3d::Identity());
    while (!pending.empty()) {
      const auto [index, outer] = pending.back();
      pending.pop_back();
      const GltfNode& node = file_.nodes[index];
      const Eigen::Affine3d here =
          node.transform ? outer * file_.transforms[*node.transform] : outer;
      if (node.mesh) addMesh(*node.mesh, here);
      push(node.children, here);
    }
  }

  // `size` bytes for each of `count` values, `stride` apart. No sum here can pass the range of
  // size_t, whatever the file says.
  const char* rangeOf(std::int64_t viewIndex, std::size_t offset, std::size_t count,
                      std::size_t size, std::size_t stride, const std::string& here) {
    if (viewIndex < 0 || static_cast<std::size_t>(viewIndex) >= model_.bufferViews.size()) {
      fail(here, "has no data");
    }
    const auto& view = model_.bufferViews[static_cast<std::size_t>(viewIndex)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= buffers_.count()) {
      fail(here, "has no buffer");
    }
    const std::string_view data = buffers_.bytes(static_cast<std::size_t>(view.buffer));
    const bool viewFits =
        view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
    const std::size_t length = viewFits ? view.byteLength : 0;
    const bool fits = count > 0 && stride >= size && offset <= length && size <= length - offset &&
                      count - 1 <= (length - offset - size) / stride;
    if (!fits) fail(here, "reaches beyond its buffer");
    return data.data() + view.byteOffset + offset;
  }

  Values valuesOf(int index, int type, const std::string& place) {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size()) {
      fail(place, "accessor " + std::to_string(index) + " does not exist");
    }
    const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    const std::string here = "accessors[" + std::to_string(index) + "]";
    if (accessor.type != type) fail(here, "has the wrong type");
    const int component =
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
    if (component <= 0 || components <= 0) fail(here, "has values of unknown type");
    const auto size = static_cast<std::size_t>(component) * static_cast<std::size_t>(components);
    Values values{nullptr, accessor.count, size, accessor.componentType, accessor.normalized, {}};
    const int view = accessor.bufferView;
    if (view >= 0) {
      const bool known = static_cast<std::size_t>(view) < model_.bufferViews.size();
      const std::size_t stride =
          known ? model_.bufferViews[static_cast<std::size_t>(view)].byteStride : 0;
      if (stride > 0) values.stride = stride;
      values.data = rangeOf(view, accessor.byteOffset, values.count, size, values.stride, here);
    }
    if (view < 0 || accessor.sparse.isSparse) {
      // Zeros where the file has no values. Their number is not bounded by its length.
      spend(values.count);
      std::vector<char> own(values.count * size, 0);
      for (std::size_t i = 0; view >= 0 && i < values.count; ++i) {
        std::copy_n(values.data + i * values.stride, size, own.data() + i * size);
      }
      values.own = std::move(own);
      values.data = values.own.data();
      values.stride = size;
    }
    if (accessor.sparse.isSparse) replaceSome(values, accessor, here);
    return values;
  }

  // A sparse accessor: values that stand elsewhere, with their places in rising order.
  void replaceSome(Values& values, const tinygltf::Accessor& accessor, const std::string& here) {
    const auto& sparse = accessor.sparse;
    const int component = sparse.indices.componentType;
    if (!isIndex(component)) fail(here, "has sparse indices that are not whole numbers");
    const int bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component));
    const auto count = static_cast<std::size_t>(std::max(sparse.count, 0));
    const auto width = static_cast<std::size_t>(bytes);
    if (count > values.count) fail(here, "replaces more values than it has");
    const auto offset = [&](int value) {
      if (value < 0) fail(here, "reaches beyond its buffer");
      return static_cast<std::size_t>(value);
    };
    const Values places{rangeOf(sparse.indices.bufferView, offset(sparse.indices.byteOffset), count,
                                width, width, here),
                        count,
                        width,
                        component,
                        false,
                        {}};
    const std::size_t size = values.stride;
    const char* const others = rangeOf(sparse.values.bufferView, offset(sparse.values.byteOffset),
                                       count, size, size, here);
    double last = -1.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double place = number(places, i, 0);
      if (!(place > last) || place >= static_cast<double>(values.count)) {
        fail(here, "its sparse indices do not rise, or lead nowhere");
      }
      last = place;
      std::copy_n(others + i * size, size,
                  values.own.data() + static_cast<std::size_t>(place) * size);
    }
  }

  static bool isIndex(int component) {
    return component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
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

  void addMesh(std::size_t index, const Eigen::Affine3d& transform) {
    const std::string place = "meshes[" + std::to_string(index) + "]";
    if (index >= model_.meshes.size()) fail(place, "does not exist");
    std::map<int, std::uint32_t> placed;  // accessors of this mesh that are in the soup, by number
    for (const auto& primitive : model_.meshes[index].primitives) {
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
      if (!isIndex(indices.component) || indices.normalized)
        fail(place, "has indices that are not whole numbers");
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
  const GltfFile& file_;
  GltfBuffers& buffers_;
  const std::string& source_;
  std::size_t bytes_;
  PolygonSoup soup_;
  std::vector<char> seen_;  // nodes
  std::size_t spent_ = 0, skipped_ = 0;
};

}  // namespace

PolygonSoup readGltf(std::string_view bytes, const std::string& source,
                     const std::filesystem::path& folder) {
  if (bytes.size() > 0xffffffffu) throw InputError(source, "", "is longer than 4 GB");
  GltfFile file = openGltf(bytes, source);
  GltfBuffers buffers(file, source, folder);
  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string error, warning;
  bool read = false;
  try {
    read = reader.LoadASCIIFromString(&model, &error, &warning, file.json.data(),
                                      static_cast<unsigned int>(file.json.size()), "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& thrown) {
    error = thrown.what();
  }
  if (!read) throw InputError(source, "", "is no valid glTF: " + firstLine(error));
  return GltfReader(model, file, buffers, source, bytes.size()).read();
}

}  // namespace flatland
