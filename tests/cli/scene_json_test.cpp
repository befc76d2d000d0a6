// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatland/io/scene_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "flatland/io/read_text.h"
#include "tests/support/random_scene.h"
#include "tests/support/run_program.h"

namespace flatland {
namespace {

using test::contentsOf;
using test::TemporaryFolder;

constexpr const char* kSmall = R"({"flatland": 1, "curves": [{"bezier": [[0, 1], [2.5, -3]]}]})";

Scene read(const std::string& text) { return sceneFromJson(text, "a.json"); }

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
  EXPECT_EQ(read(kSmall).view, (View{0.0, std::nullopt}));
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{}})").view, View{});
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{"angleDeg":5}})").view, (View{5.0, {}}));
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{"distance":null}})").view, View{});
  EXPECT_EQ(read(R"({"flatland":1,"curves":[],"view":{"distance":2}})").view, (View{0.0, 2.0}));
}

TEST(SceneJson, AcceptsAByteOrderMark) {
  EXPECT_EQ(read(std::string("\xEF\xBB\xBF") + kSmall), read(kSmall));
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
  test::Random random(test::announcedSeed("scene round trip", 20070501));
  for (int i = 0; i < 2000; ++i) {
    const Scene scene = test::anyScene(random);
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
  Scene scene = read(kSmall);
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
        BadScene{"trailingGarbage", std::string(kSmall) + "\n x", "line 2, column 2",
                 "expected end of input"},
        BadScene{"secondValue", std::string(kSmall) + "{}", "line 1, column 61",
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

/// A scene of version 2 with one curve.
std::string newer(const std::string& curve) {
  return R"({"flatland": 2, "curves": [)" + curve + "]}";
}

constexpr const char* kEveryNewKind[] = {
    R"j({"bspline": {"degree": 3, "closed": false, "points": [[0,0],[1,0],[1,1],[0,1],[2,2]],
         "knots": [0, 0, 0.5, 1, 2, 2.5, 3, 3, 4]}, "flipNormal": true})j",
    R"j({"bspline": {"degree": 2, "closed": true, "points": [[0,0],[1,0],[1,1],[0,1]]}})j",
    R"j({"rational": {"points": [[1,0],[1,1],[0,1]], "weights": [1, 0.7071067811865476, 1]}})j",
    R"j({"rational": {"degree": 2, "closed": true, "points": [[1,0],[1,1],[0,1],[-1,-1]],
         "weights": [1, 2, 3, 4]}})j",
    R"j({"family": {"name": "ellipse", "parameters": {"a": 1, "b": 1.4}}})j",
    R"j({"family": {"name": "cycloid", "parameters": {"r": 1, "d": 0, "n": 2}, "at": [0.1, -2]}})j",
    R"j({"formula": {"x": "cos(t)", "y": "a*sin(2*t)", "from": 0, "to": "2*pi",
         "constants": {"a": 0.1}}})j",
    R"j({"formula": {"x": "t", "y": "1e3", "from": -1.5, "to": 1e-7, "at": [1, 2]}})j",
};

TEST(SceneJson, EveryNewKindSurvives) {
  for (const char* curve : kEveryNewKind) {
    const Scene scene = read(newer(curve));
    const std::string text = sceneToJson(scene);
    EXPECT_EQ(read(text), scene) << text;
    EXPECT_EQ(sceneToJson(read(text)), text);
    EXPECT_NE(text.find("\"flatland\": 2"), std::string::npos);
  }
  const Scene spline = read(newer(kEveryNewKind[0]));
  EXPECT_TRUE(spline.curves[0].flipNormal);
  EXPECT_EQ(std::get<BSpline>(spline.curves[0].shape).knots()[2], 0.5);
  const Scene ellipse = read(newer(kEveryNewKind[4]));
  EXPECT_EQ(std::get<FormulaCurve>(ellipse.curves[0].shape).family()->parameters,
            (std::vector<double>{1.0, 1.4}));
}

TEST(SceneJson, IsOfVersion1UnlessItNeedsMore) {
  EXPECT_EQ(sceneToJson(read(newer(R"({"bezier": [[0, 1], [2.5, -3]]})"))),
            sceneToJson(read(kSmall)));
}

/// A scene of version 3 whose surface has these keys beside the mesh.
std::string surface(const std::string& keys) {
  return R"({"flatland": 3, "curves": [], "surface": {"mesh": "solid:torus")" + keys + "}}";
}

SurfaceSetting anySurface() {
  SurfaceSetting setting;
  setting.mesh = "solid:torus";
  setting.camera.towards = Eigen::Vector3d(1.0, 2.0, -3.0).normalized();
  setting.camera.up = {0.1, 1.0, 0.0};
  setting.camera.centre = {0.1, -0.2, 1.0 / 3.0};
  setting.camera.zoom = 2.5;
  setting.camera.perspectiveDeg = 40.0;
  setting.savedCameras = {{"Side \"A\"", {}}, {"other", setting.camera}};
  setting.families = {{"apparent-ridges", true, 0.7, "#d55e00", 2.2, false},
                      {"valleys", false, 1.0 / 7.0, "", 1.0, true}};
  setting.style = "colours";
  setting.quantity = "offset";
  setting.hidden = "dashed";
  setting.unfiltered = true;
  setting.isophotes = 7;
  setting.heights = 31;
  setting.fitScale = 1.75;
  return setting;
}

