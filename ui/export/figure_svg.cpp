// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/figure_writers.h"
#include "ui/export/plain_text.h"

namespace flatland::ui {

namespace {

std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : cleanText(text)) {
    switch (c) {
      case '&':
        xml += "&amp;";
        break;
      case '<':
        xml += "&lt;";
        break;
      case '>':
        xml += "&gt;";
        break;
      case '"':
        xml += "&quot;";
        break;
      default:
        xml += c;
    }
  }
  return xml;
}

std::string attribute(const std::string& name, const std::string& value) {
  return " " + name + "=\"" + value + "\"";
}

std::string pairText(const Vec2& p) { return decimalText(p.x()) + " " + decimalText(p.y()); }

std::string pathText(const PathData& path) {
  std::string d;
  std::size_t next = 0;
  for (const PathData::Verb verb : path.verbs) {
    if (!d.empty()) d += " ";
    switch (verb) {
      case PathData::Verb::MoveTo:
        d += "M" + pairText(path.points[next++]);
        break;
      case PathData::Verb::LineTo:
        d += "L" + pairText(path.points[next++]);
        break;
      case PathData::Verb::CubicTo:
        d += "C" + pairText(path.points[next]) + " " + pairText(path.points[next + 1]) + " " +
             pairText(path.points[next + 2]);
        next += 3;
        break;
      case PathData::Verb::Close:
        d += "Z";
        break;
    }
  }
  return d;
}

std::string strokeText(const Stroke& stroke) {
  std::string text = attribute("stroke", toHex(stroke.colour)) +
                     attribute("stroke-width", decimalText(stroke.width));
  if (!stroke.dash.empty()) {
    std::string dash;
    for (const double length : stroke.dash) dash += (dash.empty() ? "" : " ") + decimalText(length);
    text += attribute("stroke-dasharray", dash);
  }
  if (stroke.roundCaps) text += attribute("stroke-linecap", "round");
  if (stroke.roundJoins) text += attribute("stroke-linejoin", "round");
  return text;
}

std::string element(const PathShape& shape) {
  return "<path" + attribute("d", pathText(shape.path)) +
         attribute("fill", shape.fill ? toHex(*shape.fill) : "none") +
         (shape.stroke ? strokeText(*shape.stroke) : "") + "/>";
}

std::string element(const TextShape& shape) {
  std::string text = "<text" + attribute("x", decimalText(shape.position.x())) +
                     attribute("y", decimalText(shape.position.y() + baselineBelow(shape))) +
                     attribute("font-size", decimalText(shape.size)) +
                     attribute("fill", toHex(shape.colour));
  if (shape.anchor != TextShape::Anchor::Start) {
    text += attribute("text-anchor", shape.anchor == TextShape::Anchor::Middle ? "middle" : "end");
  }
  if (shape.bold) text += attribute("font-weight", "bold");
  return text + ">" + escaped(shape.text) + "</text>";
}

}  // namespace

std::string figureToSvg(const Figure& figure, const FigureSource& source) {
  const std::string width = decimalText(figure.width);
  const std::string height = decimalText(figure.height);
  std::string svg = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  svg += "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
         attribute("height", height) + attribute("viewBox", "0 0 " + width + " " + height) +
         attribute("font-family", "Helvetica, Arial, 'DejaVu Sans', sans-serif") + ">\n";
  svg += "<title>" + escaped(source.title) + "</title>\n";
  svg += "<metadata>\n<source xmlns=\"urn:flatland:source\">\n<program>" + escaped(source.program) +
         "</program>\n" +
         (source.command.empty() ? "" : "<command>" + escaped(source.command) + "</command>\n") +
         "<" + source.sceneName + ">" + escaped(source.sceneJson) + "</" + source.sceneName +
         ">\n</source>\n</metadata>\n";
  if (figure.background) {
    svg += "<rect id=\"background\"" + attribute("width", width) + attribute("height", height) +
           attribute("fill", toHex(*figure.background)) + "/>\n";
  }
  for (const FigureGroup& group : figure.groups) {
    svg += "<g" + attribute("id", escaped(group.id)) + attribute("class", escaped(group.classes)) +
           ">\n";
    for (const Shape& shape : group.shapes) {
      svg += std::visit([](const auto& s) { return element(s); }, shape) + "\n";
    }
    svg += "</g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace flatland::ui
