// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

// For tests of the program from the outside. CMake says where it is (FLATLAND_PROGRAM).

namespace flatland::test {

using nlohmann::json;

/// Runs the program as runWithoutDisplay does.
inline ProgramResult run(const std::vector<std::string>& arguments, const std::string& input = {},
                         const std::optional<std::string>& platform = "nonsense") {
  return runWithoutDisplay(FLATLAND_PROGRAM, arguments, input, platform);
}

/// The same in a folder, so that files can be named without it.
inline ProgramResult runIn(const std::filesystem::path& folder,
                           const std::vector<std::string>& arguments) {
  return runProgram(FLATLAND_PROGRAM,
                    {.arguments = arguments,
                     .environment = {{"DISPLAY", std::nullopt}, {"QT_QPA_PLATFORM", "nonsense"}},
                     .folder = folder});
}

}  // namespace flatland::test
