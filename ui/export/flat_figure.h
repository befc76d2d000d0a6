// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "flatland/features/features.h"
#include "flatland/screen/visibility.h"
#include "ui/export/figure.h"
#include "ui/export/figure_words.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

/// From the plane (scene lengths, y up) to the figure (px, y down).
struct FigureTransform {
  double scale = 1.0;          ///< px per scene length, > 0
  Vec2 origin = Vec2::Zero();  ///< where the world's origin falls, px

  Vec2 operator()(const Vec2& world) const {
    return {origin.x() + scale * world.x(), origin.y() - scale * world.y()};
  }
};

/// What the picture of a scene shows.
struct FlatFigureOptions {
  double width = 640.0, height = 480.0;  ///< px, both > 0
  double margin = 12.0;                  ///< px, kept free at every side when fitting
  double scale = 1.0;  ///< how much larger than usual symbols, letters and lines are; > 0

  /// Given: the scene is drawn so, and what lies outside the figure is cut. Empty: it is fitted,
  /// with its screen and letters.
  std::optional<FigureTransform> transform;

  /// How far from the origin towards the viewer the screen is drawn, in scene lengths. Empty: see
  /// screenLine().
  std::optional<double> screenOffset;

  /// Given: an eye is painted there by another, px; letters keep clear of it as of the figure's
  /// own.
  std::optional<Vec2> eye;

  MarkKinds kinds = defaultMarkKinds();
  Palette palette = Palette::Light;
  enum class Hidden { Pale, Remove } hidden = Hidden::Pale;
  bool controlPolygon = false;
  bool letters = true;
  bool legend = true;
  bool transparent = false;
  FigureWords words;  ///< of the legend
};

/// The screen as it is drawn: the points s axis + offset towards of the view's frame, s from `low`
/// to `high`. Scene lengths.
struct ScreenLine {
  double offset = 0.0;
  double low = 0.0, high = 0.0;
};

/// Where the screen stands: beyond the curves (with `controlPoints`, beyond those too) on the
/// viewer's side, clear of them by a part of their size; in perspective before the viewer. Long
/// enough for the image of the curves, within reason where they come near the viewer. `offset`
/// overrides the place. A scene without extent counts as one of size 1.
ScreenLine screenLine(const Scene& scene, bool controlPoints,
                      const std::optional<double>& offset = std::nullopt);

/// The place on the screen line where the point is seen; nullopt at or behind the viewer.
std::optional<Vec2> pointOnScreen(const ViewFrame& frame, const ScreenLine& screen,
                                  const Vec2& point);

/// The transform that fits curves, screen, letters and, if it is not too far off, the viewer into
/// the size asked for.
FigureTransform fittedTransform(const Scene& scene, const FlatFigureOptions& options);

/// The picture of a scene: curves (hidden parts paler), screen, image on the screen, marks with
/// letters on both, projecting lines. `features` and `visibility` must be those of `scene`.
/// Groups from below: control-polygon, rays-<kind>[-hidden], sight, curve-hidden, curve, screen,
/// image, marks-<kind>[-hidden], letters-<kind>[-hidden], viewer, legend; empty ones are left out.
/// Lines longer than the figure are cut to it, so any zoom is safe. A letter that would cover
/// another, a symbol or the eye is left out. Where the letters do not all fit side by side along
/// the screen, the letters and projecting lines of hidden marks are left out; symbols stay. Zooming
/// in brings them back. Cost: about a millisecond for a few curves.
Figure flatFigure(const Scene& scene, const FeatureSet& features, const Visibility& visibility,
                  const FlatFigureOptions& options);

}  // namespace flatland::ui
