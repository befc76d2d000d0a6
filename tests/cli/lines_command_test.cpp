// SPDX-License-Identifier: GPL-3.0-or-later
// flatland lines, from the outside.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/support/flatland_program.h"
#include "tests/support/xml_check.h"

namespace flatland::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTorus = "solid:torus:60";
constexpr double kSvgRounding = 0.00051;  // three decimals

/// The drawing that `flatland lines` makes, as JSON.
json drawn(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "drawing.json";
  std::vector<std::string> all{"lines"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"-o", file});
  const ProgramResult result = run(all);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return result.exitCode == 0 ? json::parse(contentsOf(file)) : json::object();
}

std::set<std::string> familiesOf(const json& drawing) {
  std::set<std::string> families;
  for (const json& line : drawing["polylines"]) families.insert(line["family"]);
  return families;
}

TEST(LinesCommand, JsonHasStrokesInTheCoordinatesOfTheFileAndOnTheScreen) {
  const json drawing = drawn({kTorus, "--view", "1,0.7,0.9", "--size", "640x480"});
  ASSERT_EQ(drawing.size(), 2u);
  ASSERT_FALSE(drawing["polylines"].empty());
  EXPECT_EQ(drawing["stats"]["triangles"], 2 * 60 * 60);
  EXPECT_EQ(drawing["stats"]["polylines"], drawing["polylines"].size());
  EXPECT_FALSE(drawing["stats"].contains("ms"));  // the same every time
  for (const json& line : drawing["polylines"]) {
    EXPECT_EQ(line["visible"], true);
    ASSERT_GE(line["points"].size(), 2u);
    ASSERT_EQ(line["points"].size(), line["screen"].size());
    ASSERT_EQ(line["points"].size(), line["strength"].size());
    for (const json& p : line["points"]) {
      // On the torus, whose tube of radius 0.4 runs about the circle of radius 1, up to the chords.
      const double x = p[0], y = p[1], z = p[2];
      EXPECT_NEAR(std::hypot(std::hypot(x, y) - 1.0, z), 0.4, 0.01);
    }
    for (const json& s : line["screen"]) {
      EXPECT_GE(s[0], 0.0);
      EXPECT_LE(s[0], 640.0);
      EXPECT_GE(s[1], 0.0);
      EXPECT_LE(s[1], 480.0);
    }
  }
}

// Orthographic: one scale and one offset take every point to its place, along the axes that the
// view and up make.
TEST(LinesCommand, ScreenIsTheProjectionAlongTheViewWithUpUpward) {
  const Eigen::Vector3d w = Eigen::Vector3d(1.0, 2.0, 0.5).normalized();
  const json drawing = drawn({kTorus, "--view", "1,2,0.5", "--up", "0,0,1", "--lines", "contours"});
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(w).normalized(), up = w.cross(right);
  std::vector<Eigen::Vector2d> seen, screen;
  for (const json& line : drawing["polylines"]) {
    for (std::size_t i = 0; i < line["points"].size(); ++i) {
      const json& p = line["points"][i];
      const Eigen::Vector3d at(p[0], p[1], p[2]);
      seen.emplace_back(at.dot(right), -at.dot(up));
      screen.emplace_back(line["screen"][i][0], line["screen"][i][1]);
    }
  }
  ASSERT_GT(seen.size(), 20u);
  std::size_t farthest = 1;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    if ((seen[i] - seen[0]).norm() > (seen[farthest] - seen[0]).norm()) farthest = i;
  }
  const double scale = (screen[farthest] - screen[0]).norm() / (seen[farthest] - seen[0]).norm();
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_LT((screen[i] - screen[0] - scale * (seen[i] - seen[0])).norm(), 0.01);
  }
}

