// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flatland {

/// The parts of a GLB file, within its bytes.
struct GlbChunks {
  std::string_view json, binary;   ///< `binary` is empty if there is no such chunk
  std::vector<std::string> notes;  ///< what was passed over, one sentence each
};

/// Chunks of other kinds are passed over. Throws InputError with the byte if a length is beyond the
/// file's end or the version is not 2.
GlbChunks glbChunks(std::string_view bytes, const std::string& source);

}  // namespace flatland
