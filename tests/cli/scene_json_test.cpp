// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/io/scene_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "flatland/io/read_text.h"
#include "tests/cli/scene_reading.h"
#include "tests/support/random_scene.h"
#include "tests/support/run_program.h"

namespace flatland::test {
namespace {

/// Bit for bit, so that -0.0 is not 0.0.
void expectSameBits(const Scene& a, const Scene& b) {
  ASSERT_EQ(a, b);
  for (std::size_t i = 0; i < a.curves.size(); ++i) {
    const auto& p = a.curves[i].chain().points();
    const auto& q = b.curves[i].chain().points();
    for (std::size_t j = 0; j < p.size(); ++j) {
      for (int k = 0; k < 2; ++k) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(p[j][k]), std::bit_cast<std::uint64_t>(q[j][k]));
      }
    }
  }
}

TEST(SceneJson, ReadsWhatTheFormatSays) {
  const Scene scene = read(R"({
    "flatland": 1,
    "curves": [
      {"bezier": [[0, 1], [2.5, -3], [1e3, 4]], "flipNormal": true},
      {"chain": {"degree": 2, "closed": true, "points": [[0, 0], [1, 0], [1, 1], [0, 1]]}},
      {"chain": {"degree": 1, "points": [[0, 0], [1, 0], [1, 1]]}}
    ],
    "view": {"angleDeg": -30.5, "distance": 7}
  })");
  ASSERT_EQ(scene.curves.size(), 3U);
  EXPECT_EQ(scene.curves[0].chain(), BezierChain(Bezier{{{0, 1}, {2.5, -3}, {1000, 4}}}));
  EXPECT_TRUE(scene.curves[0].flipNormal);
  EXPECT_EQ(scene.curves[1].chain(), BezierChain(2, true, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(scene.curves[1].flipNormal);
  EXPECT_EQ(scene.curves[2].chain(), BezierChain(1, false, {{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(scene.view, (View{-30.5, 7.0}));
}

TEST(SceneJson, ViewAndItsFieldsMayBeMissing) {
  EXPECT_EQ(read(kSmallScene).view, (View{0.0, std::nullopt}));
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{}})").view, View{});
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{"angleDeg":5}})").view, (View{5.0, {}}));
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{"distance":null}})").view, View{});
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{"distance":2}})").view, (View{0.0, 2.0}));
}

TEST(SceneJson, AcceptsAByteOrderMark) {
  EXPECT_EQ(read(std::string("\xEF\xBB\xBF") + kSmallScene), read(kSmallScene));
}

TEST(SceneJson, AClosedChainMayRepeatItsFirstPoint) {
  const std::string start =
      R"({"flatland":1,"curves":[{"chain":{"degree":2,"closed":true,"points":)";
  const Scene once = read(start + "[[0,0],[1,0],[1,1],[0,1]]}}]}");
  const Scene twice = read(start + "[[0,0],[1,0],[1,1],[0,1],[0,0]]}}]}");
  EXPECT_EQ(once, twice);
  EXPECT_EQ(once.curves[0].chain().points().size(), 4U);
  EXPECT_THROW(read(start + "[[0,0],[1,0],[1,1],[0,1],[0,0.5]]}}]}"), InputError);
}

TEST(SceneJson, EveryScenesBitsSurvive) {
  Random random(announcedSeed("scene round trip", 20070501));
  for (int i = 0; i < 2000; ++i) {
    const Scene scene = anyScene(random);
    expectSameBits(scene, read(sceneToJson(scene)));
  }
}

TEST(SceneJson, ExtremeNumbersSurvive) {
  using Limits = std::numeric_limits<double>;
  const Scene scene{{{BezierChain(Bezier{{{1e50, Limits::min()},
                                          {Limits::denorm_min(), -0.0},
                                          {0.1, 1.0 / 3.0},
                                          {9007199254740993.0, 1e22}}})}},
                    {Limits::lowest(), Limits::denorm_min()}};
  expectSameBits(scene, read(sceneToJson(scene)));
}

TEST(SceneJson, IsWrittenForPeople) {
  const Scene scene{{{BezierChain(Bezier{{{0, 1}, {2.5, -3}}}), true},
                     {BezierChain(1, true, {{0, 0}, {1, 0}, {1, 1}})}},
                    {90, 4.0}};
  EXPECT_EQ(sceneToJson(scene), R"({
  "flatland": 1,
  "curves": [
    {
      "bezier": [
        [0, 1],
        [2.5, -3]
      ],
      "flipNormal": true
    },
    {
      "chain": {
        "degree": 1,
        "closed": true,
        "points": [
          [0, 0],
          [1, 0],
          [1, 1]
        ]
      }
    }
  ],
  "view": {"angleDeg": 90, "distance": 4}
}
)");
}