TEST(SceneJson, ASurfaceSurvives) {
  Scene scene = read(kSmall);
  scene.surface = anySurface();
  const std::string text = sceneToJson(scene);
  EXPECT_NE(text.find("\"flatland\": 3"), std::string::npos) << text;
  EXPECT_EQ(read(text), scene) << text;
  EXPECT_EQ(sceneToJson(read(text)), text);
  scene.surface = SurfaceSetting{};
  scene.surface->mesh = "solid:sphere";
  EXPECT_EQ(read(sceneToJson(scene)), scene);
  EXPECT_EQ(read(surface("")).surface->style, SurfaceSetting{}.style);
}

// What is usual for a family is known above; 0 would be another threshold.
TEST(SceneJson, AFamilyNeedNotSayMoreThanItsName) {
  const Scene scene = read(surface(R"(, "families": [{"name": "creases"}])"));
  const SurfaceFamily& family = scene.surface->families.at(0);
  EXPECT_FALSE(family.threshold);
  EXPECT_TRUE(family.on && family.fade && family.colour.empty() && family.widthPx == 1.6);
  EXPECT_EQ(read(sceneToJson(scene)), scene);
  const Scene zero = read(surface(R"(, "families": [{"name": "creases", "threshold": 0}])"));
  EXPECT_EQ(zero.surface->families.at(0).threshold, 0.0);
  EXPECT_EQ(read(sceneToJson(zero)), zero);
}

TEST(SceneJson, FurtherViewsSweptSurfaceAndPlaneSurvive) {
  Scene scene = read(kSmall);
  scene.surface = anySurface();
  using Names = std::vector<std::string>;
  SurfacePane elsewhere{Names{"valleys", "contours"}, "one-ring", "difference", SurfaceCamera{}};
  elsewhere.camera->zoom = 1.0 / 3.0;
  // No families are something else than those of the first view.
  scene.surface->panes = {elsewhere, {Names{}}, {}};
  scene.surface->upAxis = "-z";
  scene.surface->ink = 0.03;
  scene.surface->mesh = kSweptMesh;
  scene.surface->swept = SweptSetting{"revolution", 3, -0.1, 17};
  scene.surface->plane =
      SurfacePlane{{0.1, 0.2, 0.3}, Eigen::Vector3d(1.0, -2.0, 3.0).normalized()};
  const std::string text = sceneToJson(scene);
  EXPECT_NE(text.find("\"flatland\": 4"), std::string::npos) << text;
  EXPECT_EQ(read(text), scene) << text;
  EXPECT_EQ(sceneToJson(read(text)), text);

  const test::TemporaryFolder folder;
  saveScene(scene, folder.path() / "scene.json");
  EXPECT_EQ(loadScene(folder.path() / "scene.json"), scene);
}

TEST(SceneJson, TheMeshGoesWithTheSceneFile) {
  const test::TemporaryFolder folder;
  Scene scene = read(kSmall);
  scene.surface = SurfaceSetting{};
  scene.surface->mesh = (folder.path() / "meshes" / "cow.obj").string();
  const std::filesystem::path file = folder.path() / "scene.json";
  saveScene(scene, file);
  EXPECT_EQ(read(readFile(file, 1 << 20)).surface->mesh, "meshes/cow.obj");
  EXPECT_EQ(loadScene(file).surface->mesh, scene.surface->mesh);
  scene.surface->mesh = "solid:torus";
  saveScene(scene, file);
  EXPECT_EQ(loadScene(file).surface->mesh, "solid:torus");
}

