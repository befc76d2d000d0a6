// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/core_words.h"

#include <QCoreApplication>

#include "ui/model/core_sentences.h"

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
    // ui/export/line_style.cpp; the solids of ui/app/surface_menu.cpp
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
    // ui/export: the diagrams of sweep, study and limits
    QT_TRANSLATE_NOOP("Core", "Silhouettes"),
    QT_TRANSLATE_NOOP("Core", "Inflections"),
    QT_TRANSLATE_NOOP("Core", "Flat points"),
    QT_TRANSLATE_NOOP("Core", "Corners"),
    QT_TRANSLATE_NOOP("Core", "Apparent minima"),
    QT_TRANSLATE_NOOP("Core", "Born or merged"),
    QT_TRANSLATE_NOOP("Core", "view direction (orthographic)"),
    QT_TRANSLATE_NOOP("Core", "arc length"),
    QT_TRANSLATE_NOOP("Core", "no power law here"),
    QT_TRANSLATE_NOOP("Core", "predicted slope %1"),
    QT_TRANSLATE_NOOP("Core", "fitted %1"),
    QT_TRANSLATE_NOOP("Core", "medians of %1 curves"),
    QT_TRANSLATE_NOOP("Core", "%1 pairs"),
    QT_TRANSLATE_NOOP("Core", "median %1"),
    QT_TRANSLATE_NOOP("Core", "quartiles %1, %2"),
    QT_TRANSLATE_NOOP("Core", "thesis: 1/100,000"),
    QT_TRANSLATE_NOOP("Core", "square of side %1"),
    QT_TRANSLATE_NOOP("Core", "|offset| / |feature|"),
    QT_TRANSLATE_NOOP("Core", "|offset| / |feature|, the same curves in three kinds of unit"),
    QT_TRANSLATE_NOOP("Core",
                      "apparent ridge to its ridge or valley, on the screen / length of the curve"),
    QT_TRANSLATE_NOOP("Core", "arc-length"),
    QT_TRANSLATE_NOOP("Core", "parameter"),
    QT_TRANSLATE_NOOP("Core", "unnormalised"),
    // why a formula or a curve is refused
    QT_TRANSLATE_NOOP("Core", "there is no such function"),
    QT_TRANSLATE_NOOP("Core", "neither t, pi, e nor a constant"),
    QT_TRANSLATE_NOOP("Core", "the curve turns too often for its domain"),
    QT_TRANSLATE_NOOP("Core", "one argument"),
    QT_TRANSLATE_NOOP("Core", "two arguments"),
    QT_TRANSLATE_NOOP("Core", "a closed chain needs at least 2 points"),
    QT_TRANSLATE_NOOP("Core", "the largest weight is more than a million times the smallest"),
    // why a file is refused, and parts of such sentences (core_sentences.cpp)
    QT_TRANSLATE_NOOP("Core", "top level"),
    QT_TRANSLATE_NOOP("Core", "the file is empty"),
    QT_TRANSLATE_NOOP("Core", "not UTF-8 text"),
    QT_TRANSLATE_NOOP("Core", "cannot be read"),
    QT_TRANSLATE_NOOP("Core", "cannot be written"),
    QT_TRANSLATE_NOOP("Core", "cannot be written to the end"),
    QT_TRANSLATE_NOOP("Core", "No such file or directory"),
    QT_TRANSLATE_NOOP("Core", "Permission denied"),
    QT_TRANSLATE_NOOP("Core", "Is a directory"),
    QT_TRANSLATE_NOOP("Core", "Not a directory"),
    QT_TRANSLATE_NOOP("Core", "No space left on device"),
    QT_TRANSLATE_NOOP("Core", "Read-only file system"),
    QT_TRANSLATE_NOOP("Core", "larger than 64 MiB, too large for a scene"),
    QT_TRANSLATE_NOOP("Core", "larger than 16 MiB, too large for a drawing"),
    QT_TRANSLATE_NOOP("Core", "larger than 1 MiB, too large for a lesson"),
    QT_TRANSLATE_NOOP("Core", "missing \"flatland\": 1, which marks a scene and its version"),
    QT_TRANSLATE_NOOP("Core", "missing \"curves\""),
    QT_TRANSLATE_NOOP("Core", "not a finite number"),
    QT_TRANSLATE_NOOP("Core", "expected 2 numbers [x, y]"),
    QT_TRANSLATE_NOOP("Core", "an object"),
    QT_TRANSLATE_NOOP("Core", "a number"),
    QT_TRANSLATE_NOOP("Core", "a string"),
    QT_TRANSLATE_NOOP("Core", "a number or a string"),
    QT_TRANSLATE_NOOP("Core", "true or false"),
    QT_TRANSLATE_NOOP("Core", "a list"),
    QT_TRANSLATE_NOOP("Core", "a list of points [x, y]"),
    QT_TRANSLATE_NOOP("Core", "a point [x, y]"),
    QT_TRANSLATE_NOOP("Core", "a list of curves"),
    QT_TRANSLATE_NOOP("Core", "null"),
    QT_TRANSLATE_NOOP("Core", "is compressed; unpack it first (gunzip -c x.svgz > x.svg)"),
    QT_TRANSLATE_NOOP("Core", "has no curve to show"),
    QT_TRANSLATE_NOOP("Core", "has coordinates beyond 1e50, the largest supported"),
    QT_TRANSLATE_NOOP("Core", "is too small to be seen"),
    QT_TRANSLATE_NOOP("Core", "there are no fonts here"),
    QT_TRANSLATE_NOOP("Core", "is a font without outlines"),
    QT_TRANSLATE_NOOP("Core", "has no outline, it is blank"),
    QT_TRANSLATE_NOOP("Core", "expected one character after the family's name"),
    QT_TRANSLATE_NOOP("Core", "expected a code such as U+0061 after U+"),
    QT_TRANSLATE_NOOP("Core", "no picture of this size can be made"),
    QT_TRANSLATE_NOOP("Core", "the end"),
    QT_TRANSLATE_NOOP("Core", "no title, \"# ...\""),
    QT_TRANSLATE_NOOP("Core", "no step, \"## ...\""),
    QT_TRANSLATE_NOOP("Core", "a block before the first step"),
    QT_TRANSLATE_NOOP("Core", "a second block in one step"),
    QT_TRANSLATE_NOOP("Core", "the block is not closed by ```"),
    QT_TRANSLATE_NOOP("Core", "the block is empty"),
    QT_TRANSLATE_NOOP("Core", "a step without a title"),
    QT_TRANSLATE_NOOP("Core", "expected a text"),
    QT_TRANSLATE_NOOP("Core", "expected a number"),
    QT_TRANSLATE_NOOP("Core", "expected true or false"),
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
    // core3d/study/bridge_lines.cpp
    QT_TRANSLATE_NOOP("Core", "the line has to be there"),
    QT_TRANSLATE_NOOP("Core",
                      "the surface faces away: ridges are looked for on the side that is seen"),
    QT_TRANSLATE_NOOP(
        "Core", "the parallel turns the normal as much as the meridian: no circle is a maximum"),
    QT_TRANSLATE_NOOP("Core", "the axis is within 4 edges: parallels shrink to a point"),
    QT_TRANSLATE_NOOP(
        "Core", "a corner, cusp or jump of curvature is within 4 edges: the surface is not smooth"),
    QT_TRANSLATE_NOOP("Core", "a border is within 4 edges: curvature is estimated from one side"),
    QT_TRANSLATE_NOOP("Core",
                      "a silhouette is within 4 edges, or n.w is below 0.05: lambda grows without "
                      "bound there"),
    QT_TRANSLATE_NOOP("Core",
                      "the radius of curvature is below 4 edges, here or within 4 edges: the mesh "
                      "is too coarse for the bend"),
    QT_TRANSLATE_NOOP(
        "Core", "lambda falls by less than twice what a line must have: a plain with noise on it"),
    QT_TRANSLATE_NOOP(
        "Core",
        "a perspective view turns from place to place; the bridge needs an orthographic one"),
    QT_TRANSLATE_NOOP("Core", "an extrusion seen along its rulings is a silhouette throughout"),
    QT_TRANSLATE_NOOP(
        "Core", "a surface of revolution has to be seen along its axis, from 0,1,0 or 0,-1,0"),
    // ui/export/convergence_figure.cpp
    QT_TRANSLATE_NOOP(
        "Core", "%1: median distance to the exact apparent ridge against the mean edge length"),
    QT_TRANSLATE_NOOP("Core", "Bridge"),
    QT_TRANSLATE_NOOP("Core", "1 edge"),
    QT_TRANSLATE_NOOP("Core", "%1 curvature, %2 derivative"),
    QT_TRANSLATE_NOOP("Core", ", order %1"),
    QT_TRANSLATE_NOOP("Core", "jet"),
    QT_TRANSLATE_NOOP("Core", "one-ring"),
    QT_TRANSLATE_NOOP("Core", "closed-form"),
    // ui/model/cutting_plane.cpp, loaded_surface.cpp
    QT_TRANSLATE_NOOP("Core",
                      "the plane is seen head-on: no direction within it leads to the viewer"),
    QT_TRANSLATE_NOOP("Core", "swept curve"),
};

}  // namespace

QString coreWords(const std::string& english) {
  const QString text = QCoreApplication::translate("Core", english.c_str());
  if (text != QString::fromStdString(english)) return text;
  return sentenceInWords(QString::fromStdString(english)).value_or(text);
}

FigureWords wordsOfTheWindow() {
  return [](const std::string& english) { return coreWords(english).toStdString(); };
}

}  // namespace flatland::ui