TEST(SceneJson, RefusesToWriteWhatItCouldNotRead) {
  Scene scene = read(kSmallScene);
  scene.curves[0].chain().setPoint(1, {0.0, std::nan("")});
  try {
    sceneToJson(scene);
    FAIL() << "wrote a NaN";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), "curves[0].bezier[1][1]");
  }
  scene.curves[0].chain().setPoint(1, {-1.01e50, 0.0});
  EXPECT_THROW(sceneToJson(scene), InputError);
  scene = {{{BezierChain(Bezier{std::vector<Vec2>(66, Vec2(1, 2))})}}, {}};
  EXPECT_THROW(sceneToJson(scene), InputError);
  scene = {{{BezierChain(Bezier{std::vector<Vec2>(65, Vec2(1, 2))})}}, {}};
  expectSameBits(scene, read(sceneToJson(scene)));
}

struct BadScene {
  const char* name;
  std::string text;
  std::string place;
  std::string reason;  // a part of it
};

class SceneJsonErrors : public testing::TestWithParam<BadScene> {};

TEST_P(SceneJsonErrors, NamePlaceAndReason) {
  const BadScene& bad = GetParam();
  try {
    read(bad.text);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.place(), bad.place);
    EXPECT_NE(error.reason().find(bad.reason), std::string::npos) << error.reason();
    const std::string what = error.what();
    EXPECT_EQ(what, "a.json: " + (bad.place.empty() ? "" : bad.place + ": ") + error.reason());
    EXPECT_EQ(what.find('\n'), std::string::npos) << "one line";
  }
}

std::string scene(const std::string& curves) {
  return R"({"flatland": 1, "curves": [)" + curves + "]}";
}
std::string chain(const std::string& body) { return scene(R"({"chain": {)" + body + "}}"); }
std::string view(const std::string& body) {
  return R"({"flatland": 1, "curves": [], "view": )" + body + "}";
}
std::string listOf(int points) {
  std::string list = "[";
  for (int i = 0; i < points; ++i) list += (i == 0 ? "[" : ",[") + std::to_string(i) + ",0]";
  return list + "]";
}

