// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace flatland {

/// Writes `bytes` to a temporary beside `file`, flushes it to disk and renames it over `file`.
/// Follows a symbolic link and keeps the permissions of an existing file; a write-protected one is
/// refused. A device or a pipe is written to directly. Throws InputError with the
/// system's reason; the old file is then untouched and no temporary stays behind.
void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace flatland
