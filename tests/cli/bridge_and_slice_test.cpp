// SPDX-License-Identifier: GPL-3.0-or-later
// flatland bridge and slice, from the outside: closed forms, keys, exit codes, messages.
#include <cmath>
#include <fstream>

#include "flatland/curve/curve.h"
#include "flatland/io/scene_json.h"
#include "tests/support/flatland_program.h"

namespace flatland::test {
namespace {

namespace fs = std::filesystem;

/// y = 1 - x^2 over [-1, 1], seen from above: its ridge is at (0, 1), where k = 2.
constexpr const char* kParabola =
    R"({"flatland": 1, "curves": [{"bezier": [[-1, 0], [0, 2], [1, 0]]}],
        "view": {"angleDeg": 90}})";

class BridgeAndSlice : public testing::Test {
 protected:
  BridgeAndSlice() { std::ofstream(folder_.path() / "parabola.json") << kParabola; }

  ProgramResult run(const std::vector<std::string>& arguments) const {
    return runIn(folder_.path(), arguments);
  }
  std::string contents(const char* name) const { return contentsOf(folder_.path() / name); }
  bool exists(const char* name) const { return fs::exists(folder_.path() / name); }

  /// What is written with `-o out.json`.
  json made(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"-o", "out.json"});
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.exitCode == 0 ? json::parse(contents("out.json")) : json::object();
  }

  void expectRefused(const std::vector<std::string>& arguments, int code,
                     const std::string& message) const {
    SCOPED_TRACE(message);
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exitCode, code) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
    EXPECT_FALSE(exists("out.json"));
  }

  TemporaryFolder folder_;
};

using BridgeCommand = BridgeAndSlice;
using SliceCommand = BridgeAndSlice;

TEST_F(BridgeCommand, TheRidgeOfAParabolaIsARulingOfItsExtrusion) {
  const json bridge = made(
      {"bridge", "parabola.json", "--extrude", "1", "--view", "0,2,0.6", "--resolutions", "32,64"});
  EXPECT_EQ(bridge["surface"], "extrusion");
  EXPECT_EQ(bridge["height"], 1.0);
  EXPECT_NEAR(bridge["viewAngleDeg"], 90.0, 1e-12);
  ASSERT_EQ(bridge["predicted"].size(), 1u);
  const json& line = bridge["predicted"][0];
  EXPECT_EQ(line["kind"], "apparent-ridge");
  EXPECT_EQ(line["limit"], "none");
  EXPECT_EQ(line["closed"], false);
  EXPECT_NEAR(line["t"], 0.5, 1e-12);
  EXPECT_NEAR(line["lambda"], 4.0, 1e-9);
  EXPECT_NEAR(line["facing"], 2.0 / std::hypot(2.0, 0.6), 1e-9);
  ASSERT_EQ(line["points"].size(), 2u);
  for (const int end : {0, 1}) {
    const json& p = line["points"][static_cast<std::size_t>(end)];
    EXPECT_NEAR(p[0], 0.0, 1e-12);
    EXPECT_NEAR(p[1], 1.0, 1e-12);
    EXPECT_EQ(p[2], end - 0.5);
  }
  ASSERT_EQ(bridge["series"].size(), 4u);  // two estimators, two derivatives
  const json& jet = bridge["series"][0];
  EXPECT_EQ(jet["estimator"], "jet");
  EXPECT_EQ(jet["derivative"], "closed-form");
  ASSERT_EQ(jet["rows"].size(), 2u);
  EXPECT_EQ(jet["rows"][1]["cells"], 64);
  const json& ridges = jet["rows"][1]["ridges"];
  EXPECT_EQ(ridges["lines"], 1);
  EXPECT_EQ(ridges["linesBy"]["none"], 1);
  EXPECT_LT(ridges["medianEdges"], 0.1);
  EXPECT_LT(ridges["backMedianEdges"], 0.1);
  EXPECT_GT(ridges["coverage"], 0.99);
}

