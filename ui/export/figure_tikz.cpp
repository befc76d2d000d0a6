// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <tuple>

#include "ui/export/figure_writers.h"
#include "ui/export/mark_style.h"
#include "ui/export/plain_text.h"

namespace flatland::ui {

namespace {

constexpr double kBpPerPx = 0.75;          // 72 bp and 96 px to the inch
constexpr double kPtPerBp = 72.27 / 72.0;  // TeX's own point is a little smaller

using Rgb24 = std::tuple<std::uint8_t, std::uint8_t, std::uint8_t>;
Rgb24 keyOf(Rgb c) { return {c.r, c.g, c.b}; }

/// Names of the colours of the visual language on one background.
std::map<Rgb24, std::string> colourNames(Palette palette) {
  std::map<Rgb24, std::string> names;
  const SceneColours& scene = sceneColours(palette);
  // The first name of a colour stays.
  const auto add = [&](Rgb colour, const std::string& name) {
    names.emplace(keyOf(colour), name);
    names.emplace(keyOf(paler(colour, scene.background)), name + "-hidden");
  };
  add(scene.background, "flatland-background");
  add(scene.curve, "flatland-curve");
  add(scene.screen, "flatland-screen");
  add(scene.text, "flatland-text");
  add(scene.controlPolygon, "flatland-control-polygon");
  add(scene.faint, "flatland-sight");
  for (const MarkKind kind : markKindsInLegendOrder()) {
    const MarkStyle& style = styleOf(kind, palette);
    const std::string base = "flatland-" + std::string(nameOf(kind));
    add(style.colour, base);
    add(style.letterColour, base + "-letter");
  }
  return names;
}

std::set<Rgb24> coloursOf(const Figure& figure) {
  std::set<Rgb24> colours;
  if (figure.background) colours.insert(keyOf(*figure.background));
  for (const FigureGroup& group : figure.groups) {
    for (const Shape& shape : group.shapes) {
      if (const auto* path = std::get_if<PathShape>(&shape)) {
        if (path->fill) colours.insert(keyOf(*path->fill));
        if (path->stroke) colours.insert(keyOf(path->stroke->colour));
      } else if (const auto* text = std::get_if<TextShape>(&shape)) {
        colours.insert(keyOf(text->colour));
      }
    }
  }
  return colours;
}

/// The names of a figure's colours: those of the background that names more of them, and their
/// values for the rest.
class ColourNames {
 public:
  explicit ColourNames(const Figure& figure) : used_(coloursOf(figure)) {
    const auto known = [this](const std::map<Rgb24, std::string>& names) {
      return std::count_if(used_.begin(), used_.end(),
                           [&names](const Rgb24& c) { return names.contains(c); });
    };
    std::map<Rgb24, std::string> light = colourNames(Palette::Light);
    std::map<Rgb24, std::string> dark = colourNames(Palette::Dark);
    names_ = known(dark) > known(light) ? std::move(dark) : std::move(light);
  }

  std::string of(Rgb colour) const {
    const auto known = names_.find(keyOf(colour));
    return known != names_.end() ? known->second : "flatland-" + hexText(colour);
  }

  std::string definitions() const {
    std::string text;
    for (const auto& [r, g, b] : used_) {
      const Rgb colour{r, g, b};
      text += "\\providecolor{" + of(colour) + "}{HTML}{" + hexText(colour) + "}\n";
    }
    return text;
  }

 private:
  /// "D55E00", as xcolor wants it.
  static std::string hexText(Rgb colour) {
    std::string hex = toHex(colour).substr(1);
    for (char& c : hex) {
      if (c >= 'a') c = static_cast<char>(c - 'a' + 'A');
    }
    return hex;
  }

