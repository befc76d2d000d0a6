// SPDX-License-Identifier: MIT
#include "flatland/scene/degenerate_presets.h"

#include <utility>

namespace flatland {

namespace {

// Coordinates are sums of powers of two, or small multiples of them, so that what is degenerate on
// paper is degenerate in the machine, to the last bit. tests/flatland/degenerate_presets_test.cpp
// holds the answers in numbers.

Preset degenerate(std::string id, std::string name, std::string description, Curve shape,
                  double viewDeg, std::string expected) {
  return {std::move(id),          std::move(name),
          std::move(description), {{{std::move(shape)}}, {viewDeg, std::nullopt}},
          kDegenerateGroup,       std::move(expected)};
}

BezierChain bezier(std::vector<Vec2> points) { return BezierChain(Bezier{std::move(points)}); }

Curve unitCircle() { return *FormulaCurve::make(FamilyCurve{Family::Id::Circle, {1.0}}).curve; }

}  // namespace

std::vector<Preset> degeneratePresets() {
  return {
      degenerate("pause", "Pause on the way",
                 "x = u^3, y = u^4: the speed vanishes at u = 0, but the tangent does not turn "
                 "back, y = x^(4/3).",
                 bezier({{-1, 1}, {0.5, -1}, {0, 1}, {-0.5, -1}, {1, 1}}), 90.0,
                 "One valley and one apparent ridge, both at the lowest point, where curvature is "
                 "infinite. No corner: the tangent is continuous."),
      degenerate("collinear", "Points on a line",
                 "Four control points on a slanted line: curvature is 0 everywhere, so every point "
                 "would be an inflection.",
                 bezier({{-2, -1}, {-0.5, -0.25}, {1, 0.5}, {2, 1}}), 90.0,
                 "No mark at all. The curve is listed as straight."),
      degenerate(
          "end-on", "Line seen end-on",
          "A straight curve seen along itself: its image is one point, and every point would "
          "be a silhouette.",
          bezier({{-2, 0}, {-0.5, 0}, {1, 0}, {2, 0}}), 0.0,
          "No mark at all. The curve is listed as straight and seen end-on."),
      degenerate(
          "turning-back", "Line that turns back",
          "Three points on a line, the ends in the same place: there and back again.",
          bezier({{-2, -1}, {4, 2}, {-2, -1}}), 90.0,
          "One corner of 180 degrees at the far end, a silhouette too. Both halves are listed "
          "as straight."),
      degenerate("point", "All points equal",
                 "Four control points in one place: a curve without length.",
                 bezier({{0.5, 0.25}, {0.5, 0.25}, {0.5, 0.25}, {0.5, 0.25}}), 90.0,
                 "No mark at all. The curve is listed as a point."),
      degenerate(
          "coincident", "Coincident control points",
          "The first two control points are one: the curve starts at speed 0.",
          bezier({{-1.5, -0.5}, {-1.5, -0.5}, {0.5, 1.5}, {1.5, -0.5}}), 90.0,
          "One ridge and one apparent ridge at the crest; one flat point and one apparent "
          "minimum before it. Nothing at the start: its curvature is infinite, but an end has "
          "no extremum."),
      degenerate("inflection-at-end", "Inflection at an end",
                 "y = 4/9 x^3 from x = 0: curvature vanishes at the very start.",
                 bezier({{0, 0}, {0.5, 0}, {1, 0}, {1.5, 1.5}}), 90.0,
                 "One inflection at t = 0, one valley at x = (9/80)^(1/4) = 0.579 and one apparent "
                 "ridge at x = (3/16)^(1/4) = 0.658."),
      degenerate("silhouette-at-inflection", "Silhouette at an inflection",
                 "y = 8/27 x^3 seen along its tangent at the origin: n.w touches 0 there and keeps "
                 "its sign, a double root.",
                 bezier({{-1.5, -1}, {-0.5, 1}, {0.5, -1}, {1.5, 1}}), 0.0,
                 "One silhouette and one inflection, both at t = 1/2; a valley and a ridge at x = "
                 "-0.709 and 0.709. No apparent ridge: lambda only grows towards the silhouette."),
      degenerate("undulation", "Undulation",
                 "y = x^4: curvature touches 0 at the middle and keeps its sign, a double root.",
                 bezier({{-1, 1}, {-0.5, -1}, {0, 1}, {0.5, -1}, {1, 1}}), 90.0,
                 "No inflection. A flat point and an apparent minimum with lambda = 0 at t = 1/2; "
                 "valleys at x = -+(1/56)^(1/6) = 0.511, apparent ridges at x = -+(1/32)^(1/6) = "
                 "0.561."),
      degenerate("constant-curvature", "Constant curvature",
                 "A true circle, given by its formula: k' is 0 everywhere, so every point would be "
                 "an extremum.",
                 unitCircle(), 90.0,
                 "Two silhouettes, left and right, and two apparent minima with lambda = 1, facing "
                 "the viewer and away. No ridge and no apparent ridge. The curve is listed as of "
                 "constant curvature."),
      degenerate("double-root", "Double root of k'",
                 "A curve that bends ever less from left to right; at the middle the loss stops, "
                 "k' = k'' = 0, and goes on.",
                 bezier({{-3, -1.6875}, {-1.5, -1.6875}, {0, 0.0625}, {1.5, 0.5625}, {3, 5.8125}}),
                 90.0,
                 "No ridge, valley or flat point: k' keeps its sign. One apparent minimum and one "
                 "apparent ridge, to the left and right of the middle."),
      degenerate(
          "straight-piece", "Straight, then bent",
          "A straight piece that goes over smoothly into a cubic: on the first k and k' are 0 "
          "throughout.",
          BezierChain(3, false,
                      {{-2, 0}, {-1.5, 0}, {-1, 0}, {-0.5, 0}, {0, 0}, {0.5, 0}, {0.5, 1}}),
          90.0,
          "Nothing on the straight piece, which is listed as straight, and nothing at the "
          "joint. On the cubic a valley, and a silhouette at its end."),
      degenerate(
          "corner-fold", "Corner with a fold",
          "Two straight pieces that meet at an angle; seen from the right the image turns back "
          "at the corner.",
          BezierChain(1, false, {{-1, 1}, {0, -1}, {1, 0.5}}), 0.0,
          "A corner of 119.7 degrees, which is a silhouette too; seen from above it is the "
          "corner alone. Both pieces are listed as straight."),
      degenerate(
          "jump", "Curvature jumps",
          "Two parabolas with a common tangent at the crest, where curvature jumps from 1 to "
          "4.",
          BezierChain(2, false, {{-2, -1}, {-1, 1}, {0, 1}, {0.5, 1}, {1, -1}}), 90.0,
          "One ridge and one apparent ridge, both at the joint, with the larger of its two "
          "curvatures: lambda = 16."),
  };
}

}  // namespace flatland