TEST_F(BridgeCommand, AnOpenCurveFacesItsViewerFromBehindToo) {
  const json bridge =
      made({"bridge", "parabola.json", "--view", "0,-2,0.6", "--resolutions", "16"});
  ASSERT_EQ(bridge["predicted"].size(), 1u);
  // An open curve's outside is where its normal points, which is towards the viewer.
  EXPECT_NEAR(bridge["predicted"][0]["facing"], 2.0 / std::hypot(2.0, 0.6), 1e-9);
  EXPECT_EQ(bridge["predicted"][0]["limit"], "none");
}

TEST_F(BridgeCommand, ARevolvedProfileHasACircle) {
  // The parabola about x = -2: the crest at radius 2 and height 1, seen along the axis.
  const json bridge = made({"bridge", "parabola.json", "--revolve", "-2", "--resolutions", "24"});
  EXPECT_EQ(bridge["surface"], "revolution");
  EXPECT_EQ(bridge["axis"], -2.0);
  ASSERT_EQ(bridge["predicted"].size(), 1u);
  EXPECT_EQ(bridge["predicted"][0]["closed"], true);
  for (const json& p : bridge["predicted"][0]["points"]) {
    EXPECT_NEAR(std::hypot(p[0].get<double>() + 2.0, p[2].get<double>()), 2.0, 1e-9);
    EXPECT_NEAR(p[1], 1.0, 1e-9);
  }
}

TEST_F(BridgeCommand, TheTableAndTheFilesAreTheSameEveryTime) {
  const std::vector<std::string> command{"bridge", "parabola.json", "--resolutions", "16,24"};
  std::string first;
  for (const char* file : {"a.json", "b.json", "a.csv", "b.csv", "a.svg"}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"-o", file});
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    if (first.empty()) first = result.out;
    EXPECT_EQ(result.out, first);
  }
  EXPECT_EQ(contents("a.json"), contents("b.json"));
  EXPECT_EQ(contents("a.csv"), contents("b.csv"));
  EXPECT_EQ(contents("a.csv").find("estimator,derivative,cells,edge,ridgePieces,ridgeMedianEdges"),
            0u);
  EXPECT_NE(first.find("predicted from flatland, seen from 90 degrees"), std::string::npos);
  EXPECT_NE(contents("a.svg").find("--resolutions 16,24"), std::string::npos);
}

TEST_F(BridgeCommand, RandomOnesAreNamedWithTheirNumbers) {
  const json bridge = made({"bridge", "--random", "2", "--seed", "5", "--resolutions", "48"});
  EXPECT_EQ(bridge["seed"], 5);
  EXPECT_EQ(bridge["cells"], 48);
  ASSERT_EQ(bridge["trials"].size(), 2u);
  EXPECT_GE(bridge["drawn"], 2);
  for (const json& trial : bridge["trials"]) {
    EXPECT_EQ(trial["points"].size(), 9u);
    EXPECT_NEAR(std::hypot(trial["towards"][0].get<double>(), trial["towards"][1].get<double>(),
                           trial["towards"][2].get<double>()),
                1.0, 1e-12);
    EXPECT_GE(trial["ridges"]["lines"], 1);
    EXPECT_TRUE(trial["ahead"].contains("limit") && trial["ahead"].contains("coarser"));
    EXPECT_GT(trial["gentlestEdges"], 0.0);
  }
  const json other = made({"bridge", "--random", "2", "--seed", "6", "--resolutions", "48"});
  EXPECT_NE(other["trials"], bridge["trials"]);
}