  std::set<Rgb24> used_;
  std::map<Rgb24, std::string> names_;
};

std::string escaped(const std::string& text) {
  constexpr std::string_view kDegree = "\u00b0";
  std::string tex;
  const std::string clean = cleanText(text);
  for (std::size_t i = 0; i < clean.size(); ++i) {
    if (clean.compare(i, kDegree.size(), kDegree) == 0) {
      tex += "$^\\circ$";
      i += kDegree.size() - 1;
      continue;
    }
    switch (clean[i]) {
      case '\\':
        tex += "\\textbackslash{}";
        break;
      case '~':
        tex += "\\textasciitilde{}";
        break;
      case '^':
        tex += "\\textasciicircum{}";
        break;
      case '#':
      case '$':
      case '%':
      case '&':
      case '_':
      case '{':
      case '}':
        tex += '\\';
        [[fallthrough]];
      default:
        tex += clean[i];
    }
  }
  return tex;
}

/// Every line of the text as a comment.
std::string commented(const std::string& text) {
  std::string comment;
  std::string line;
  for (const char c : cleanText(text) + "\n") {
    if (c != '\n') {
      line += c;
    } else if (!line.empty()) {
      comment += "%   " + line + "\n";
      line.clear();
    }
  }
  return comment;
}

std::string capitalised(std::string word) {
  word.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
  return word;
}

std::string pairText(const Vec2& p) {
  return "(" + decimalText(p.x()) + "," + decimalText(p.y()) + ")";
}

std::string bp(double px) { return decimalText(px * kBpPerPx) + "bp"; }

std::string pathText(const PathData& path) {
  std::string text;
  std::size_t next = 0;
  for (const PathData::Verb verb : path.verbs) {
    switch (verb) {
      case PathData::Verb::MoveTo:
        text += " " + pairText(path.points[next++]);
        break;
      case PathData::Verb::LineTo:
        text += " -- " + pairText(path.points[next++]);
        break;
      case PathData::Verb::CubicTo:
        text += " .. controls " + pairText(path.points[next]) + " and " +
                pairText(path.points[next + 1]) + " .. " + pairText(path.points[next + 2]);
        next += 3;
        break;
      case PathData::Verb::Close:
        text += " -- cycle";
        break;
    }
  }
  return text;
}

std::string command(const PathShape& shape, const ColourNames& colours) {
  std::string options;
  const auto add = [&options](const std::string& option) {
    options += (options.empty() ? "" : ", ") + option;
  };
  if (shape.fill) add("fill=" + colours.of(*shape.fill));
  if (shape.stroke) {
    add("draw=" + colours.of(shape.stroke->colour));
    add("line width=" + bp(shape.stroke->width));
    std::string dash;
    bool on = true;
    for (const double length : shape.stroke->dash) {
      dash += (on ? " on " : " off ") + bp(length);
      on = !on;
    }
    if (!dash.empty()) add("dash pattern=" + dash.substr(1));
    if (shape.stroke->roundCaps) add("line cap=round");
    if (shape.stroke->roundJoins) add("line join=round");
  }
  return "\\path[" + options + "]" + pathText(shape.path) + ";";
}

std::string command(const TextShape& shape, const ColourNames& colours) {
  std::string anchor = "base";
  if (shape.anchor == TextShape::Anchor::Start) anchor = "base west";
  if (shape.anchor == TextShape::Anchor::End) anchor = "base east";
  const std::string size = decimalText(shape.size * kBpPerPx * kPtPerBp);
  return "\\node[anchor=" + anchor + ", inner sep=0pt, text=" + colours.of(shape.colour) +
         ", font=\\sffamily" + (shape.bold ? "\\bfseries" : "") + "\\fontsize{" + size + "}{" +
         size + "}\\selectfont] at " + pairText(shape.position + Vec2(0.0, baselineBelow(shape))) +
         " {" + escaped(shape.text) + "};";
}

}  // namespace

std::string figureToTikz(const Figure& figure, const FigureSource& source) {
  const ColourNames colours(figure);
  std::string body;
  if (figure.background) {
    body += "\\path[fill=" + colours.of(*figure.background) + "] (0,0) rectangle " +
            pairText({figure.width, figure.height}) + ";\n";
  }
  for (const FigureGroup& group : figure.groups) {
    body += "% " + group.id + "\n";
    for (const Shape& shape : group.shapes) {
      body += std::visit([&](const auto& s) { return command(s, colours); }, shape) + "\n";
    }
  }

  std::string tikz = commented(source.title) +
                     "% Compiles alone; or \\input it after "
                     "\\usepackage{standalone,tikz}.\n";
  tikz += "% Made by:\n" + commented(source.program) + "% Command:\n" + commented(source.command) +
          "% " + capitalised(source.sceneName) + ":\n" + commented(source.sceneJson);
  tikz += "\\documentclass[tikz]{standalone}\n\\begin{document}\n";
  tikz += "\\begin{tikzpicture}[x=" + bp(1.0) + ", y=-" + bp(1.0) + "]\n";
  tikz += "% A colour that is defined already keeps its definition.\n";
  tikz += colours.definitions();
  const std::string box = "(0,0) rectangle " + pairText({figure.width, figure.height}) + ";\n";
  tikz += "\\path[use as bounding box, clip] " + box + body;
  return tikz + "\\end{tikzpicture}\n\\end{document}\n";
}

}  // namespace flatland::ui
