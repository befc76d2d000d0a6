// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/export/flat_figure.h"

// What the files of the flat figure share; not for others.
namespace flatland::ui {

/// Room for the letters beyond the screen, px.
inline constexpr double kLetterColumnPx = 22.0;

/// The options of the figure that becomes the one asked for when it is magnified by their scale.
FlatFigureOptions atUnitScale(FlatFigureOptions options);

/// Points of a curve, in order, and of all curves, close enough together for bounds and for keeping
/// letters off the curve.
std::vector<Vec2> sampledPoints(const SceneCurve& curve);
std::vector<Vec2> sampledPoints(const Scene& scene);

/// True if the viewer is near enough to be part of the picture.
bool showsViewer(const Scene& scene, const ScreenLine& screen);

/// Height of the legend's rows, px, 0 without a legend. It lists every kind that is switched on, so
/// that pictures of one scene from several sides are laid out alike.
double legendHeight(const Scene& scene, const FlatFigureOptions& options);

/// The legend's shapes at the bottom of the figure.
FigureGroup legend(const Scene& scene, const FlatFigureOptions& options);

}  // namespace flatland::ui