TEST_F(BridgeCommand, WhatCannotBeIsRefused) {
  const auto refused = [this](std::vector<std::string> arguments, int code,
                              const std::string& message) {
    arguments.insert(arguments.begin(), "bridge");
    arguments.insert(arguments.end(), {"-o", "out.json"});
    expectRefused(arguments, code, message);
  };
  refused({}, 2, "a scene or --random is needed");
  refused({"parabola.json", "--extrude", "1", "--revolve", "0"}, 2, "exclude each other");
  refused({"parabola.json", "--random", "2"}, 2, "give no scene, sweep or view");
  refused({"--random", "2", "--view", "1,0,0"}, 2, "give no scene, sweep or view");
  refused({"parabola.json", "--view", "0,0,1"}, 2, "a silhouette throughout");
  refused({"parabola.json", "--revolve", "-2", "--view", "1,0,0"}, 2, "along its axis");
  refused({"parabola.json", "--curve", "1"}, 2, "curve");
  refused({"parabola.json", "--resolutions", "4"}, 2, "--resolutions");
  refused({"parabola.json", "--extrude", "0"}, 2, "--extrude");
  refused({"parabola.json", "--extrud", "1"}, 2, "did you mean '--extrude'?");
  refused({"none.json"}, 1, "none.json");
  expectRefused({"bridge", "--random", "2", "-o", "out.svg"}, 2, ".csv or .json");
  expectRefused({"bridge", "parabola.json", "-o", "out.txt"}, 2, "should end in");
}

TEST_F(SliceCommand, ASphereIsCutInACircle) {
  const json written =
      made({"slice", "solid:sphere:40", "--plane", "0,1,0,0.25", "--view", "0,0,1"});
  const Scene scene = sceneFromJson(written.dump(), "out.json");
  ASSERT_EQ(scene.curves.size(), 1u);
  EXPECT_NEAR(scene.view.angleDeg, 90.0, 1e-12);
  const Curve& circle = scene.curves[0].shape;
  ASSERT_TRUE(isClosed(circle));
  // The tolerance, a thousandth of the diameter, and the facets: 160 round.
  constexpr double kOff = 2e-3 + 4e-4;
  const double end = pieceCount(circle);
  double turned = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Vec2 p = pointAt(circle, end * i / 200.0), q = pointAt(circle, end * (i + 1) / 200.0);
    EXPECT_NEAR(p.norm(), std::sqrt(1.0 - 0.25 * 0.25), kOff);
    turned += std::atan2(cross(p, q), p.dot(q));
  }
  // Once round, with the outside on the left.
  EXPECT_NEAR(turned, -2.0 * M_PI, 1e-6);
}

TEST_F(SliceCommand, ThePlaneHasASideAndAnyScale) {
  // z = 2 exp(-r^2 / 2) at z = 1: r = sqrt(2 ln 2). At z = -1 there is nothing.
  const double radius = std::sqrt(2.0 * std::log(2.0));
  for (const char* plane : {"0,0,1,1", "0,0,3,3", "0,0,-0.5,-0.5"}) {
    SCOPED_TRACE(plane);
    const Scene scene = sceneFromJson(
        made({"slice", "solid:gaussian-bump:80", "--plane", plane, "--view", "1,0,0.5"}).dump(),
        "out.json");
    ASSERT_EQ(scene.curves.size(), 1u);
    const double end = pieceCount(scene.curves[0].shape);
    for (int i = 0; i < 50; ++i) {
      EXPECT_NEAR(pointAt(scene.curves[0].shape, end * i / 50.0).norm(), radius, 0.012);
    }
  }
  fs::remove(folder_.path() / "out.json");
  expectRefused({"slice", "solid:gaussian-bump:80", "--plane", "0,0,1,-1", "-o", "out.json"}, 2,
                "the plane does not cut the mesh");
}

TEST_F(SliceCommand, TheReportHasTheMarksAndTheirAngles) {
  const std::vector<std::string> command{"slice",  "solid:sphere:40", "--plane", "0,1,0,0",
                                         "--view", "0,0,1",           "-o",      "out.json"};
  const ProgramResult result = run(command);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(result.out.find("1 curves, at most "), 0u) << result.out;
  // The circle's two silhouettes, at its left and right.
  std::vector<double> at;
  for (std::size_t i = result.out.find("silhouette"); i != std::string::npos;
       i = result.out.find("silhouette", i + 1)) {
    at.push_back(std::stod(result.out.substr(result.out.find(" x ", i) + 3)));
  }
  ASSERT_EQ(at.size(), 2u) << result.out;
  EXPECT_NEAR(std::max(at[0], at[1]), 1.0, 3e-3);
  EXPECT_NEAR(std::min(at[0], at[1]), -1.0, 3e-3);
  const std::string scene = contents("out.json");
  EXPECT_EQ(run(command).out, result.out);
  EXPECT_EQ(contents("out.json"), scene);
}

