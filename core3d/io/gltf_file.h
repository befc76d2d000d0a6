// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace flatland {

/// A glTF file taken apart: what stands in its JSON about shapes, and the bytes of a GLB.
struct GltfFile {
  std::string json;         ///< scenes, nodes, meshes, accessors, buffers; nothing else
  std::string_view binary;  ///< the BIN chunk of a GLB, part of the file's bytes; or empty
  bool isGlb = false;
};

/// Checks the lengths of a GLB's chunks, parses the JSON and leaves out images, materials,
/// animations, extensions and the like: they say nothing about shapes, and a faulty picture must
/// not keep a mesh from being read. Throws InputError, also for nesting deeper than any real file's
/// and for extensions without which the shapes cannot be read (compression).
GltfFile openGltf(std::string_view bytes, const std::string& source);

}  // namespace flatland
