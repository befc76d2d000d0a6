// SPDX-License-Identifier: GPL-3.0-or-later
// flatland lines on every example mesh beside the checkout.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/core3d/example_meshes.h"
#include "tests/support/run_program.h"

namespace flatland {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::dataFolder;

constexpr std::uintmax_t kLargeBytes = 3000000;  // what takes long to draw is tested as "Large"
constexpr std::size_t kMeshes = 21;
constexpr std::size_t kMessyMeshes = 52;

#if defined(__SANITIZE_ADDRESS__)
constexpr double kSeconds = 20.0, kMegabytes = 4000.0;
#else
constexpr double kSeconds = 1.0;  // of processor time
constexpr double kMegabytes = 200.0;
#endif

// What the programs started so far have used.
struct Usage {
  double seconds, mostMegabytes;
};
Usage usageOfPrograms() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024.0};
}

class LinesData : public test::ExampleMeshes {
 protected:
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

// Odd and broken files, all of them small: all families at once, or one line that says why not.
TEST_F(LinesData, MessyFilesAreDrawnOrRefused) {
  ASSERT_TRUE(fs::is_directory(dataFolder() / "messy"));
  const test::TemporaryFolder folder;
  std::size_t all = 0, drawn = 0;
  for (const auto& entry : fs::directory_iterator(dataFolder() / "messy")) {
    if (entry.path().extension() == ".md") continue;
    ++all;
    SCOPED_TRACE(entry.path().filename());
    const fs::path output = folder.path() / (entry.path().filename().string() + ".json");
    const Usage before = usageOfPrograms();
    const test::ProgramResult result = test::runProgram(
        FLATLAND_PROGRAM, {.arguments = {"lines", entry.path(), "-o", output, "--lines", "all",
                                         "--hidden", "show", "--view", "1,0.6,1.4"}});
    const Usage after = usageOfPrograms();
    EXPECT_LT(after.seconds - before.seconds, kSeconds);
    EXPECT_LE(after.mostMegabytes, std::max(before.mostMegabytes, kMegabytes));
    if (result.exitCode == 0) {
      ++drawn;
      const json drawing = json::parse(test::contentsOf(output));
      for (const json& line : drawing["polylines"]) {
        for (const char* list : {"points", "screen"}) {
          for (const json& place : line[list]) {
            for (const json& x : place) EXPECT_TRUE(x.is_number()) << list;
          }
        }
      }
    } else {
      EXPECT_EQ(result.exitCode, 1);
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
      EXPECT_FALSE(fs::exists(output));
    }
  }
  EXPECT_EQ(all, kMessyMeshes);
  EXPECT_GT(drawn, 15u);
}

TEST_F(LinesData, EveryMeshIsDrawn) { drawAll(false); }
TEST_F(LinesData, EveryLargeMeshIsDrawn) { drawAll(true); }

}  // namespace
}  // namespace flatland