INSTANTIATE_TEST_SUITE_P(
    All, SceneJsonErrors,
    testing::Values(
        // Not JSON.
        BadScene{"empty", "", "", "empty"}, BadScene{"blank", " \n\t\r\n", "", "empty"},
        BadScene{"onlyMark", "\xEF\xBB\xBF", "", "empty"},
        BadScene{"syntax", "{\n  \"flatland\": 1,\n  curves\n}", "line 3, column 3",
                 "not valid JSON"},
        BadScene{"cutOff", "{\"flatland\": 1", "line 1, column 15", "unexpected end"},
        BadScene{"columnsAreCharacters", "{\"flatl\u00e4nd\": x}", "line 1, column 14",
                 "not valid JSON"},
        BadScene{"afterMark", "\xEF\xBB\xBF?", "line 1, column 1", "not valid JSON"},
        BadScene{"trailingGarbage", std::string(kSmallScene) + "\n x", "line 2, column 2",
                 "expected end of input"},
        BadScene{"secondValue", std::string(kSmallScene) + "{}", "line 1, column 61",
                 "expected end of input"},
        BadScene{"nan", scene(R"({"bezier": [[0, NaN], [1, 1]]})"), "line 1, column 44",
                 "not valid JSON"},
        BadScene{"tooLargeNumber", scene(R"({"bezier": [[0, 1e400], [1, 1]]})"),
                 "line 1, column 48", "number '1e400' is too large"},
        BadScene{"latin1", "{\n\"\xE4\": 1}", "line 2, column 2", "not UTF-8"},
        BadScene{"utf16", std::string("\xFF\xFE{\0", 4), "line 1, column 1", "not UTF-8"},
        BadScene{"overlongUtf8", "{\"\xC0\xAF\": 1}", "line 1, column 3", "not UTF-8"},
        BadScene{"surrogate", "{\"\xED\xA0\x80\": 1}", "line 1, column 3", "not UTF-8"},
        BadScene{"cutUtf8", "{\"\xE2\x82", "line 1, column 3", "not UTF-8"},
        BadScene{"deep", std::string(100000, '['), "[0][0][0][0][0][0][0][0][0][0][0][0][0][0][0]",
                 "nested deeper than 16"},
        BadScene{"keyTwice", R"({"flatland": 1, "curves": [], "curves": []})", "top level",
                 "the key \"curves\" is there twice"},
        BadScene{"innerKeyTwice", scene(R"({}, {"chain": {"degree": 1, "degree": 2}})"),
                 "curves[1].chain", "the key \"degree\" is there twice"},
        BadScene{"newlineInKey", "{\"flatland\":1,\"curves\":[],\"a\\nb\":1}", "top level",
                 "unknown key \"a\\nb\""},
        // Not a scene.
        BadScene{"list", "[]", "top level", "expected an object, found a list"},
        BadScene{"noVersion", R"({"curves": []})", "top level", "missing \"flatland\": 1"},
        BadScene{"newer", R"({"flatland": 5, "curves": []})", "flatland",
                 "version 5 was made by a newer Flatland; this one reads up to version 4"},
        BadScene{"newerWithNewKeys", R"({"flatland": 5, "shapes": []})", "flatland", "newer"},
        BadScene{"zeroVersion", R"({"flatland": 0, "curves": []})", "flatland",
                 "expected version 1 to 4, found 0"},
        BadScene{"halfVersion", R"({"flatland": 1.5, "curves": []})", "flatland",
                 "expected a whole number, found 1.5"},
        BadScene{"wordVersion", R"({"flatland": "1", "curves": []})", "flatland",
                 "expected a number, found a string"},
        BadScene{"unknownKey", R"({"flatland": 1, "curve": []})", "top level",
                 "unknown key \"curve\"; known here: flatland, curves, view"},
        BadScene{"noCurves", R"({"flatland": 1})", "top level", "missing \"curves\""},
        BadScene{"curvesNull", R"({"flatland": 1, "curves": null})", "curves",
                 "expected a list of curves, found null"},
        BadScene{"curveNumber", scene("7"), "curves[0]", "expected an object, found a number"},
        BadScene{"curveEmpty", scene("{}"), "curves[0]", "missing \"bezier\" or \"chain\""},
        BadScene{"curveBoth",
                 scene(R"({"bezier": [[0,0],[1,1]], "chain": {"degree": 1, "points": []}})"),
                 "curves[0]", "both \"bezier\" and \"chain\""},
        BadScene{"curveKey", scene(R"({"bezier": [[0,0],[1,1]], "colour": "red"})"), "curves[0]",
                 "unknown key \"colour\"; known here: bezier, chain, flipNormal"},
        BadScene{"flipNumber", scene(R"({"bezier": [[0,0],[1,1]], "flipNormal": 1})"),
                 "curves[0].flipNormal", "expected true or false, found a number"},
        BadScene{"bezierObject", scene(R"({"bezier": {}})"), "curves[0].bezier",
                 "expected a list of points [x, y], found an object"},
        BadScene{"bezierEmpty", scene(R"({"bezier": []})"), "curves[0].bezier",
                 "at least 2 points, found 0"},
        BadScene{"bezierOne", scene(R"({"bezier": [[1, 2]]})"), "curves[0].bezier",
                 "at least 2 points, found 1"},
        BadScene{"bezierHigh", scene(R"({"bezier": )" + listOf(66) + "}"), "curves[0].bezier",
                 "degree 65 is above 64"},
        BadScene{"pointNumber", scene(R"({"bezier": [[0, 0], 5]})"), "curves[0].bezier[1]",
                 "expected a point [x, y], found a number"},
        BadScene{"pointThree", scene(R"({"bezier": [[0, 0], [1, 2, 3]]})"), "curves[0].bezier[1]",
                 "expected 2 numbers [x, y], found 3"},
        BadScene{"coordinateString", scene(R"({"bezier": [[0, 0], [1, 1], [2, "3"]]})"),
                 "curves[0].bezier[2][1]", "expected a number, found a string"},
        BadScene{"coordinateNull", scene(R"({"bezier": [[0, 0], [null, 1]]})"),
                 "curves[0].bezier[1][0]", "expected a number, found null"},
        BadScene{"coordinateTrue", scene(R"({"bezier": [[0, true], [0, 1]]})"),
                 "curves[0].bezier[0][1]", "expected a number, found true"},
        BadScene{"coordinateHuge", scene(R"({"bezier": [[0, 0], [0, -1.01e50]]})"),
                 "curves[0].bezier[1][1]", "-1.01e+50 is beyond 1e+50"},
        BadScene{"distanceHuge", view(R"({"distance": 1e51})"), "view.distance",
                 "1e+51 is beyond 1e+50"},
        BadScene{"chainNoDegree", chain(R"("points": [[0,0],[1,1]])"), "curves[0].chain",
                 "missing \"degree\""},
        BadScene{"chainNoPoints", chain(R"("degree": 3)"), "curves[0].chain", "missing \"points\""},
        BadScene{"chainDegreeZero", chain(R"("degree": 0, "points": [[0,0],[1,1]])"),
                 "curves[0].chain.degree", "at least 1, found 0"},
        BadScene{"chainDegreeHigh", chain(R"("degree": 65, "points": [[0,0],[1,1]])"),
                 "curves[0].chain.degree", "degree 65 is above 64"},
        BadScene{"chainDegreeHuge", chain(R"("degree": 1e300, "points": [[0,0],[1,1]])"),
                 "curves[0].chain.degree", "whole number"},
        BadScene{"chainCount", chain(R"("degree": 3, "points": )" + listOf(5)),
                 "curves[0].chain.points", "degree 3 with 5 points: an open chain"},
        BadScene{"chainNone", chain(R"("degree": 3, "points": [])"), "curves[0].chain.points",
                 "degree 3 with 0 points"},
        BadScene{"closedCount", chain(R"("degree": 3, "closed": true, "points": )" + listOf(7)),
                 "curves[0].chain.points", "degree 3 with 7 points: a closed chain"},
        BadScene{"closedWord", chain(R"("degree": 1, "closed": "yes", "points": [[0,0],[1,1]])"),
                 "curves[0].chain.closed", "expected true or false, found a string"},
        BadScene{"chainKey", chain(R"("degree": 1, "weights": [], "points": [[0,0],[1,1]])"),
                 "curves[0].chain", "unknown key \"weights\"; known here: degree, closed, points"},
        BadScene{"viewNull", view("null"), "view", "expected an object, found null"},
        BadScene{"viewKey", view(R"({"angle": 1})"), "view",
                 "unknown key \"angle\"; known here: angleDeg, distance"},
        BadScene{"viewAngle", view(R"({"angleDeg": "east"})"), "view.angleDeg",
                 "expected a number, found a string"},
        BadScene{"distanceZero", view(R"({"distance": 0})"), "view.distance",
                 "expected a distance above 0, found 0"},
        BadScene{"distanceNegative", view(R"({"distance": -2.5})"), "view.distance",
                 "expected a distance above 0, found -2.5"},
        BadScene{"distanceWord", view(R"({"distance": "far"})"), "view.distance",
                 "expected a number or null, found a string"}),
    [](const testing::TestParamInfo<BadScene>& bad) { return std::string(bad.param.name); });

