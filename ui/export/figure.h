// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "flatland/curve/vec2.h"

namespace flatland::ui {

// A drawing as plain values, which the writers turn into SVG, TikZ, PDF, PNG or painter calls.
// Figure coordinates: px of 1/96 inch, origin at the top left corner, y down. No transparency.

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;

  bool operator==(const Rgb&) const = default;
};

/// "#rrggbb"
std::string toHex(Rgb colour);

/// Lines and cubic Beziers, in order.
struct PathData {
  enum class Verb : std::uint8_t { MoveTo, LineTo, CubicTo, Close };  ///< take 1, 1, 3, 0 points
  std::vector<Verb> verbs;
  std::vector<Vec2> points;

  void moveTo(const Vec2& p);
  void lineTo(const Vec2& p);
  void cubicTo(const Vec2& c1, const Vec2& c2, const Vec2& p);
  void close();
  /// The closed circle as four cubics (radius exact to 3e-4 of itself).
  void addCircle(const Vec2& centre, double radius);
};

struct Stroke {
  Rgb colour;
  double width = 1.0;             ///< px
  std::vector<double> dash = {};  ///< on, off, ... in px; empty: solid
  bool roundCaps = false;
  bool roundJoins = false;  ///< else mitred
};

struct PathShape {
  PathData path;
  std::optional<Rgb> fill = {};
  std::optional<Stroke> stroke = {};
};

/// One line of sans-serif text.
struct TextShape {
  enum class Anchor { Start, Middle, End };
  Vec2 position;  ///< of the anchor, at mid-height of the lower-case letters
  std::string text;
  double size = 12.0;  ///< px, height of the font
  Rgb colour;
  Anchor anchor = Anchor::Middle;
  bool bold = false;
};

using Shape = std::variant<PathShape, TextShape>;

/// Shapes that belong together and are drawn together.
struct FigureGroup {
  std::string id;       ///< unique in the figure, for example "marks-ridge-hidden"
  std::string classes;  ///< separated by blanks, for example "mark ridge hidden"
  std::vector<Shape> shapes;
};

struct Figure {
  double width = 0.0, height = 0.0;  ///< px
  std::optional<Rgb> background;     ///< none: transparent
  std::vector<FigureGroup> groups;   ///< first is drawn first
};

/// The figure `factor` times as large in every respect, text and line widths included.
Figure magnified(Figure figure, double factor);

/// What a file says about itself, so that it can be made again.
struct FigureSource {
  std::string title;
  std::string program;              ///< name and version
  std::string command;              ///< the command line, may be empty
  std::string sceneJson;            ///< what was drawn, may be empty
  std::string sceneName = "scene";  ///< what that is called in the file, a word
};

/// How far the text's baseline lies below its position, px: half the height of lower-case letters
/// in Helvetica and its like.
inline double baselineBelow(const TextShape& text) { return 0.26 * text.size; }

/// About how wide the text is, px: rather more than less. There is no font here to ask.
double estimatedWidth(const std::string& text, double size);

}  // namespace flatland::ui