// A bar that is round along z: t_A is across it everywhere, so the plane through a place of it
// along the view and t_A is the plane across, and its section the circle.
TEST_F(SliceCommand, ThroughAPlaceAlongTheViewAndTheDirectionOfTheRidge) {
  const Scene scene = sceneFromJson(
      made({"slice", "solid:cylinder:60", "--through", "1,0,0.1", "--view", "2,1,0"}).dump(), "");
  ASSERT_EQ(scene.curves.size(), 1u);
  const Curve& circle = scene.curves[0].shape;
  EXPECT_TRUE(isClosed(circle));
  Vec2 low = pointAt(circle, 0.0), high = low;
  for (int i = 1; i < 200; ++i) {
    const Vec2 p = pointAt(circle, pieceCount(circle) * i / 200.0);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double diameter = high.x() - low.x();
  EXPECT_NEAR(high.y() - low.y(), diameter, 0.01);
  EXPECT_GT(diameter, 0.1);
}

TEST_F(SliceCommand, WhatCannotBeIsRefused) {
  const auto refused = [this](std::vector<std::string> arguments, int code,
                              const std::string& message) {
    arguments.insert(arguments.begin(), "slice");
    arguments.insert(arguments.end(), {"-o", "out.json"});
    expectRefused(arguments, code, message);
  };
  refused({"solid:torus:12"}, 2, "give either --plane or --through");
  refused({"solid:torus:12", "--plane", "1,0,0,0", "--through", "1,0,0"}, 2,
          "give either --plane or --through");
  refused({"solid:torus:12", "--plane", "0,0,0,1"}, 2, "the normal is 0,0,0");
  refused({"solid:torus:12", "--plane", "1,0,nan,1"}, 2, "--plane");
  refused({"solid:torus:12", "--plane", "1,0,0,inf"}, 2, "--plane");
  refused({"solid:torus:12", "--through", "nan,0,0"}, 2, "--through");
  refused({"solid:torus:12", "--plane", "1,0,0"}, 2, "--plane");
  refused({"solid:torus:12", "--plane", "1,0,0,9"}, 2, "does not cut the mesh");
  refused({"solid:torus:12", "--plane", "1,0,0,0", "--tolerance", "0"}, 2, "--tolerance");
  refused({"solid:torus:12", "--plain", "1,0,0,0"}, 2, "did you mean '--plane'?");
  for (const char* size : {"1e-300", "1e+200"}) {
    std::ofstream(folder_.path() / "far.obj")
        << "v 0 0 0\nv " << size << " 0 0\nv 0 " << size << " 0\nv 0 0 " << size
        << "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    refused({"far.obj", "--plane", "1,0,0,0"}, 1,
            std::string("far.obj: the longest side is ") + size);
  }
  refused({"none.obj", "--plane", "1,0,0,0"}, 1, "none.obj");
  refused({"solid:tours", "--plane", "1,0,0,0"}, 1, "no such solid");
  expectRefused({"slice", "solid:torus:12", "--plane", "1,0,0,0", "-o", "out.svg"}, 2, ".json");
  expectRefused({"slice", "solid:torus:12", "--plane", "1,0,0,0"}, 2, "--output is required");
}

TEST_F(BridgeAndSlice, HelpHasExamples) {
  for (const char* command : {"bridge", "slice"}) {
    const ProgramResult result = run({command, "--help"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_TRUE(result.err.empty());
    EXPECT_NE(result.out.find("Examples:\n  flatland " + std::string(command)), std::string::npos);
  }
}

}  // namespace
}  // namespace flatland::test
