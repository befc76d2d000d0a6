// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_writers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "flatland/io/scene_json.h"
#include "tests/support/xml_check.h"
#include "ui/export/flat_figure.h"
#include "ui/export/plain_text.h"

namespace flatland::ui {
namespace {

using test::readXml;
using test::XmlElement;
using test::XmlReading;

const FigureSource kSource{.title = "A <title> & more",
                           .program = "flatland 0",
                           .command = "flatland draw 'a b.json' -o \"x\".svg",
                           .sceneJson = sceneToJson(defaultScene())};

Figure flatFigureOf(const Scene& scene, const FlatFigureOptions& options = {}) {
  return flatFigure(scene, findFeatures(scene), Visibility(scene), options);
}

/// One of everything, with numbers that can be looked for.
Figure handMade() {
  PathData path;
  path.moveTo({1, 2});
  path.lineTo({3.5, 4});
  path.cubicTo({5, 6}, {7, 8}, {9, 10.12345});
  path.close();
  Figure figure{.width = 100, .height = 50, .background = Rgb{1, 2, 3}, .groups = {}};
  figure.groups.push_back(
      {"first",
       "one two",
       {PathShape{path, Rgb{0xAB, 0xCD, 0xEF},
                  Stroke{.colour = {0, 0x72, 0xB2}, .width = 2, .dash = {4, 2}, .roundCaps = true}},
        TextShape{.position = {10, 20},
                  .text = "50% <a> & _b_ {\\} \u00b0",
                  .size = 10,
                  .colour = {9, 9, 9},
                  .anchor = TextShape::Anchor::End,
                  .bold = true}}});
  return figure;
}

const XmlElement& only(const XmlReading& reading, const std::string& name) {
  const XmlElement* found = nullptr;
  for (const XmlElement& element : reading.elements) {
    if (element.name != name) continue;
    EXPECT_EQ(found, nullptr) << "more than one " << name;
    found = &element;
  }
  EXPECT_NE(found, nullptr) << "no " << name;
  static const XmlElement kNone;
  return found != nullptr ? *found : kNone;
}

TEST(XmlCheck, SeesWhatIsWrong) {
  const std::string start = R"(<?xml version="1.0" encoding="UTF-8"?>)";
  EXPECT_FALSE(readXml(start + "<a b=\"1\"><c/>x &lt; y</a>").error);
  for (const char* bad : {"<a>", "<a></b>", "<a b=\"1\" b=\"2\"/>", "<a>&</a>", "<a>&nbsp;</a>",
                          "<a b=\"<\"/>", "<a/><b/>", "x<a/>", "", "<a b=1/>", "<a>\x01</a>"}) {
    EXPECT_TRUE(readXml(start + bad).error) << bad;
  }
}

TEST(Svg, WritesEveryShape) {
  const XmlReading svg = readXml(figureToSvg(handMade(), kSource));
  ASSERT_FALSE(svg.error) << *svg.error;
  const XmlElement& root = svg.elements.front();
  EXPECT_EQ(root.name, "svg");
  EXPECT_EQ(root.attributes.at("width"), "100");
  EXPECT_EQ(root.attributes.at("viewBox"), "0 0 100 50");
  EXPECT_EQ(only(svg, "title").text, kSource.title);
  EXPECT_EQ(only(svg, "rect").attributes.at("fill"), "#010203");
  const XmlElement& group = only(svg, "g");
  EXPECT_EQ(group.attributes.at("id"), "first");
  EXPECT_EQ(group.attributes.at("class"), "one two");
  const XmlElement& path = only(svg, "path");
  EXPECT_EQ(path.attributes.at("d"), "M1 2 L3.5 4 C5 6 7 8 9 10.123 Z");
  EXPECT_EQ(path.attributes.at("fill"), "#abcdef");
  EXPECT_EQ(path.attributes.at("stroke"), "#0072b2");
  EXPECT_EQ(path.attributes.at("stroke-width"), "2");
  EXPECT_EQ(path.attributes.at("stroke-dasharray"), "4 2");
  EXPECT_EQ(path.attributes.at("stroke-linecap"), "round");
  const XmlElement& text = only(svg, "text");
  EXPECT_EQ(text.text, "50% <a> & _b_ {\\} \u00b0");
  EXPECT_EQ(text.attributes.at("x"), "10");
  EXPECT_EQ(text.attributes.at("y"), "22.6");
  EXPECT_EQ(text.attributes.at("text-anchor"), "end");
  EXPECT_EQ(text.attributes.at("font-weight"), "bold");
}

TEST(Svg, HoldsWhatItTakesToMakeItAgain) {
  const XmlReading svg = readXml(figureToSvg(flatFigureOf(defaultScene()), kSource));
  ASSERT_FALSE(svg.error) << *svg.error;
  EXPECT_EQ(sceneFromJson(only(svg, "scene").text, "svg"), defaultScene());
  EXPECT_EQ(only(svg, "command").text, kSource.command);
  EXPECT_EQ(only(svg, "program").text, kSource.program);
}

TEST(Svg, IsWellFormedForEveryPreset) {
  for (const Preset& preset : presets()) {
    FlatFigureOptions options;
    options.kinds.set();
    options.controlPolygon = true;
    Scene scene = preset.scene;
    scene.view.distance = 6.0;
    const XmlReading svg = readXml(figureToSvg(flatFigureOf(scene, options), kSource));
    EXPECT_FALSE(svg.error) << preset.id << ": " << *svg.error;
    std::vector<std::string> ids;
    for (const XmlElement& element : svg.elements) {
      if (element.attributes.contains("id")) ids.push_back(element.attributes.at("id"));
    }
    std::sort(ids.begin(), ids.end());
    EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end()) << "an id twice";
  }
}

TEST(Svg, SurvivesAnyByteInTheCommand) {
  FigureSource source = kSource;
  source.command.clear();
  for (int byte = 1; byte < 256; ++byte) source.command += static_cast<char>(byte);
  const XmlReading svg = readXml(figureToSvg(handMade(), source));
  ASSERT_FALSE(svg.error) << *svg.error;
  EXPECT_EQ(only(svg, "command").text.find('\x01'), std::string::npos);
  EXPECT_NE(only(svg, "command").text.find("\uFFFD"), std::string::npos);
}

TEST(Svg, TransparentHasNoBackground) {
  Figure figure = handMade();
  figure.background.reset();
  EXPECT_EQ(figureToSvg(figure, kSource).find("<rect"), std::string::npos);
}

TEST(Tikz, WritesEveryShape) {
  const std::string tikz = figureToTikz(handMade(), kSource);
  const auto has = [&tikz](const std::string& part) {
    return tikz.find(part) != std::string::npos;
  };
  EXPECT_TRUE(has("\\begin{tikzpicture}[x=0.75bp, y=-0.75bp]"));
  EXPECT_TRUE(has("\\providecolor{flatland-ABCDEF}{HTML}{ABCDEF}"));
  EXPECT_TRUE(has("\\providecolor{flatland-inflection}{HTML}{0072B2}"));
  EXPECT_TRUE(has("(1,2) -- (3.5,4) .. controls (5,6) and (7,8) .. (9,10.123) -- cycle;"));
  EXPECT_TRUE(has("line width=1.5bp, dash pattern=on 3bp off 1.5bp, line cap=round"));
  EXPECT_TRUE(has("anchor=base east"));
  EXPECT_TRUE(has("at (10,22.6) {50\\% <a> \\& \\_b\\_ \\{\\textbackslash{}\\} $^\\circ$};"))
      << tikz;
  EXPECT_TRUE(has("% first"));
}

/// What stands between `from` and the next of the characters `to`, wherever `from` is in the line.
std::vector<std::string> between(const std::string& line, const std::string& from,
                                 const std::string& to) {
  std::vector<std::string> found;
  for (std::size_t at = line.find(from); at != std::string::npos; at = line.find(from, at)) {
    at += from.size();
    found.push_back(line.substr(at, line.find_first_of(to, at) - at));
  }
  return found;
}

TEST(Tikz, CompilesAsFarAsBracesAndEnvironmentsGo) {
  for (const Preset& preset : presets()) {
    const std::string tikz = figureToTikz(flatFigureOf(preset.scene), kSource);
    int braces = 0;
    int colours = 0;
    std::vector<std::string> open;
    std::istringstream lines(tikz);
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind('%', 0) == 0) continue;
      for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\\') {
          ++i;  // an escaped brace is text
        } else {
          braces += line[i] == '{' ? 1 : line[i] == '}' ? -1 : 0;
          ASSERT_GE(braces, 0);
        }
      }
      for (const std::string& name : between(line, "\\begin{", "}")) open.push_back(name);
      for (const std::string& name : between(line, "\\end{", "}")) {
        ASSERT_FALSE(open.empty());
        EXPECT_EQ(open.back(), name);
        open.pop_back();
      }
      // Every colour used is defined.
      for (const char* use : {"draw=", "fill=", "text="}) {
        for (const std::string& name : between(line, use, ",]")) {
          ++colours;
          EXPECT_NE(tikz.find("\\providecolor{" + name + "}"), std::string::npos) << line;
        }
      }
    }
    EXPECT_EQ(braces, 0);
    EXPECT_TRUE(open.empty());
    EXPECT_GT(colours, 20);
  }
}

TEST(Tikz, TheSceneIsInTheComments) {
  const std::string tikz = figureToTikz(handMade(), kSource);
  std::string json;
  bool inScene = false;
  std::istringstream lines(tikz);
  for (std::string line; std::getline(lines, line);) {
    if (line == "% Scene:") {
      inScene = true;
    } else if (inScene && line.rfind("%   ", 0) == 0) {
      json += line.substr(4) + "\n";
    } else {
      inScene = false;
    }
  }
  EXPECT_EQ(sceneFromJson(json, "tex"), defaultScene());
}

TEST(DecimalText, IsShortAndPlain) {
  EXPECT_EQ(decimalText(0.0), "0");
  EXPECT_EQ(decimalText(-0.0001), "0");
  EXPECT_EQ(decimalText(-1.5), "-1.5");
  EXPECT_EQ(decimalText(100.0), "100");
  EXPECT_EQ(decimalText(0.12345), "0.123");
  EXPECT_EQ(decimalText(1e9), "1000000000");
  EXPECT_EQ(decimalText(1e300).size(), 301U);
}

}  // namespace
}  // namespace flatland::ui
