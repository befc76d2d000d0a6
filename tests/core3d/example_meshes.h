// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace flatland::test {

/// Where the example meshes are: FLATLAND_DATA in the environment, or as the build was told.
inline std::filesystem::path dataFolder() {
  const char* asked = std::getenv("FLATLAND_DATA");
  return asked ? std::filesystem::path(asked) : std::filesystem::path(FLATLAND_DATA_FOLDER);
}

/// Without the data a test is skipped at home, and fails where everything must be there.
class ExampleMeshes : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path folder = dataFolder();
    if (std::filesystem::is_directory(folder / "meshes") &&
        std::filesystem::is_directory(folder / "messy"))
      return;
    const char* ci = std::getenv("CI");
    if (ci && std::string(ci) == "true") {
      FAIL() << folder << " has no example meshes; set FLATLAND_DATA";
    }
    GTEST_SKIP() << "no example meshes in " << folder << "; set FLATLAND_DATA";
  }
};

}  // namespace flatland::test
