// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of curves that came with version 2 of scene files.
#include "tests/cli/scene_reading.h"

namespace flatland::test {
namespace {

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

TEST(CurveJson, EveryNewKindSurvives) {
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

TEST(CurveJson, IsOfVersion1UnlessItNeedsMore) {
  EXPECT_EQ(sceneToJson(read(newer(R"({"bezier": [[0, 1], [2.5, -3]]})"))),
            sceneToJson(read(kSmallScene)));
}

TEST(CurveJson, SaysWhatIsWrongWithANewKind) {
  expectRefused(R"({"flatland": 1, "curves": [{"family": {}}]})", "curves[0]",
                "came with version 2; write \"flatland\": 2");
  expectRefused(newer("{}"), "curves[0]", "missing \"bezier\"");
  expectRefused(newer(R"({"bspline": {"points": []}})"), "curves[0].bspline", "missing \"degree\"");
  expectRefused(newer(R"({"bspline": {"degree": 17, "points": []}})"), "curves[0].bspline.degree",
                "above 16");
  expectRefused(newer(R"({"bspline": {"degree": 2, "points": [[0,0],[1,1]]}})"),
                "curves[0].bspline", "at least 3 points, found 2");
  expectRefused(newer(R"({"bspline": {"degree": 1, "points": [[0,0],[1,1]], "knots": [0,0,1]}})"),
                "curves[0].bspline", "expected 4 knots");
  expectRefused(newer(R"({"rational": {"points": [[0,0],[1,1]], "weights": [1, 0]}})"),
                "curves[0].rational", "weight 1 is not above 0");
  expectRefused(newer(R"({"rational": {"points": [[0,0],[1,1]], "weights": [1]}})"),
                "curves[0].rational", "expected 2 weights");
  expectRefused(newer(R"({"rational": {"closed": true, "points": [], "weights": []}})"),
                "curves[0].rational", "missing \"degree\"");
  expectRefused(newer(R"({"family": {"name": "oval", "parameters": {}}})"), "curves[0].family.name",
                "known: circle, ellipse");
  expectRefused(newer(R"({"family": {"name": "circle", "parameters": {}}})"),
                "curves[0].family.parameters", "missing \"r\"");
  expectRefused(newer(R"({"family": {"name": "circle", "parameters": {"r": 1, "b": 1}}})"),
                "curves[0].family.parameters", "known here: r");
  expectRefused(newer(R"({"family": {"name": "circle", "parameters": {"r": 0}}})"),
                "curves[0].family.parameters", "r must be from");
  expectRefused(newer(R"({"formula": {"x": "t", "y": "2 t", "from": 0, "to": 1}})"),
                "curves[0].formula.y", "column 3: ");
  expectRefused(newer(R"({"formula": {"x": "1/t", "y": "t", "from": 0, "to": 1}})"),
                "curves[0].formula.x", "at t = 0");
  expectRefused(newer(R"({"formula": {"x": "t", "y": "t", "from": 0, "to": true}})"),
                "curves[0].formula.to", "expected a number or a string");
  expectRefused(
      newer(R"({"formula": {"x": "t", "y": "t", "from": 0, "to": 1, "constants": {"t": 1}}})"),
      "curves[0].formula.constants", "taken");
}

}  // namespace
}  // namespace flatland::test
