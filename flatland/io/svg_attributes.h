// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flatland/io/svg_path.h"

// The attribute languages of SVG 2 and its basic shapes, without the XML around them. Texts that do
// not fit throw InputError with `source`, `place` and the character.
namespace flatland {

/// What a message about an attribute begins with.
struct SvgPlace {
  std::string source;  ///< the file
  std::string place;   ///< line, element and attribute
};

/// "translate(3) rotate(45 1 2)": matrix, translate, scale, rotate, skewX, skewY, applied from the
/// right. Angles are degrees; matrices may be singular.
Eigen::Affine2d svgTransform(std::string_view text, const SvgPlace& place);

/// A length in user units, which are pixels of 1/96 inch: a number with px, mm, cm, in, pt, pc, Q,
/// em or ex (16 and 8 px), or with %, of `whole`.
double svgLength(std::string_view text, double whole, const SvgPlace& place);

/// "1,2 3,4": points with comma or space between the numbers. An odd number of numbers is an error.
std::vector<Vec2> svgPoints(std::string_view text, const SvgPlace& place);

struct SvgViewBox {
  Vec2 corner, size;
};

/// Four numbers; nullopt where width or height is not positive, which SVG takes for none.
std::optional<SvgViewBox> svgViewBox(std::string_view text, const SvgPlace& place);

/// Maps the box into a viewport of `size` with its corner at the origin, as the attribute
/// preserveAspectRatio says ("xMidYMid meet" where it is empty or not understood).
Eigen::Affine2d fitViewBox(const SvgViewBox& box, const Vec2& size, std::string_view aspect);

/// A rectangle, its corners rounded by quarter ellipses if both radii are positive (at most half
/// the sides count). Walked as SVG says: from the top left corner along +x.
Subpath svgRectangle(const Vec2& corner, const Vec2& size, const Vec2& radii);
/// Walked from its +x end towards +y.
Subpath svgEllipse(const Vec2& centre, const Vec2& radii);
/// Lines through the points; empty below two of them.
Subpath svgPolyline(const std::vector<Vec2>& points, bool closed);

}  // namespace flatland
