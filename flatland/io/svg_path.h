// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flatland/curve/curve.h"

namespace flatland {

/// A Bezier segment, or an arc of an ellipse: then of degree 2, with a weight of the middle point
/// where its ends have 1 (see RationalBezier).
struct PathSegment : Bezier {
  double weight = 1.0;

  PathSegment(std::vector<Vec2> p, double w = 1.0) : Bezier{std::move(p)}, weight(w) {}
  PathSegment(Bezier bezier) : Bezier(std::move(bezier)) {}
};

/// One subpath of an SVG path: segments of degree 1 to 3, each starting where the one before ends.
/// Coordinates are those of the text, so y points down in most files.
struct Subpath {
  Vec2 start = Vec2::Zero();
  std::vector<PathSegment> segments;
  bool closed = false;  ///< by Z; the closing line is not among the segments
};

/// No path may have more segments than this, arcs counted by their quarters.
inline constexpr std::size_t kMostSvgSegments = 100'000;

/// The whole grammar of path data (SVG 2, section 9.3): M L H V C S Q T A Z, absolute and relative,
/// repeated arguments, numbers and flags run together. Unlike a browser, which draws up to the
/// first error, this refuses a path that has one: throws InputError with `source`, `place` extended
/// by the character (counted from 1), and the reason. An empty text is a path without subpaths.
std::vector<Subpath> subpathsFromSvg(std::string_view text, const std::string& source,
                                     const std::string& place);

/// Elliptical arc from `from` to `to` as SVG defines it (SVG 2, B.2): radii of either sign, made
/// larger together if they are too short to reach; a radius of zero gives the line; equal ends give
/// nothing. Segments of at most 90 degrees of the ellipse each, exact up to rounding, so that the
/// curvature is that of the ellipse too: an arc of a circle has no ridges.
struct SvgArc {
  Vec2 radii;
  double rotationDeg = 0.0;  ///< of the first radius against the x axis
  bool large = false;        ///< the longer way round
  bool sweep = false;        ///< angles grow from `from` to `to`
};
std::vector<PathSegment> conicsOfArc(const Vec2& from, const Vec2& to, const SvgArc& arc);

/// What turning a subpath into a chain dropped or changed, to be told to the person.
struct ChainNotes {
  int zeroLengthSegments = 0;  ///< dropped: all their control points coincide
  int emptySubpaths = 0;       ///< dropped: no segment of any length
  int joinedEnds = 0;          ///< ends moved onto the start, see chainOf()
};

/// Ends nearer to the start than this times the size of the subpath are the start: files hold six
/// digits or so, and sums of relative steps miss by a few units of the last.
inline constexpr double kSameEnd = 1e-6;

/// The subpath as one BezierChain, or with arcs as one RationalBezier, of the lowest degree that
/// holds all its segments; lower ones are raised, which changes no point of the curve. Closed if Z
/// closes it or if its ends coincide (kSameEnd). Z adds the closing line, if there is a gap.
/// nullopt if no segment has any length.
std::optional<Curve> chainOf(const Subpath& subpath, ChainNotes& notes);

}  // namespace flatland