TEST(SceneJson, EveryCutIsReported) {
  std::string text =
      "{\"flatland\": 1, \"curves\": [{\"chain\": {\"degree\": 1, \"closed\": true, "
      "\"points\": [[0, -1.5e3], [1, 2], [3, 4]]}, \"flipNormal\": false}], "
      "\"view\": {\"angleDeg\": 90, \"distance\": null}}";
  ASSERT_NO_THROW(read(text));
  for (std::size_t length = 0; length < text.size(); ++length) {
    try {
      read(text.substr(0, length));
      ADD_FAILURE() << "accepted the first " << length << " bytes";
    } catch (const InputError& error) {
      EXPECT_FALSE(error.reason().empty());
      if (length > 0) {
        EXPECT_EQ(error.place(), "line 1, column " + std::to_string(length + 1));
      }
    }
  }
}

TEST(SceneJson, NoChangedByteDoesMoreThanBeReported) {
  const std::string text = sceneToJson(defaultScene());
  int refused = 0;
  int accepted = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'\0', '\n', '"', '[', '}', ',', '9', 'e', '-', '\x80', '\xFF'}) {
      std::string changed = text;
      changed[i] = c;
      try {
        read(changed);
        ++accepted;
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, accepted) << "most bytes matter";
  EXPECT_GT(accepted, 0) << "digits may change";
}

TEST(SceneJson, TooLargeATextIsRefusedUnread) {
  const std::string text(kLargestSceneBytes + 1, ' ');
  try {
    read(text);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(error.reason().find("64 MiB"), std::string::npos) << error.reason();
  }
}

TEST(SceneFile, SavesAndLoads) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "scene.json";
  saveScene(defaultScene(), file);
  EXPECT_EQ(loadScene(file), defaultScene());
  EXPECT_EQ(contentsOf(file), sceneToJson(defaultScene()));
  EXPECT_EQ(folder.count(), 1U);
}

TEST(SceneFile, ErrorsNameTheFile) {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "none.json";
  try {
    loadScene(missing);
    FAIL() << "loaded";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              missing.string() + ": cannot be read: No such file or directory");
  }
  try {
    loadScene(folder.path());
    FAIL() << "loaded";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              folder.path().string() + ": cannot be read: Is a directory");
  }
}

TEST(SceneFile, ABadSceneLeavesTheOldFile) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "scene.json";
  saveScene(defaultScene(), file);
  Scene bad = defaultScene();
  bad.view.angleDeg = std::numeric_limits<double>::infinity();
  EXPECT_THROW(saveScene(bad, file), InputError);
  EXPECT_EQ(loadScene(file), defaultScene());
}

}  // namespace
}  // namespace flatland::test
