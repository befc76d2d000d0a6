// SPDX-License-Identifier: GPL-3.0-or-later
// SVG files from the wild: their marks, and what becomes of them when they are damaged.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "flatland/features/features.h"
#include "flatland/io/input_error.h"
#include "flatland/io/scene_json.h"
#include "flatland/io/svg_file.h"
#include "tests/support/run_program.h"
#include "tests/support/seed.h"

namespace flatland::test {
namespace {

std::vector<std::filesystem::path> realFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(FLATLAND_TEST_DATA "/svg")) {
    if (isSvgName(entry.path().string())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(SvgRealFiles, RealFilesGiveMarks) {
  const std::vector<std::filesystem::path> files = realFiles();
  ASSERT_GE(files.size(), 5U);
  int withSomethingLeftOut = 0;
  for (const std::filesystem::path& file : files) {
    const ImportedScene imported = loadSvg(file);
    withSomethingLeftOut += !imported.leftOut.empty();
    // Icons are square; every curve lies within the page.
    for (const double angle : {90.0, 20.0}) {
      Scene scene = imported.scene;
      scene.view.angleDeg = angle;
      const FeatureSet found = findFeatures(scene);
      EXPECT_TRUE(found.complete()) << file << ' ' << found.unresolved.size();
      std::vector<int> silhouettes(scene.curves.size(), 0);
      for (const Mark& mark : found.marks) {
        if (mark.kind == MarkKind::Silhouette) ++silhouettes[static_cast<std::size_t>(mark.curve)];
      }
      for (std::size_t i = 0; i < silhouettes.size(); ++i) {
        // A closed curve turns back on the screen at least twice, and as often there as back.
        if (!isClosed(scene.curves[i].shape)) continue;
        const bool endOn =
            std::any_of(found.degenerate.begin(), found.degenerate.end(), [&](const Degenerate& d) {
              return d.curve == static_cast<int>(i) && d.what == Degenerate::What::StraightEndOn;
            });
        if (endOn) continue;
        EXPECT_GE(silhouettes[i], 2) << file << " curve " << i;
        EXPECT_EQ(silhouettes[i] % 2, 0) << file << " curve " << i;
      }
    }
    // What is imported can be saved and read back.
    EXPECT_EQ(sceneFromJson(sceneToJson(imported.scene), "back"), imported.scene);
  }
  EXPECT_EQ(withSomethingLeftOut, 4);  // of minuet-scales.svg all is read, its style sheet too
}

TEST(SvgRealFiles, IconsOfTheSystemIfThereAreAny) {
  int read = 0, refused = 0;
  for (const char* folder : {"/usr/share/icons/Adwaita", "/usr/share/icons/hicolor"}) {
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none)) {
      if (!isSvgName(entry.path().string()) || !entry.is_regular_file()) continue;
      try {
        const ImportedScene imported = loadSvg(entry.path());
        EXPECT_FALSE(imported.scene.curves.empty());
        ++read;
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  if (read + refused == 0) GTEST_SKIP() << "no icons here";
  EXPECT_LE(refused, read / 50) << read << " read";
}

TEST(SvgRealFiles, MutatedFilesAreReadOrRefused) {
  Random random(announcedSeed("svg mutations", 11));
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  std::vector<std::string> texts;
  for (const auto& file : realFiles()) texts.push_back(contentsOf(file));
  const std::string pieces[] = {"<",    ">",    "\"",      "1e308", "-",    "z",
                                "M",    "A",    "NaN",     "%",     "use ", "99999999999",
                                "\xff", "</g>", "matrix(", ",",     "&#0;", " 0 0 0"};
  int read = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = texts[below(texts.size())];
    for (std::size_t k = below(4) + 1; k > 0; --k) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, below(40));
          break;
        case 2:
          text.insert(at, pieces[below(std::size(pieces))]);
          break;
        default:
          text.insert(at, text.substr(below(text.size()), below(200)));
      }
    }
    try {
      const ImportedScene imported = sceneFromSvg(text, "mutated.svg");
      ++read;
      for (const SceneCurve& curve : imported.scene.curves) {
        for (const Vec2& p : controlPoints(curve.shape)) EXPECT_TRUE(p.allFinite());
      }
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("mutated.svg: ", 0), 0U);
    }
  }
  EXPECT_GT(read, 200);
}

}  // namespace
}  // namespace flatland::test