TEST(LinesCommand, SvgHasTheStrokesOfTheJson) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "torus.svg";
  const std::vector<std::string> arguments{kTorus,
                                           "--view",
                                           "1,0.3,0.5",
                                           "--hidden",
                                           "dash",
                                           "--lines",
                                           "contours,apparent-ridges,ridges"};
  std::vector<std::string> svgArguments{"lines"};
  svgArguments.insert(svgArguments.end(), arguments.begin(), arguments.end());
  svgArguments.insert(svgArguments.end(), {"-o", file});
  ASSERT_EQ(run(svgArguments).exitCode, 0);
  const json drawing = drawn(arguments);
  const XmlReading reading = readXml(contentsOf(file));
  ASSERT_EQ(reading.error, std::nullopt);

  std::map<std::string, std::vector<json>> strokes;  // by the id of their group
  for (const json& line : drawing["polylines"]) {
    const std::string seen = line["visible"].get<bool>() ? "visible" : "hidden";
    strokes[line["family"].get<std::string>() + "-" + seen].push_back(line);
  }
  EXPECT_TRUE(strokes.contains("contours-hidden"));
  std::string group, command;
  std::map<std::string, std::size_t> next;
  for (const XmlElement& element : reading.elements) {
    if (element.name == "command") command = element.text;
    if (element.name == "g") {
      group = element.attributes.at("id");
      const std::size_t dash = group.rfind('-');
      EXPECT_EQ(element.attributes.at("class"),
                "lines " + group.substr(0, dash) + " " + group.substr(dash + 1));
    }
    if (element.name != "path") continue;
    ASSERT_TRUE(strokes.contains(group)) << group;
    ASSERT_LT(next[group], strokes[group].size());
    const json& line = strokes[group][next[group]++];
    EXPECT_EQ(element.attributes.at("stroke-linejoin"), "round");
    EXPECT_EQ(element.attributes.contains("stroke-dasharray"), line["visible"] == false);
    std::string path = element.attributes.at("d");
    EXPECT_EQ(path.back() == 'Z', line["closed"].get<bool>());
    for (char& c : path) {
      if (std::isalpha(static_cast<unsigned char>(c)) != 0) c = ' ';
    }
    std::istringstream in(path);
    double x = 0.0, y = 0.0;
    std::size_t points = 0;
    for (; in >> x >> y; ++points) {
      ASSERT_LT(points, line["screen"].size());
      EXPECT_NEAR(x, line["screen"][points][0].get<double>(), kSvgRounding);
      EXPECT_NEAR(y, line["screen"][points][1].get<double>(), kSvgRounding);
    }
    EXPECT_EQ(points, line["screen"].size());
  }
  for (const auto& [id, lines] : strokes) EXPECT_EQ(next[id], lines.size()) << id;
  // The command reproduces the figure and tells nothing of where it was made.
  EXPECT_EQ(command,
            "flatland lines solid:torus:60 --view 1,0.3,0.5 --hidden dash --lines "
            "contours,apparent-ridges,ridges -o torus.svg");
  EXPECT_EQ(contentsOf(file).find(folder.path().string()), std::string::npos);
}

