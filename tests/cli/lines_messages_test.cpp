// SPDX-License-Identifier: GPL-3.0-or-later
// What flatland lines and the other commands of meshes say of what cannot be, and their help.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "core3d/lines/line_family.h"
#include "tests/support/flatland_program.h"

namespace flatland::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTorus = "solid:torus:60";

TEST(LinesMessages, BadInputIsTold) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "bad.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n";
  std::ofstream(folder.path() / "cameras.json")
      << R"({"flatland": 1, "cameras": [{"veiw": [1, 0, 0]}]})";
  std::ofstream(folder.path() / "zoom.json") << R"({"flatland": 1, "cameras": [{"zoom": 1e9}]})";
  std::ofstream(folder.path() / "twice.json")
      << R"({"flatland": 1, "cameras": [{"name": "02"}, {}]})";
  struct Case {
    std::vector<std::string> arguments;
    const char* message;
  };
  const Case cases[] = {
      {{"lines", "none.obj", "-o", "a.svg"}, "flatland: none.obj"},
      {{"lines", "preset:thesis", "-o", "a.svg"},
       "preset:thesis: a scene of curves, not a mesh; flatland draw makes a picture of it"},
      {{"lines", "bad.obj", "-o", "a.svg"}, "flatland: bad.obj: line 4"},
      {{"lines", "solid:tours", "-o", "a.svg"}, "no such solid; there are sphere, "},
      {{"lines", "solid:torus:x", "-o", "a.svg"}, "number of cells"},
      {{"lines", kTorus, "-o", "none/a.svg"}, "none/a.svg"},
      {{"lines", kTorus, "-o", "a.svg", "--cameras", "none.json"}, "none.json"},
      {{"lines", kTorus, "-o", "a.svg", "--cameras", "cameras.json"},
       "cameras.json: cameras[0]: unknown key \"veiw\""},
      {{"lines", kTorus, "-o", "a.svg", "--cameras", "zoom.json"},
       "zoom.json: cameras[0].zoom: expected a zoom above 0, at most 1000, found 1e+09"},
      {{"lines", kTorus, "-o", "a.svg", "--cameras", "twice.json"},
       "twice.json: cameras[1]: its picture would be a-02.svg, as that of cameras[0]"},
      {{"fields", "none.obj", "-o", "a.ply"}, "none.obj"},
  };
  for (const Case& bad : cases) {
    const ProgramResult result = runIn(folder.path(), bad.arguments);
    EXPECT_EQ(result.exitCode, 1) << result.err;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_FALSE(fs::exists(folder.path() / "a.svg"));
  }
}

