// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flatland {

/// Where the bytes of a buffer come from.
struct GltfBuffer {
  std::optional<std::string> uri;  ///< as the file has it; none: the BIN chunk of a GLB
  std::size_t length = 0;          ///< bytes that count, from the beginning
};

struct GltfNode {
  std::optional<std::uint32_t> mesh;
  std::optional<std::uint32_t> transform;  ///< place in GltfFile::transforms; none: identity
  std::vector<std::uint32_t> children;     ///< not checked: may lead nowhere or back
};

/// A glTF file taken apart: what it says about shapes.
struct GltfFile {
  std::string json;         ///< asset, meshes, accessors, bufferViews; nothing else
  std::string_view binary;  ///< the BIN chunk of a GLB, part of the file's bytes; or empty
  std::vector<GltfBuffer> buffers;
  std::vector<GltfNode> nodes;
  std::vector<Eigen::Affine3d> transforms;
  std::vector<std::uint32_t> roots;  ///< nodes of the default scene; without one those at the top
  std::vector<std::string> notes;    ///< what was passed over, one sentence each
};

/// Checks the lengths of a GLB's chunks, parses the JSON and leaves out images, materials,
/// animations, extensions and the like: they say nothing about shapes, and a faulty picture must
/// not keep a mesh from being read. Throws InputError with the place, also for a version other than
/// 2, for nesting deeper than any real file's, for values of the wrong type, and for extensions
/// without which the shapes cannot be read (compression).
GltfFile openGltf(std::string_view bytes, const std::string& source);

}  // namespace flatland