TEST(LinesCommand, IsTheSameEveryTime) {
  const TemporaryFolder folder;
  for (const char* name : {"a.svg", "b.svg", "a.json", "b.json", "a.tex", "b.tex"}) {
    const ProgramResult result =
        runIn(folder.path(), {"lines", "solid:bumpy-sphere:30", "-o", name, "--lines", "all",
                              "--threads", name[0] == 'a' ? "1" : "2"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
  }
  const auto withoutCommand = [&](const std::string& name, const std::string& start) {
    std::istringstream in(contentsOf(folder.path() / name));
    std::string text;
    for (std::string line; std::getline(in, line);) {
      if (line.find(start) == std::string::npos) text += line + "\n";
    }
    return text;
  };
  EXPECT_EQ(contentsOf(folder.path() / "a.json"), contentsOf(folder.path() / "b.json"));
  for (const std::string suffix : {".svg", ".tex"}) {
    EXPECT_EQ(withoutCommand("a" + suffix, "--threads"), withoutCommand("b" + suffix, "--threads"));
  }
}

TEST(LinesCommand, WritesEveryFormat) {
  const TemporaryFolder folder;
  const auto make = [&](const std::string& name) {
    return run({"lines", kTorus, "-o", folder.path() / name, "--size", "200x150"});
  };
  ASSERT_EQ(make("a.tex").exitCode, 0);
  const std::string tex = contentsOf(folder.path() / "a.tex");
  EXPECT_NE(tex.find("\\begin{tikzpicture}"), std::string::npos);
  EXPECT_NE(tex.find("line join=round"), std::string::npos);
  EXPECT_NE(tex.find("% Drawing:"), std::string::npos);
  if (FLATLAND_WITH_QT) {
    ASSERT_EQ(make("a.png").exitCode, 0);
    const std::string png = contentsOf(folder.path() / "a.png");
    ASSERT_GT(png.size(), 33u);
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_EQ(static_cast<unsigned char>(png[19]), 200);  // width, lowest byte
    EXPECT_EQ(static_cast<unsigned char>(png[23]), 150);
    ASSERT_EQ(make("a.pdf").exitCode, 0);
    const std::string pdf = contentsOf(folder.path() / "a.pdf");
    EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
    EXPECT_NE(pdf.find("drawing.json"), std::string::npos);
  } else {
    const ProgramResult result = make("a.png");
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find("needs Qt"), std::string::npos) << result.err;
  }
}

TEST(LinesCommand, DrawsTheFamiliesAskedFor) {
  EXPECT_EQ(familiesOf(drawn({"solid:sphere:30"})), std::set<std::string>{"contours"});
  EXPECT_EQ(familiesOf(drawn({"solid:cylinder:30", "--view", "1,0,0.5", "--lines", "boundaries"})),
            std::set<std::string>{"boundaries"});
  const json isophotes = drawn({"solid:sphere:30", "--lines", "isophotes", "--isophotes", "4"});
  std::set<int> levels;
  for (const json& line : isophotes["polylines"]) levels.insert(line["level"].get<int>());
  EXPECT_GE(levels.size(), 3u);
  EXPECT_LE(levels.size(), 5u);
}

TEST(LinesCommand, ThresholdsAndInkChangeHowMuchIsDrawn) {
  const auto ink = [](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"solid:bumpy-sphere:40", "--lines", "ridges,valleys"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return drawn(arguments)["stats"]["ink"].get<double>();
  };
  const double all = ink({"--threshold", "ridges=0", "--threshold", "valleys=0"});
  const double some = ink({"--threshold", "ridges=1000000", "--threshold", "valleys=0"});
  EXPECT_GT(all, some);
  EXPECT_NEAR(ink({"--threshold", "ridges=1000000", "--threshold", "valleys=1000000"}), 0.0, 1e-9);
  EXPECT_NEAR(ink({"--ink", "0.01"}), 0.01, 0.002);
}

TEST(LinesCommand, HiddenLinesAreThereWhenAskedFor) {
  const auto hidden = [](const char* how) {
    const json drawing =
        drawn({kTorus, "--view", "1,0,0.4", "--lines", "contours", "--hidden", how});
    return std::count_if(drawing["polylines"].begin(), drawing["polylines"].end(),
                         [](const json& line) { return line["visible"] == false; });
  };
  EXPECT_EQ(hidden("remove"), 0);
  EXPECT_GT(hidden("dash"), 0);
  EXPECT_EQ(hidden("show"), hidden("dash"));
}

TEST(LinesCommand, TurntableNumbersItsFilesAndKeepsTheSize) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runIn(folder.path(), {"lines", "solid:ellipsoid:20", "-o", "e.json", "--turntable", "12",
                            "--lines", "contours", "--stats"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(folder.count(), 12u);
  const json stats = json::parse(result.out);
  ASSERT_EQ(stats["views"].size(), 12u);
  const auto contour = [&](int i) {
    const std::string name = std::string("e-") + (i < 10 ? "0" : "") + std::to_string(i) + ".json";
    EXPECT_EQ(stats["views"][static_cast<std::size_t>(i - 1)]["file"], name);
    double height = 0.0, width = 0.0;
    const json drawing = json::parse(contentsOf(folder.path() / name));
    for (const json& line : drawing["polylines"]) {
      for (const json& s : line["screen"]) {
        width = std::max(width, std::abs(s[0].get<double>() - 400.0));
        height = std::max(height, std::abs(s[1].get<double>() - 300.0));
      }
    }
    return std::pair(width, height);
  };
  // Half axes 1, 0.8, 0.6: turned about y the height stays, and the width goes from x to z.
  const auto [frontWidth, frontHeight] = contour(1);
  const auto [sideWidth, sideHeight] = contour(4);
  EXPECT_NEAR(frontHeight, sideHeight, 0.5);
  EXPECT_NEAR(frontWidth / frontHeight, 1.0 / 0.8, 0.01);
  EXPECT_NEAR(sideWidth / sideHeight, 0.6 / 0.8, 0.01);
  const auto [thirdWidth, thirdHeight] = contour(7);
  EXPECT_NEAR(thirdWidth, frontWidth, 0.5);
}

TEST(LinesCommand, TurntableAboutTheUsualViewLooksAcrossIt) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runIn(folder.path(), {"lines", "solid:ellipsoid:20", "-o", "e.json", "--up", "0,0,1",
                            "--turntable", "4", "--lines", "contours"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto width = [&](const char* name) {
    double most = 0.0;
    const json drawing = json::parse(contentsOf(folder.path() / name));
    for (const json& line : drawing["polylines"]) {
      for (const json& s : line["screen"]) {
        most = std::max(most, std::abs(s[0].get<double>() - 400.0));
      }
    }
    return most;
  };
  // Half axes 1 and 0.8 across z: from -y the first is seen, a quarter on the second.
  EXPECT_NEAR(width("e-01.json") / width("e-02.json"), 1.0 / 0.8, 0.01);
  // So is a single picture.
  ASSERT_EQ(runIn(folder.path(), {"lines", "solid:ellipsoid:20", "-o", "s.json", "--up", "0,0,1"})
                .exitCode,
            0);
  ASSERT_EQ(runIn(folder.path(), {"lines", "solid:ellipsoid:20", "-o", "y.json", "--up", "0,0,1",
                                  "--view", "0,-1,0"})
                .exitCode,
            0);
  EXPECT_EQ(contentsOf(folder.path() / "s.json"), contentsOf(folder.path() / "y.json"));
}

TEST(LinesCommand, PicturesTellWhatShapedThem) {
  const TemporaryFolder folder;
  const ProgramResult result =
      runIn(folder.path(), {"lines", kTorus, "-o", "t.svg", "--lines", "apparent-ridges,isophotes",
                            "--threshold", "apparent-ridges=0", "--isophotes", "7", "--hidden",
                            "dash", "--style", "taper", "--min-length", "9", "--unfiltered"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  std::string svg = contentsOf(folder.path() / "t.svg");
  for (std::size_t at; (at = svg.find("&quot;")) != std::string::npos;) svg.replace(at, 6, "\"");
  for (const char* part : {R"("apparent-ridges": 0.0)", R"("isophotes": 7)", R"("hidden": "dash")",
                           R"("style": "taper")", R"("minLength": 9.0)", R"("unfiltered": true)",
                           R"("fit": "outline")"}) {
    EXPECT_NE(svg.find(part), std::string::npos) << part;
  }
}

TEST(LinesCommand, CamerasGiveTheirNamesToTheFiles) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "cameras.json")
      << R"({"flatland": 1, "cameras": [{"name": "front"}, {"view": [1, 0, 0],
           "perspectiveDeg": 40, "zoom": 1}]})";
  const ProgramResult result =
      runIn(folder.path(), {"lines", kTorus, "-o", "t.svg", "--cameras", "cameras.json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_TRUE(fs::exists(folder.path() / "t-front.svg"));
  EXPECT_TRUE(fs::exists(folder.path() / "t-02.svg"));
  EXPECT_EQ(folder.count(), 3u);
}

TEST(LinesCommand, ZoomCostsNoMoreThanThePicture) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "near.json")
      << R"({"flatland": 1, "cameras": [{"view": [1, 0.6, 2], "zoom": 1000}]})";
  const ProgramResult result =
      runIn(folder.path(), {"lines", kTorus, "-o", "t.json", "--lines", "all", "--cameras",
                            "near.json", "--hidden", "show"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json drawing = json::parse(contentsOf(folder.path() / "t-01.json"));
  for (const json& line : drawing["polylines"]) {
    for (const json& s : line["screen"]) {
      EXPECT_NEAR(s[0].get<double>(), 400.0, 901.0);
      EXPECT_NEAR(s[1].get<double>(), 300.0, 801.0);
    }
  }
}

TEST(LinesCommand, StatsTellTheStages) {
  const TemporaryFolder folder;
  const ProgramResult result = run({"lines", kTorus, "-o", folder.path() / "a.svg", "--stats"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json stats = json::parse(result.out);
  EXPECT_EQ(stats["mesh"], kTorus);
  EXPECT_EQ(stats["triangles"], 7200);
  EXPECT_EQ(stats["vertices"], 3600);
  EXPECT_GT(stats["precomputeMs"]["fields"], 0.0);
  EXPECT_GT(stats["peakMemoryMb"], 1.0);
  ASSERT_EQ(stats["views"].size(), 1u);
  const json& view = stats["views"][0];
  for (const char* key : {"segments", "polylines", "ink", "share", "thresholdFactor"}) {
    EXPECT_TRUE(view[key].is_number()) << key;
  }
  EXPECT_EQ(view["inkReached"], true);
  double prepared = 0.0;
  for (const char* part : {"read", "fields", "lines", "rays"}) {
    EXPECT_GT(stats["precomputeMs"][part], 0.0) << part;
    prepared += stats["precomputeMs"][part].get<double>();
  }
  EXPECT_NEAR(stats["precomputeMs"]["total"].get<double>(), prepared, 0.01);
  double sum = 0.0;
  for (const char* stage : {"vertex", "segment", "chain", "visibility", "stroke"}) {
    sum += view["ms"][stage].get<double>();
  }
  EXPECT_NEAR(view["ms"]["total"].get<double>(), sum, 0.01);
}

}  // namespace
}  // namespace flatland::test
