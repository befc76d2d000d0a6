// SPDX-License-Identifier: GPL-3.0-or-later
// SVG files: elements, transforms, what is left out, limits.
#include "flatland/io/svg_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "flatland/features/features.h"
#include "flatland/io/input_error.h"
#include "flatland/io/number_text.h"

namespace flatland {
namespace {

constexpr SvgOptions kKeepSize{.comfortable = false};

std::string drawing(const std::string& content, const std::string& attributes = {}) {
  return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " +
         attributes + ">" + content + "</svg>";
}

/// The page is 100 units high unless the attributes say otherwise, so y up is 100 - y.
ImportedScene read(const std::string& content,
                   const std::string& attributes = "width='100' height='100'",
                   const SvgOptions& options = kKeepSize) {
  return sceneFromSvg(drawing(content, attributes), "a.svg", options);
}

void expectPoints(const ImportedScene& imported, std::size_t curve, std::vector<Vec2> expected,
                  double tolerance = 1e-12) {
  ASSERT_LT(curve, imported.scene.curves.size());
  const std::vector<Vec2>& points = imported.scene.curves[curve].chain().points();
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((points[i] - expected[i]).norm(), tolerance)
        << i << ": " << points[i].transpose() << " instead of " << expected[i].transpose();
  }
}

std::string whyRefused(const std::string& text) {
  try {
    sceneFromSvg(text, "a.svg");
  } catch (const InputError& error) {
    return error.what();
  }
  return "was read";
}
void expectRefused(const std::string& content, const std::string& part) {
  const std::string why = whyRefused(drawing(content));
  EXPECT_NE(why.find(part), std::string::npos) << why;
  EXPECT_EQ(why.find('\n'), std::string::npos) << why;
}

TEST(SvgFile, YIsTurnedUp) {
  expectPoints(read("<path d='M10 20L30 20L30 60'/>"), 0, {{10, 80}, {30, 80}, {30, 40}},
               0.0 + 1e-15);
}

TEST(SvgFile, EveryTransform) {
  const double h = std::sqrt(0.5), t = std::tan(std::numbers::pi / 6);
  const std::vector<std::pair<std::string, Vec2>> cases{
      // Where (10, 20) goes, y down.
      {"translate(3)", {13, 20}},
      {"translate(3,-4)", {13, 16}},
      {"scale(2)", {20, 40}},
      {"scale(2 .5)", {20, 10}},
      {"rotate(90)", {-20, 10}},
      {"rotate(45)", {-10 * h, 30 * h}},
      {"rotate(90 10 0)", {-10, 0}},
      {"rotate(-90,10,0)", {30, 0}},
      {"skewX(30)", {10 + 20 * t, 20}},
      {"skewY(30)", {10, 20 + 10 * t}},
      {"matrix(1 2 3 4 5 6)", {10 + 60 + 5, 20 + 80 + 6}},
      {"translate(3) scale(2)", {23, 40}},
      {"scale(2),translate(3)", {26, 40}},
      {" translate( 1 , 2 )\n,scale(2) rotate(90) ", {-39, 22}},
      {"none", {10, 20}},
      {"", {10, 20}},
  };
  for (const auto& [transform, expected] : cases) {
    const ImportedScene imported =
        read("<line transform='" + transform + "' x1='10' y1='20' x2='0' y2='0'/>");
    const Vec2 at = imported.scene.curves.at(0).chain().points()[0];
    EXPECT_LT((at - Vec2(expected.x(), 100 - expected.y())).norm(), 1e-12)
        << transform << ": " << at.transpose();
  }
}

TEST(SvgFile, GroupsMultiplyFromOutside) {
  const ImportedScene imported = read(
      "<g transform='translate(10,0)'><g transform='scale(2)'><a><line x1='1' y1='2' x2='3' "
      "y2='4'/></a></g><line x1='1' y1='2' x2='3' y2='4'/></g>");
  expectPoints(imported, 0, {{12, 96}, {16, 92}});
  expectPoints(imported, 1, {{11, 98}, {13, 96}});
}

TEST(SvgFile, BasicShapes) {
  expectPoints(read("<rect x='1' y='2' width='30' height='40'/>"), 0,
               {{1, 98}, {31, 98}, {31, 58}, {1, 58}});
  expectPoints(read("<polyline points='1,2 3 4,5-6'/>"), 0, {{1, 98}, {3, 96}, {5, 106}});
  expectPoints(read("<polygon points='1,2 3 4 5,6 1,2'/>"), 0, {{1, 98}, {3, 96}, {5, 94}});
  EXPECT_TRUE(read("<polygon points='1,2 3 4 5,7'/>").scene.curves[0].chain().closed());
  EXPECT_FALSE(read("<polyline points='1,2 3 4 5,7'/>").scene.curves[0].chain().closed());

  const Curve circle = read("<circle cx='10' cy='20' r='5'/>").scene.curves.at(0).shape;
  EXPECT_TRUE(isClosed(circle));
  EXPECT_EQ(pieceCount(circle), 4);
  const Curve ellipse = read("<ellipse cx='10' cy='20' rx='5' ry='2'/>").scene.curves.at(0).shape;
  double most = 0.0;
  for (double t = 0.0; t < 4.0; t += 0.0625) {
    const Vec2 c = pointAt(circle, t) - Vec2(10, 80), e = pointAt(ellipse, t) - Vec2(10, 80);
    EXPECT_NEAR(c.norm(), 5.0, 1e-13);
    EXPECT_NEAR(std::hypot(e.x() / 5, e.y() / 2), 1.0, 1e-13);
    most = std::max(most, std::abs(e.x()));
  }
  EXPECT_NEAR(most, 5.0, 1e-13);
}

int countOf(const FeatureSet& found, std::initializer_list<MarkKind> kinds) {
  return static_cast<int>(std::count_if(found.marks.begin(), found.marks.end(), [&](const Mark& m) {
    return std::find(kinds.begin(), kinds.end(), m.kind) != kinds.end();
  }));
}

// A circle has no ridges and an ellipse four vertices, wherever they are drawn and however an
// affine map has turned one into the other.
TEST(SvgFile, CirclesAndEllipsesHaveTheirOwnMarksOnly) {
  struct Drawn {
    std::string content;
    bool circle;
  };
  const std::vector<Drawn> cases{
      {"<circle cx='10' cy='20' r='5'/>", true},
      {"<g transform='translate(812.7 311.3) rotate(31)'><circle cx='1' cy='7.3' r='3.1'/></g>",
       true},
      {"<path d='M10 20A5 5 0 0 1 20 20A5 5 0 1 1 10 20z'/>", true},
      {"<ellipse cx='10' cy='20' rx='10' ry='5' transform='scale(1 2)'/>", true},
      {"<ellipse cx='10' cy='20' rx='5' ry='2'/>", false},
      {"<circle cx='10' cy='20' r='5' transform='matrix(1 .3 .7 2 -100 20)'/>", false}};
  for (const Drawn& drawn : cases) {
    SCOPED_TRACE(drawn.content);
    Scene scene = read(drawn.content).scene;
    scene.view.angleDeg = 20.0;
    const FeatureSet found = findFeatures(scene);
    EXPECT_TRUE(found.complete());
    EXPECT_EQ(countOf(found, {MarkKind::Silhouette}), 2);
    EXPECT_EQ(countOf(found, {MarkKind::Inflection}), 0);
    const int vertices = countOf(found, {MarkKind::Ridge, MarkKind::Valley});
    EXPECT_EQ(vertices, drawn.circle ? 0 : 2);
  }
}

TEST(SvgFile, StyleSheetsSayWhatIsDrawn) {
  const auto drawn = [](const std::string& sheet, const std::string& attributes) {
    const std::string other = "<rect width='9' height='9'/>";
    return read("<style>" + sheet + "</style>" + other + "<line x2='1' stroke='red' " + attributes +
                "/>")
               .scene.curves.size() == 2;
  };
  struct Case {
    std::string sheet, attributes;
    bool drawn;
  };
  const std::vector<Case> cases{
      {".a{display:none}", "class='a'", false},
      {".a{display:none}", "class='aa'", true},
      {".a { display : none ; }", "class=' b  a '", false},
      {"line{visibility:hidden}", "", false},
      {"#x{visibility:collapse}", "id='x'", false},
      {"*{stroke:none;fill:none}rect{fill:red}", "", false},
      {"<![CDATA[ .a{display:none} ]]>", "class='a'", false},
      {"<![CDATA[<!-- /* .a{} */ .a/**/{display:none} -->]]>", "class='a'", false},
      {"@charset 'x{'; @import url(a.css); .a{display:none}", "class='a'", false},
      {"g, .b , line.a{display:none}", "class='a'", false},
      {".b, rect.a{display:none}", "class='a'", true},
      {".a.b{display:none}", "class='a'", true},
      {".a.b{display:none}", "class='b a'", false},
      // The more specific counts, then the later; the element's own style most, its attribute
      // least.
      {".a{display:none}line{display:inline}", "class='a'", false},
      {"#x{display:inline}.a{display:none}", "id='x' class='a'", true},
      {".a{display:inline}.a{display:none !important}", "class='a'", false},
      {".a{display:none}", "class='a' style='display:inline'", true},
      {".a{display:inline}", "class='a' display='none'", true},
      {".a{stroke:none;fill:none}", "class='a'", false},
      {".a{stroke:none}", "class='a'", true},
      // What is not understood hides nothing.
      {"g .a{display:none}", "class='a'", true},
      {".a:hover{display:none}", "class='a'", true},
      {"@media print { .a{display:none} }", "class='a'", true},
      {".a{display:none", "class='a'", false},
      {"}{;:.a{", "class='a'", true}};
  for (const Case& one : cases) {
    EXPECT_EQ(drawn(one.sheet, one.attributes), one.drawn) << one.sheet << ' ' << one.attributes;
  }
  EXPECT_EQ(read("<style>g .a{fill:red} .a{font:x} @media print{.b{fill:red}}</style>"
                 "<rect width='9' height='9'/>")
                .leftOut,
            "left out: 2 style rules");
}

TEST(SvgFile, RoundedRectangle) {
  // Area of a rectangle with quarter ellipses for corners: w h - (4 - pi) rx ry.
  const std::vector<std::pair<std::string, double>> cases{
      {"rx='3' ry='2'", 1200 - (4 - std::numbers::pi) * 6},
      {"rx='3'", 1200 - (4 - std::numbers::pi) * 9},
      {"ry='2'", 1200 - (4 - std::numbers::pi) * 4},
      {"rx='100' ry='2'", 1200 - (4 - std::numbers::pi) * 15 * 2},
      {"rx='100' ry='100'", 300 * std::numbers::pi},
      {"rx='3' ry='0'", 1200},
      {"rx='10%' ry='auto'", 1200 - (4 - std::numbers::pi) * 100},
      {"", 1200}};
  for (const auto& [radii, area] : cases) {
    const ImportedScene imported = read("<rect x='1' y='2' width='30' height='40' " + radii + "/>");
    const double found = 0.5 * std::abs(twiceSignedArea(imported.scene.curves.at(0).shape));
    EXPECT_NEAR(found, area, 1e-8 * area) << radii;
    EXPECT_EQ(imported.leftOut, "") << radii;
  }
}

TEST(SvgFile, UnitsAndViewBoxes) {
  const double mm = 96 / 25.4;
  const std::string line = "<line x1='0' y1='0' x2='10' y2='20'/>";
  const std::vector<std::tuple<std::string, Vec2, Vec2>> cases{
      {"width='100mm' height='50mm' viewBox='0 0 100 50'", {0, 50 * mm}, {10 * mm, 30 * mm}},
      {"width='1in' height='1in'", {0, 96}, {10, 76}},
      {"width='200' height='100' viewBox='0 0 20 20'", {50, 100}, {100, 0}},
      {"width='200' height='100' viewBox='0 0 20 20' preserveAspectRatio='xMinYMin'",
       {0, 100},
       {50, 0}},
      {"width='200' height='100' viewBox='0 0 20 20' preserveAspectRatio='xMaxYMid meet'",
       {100, 100},
       {150, 0}},
      {"width='200' height='100' viewBox='0 0 20 20' preserveAspectRatio='none'",
       {0, 100},
       {100, 0}},
      {"width='200' height='100' viewBox='0 0 20 20' preserveAspectRatio='xMidYMax slice'",
       {0, 200},
       {100, 0}},
      {"viewBox='-5 -5 40 40'", {5, 35}, {15, 15}},
      {"", {0, 150}, {10, 130}},
  };
  for (const auto& [attributes, first, second] : cases) {
    SCOPED_TRACE(attributes);
    expectPoints(read(line, attributes), 0, {first, second}, 1e-10);
  }
  // A drawing in a drawing, and lengths in its per cents.
  expectPoints(read("<svg x='10' y='20' width='50' height='40' viewBox='0 0 100 80'><line x1='10%' "
                    "y1='50%' x2='1cm' y2='0'/></svg>"),
               0, {{15, 60}, {10 + 0.5 * 96 / 2.54, 80}});
}

TEST(SvgFile, UseAndSymbols) {
  const std::string defs =
      "<defs><line id='l' x1='0' y1='0' x2='1' y2='2'/><g id='g' transform='scale(2)'><use "
      "href='#l' x='1'/></g></defs><symbol id='s' viewBox='0 0 2 2'><use "
      "xlink:href='#l'/></symbol>";
  expectPoints(read(defs + "<use xlink:href='#l' x='10' y='5' transform='scale(2)'/>"), 0,
               {{20, 90}, {22, 86}});
  expectPoints(read(defs + "<use href='#g' y='5'/>"), 0, {{2, 95}, {4, 91}});
  expectPoints(read(defs + "<use href='#s' x='10' width='20' height='20'/>"), 0,
               {{10, 100}, {20, 80}});
  EXPECT_EQ(read(defs + "<use href='#l'/>").scene.curves.size(), 1U);  // defs alone are not drawn
  EXPECT_EQ(read("<use href='#no'/><use href='other.svg#l'/><line x2='1'/>").leftOut,
            "left out: 2 references to what is not there");
}

TEST(SvgFile, WhatIsLeftOutIsCounted) {
  const ImportedScene imported = read(
      "<defs><linearGradient id='a'/><radialGradient id='b'/><filter id='f'/>"
      "<clipPath id='c'><rect width='1' height='1'/></clipPath></defs>"
      "<style>.x { fill: red } text > .x { fill: none }</style>"
      "<text>words</text><text>words</text><image href='x.png'/>"
      "<path d='M0 0L1 1' style='display:none'/><g display='none'><path d='M0 0L1 1'/></g>"
      "<path d='M0 0L1 1' style='fill:none;stroke : none'/>"
      "<path d='M0 0L1 1' visibility='hidden'/>"
      "<path d='M0 0L0 0L1 1M5 5M6 6' clip-path='url(#c)'/>");
  EXPECT_EQ(imported.scene.curves.size(), 1U);
  EXPECT_EQ(imported.done, "1 curve, y turned up");
  EXPECT_EQ(imported.leftOut,
            "left out: 2 gradients, 1 filter, 1 style rule, 2 texts, 1 image, 3 hidden elements, "
            "1 shape with neither fill nor stroke, 1 clip path, 2 subpaths without length, 1 "
            "segment of zero length");
  EXPECT_EQ(imported.note(), imported.done + "; " + imported.leftOut);
}

TEST(SvgFile, PaintIsInherited) {
  const std::string line = "<line x2='1'/>";
  EXPECT_THROW(read("<g style='fill:none'>" + line + "</g>"), InputError);
  EXPECT_NO_THROW(read("<g style='fill:none' stroke='red'>" + line + "</g>"));
  EXPECT_NO_THROW(read("<g fill='none'><line x2='1' stroke='red'/></g>"));
  EXPECT_NO_THROW(read("<g visibility='hidden'><line x2='1' visibility='visible'/></g>"));
  // The property of the style counts more than the attribute.
  EXPECT_THROW(read("<line x2='1' fill='red' style='fill:none'/>"), InputError);
  // A class may be given paint by a rule that is passed over.
  EXPECT_NO_THROW(read("<style>g>.a{fill:red}</style><line class='a' x2='1' fill='none'/>"));
}

TEST(SvgFile, SwitchTakesTheFirstThatNeedsNothing) {
  const ImportedScene imported = read(
      "<switch><foreignObject requiredExtensions='x'/><g><line x2='1'/></g><line x2='2'/>"
      "</switch>");
  ASSERT_EQ(imported.scene.curves.size(), 1U);
  EXPECT_EQ(imported.scene.curves[0].chain().points()[1].x(), 1.0);
}

TEST(SvgFile, ComfortableSize) {
  for (const double size : {1e-6, 0.7, 3.0, 4.0, 4.1, 480.0, 1e6}) {
    const ImportedScene imported =
        read("<rect x='7' width='" + numberText(size) + "' height='" + numberText(size / 4) + "'/>",
             "width='100' height='100'", {});
    const Bounds box = boundsOf(imported.scene);
    const Vec2 sides = box.high - box.low;
    // 7 + 1e-6 has lost ten digits.
    const double lost = 1e-15 / size;
    EXPECT_GT(sides.x(), 2.0 * (1 - lost)) << size;
    EXPECT_LE(sides.x(), 4.0 * (1 + lost)) << size;
    EXPECT_NEAR(sides.y() / sides.x(), 0.25, 100 * lost) << size;
    EXPECT_LT(box.centre().norm(), 1e-15 + 100 * lost) << size;
    // By a power of two, so that no digit is lost.
    const double factor = sides.x() / size;
    EXPECT_NEAR(std::log2(factor), std::round(std::log2(factor)), 100 * lost) << size;
  }
  EXPECT_EQ(read("<rect width='64' height='8'/>", "", {}).done,
            "1 curve, y turned up, scaled by 1/16 and centred");
  EXPECT_EQ(read("<rect width='.5' height='.25'/>", "", {}).done,
            "1 curve, y turned up, scaled by 8 and centred");
}

TEST(SvgFile, ErrorsNameTheLine) {
  EXPECT_EQ(whyRefused("<svg>\n<g>\n<path id='p1' d='M0 0\nL1 q'/></g></svg>"),
            "a.svg: line 3, <path id=\"p1\">, d, character 9: expected a number, found 'q'");
  EXPECT_EQ(whyRefused("<svg>\n<g>\n</svg>").substr(0, 40),
            "a.svg: line 3: is not well-formed XML: S");
  expectRefused("<rect width='-1' height='2'/>", "width is negative");
  expectRefused("<circle r='x'/>", "<circle>, r, character 1: expected a number, found 'x'");
  expectRefused("<circle r='3 parsec'/>", "expected a length, found 'p'");
  expectRefused("<circle r='3parsec'/>", "unknown unit parsec");
  expectRefused("<g transform='turn(3)'/>", "there is no transform turn of 1 numbers");
  expectRefused("<g transform='scale(3'/>", "expected a number or ), found the end");
  expectRefused("<g transform='rotate(3 4)'/>", "there is no transform rotate of 2 numbers");
  expectRefused("<g transform='matrix(1 0 0 1 0)'/>", "there is no transform matrix of 5 numbers");
  expectRefused("<polygon points='1 2 3'/>", "expected pairs x,y, found 3 numbers");
  expectRefused("<svg viewBox='0 0 1'/>", "expected 4 numbers, found 3");
  expectRefused("<text>a</text>", "has no curve to show; left out: 1 text");
  expectRefused("", "has no curve to show");
  EXPECT_NE(whyRefused("<html/>").find("is not SVG: its outermost element is <html>"),
            std::string::npos);
  EXPECT_NE(whyRefused("").find("is not well-formed XML"), std::string::npos);
  EXPECT_NE(whyRefused("\x1f\x8b\x08").find("is compressed"), std::string::npos);
}

// Each of these has brought some reader of SVG down.
TEST(SvgFile, HostileFilesGetOneMessageSoon) {
  const auto start = std::chrono::steady_clock::now();
  std::string deep;
  for (int i = 0; i < 300'000; ++i) deep += "<g>";
  for (int i = 0; i < 300'000; ++i) deep += "</g>";
  expectRefused(deep, "nested deeper than 200");
  expectRefused("<g id='a'><use href='#a'/></g>", "refers to itself");
  expectRefused("<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>", "refers to itself");
  std::string laughs = "<line id='u0' x2='1'/>";
  for (int i = 1; i < 16; ++i) {
    laughs += "<g id='u" + std::to_string(i) + "'>";
    for (int k = 0; k < 10; ++k) laughs += "<use href='#u" + std::to_string(i - 1) + "'/>";
    laughs += "</g>";
  }
  expectRefused(laughs, "more elements to draw than 200000");
  // A long path that is drawn ten thousand times: hidden it costs nothing, else it is too many.
  std::string path = "M0 0";
  for (int i = 0; i < 60'000; ++i) path += "L" + std::to_string(i % 7) + " 1";
  const auto drawnOften = [&path](const std::string& how) {
    std::string all = "<defs><path id='p' " + how + " d='" + path + "'/><g id='g'>";
    for (int i = 0; i < 100; ++i) all += "<use href='#p'/>";
    all += "</g></defs><line x2='1'/>";
    for (int i = 0; i < 100; ++i) all += "<use href='#g'/>";
    return all;
  };
  EXPECT_EQ(read(drawnOften("visibility='hidden'")).scene.curves.size(), 1U);
  EXPECT_EQ(read(drawnOften("fill='none'")).scene.curves.size(), 1U);
  expectRefused(drawnOften(""), "segments, too many");
  std::string notes = "<g id='n'>";
  for (int i = 0; i < 1000; ++i) notes += "<x:n/>";
  notes += "</g>";
  for (int i = 0; i < 300; ++i) notes += "<use href='#n'/>";
  expectRefused(notes, "more elements to draw than 200000");
  std::string entities = "<!DOCTYPE svg [<!ENTITY a0 'ha'>";
  for (int i = 1; i < 30; ++i) {
    entities += "<!ENTITY a" + std::to_string(i) + " '";
    for (int k = 0; k < 10; ++k) entities += "&a" + std::to_string(i - 1) + ";";
    entities += "'>";
  }
  EXPECT_NE(whyRefused(entities + "]><svg><text>&a29;</text></svg>").find("no curve to show"),
            std::string::npos);
  expectRefused("<g transform='scale(1e200)'><g transform='scale(1e200)'><line x2='1'/></g></g>",
                "coordinates beyond 1e50");
  expectRefused("<line x2='1e-60'/>", "too small to be seen");
  expectRefused("<g transform='scale(0)'><line x2='1'/></g>", "no curve to show");
  EXPECT_NE(whyRefused(std::string(kLargestSvgBytes + 1, ' ')).find("larger than 16 MiB"),
            std::string::npos);
  EXPECT_NE(whyRefused(drawing(std::string("<line x2='1'/>\0<g>", 18))).size(), 0U);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 30.0);  // seconds where it could be for ever
}

}  // namespace
}  // namespace flatland