TEST(LinesMessages, BadUsageIsToldWithTheValidNames) {
  struct Case {
    std::vector<std::string> arguments;
    const char* message;
  };
  const Case cases[] = {
      {{"lines", kTorus}, "--output is required"},
      {{"lines", kTorus, "-o", "a.doc"}, ".svg, .pdf, .png, .tex or .json"},
      {{"lines", kTorus, "-o", "a.svg", "--lines", "contours,apparent-ridge"},
       "did you mean apparent-ridges? There are exterior-silhouette, contours"},
      {{"lines", kTorus, "-o", "a.svg", "--threshold", "rigdes=1"}, "did you mean ridges?"},
      {{"lines", kTorus, "-o", "a.svg", "--threshold", "ridges"}, "FAMILY=VALUE"},
      {{"lines", kTorus, "-o", "a.svg", "--threshold", "apparent-ridges=-1"}, "from 0 up"},
      {{"lines", kTorus, "-o", "a.svg", "--threshold", "ridges=1"},
       "--threshold: ridges are not among the lines drawn"},
      {{"lines", kTorus, "-o", "a.svg", "--threshold", "contours=1"},
       "no threshold of contours; there are suggestive-contours"},
      {{"lines", kTorus, "-o", "a.svg", "--isophotes", "5"}, "isophotes are not among the lines"},
      {{"lines", kTorus, "-o", "a.svg", "--topographic-up", "0,0,1"},
       "topographic are not among the lines"},
      {{"lines", kTorus, "-o", "-"}, "the format is told by a file's name"},
      {{"lines", "-", "-o", "a.svg"}, "a mesh is read from a file"},
      {{"lines", kTorus, "-o", "a.svg", "--hiden", "dash"}, "did you mean '--hidden'?"},
      {{"fields", kTorus, "-o", "a.ply", "--estimater=jet"}, "did you mean '--estimator'?"},
      {{"study", "offset", "--sede", "1"},
       "(see flatland study offset --help); did you mean '--seed'?"},
      {{"lines", kTorus, "-o", "a.svg", "--view", "0,0,0"}, "expected a direction"},
      {{"lines", kTorus, "-o", "a.svg", "--view", "1,2"}, "expected a direction"},
      {{"lines", kTorus, "-o", "a.svg", "--hidden", "dashed"}, "did you mean dash?"},
      {{"lines", kTorus, "-o", "a.svg", "--estimator", "jets"}, "did you mean jet?"},
      {{"lines", kTorus, "-o", "a.svg", "--ink", "2"}, "--ink"},
      {{"lines", kTorus, "-o", "a.svg", "--perspective", "180"}, "--perspective"},
      {{"lines", kTorus, "-o", "a.svg", "--turntable", "4", "--cameras", "c.json"}, "exclude"},
      {{"lines", kTorus, "-o", "a.svg", "--view", "0,2,0", "--turntable", "4"}, "--view is along"},
      {{"lines", kTorus, "-o", "a.svg", "--estimator", "one-ring", "--scale", "11"}, "10 at most"},
      {{"fields", kTorus, "-o", "a.svg"}, ".ply or .csv"},
      {{"convergence", "sine-shet"}, "did you mean sine-sheet? There are sine-sheet, gaussian"},
      {{"convergence", "sine-sheet", "--cells", "2"}, "--cells"},
  };
  for (const Case& bad : cases) {
    const ProgramResult result = run(bad.arguments);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << result.err;
  }
}

TEST(LinesMessages, NumbersThatAreNoneAreRefusedByEveryOption) {
  struct Case {
    std::vector<std::string> arguments;
    const char* message;
  };
  const std::vector<std::string> lines{"lines", kTorus, "-o", "a.svg"};
  const Case cases[] = {
      {{"--width", "nan"}, "--width: expected a number from 0.01 to 100, found nan"},
      {{"--width", "inf"}, "found inf"},
      {{"--perspective", "nan"}, "--perspective: expected a number from 0.1 to 179, found nan"},
      {{"--dpi", "nan"}, "--dpi: expected a number from 8 to 4800"},
      {{"--ink", "nan"}, "--ink: expected a number from 0.000001 to 1, found nan"},
      {{"--min-length", "nan"}, "--min-length: expected a number from 0 to 10000"},
      {{"--simplify", "nan"}, "--simplify: expected a number from 0 to 100"},
      {{"--scale", "-nan"}, "--scale: expected a number from 1 to 100"},
      {{"--threads", "2.5"}, "--threads: expected a whole number from 1 to 1024, found 2.5"},
      {{"--lines", "creases", "--threshold", "creases=400"}, "expected degrees from 0 to 180"},
      {{"--lines", "contours,,ridges"}, "--lines: an entry between the commas"},
      {{"--lines=contours,"}, "--lines: an entry between the commas"},
  };
  for (Case bad : cases) {
    bad.arguments.insert(bad.arguments.begin(), lines.begin(), lines.end());
    const ProgramResult result = run(bad.arguments);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << result.err;
  }
  const Case others[] = {
      {{"convergence", "gaussian-bump", "--cells", "10,20", "--threshold", "nan"},
       "--threshold: expected a number from 0 to 1000000, found nan"},
      {{"convergence", "gaussian-bump", "--cells", "10,,20"}, "--cells: an entry"},
      {{"convergence", "sine-sheet", "--seed", "-1"},
       "--seed: expected a whole number from 0, found -1"},
      {{"study", "offset", "--seed", "2.5"}, "--seed: expected a whole number from 0, found 2.5"},
      {{"study", "offset", "--scale", "nan"}, "--scale: expected a number, found nan"},
      {{"study", "limits", "preset:thesis", "--t", "nan"}, "--t: expected a number, found nan"},
      {{"derivation", kTorus, "--vertex", "-1"}, "--vertex: expected a whole number from 0"},
      {{"derivation", kTorus, "--point", "0,nan,0"}, "--point: expected a number, found nan"},
      {{"slice", kTorus, "-o", "a.json", "--plane", "1,0,0,0", "--tolerance", "nan"},
       "--tolerance: expected a number from 1e-12 to 1e+12"},
      {{"bridge", "preset:thesis", "--extrude", "nan"}, "--extrude: expected a number from"},
      {{"lins", "hand.obj", "-o", "bad/a.svg"}, "not expected: hand.obj -o bad/a.svg"},
  };
  for (const Case& bad : others) {
    const ProgramResult result = run(bad.arguments);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_NE(result.err.find(bad.message), std::string::npos) << result.err;
  }
  EXPECT_NE(run({"lines", "--help"}).out.find("from 0.000001 to 1\n"), std::string::npos);
}

