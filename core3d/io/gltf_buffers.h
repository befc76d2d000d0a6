// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core3d/io/gltf_file.h"

namespace flatland {

/// The bytes of a glTF file's buffers: its own chunk, data URIs, and files that lie beside it or
/// below, also after following links. Each is read when it is first asked for, so one that no mesh
/// needs may be missing; files named twice are read once.
class GltfBuffers {
 public:
  /// Takes the URIs out of `file`; refers to its chunk and to `source`. With an empty folder no
  /// other file is read.
  GltfBuffers(GltfFile& file, const std::string& source, std::filesystem::path folder);

  std::size_t count() const { return buffers_.size(); }

  /// Throws InputError if the buffer has no such source or that is shorter than it says.
  /// Precondition: index < count().
  std::string_view bytes(std::size_t index);

  /// Of all files and data URIs that were read.
  std::size_t bytesRead() const { return bytesRead_; }

 private:
  std::string_view load(const GltfBuffer& buffer, std::size_t index);
  const std::string& neighbour(const std::string& uri, const std::string& place);

  std::vector<GltfBuffer> buffers_;
  std::string_view chunk_;
  const std::string& source_;
  std::filesystem::path folder_;
  std::map<std::filesystem::path, std::string> files_;
  std::map<std::size_t, std::string> decoded_;  // of data URIs, by number of the buffer
  std::vector<std::string_view> loaded_;        // data() is null before
  std::size_t bytesRead_ = 0;
};

}  // namespace flatland
