// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QSize>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "ui/model/seen_surface.h"
#include "ui/model/surface_look.h"
#include "ui/view3d/mark_lines.h"
#include "ui/view3d/surface_models.h"

namespace flatland::ui {

/// Everything a picture of the surface is made from, as a value: for OpenGL, for a job, for a file.
struct SurfacePicture {
  std::shared_ptr<const LoadedSurface> surface;  ///< null: an empty picture
  std::shared_ptr<const SeenSurface> seen;       ///< null: no lines yet
  std::vector<MarkLines> marks;                  ///< predicted lines, a section
  std::shared_ptr<const BridgeView> bridge;      ///< whose lines are shown; null: none are
  std::shared_ptr<const SectionView> section;    ///< of this surface; null: none
  MarkKinds markKinds;                           ///< of the section that are shown
  SurfaceSetting setting;  ///< of this view alone; its camera is that it is looked at from
  Palette palette = Palette::Light;
  double lineScale = 1.0;  ///< of the widths

  /// The same as it was asked for: for vectors, which find their lines and solve for ink anew.
  PaneSetting pane;
  std::string title;  ///< of one of several views

  /// The colour map is there and asked for.
  const VertexColours* colours() const;
};

/// Lines that look alike.
struct LineLayer {
  const std::vector<LineVertex>* ends;  ///< of picture.seen; two in a row are a segment
  Rgb colour;
  double widthPx;
  double threshold;  ///< weak lines are paler; 0: none is
  /// So many ends are of lines that are seen, the rest is hidden. Empty: depth tells.
  std::optional<std::size_t> visibleEnds = {};
};

/// The lines of a picture, first drawn first. None if there are none of its surface.
std::vector<LineLayer> lineLayers(const SurfacePicture& picture);

/// What a part of a difference looks like, by SeenDifference::Part.
Rgb differenceColour(std::size_t part, Palette palette);

/// Adds the marks of bridges that are about its surface, in the colours of its palette.
void addMarks(SurfacePicture& picture, Bridges& bridges);

/// What all views show now, the first one first.
std::vector<SurfacePicture> picturesOf(const SurfaceModels& models);

/// What a view shows now.
SurfacePicture pictureOf(const SurfaceModels& models);

/// Colours of a style, each 0 to 1; the OpenGL picture and the painted one read the same.
struct ShadingColours {
  std::array<float, 3> background, base, dark, warm, cool;
};
ShadingColours shadingColours(Palette palette);

/// Direction of the light in the axes of the picture (right, up, towards the viewer), unit.
inline constexpr std::array<float, 3> kLight = {-0.348f, 0.447f, 0.824f};
/// How much nearer, in units of clip space, a line counts than the surface it lies on.
inline constexpr float kLineBias = 2e-3f;
inline constexpr float kDashPx = 4.0f;  ///< of hidden lines: a dash, and a gap, to right or upward
/// Opacity of lines that are hidden, dashed or not: the share that paler() keeps in files.
inline constexpr float kHiddenInk = 5.0f / 12.0f;

/// The picture without OpenGL, the same but for the smoothing of edges. Works in any thread and at
/// any size; about 50 ms a megapixel. Lines are `ratio` times as wide as they are in the window.
QImage paintSurface(const SurfacePicture& picture, const QSize& size, double ratio = 1.0);

/// Several of them side by side, with their titles (figure_cells.h), and with what the window has
/// beside them: marks and legends. `size` in pixels, of which `ratio` are one of the window.
QImage paintSurfaces(const std::vector<SurfacePicture>& pictures, const QSize& size,
                     double ratio = 1.0);

}  // namespace flatland::ui