TEST(LinesMessages, InkThatCannotBeReachedIsToldWithPictureAndNumbers) {
  const TemporaryFolder folder;
  const ProgramResult result = runIn(folder.path(), {"lines", "solid:sphere:20", "-o", "s.json",
                                                     "--ink", "0.5", "--turntable", "2"});
  EXPECT_EQ(result.exitCode, 0);
  for (const char* file : {"s-01.json", "s-02.json"}) {
    const json stats = json::parse(contentsOf(folder.path() / file))["stats"];
    EXPECT_EQ(stats["inkReached"], false);
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(),
                  "flatland: %s: ink of 0.5 is not reached; strokes worth drawing give %.4g\n",
                  file, stats["ink"].get<double>());
    EXPECT_NE(result.err.find(line.data()), std::string::npos) << result.err << line.data();
  }
}

TEST(LinesMessages, ThresholdsThatInkFoundCanBeGivenBack) {
  const TemporaryFolder folder;
  const std::vector<std::string> lines{"lines", "solid:bumpy-sphere:60", "--lines",
                                       "apparent-ridges,creases"};
  const auto made = [&](const std::string& file, std::vector<std::string> more) {
    more.insert(more.begin(), lines.begin(), lines.end());
    more.insert(more.end(), {"-o", file});
    EXPECT_EQ(runIn(folder.path(), more).exitCode, 0);
    return contentsOf(folder.path() / file);
  };
  const auto recordOf = [](const std::string& svg) {
    const std::size_t start = svg.find('{', svg.find("<drawing>"));
    std::string text = svg.substr(start, svg.find("</", start) - start);
    const std::string quote = "&quot;";
    for (std::size_t i = 0; (i = text.find(quote, i)) != std::string::npos;) {
      text.replace(i, quote.size(), "\"");
    }
    return json::parse(text);
  };
  const auto strokesOf = [](const std::string& svg) { return svg.substr(svg.find("</metadata>")); };
  // Little ink: thresholds are raised, and given back they draw the same strokes.
  const std::string svg = made("ink.svg", {"--ink", "0.004"});
  const json record = recordOf(svg);
  ASSERT_GT(record["thresholdFactor"].get<double>(), 1.0);
  EXPECT_EQ(record["thresholds"]["creases"], 30.0);  // which ink leaves alone
  const double used = record["thresholds"]["apparent-ridges"];
  EXPECT_DOUBLE_EQ(used, 2.0 * record["thresholdFactor"].get<double>());
  const std::string again =
      made("again.svg", {"--threshold", "apparent-ridges=" + json(used).dump()});
  EXPECT_EQ(strokesOf(svg), strokesOf(again));
  EXPECT_NE(strokesOf(svg), strokesOf(made("usual.svg", {})));
  EXPECT_FALSE(recordOf(again).contains("thresholdFactor"));
}

TEST(LinesMessages, HelpHasExamplesAndEveryFamily) {
  for (const char* command : {"lines", "fields", "convergence"}) {
    const ProgramResult result = run({command, "--help"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_NE(result.out.find("Examples:"), std::string::npos) << command;
    EXPECT_TRUE(result.err.empty());
  }
  const std::string help = run({"lines", "--help"}).out;
  for (const LineFamily family : allLineFamilies()) {
    EXPECT_NE(help.find(std::string(nameOf(family))), std::string::npos) << nameOf(family);
  }
  EXPECT_NE(help.find("zero-mean-curvature=0.1"), std::string::npos);
  EXPECT_NE(help.find("creases=30"), std::string::npos);
}

}  // namespace
}  // namespace flatland::test