TEST(SceneJson, SaysWhatIsWrongWithASurface) {
  const struct {
    std::string text, place, reason;
  } cases[] = {
      {R"({"flatland": 2, "curves": [], "surface": {"mesh": "a.ply"}})", "surface",
       "came with version 3"},
      {R"({"flatland": 3, "curves": [], "surface": {}})", "surface", "missing \"mesh\""},
      {R"({"flatland": 3, "curves": [], "surface": {"mesh": ""}})", "surface.mesh",
       "expected a file"},
      {surface(R"(, "colour": 1)"), "surface", "unknown key \"colour\""},
      {surface(R"(, "camera": {"zoom": 0})"), "surface.camera.zoom", "above 0"},
      {surface(R"(, "camera": {"towards": [0, 0, 0]})"), "surface.camera.towards", "direction"},
      {surface(R"(, "camera": {"towards": [0, 2, 0]})"), "surface.camera", "lies along"},
      {surface(R"(, "camera": {"towards": [1, 2]})"), "surface.camera.towards", "three numbers"},
      {surface(R"(, "camera": {"perspectiveDeg": 179.5})"), "surface.camera.perspectiveDeg",
       "from 0.1 to 179"},
      {surface(R"(, "camera": {"perspectiveDeg": 0})"), "surface.camera.perspectiveDeg",
       "from 0.1 to 179"},
      {surface(R"(, "families": [{"name": "a", "threshold": -1}])"),
       "surface.families[0].threshold", "0 or above"},
      {surface(R"(, "families": [{"name": "a"}, {"name": "a"}])"), "surface.families[1]",
       "of this name"},
      {surface(R"(, "families": [{"name": "a", "colour": "red"}])"), "surface.families[0].colour",
       "a colour like"},
      {surface(R"(, "families": [{"name": "a", "widthPx": 0}])"), "surface.families[0].widthPx",
       "above 0"},
      {surface(R"(, "isophotes": 0)"), "surface.isophotes", "1 to 1000"},
      {surface(R"(, "ink": 0.1)"), "surface", "came with version 4"},
      {surface(R"(, "ink": 1.1)"), "surface.ink", "at most 1"},
      {surface(R"(, "upAxis": "z")"), "surface", "came with version 4"},
      {surface(R"(, "upAxis": "w")"), "surface.upAxis", "x, -x, y, -y, z or -z"},
      {surface(R"(, "panes": [{}, {}, {}, {}])"), "surface.panes", "more than 3"},
      {surface(R"(, "plane": {"point": [0, 0, 0], "normal": [0, 0, 0]})"), "surface.plane.normal",
       "a direction"},
      {surface(R"(, "swept": {"kind": "extrusion", "amount": 1})"), "surface", "belong together"},
      {surface(R"(, "swept": {"kind": "loft", "amount": 1})"), "surface.swept.kind",
       "extrusion or revolution"},
      {surface(R"(, "swept": {"kind": "extrusion", "amount": 0})"), "surface.swept.amount",
       "above 0"},
      {surface(R"(, "swept": {"kind": "extrusion", "amount": 1, "cells": 2})"),
       "surface.swept.cells", "3 to 1000"},
      {surface(R"(, "fitScale": 0.5)"), "surface.fitScale", "at least 1"},
  };
  for (const auto& one : cases) {
    try {
      read(one.text);
      ADD_FAILURE() << "read " << one.text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), one.place) << one.text;
      EXPECT_NE(std::string(error.what()).find(one.reason), std::string::npos) << error.what();
    }
  }
}

TEST(SceneJson, SaysWhatIsWrongWithANewKind) {
  const auto expectError = [](const std::string& text, const std::string& place,
                              const std::string& reason) {
    try {
      read(text);
      ADD_FAILURE() << "read " << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.place(), place) << text;
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  };
  expectError(R"({"flatland": 1, "curves": [{"family": {}}]})", "curves[0]",
              "came with version 2; write \"flatland\": 2");
  expectError(newer("{}"), "curves[0]", "missing \"bezier\"");
  expectError(newer(R"({"bspline": {"points": []}})"), "curves[0].bspline", "missing \"degree\"");
  expectError(newer(R"({"bspline": {"degree": 17, "points": []}})"), "curves[0].bspline.degree",
              "above 16");
  expectError(newer(R"({"bspline": {"degree": 2, "points": [[0,0],[1,1]]}})"), "curves[0].bspline",
              "at least 3 points, found 2");
  expectError(newer(R"({"bspline": {"degree": 1, "points": [[0,0],[1,1]], "knots": [0,0,1]}})"),
              "curves[0].bspline", "expected 4 knots");
  expectError(newer(R"({"rational": {"points": [[0,0],[1,1]], "weights": [1, 0]}})"),
              "curves[0].rational", "weight 1 is not above 0");
  expectError(newer(R"({"rational": {"points": [[0,0],[1,1]], "weights": [1]}})"),
              "curves[0].rational", "expected 2 weights");
  expectError(newer(R"({"rational": {"closed": true, "points": [], "weights": []}})"),
              "curves[0].rational", "missing \"degree\"");
  expectError(newer(R"({"family": {"name": "oval", "parameters": {}}})"), "curves[0].family.name",
              "known: circle, ellipse");
  expectError(newer(R"({"family": {"name": "circle", "parameters": {}}})"),
              "curves[0].family.parameters", "missing \"r\"");
  expectError(newer(R"({"family": {"name": "circle", "parameters": {"r": 1, "b": 1}}})"),
              "curves[0].family.parameters", "known here: r");
  expectError(newer(R"({"family": {"name": "circle", "parameters": {"r": 0}}})"),
              "curves[0].family.parameters", "r must be from");
  expectError(newer(R"({"formula": {"x": "t", "y": "2 t", "from": 0, "to": 1}})"),
              "curves[0].formula.y", "column 3: ");
  expectError(newer(R"({"formula": {"x": "1/t", "y": "t", "from": 0, "to": 1}})"),
              "curves[0].formula.x", "at t = 0");
  expectError(newer(R"({"formula": {"x": "t", "y": "t", "from": 0, "to": true}})"),
              "curves[0].formula.to", "expected a number or a string");
  expectError(
      newer(R"({"formula": {"x": "t", "y": "t", "from": 0, "to": 1, "constants": {"t": 1}}})"),
      "curves[0].formula.constants", "taken");
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
}  // namespace flatland
