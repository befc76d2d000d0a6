// SPDX-License-Identifier: GPL-3.0-or-later
// flatland lines on every example mesh beside the checkout.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/run_program.h"

namespace flatland {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t kLargeBytes = 3000000;  // what takes long to draw is tested as "Large"
constexpr std::size_t kMeshes = 21;

fs::path dataFolder() {
  const char* asked = std::getenv("FLATLAND_DATA");
  return asked ? fs::path(asked) : fs::path(FLATLAND_DATA_FOLDER);
}

// Without the data the test is skipped at home, and fails where everything must be there.
class LinesData : public testing::Test {
 protected:
  void SetUp() override {
    if (fs::is_directory(dataFolder() / "meshes")) return;
    const char* ci = std::getenv("CI");
    if (ci && std::string(ci) == "true") {
      FAIL() << dataFolder() << " has no example meshes; set FLATLAND_DATA";
    }
    GTEST_SKIP() << "no example meshes in " << dataFolder() << "; set FLATLAND_DATA";
  }

  static std::vector<fs::path> meshes(bool large) {
    std::vector<fs::path> files;
    std::size_t all = 0;
    for (const auto& entry : fs::directory_iterator(dataFolder() / "meshes")) {
      const std::string extension = entry.path().extension().string();
      if (extension == ".md" || extension == ".png") continue;
      ++all;
      if ((entry.file_size() > kLargeBytes) == large) files.push_back(entry.path());
    }
    EXPECT_EQ(all, kMeshes);
    return files;
  }

  // Draws with the usual lines from a view that is along none of the axes.
  static void drawAll(bool large) {
    const test::TemporaryFolder folder;
    const fs::path output = folder.path() / "drawing.json";
    for (const fs::path& mesh : meshes(large)) {
      SCOPED_TRACE(mesh.filename());
      const test::ProgramResult result = test::runProgram(
          FLATLAND_PROGRAM,
          {.arguments = {"lines", mesh, "-o", output, "--view", "1,0.6,1.4", "--stats"}});
      ASSERT_EQ(result.exitCode, 0) << result.err;
      const json stats = json::parse(result.out), drawing = json::parse(test::contentsOf(output));
      EXPECT_EQ(stats["mesh"], mesh.filename().string());
      EXPECT_EQ(stats["triangles"], drawing["stats"]["triangles"]);
      std::set<std::string> families;
      double left = 800.0, right = 0.0, top = 600.0, bottom = 0.0;
      for (const json& line : drawing["polylines"]) {
        families.insert(line["family"]);
        for (const json& at : line["screen"]) {
          left = std::min(left, at[0].get<double>());
          right = std::max(right, at[0].get<double>());
          top = std::min(top, at[1].get<double>());
          bottom = std::max(bottom, at[1].get<double>());
        }
        for (const json& p : line["points"]) {
          for (const json& x : p) EXPECT_TRUE(x.is_number());  // null would be no number
        }
      }
      EXPECT_TRUE(families.contains("contours"));
      // The outline fills the picture less its margin, one way or the other.
      EXPECT_GE(std::min({left, top, 800.0 - right, 600.0 - bottom}), 15.0);
      EXPECT_TRUE(right - left > 740.0 || bottom - top > 540.0)
          << left << ' ' << right << ' ' << top << ' ' << bottom;
    }
  }
};

TEST_F(LinesData, EveryMeshIsDrawn) { drawAll(false); }
TEST_F(LinesData, EveryLargeMeshIsDrawn) { drawAll(true); }

}  // namespace
}  // namespace flatland
