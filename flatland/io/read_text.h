// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace flatland {

/// A whole file, or its beginning: at most a block more than `mostBytes`, so that the caller sees
/// that there is too much. Works on pipes too. Throws InputError with the system's reason.
std::string readFile(const std::filesystem::path& file, std::size_t mostBytes);

/// The same of standard input; "standard input" is its name in errors.
std::string readStandardInput(std::size_t mostBytes);

}  // namespace flatland
