// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/core_words.h"

#include <QCoreApplication>

namespace flatland::ui {

namespace {

// Only for lupdate, which collects the words to translate. A test holds the list against what the
// libraries say.
[[maybe_unused]] constexpr const char* kListed[] = {
    // ui/export/flat_legend.cpp, mark_style.cpp
    QT_TRANSLATE_NOOP("Core", "seen from %1"),
    QT_TRANSLATE_NOOP("Core", "at distance %1"),
    QT_TRANSLATE_NOOP("Core", "paler: hidden"),
    QT_TRANSLATE_NOOP("Core", "Silhouette"),
    QT_TRANSLATE_NOOP("Core", "Inflection"),
    QT_TRANSLATE_NOOP("Core", "Ridge"),
    QT_TRANSLATE_NOOP("Core", "Valley"),
    QT_TRANSLATE_NOOP("Core", "Flat point"),
    QT_TRANSLATE_NOOP("Core", "Corner"),
    QT_TRANSLATE_NOOP("Core", "Apparent ridge"),
    QT_TRANSLATE_NOOP("Core", "Apparent minimum"),
    // ui/export/line_style.cpp; the built-in solids
    QT_TRANSLATE_NOOP("Core", "Exterior silhouette"),
    QT_TRANSLATE_NOOP("Core", "Occluding contours"),
    QT_TRANSLATE_NOOP("Core", "Suggestive contours"),
    QT_TRANSLATE_NOOP("Core", "Suggestive highlights"),
    QT_TRANSLATE_NOOP("Core", "Apparent ridges"),
    QT_TRANSLATE_NOOP("Core", "Principal highlights"),
    QT_TRANSLATE_NOOP("Core", "Isophotes"),
    QT_TRANSLATE_NOOP("Core", "Ridges"),
    QT_TRANSLATE_NOOP("Core", "Valleys"),
    QT_TRANSLATE_NOOP("Core", "Parabolic lines"),
    QT_TRANSLATE_NOOP("Core", "Zero mean curvature"),
    QT_TRANSLATE_NOOP("Core", "Creases"),
    QT_TRANSLATE_NOOP("Core", "Boundaries"),
    QT_TRANSLATE_NOOP("Core", "Self-intersections"),
    QT_TRANSLATE_NOOP("Core", "Topographic lines"),
    QT_TRANSLATE_NOOP("Core", "sphere"),
    QT_TRANSLATE_NOOP("Core", "cylinder"),
    QT_TRANSLATE_NOOP("Core", "torus"),
    QT_TRANSLATE_NOOP("Core", "ellipsoid"),
    QT_TRANSLATE_NOOP("Core", "saddle"),
    QT_TRANSLATE_NOOP("Core", "sine sheet"),
    QT_TRANSLATE_NOOP("Core", "gaussian bump"),
    QT_TRANSLATE_NOOP("Core", "rounded cube"),
    QT_TRANSLATE_NOOP("Core", "bumpy sphere"),
    // flatland/curve: families, kinds, and why an edit or a formula is refused; flatland/features
    QT_TRANSLATE_NOOP("Core", "Circle"),
    QT_TRANSLATE_NOOP("Core", "Ellipse"),
    QT_TRANSLATE_NOOP("Core", "Parabola"),
    QT_TRANSLATE_NOOP("Core", "Sine"),
    QT_TRANSLATE_NOOP("Core", "Gaussian bump"),
    QT_TRANSLATE_NOOP("Core", "Superellipse"),
    QT_TRANSLATE_NOOP("Core", "Lissajous"),
    QT_TRANSLATE_NOOP("Core", "Cycloid"),
    QT_TRANSLATE_NOOP("Core", "radius"),
    QT_TRANSLATE_NOOP("Core", "half axis along x"),
    QT_TRANSLATE_NOOP("Core", "half axis along y"),
    QT_TRANSLATE_NOOP("Core", "steepness"),
    QT_TRANSLATE_NOOP("Core", "half width"),
    QT_TRANSLATE_NOOP("Core", "half height"),
    QT_TRANSLATE_NOOP("Core", "amplitude"),
    QT_TRANSLATE_NOOP("Core", "wave number"),
    QT_TRANSLATE_NOOP("Core", "height"),
    QT_TRANSLATE_NOOP("Core", "width of the bump"),
    QT_TRANSLATE_NOOP("Core", "half width of the curve"),
    QT_TRANSLATE_NOOP("Core", "exponent"),
    QT_TRANSLATE_NOOP("Core", "swings along x"),
    QT_TRANSLATE_NOOP("Core", "swings along y"),
    QT_TRANSLATE_NOOP("Core", "phase, degrees"),
    QT_TRANSLATE_NOOP("Core", "radius of the wheel"),
    QT_TRANSLATE_NOOP("Core", "distance of the pen from the hub; r gives cusps"),
    QT_TRANSLATE_NOOP("Core", "arches"),
    QT_TRANSLATE_NOOP("Core", "Bezier curve"),
    QT_TRANSLATE_NOOP("Core", "Bezier chain"),
    QT_TRANSLATE_NOOP("Core", "B-spline"),
    QT_TRANSLATE_NOOP("Core", "rational Bezier"),
    QT_TRANSLATE_NOOP("Core", "formula"),
    QT_TRANSLATE_NOOP("Core", "a curve needs at least 2 control points"),
    QT_TRANSLATE_NOOP("Core", "only joints can be removed from a chain; this point is a handle"),
    QT_TRANSLATE_NOOP("Core", "too few joints would stay: remove the whole curve instead"),
    QT_TRANSLATE_NOOP(
        "Core",
        "The curve is given by a formula and has no points; convert it to a Bezier chain first."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Points of a rational chain cannot be removed; convert it to a Bezier chain first."),
    QT_TRANSLATE_NOOP("Core", "A rational Bezier curve keeps at least 2 points."),
    QT_TRANSLATE_NOOP("Core",
                      "The degree of a B-spline stays; convert it to a Bezier chain to raise it."),
    QT_TRANSLATE_NOOP("Core", "The curve is given by a formula and has no degree."),
    QT_TRANSLATE_NOOP("Core", "the defining polynomial cannot be told from zero"),
    QT_TRANSLATE_NOOP("Core", "none or an even number of roots too close to tell apart"),
    QT_TRANSLATE_NOOP("Core", "an odd number of roots too close to count; one is marked"),
    QT_TRANSLATE_NOOP("Core", "curvature is infinite here, of undecided sign"),
    QT_TRANSLATE_NOOP("Core", "the curve is too large or too small for double precision"),
    QT_TRANSLATE_NOOP("Core", "the formula is nested too deeply"),
    QT_TRANSLATE_NOOP("Core", "something is missing here"),
    QT_TRANSLATE_NOOP("Core", "a ) is missing"),
    QT_TRANSLATE_NOOP("Core", "there is no ( for this )"),
    QT_TRANSLATE_NOOP("Core", "this number is out of range"),
    QT_TRANSLATE_NOOP("Core", "this is not a number"),
    QT_TRANSLATE_NOOP("Core", "t cannot stand here: the domain of t must not depend on it"),
    QT_TRANSLATE_NOOP("Core", "a name begins with a letter"),
    QT_TRANSLATE_NOOP("Core", "a name has only letters a-z, digits and _"),
    QT_TRANSLATE_NOOP("Core", "the name is longer than 64 letters"),
    QT_TRANSLATE_NOOP("Core", "the name is taken already"),
    QT_TRANSLATE_NOOP("Core", "this is not a finite number"),
    QT_TRANSLATE_NOOP("Core", "this is beyond 1e15"),
    // flatland/scene/presets.cpp
    QT_TRANSLATE_NOOP("Core", "Thesis figure 3-4"),
    QT_TRANSLATE_NOOP("Core",
                      "Five control points, seen from the right: silhouettes, ridges, a valley, "
                      "inflections and apparent ridges on one curve."),
    QT_TRANSLATE_NOOP("Core", "Almost a circle"),
    QT_TRANSLATE_NOOP("Core",
                      "The four-piece circle of drawing programs: its curvature wavers by three "
                      "per cent, and so it has ridges that a circle has not."),
    QT_TRANSLATE_NOOP("Core", "S-curve"),
    QT_TRANSLATE_NOOP(
        "Core", "A cubic with one inflection; turn the view until the silhouettes meet in it."),
    QT_TRANSLATE_NOOP("Core", "Bump"),
    QT_TRANSLATE_NOOP("Core",
                      "A bump on a plain, seen from straight above: the foot of the bump shows "
                      "where the offset term moves an apparent ridge away from the ridge."),
    QT_TRANSLATE_NOOP("Core", "Cusp"),
    QT_TRANSLATE_NOOP("Core",
                      "A cubic whose speed vanishes at t = 1/2: the tangent turns back, a corner "
                      "of 180 degrees."),
    QT_TRANSLATE_NOOP("Core", "Loop"),
    QT_TRANSLATE_NOOP("Core",
                      "A curve that crosses itself and hides part of itself from the screen."),
    QT_TRANSLATE_NOOP("Core", "Examples"),
    QT_TRANSLATE_NOOP("Core", "Degenerate cases"),
    QT_TRANSLATE_NOOP("Core",
                      "One corner of 180 degrees at the tip, which is a silhouette too because the "
                      "image folds there, and one apparent minimum near the lower left end. No "
                      "ridge: at the tip curvature is infinite and changes sign."),
    // flatland/scene/degenerate_presets.cpp
    QT_TRANSLATE_NOOP("Core", "Pause on the way"),
    QT_TRANSLATE_NOOP("Core",
                      "x = u^3, y = u^4: the speed vanishes at u = 0, but the tangent does not "
                      "turn back, y = x^(4/3)."),
    QT_TRANSLATE_NOOP("Core",
                      "One valley and one apparent ridge, both at the lowest point, where "
                      "curvature is infinite. No corner: the tangent is continuous."),
    QT_TRANSLATE_NOOP("Core", "Points on a line"),
    QT_TRANSLATE_NOOP("Core",
                      "Four control points on a slanted line: curvature is 0 everywhere, so every "
                      "point would be an inflection."),
    QT_TRANSLATE_NOOP("Core", "No mark at all. The curve is listed as straight."),
    QT_TRANSLATE_NOOP("Core", "Line seen end-on"),
    QT_TRANSLATE_NOOP("Core",
                      "A straight curve seen along itself: its image is one point, and every point "
                      "would be a silhouette."),
    QT_TRANSLATE_NOOP("Core", "No mark at all. The curve is listed as straight and seen end-on."),
    QT_TRANSLATE_NOOP("Core", "Line that turns back"),
    QT_TRANSLATE_NOOP("Core",
                      "Three points on a line, the ends in the same place: there and back again."),
    QT_TRANSLATE_NOOP("Core",
                      "One corner of 180 degrees at the far end, a silhouette too. Both halves are "
                      "listed as straight."),
    QT_TRANSLATE_NOOP("Core", "All points equal"),
    QT_TRANSLATE_NOOP("Core", "Four control points in one place: a curve without length."),
    QT_TRANSLATE_NOOP("Core", "No mark at all. The curve is listed as a point."),
    QT_TRANSLATE_NOOP("Core", "Coincident control points"),
    QT_TRANSLATE_NOOP("Core", "The first two control points are one: the curve starts at speed 0."),
    QT_TRANSLATE_NOOP(
        "Core",
        "One ridge and one apparent ridge at the crest; one flat point and one apparent minimum "
        "before it. Nothing at the start: its curvature is infinite, but an end has no extremum."),
    QT_TRANSLATE_NOOP("Core", "Inflection at an end"),
    QT_TRANSLATE_NOOP("Core", "y = 4/9 x^3 from x = 0: curvature vanishes at the very start."),
    QT_TRANSLATE_NOOP("Core",
                      "One inflection at t = 0, one valley at x = (9/80)^(1/4) = 0.579 and one "
                      "apparent ridge at x = (3/16)^(1/4) = 0.658."),
    QT_TRANSLATE_NOOP("Core", "Silhouette at an inflection"),
    QT_TRANSLATE_NOOP("Core",
                      "y = 8/27 x^3 seen along its tangent at the origin: n.w touches 0 there and "
                      "keeps its sign, a double root."),
    QT_TRANSLATE_NOOP(
        "Core",
        "One silhouette and one inflection, both at t = 1/2; a valley and a ridge at x = -0.709 "
        "and 0.709. No apparent ridge: lambda only grows towards the silhouette."),
    QT_TRANSLATE_NOOP("Core", "Undulation"),
    QT_TRANSLATE_NOOP(
        "Core", "y = x^4: curvature touches 0 at the middle and keeps its sign, a double root."),
    QT_TRANSLATE_NOOP(
        "Core",
        "No inflection. A flat point and an apparent minimum with lambda = 0 at t = 1/2; valleys "
        "at x = -+(1/56)^(1/6) = 0.511, apparent ridges at x = -+(1/32)^(1/6) = 0.561."),
    QT_TRANSLATE_NOOP("Core", "Constant curvature"),
    QT_TRANSLATE_NOOP("Core",
                      "A true circle, given by its formula: k' is 0 everywhere, so every point "
                      "would be an extremum."),
    QT_TRANSLATE_NOOP("Core",
                      "Two silhouettes, left and right, and two apparent minima with lambda = 1, "
                      "facing the viewer and away. No ridge and no apparent ridge. The curve is "
                      "listed as of constant curvature."),
    QT_TRANSLATE_NOOP("Core", "Double root of k'"),
    QT_TRANSLATE_NOOP("Core",
                      "A curve that bends ever less from left to right; at the middle the loss "
                      "stops, k' = k'' = 0, and goes on."),
    QT_TRANSLATE_NOOP("Core",
                      "No ridge, valley or flat point: k' keeps its sign. One apparent minimum and "
                      "one apparent ridge, to the left and right of the middle."),
    QT_TRANSLATE_NOOP("Core", "Straight, then bent"),
    QT_TRANSLATE_NOOP("Core",
                      "A straight piece that goes over smoothly into a cubic: on the first k and "
                      "k' are 0 throughout."),
    QT_TRANSLATE_NOOP("Core",
                      "Nothing on the straight piece, which is listed as straight, and nothing at "
                      "the joint. On the cubic a valley, and a silhouette at its end."),
    QT_TRANSLATE_NOOP("Core", "Corner with a fold"),
    QT_TRANSLATE_NOOP("Core",
                      "Two straight pieces that meet at an angle; seen from the right the image "
                      "turns back at the corner."),
    QT_TRANSLATE_NOOP("Core",
                      "A corner of 119.7 degrees, which is a silhouette too; seen from above it is "
                      "the corner alone. Both pieces are listed as straight."),
    QT_TRANSLATE_NOOP("Core", "Curvature jumps"),
    QT_TRANSLATE_NOOP(
        "Core",
        "Two parabolas with a common tangent at the crest, where curvature jumps from 1 to 4."),
    QT_TRANSLATE_NOOP("Core",
                      "One ridge and one apparent ridge, both at the joint, with the larger of its "
                      "two curvatures: lambda = 16."),
};

}  // namespace

QString coreWords(const std::string& english) {
  return QCoreApplication::translate("Core", english.c_str());
}

}  // namespace flatland::ui
