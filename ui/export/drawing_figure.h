// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core3d/draw/drawing.h"
#include "ui/export/figure.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

/// How a drawing of a mesh looks.
struct DrawingFigureOptions {
  enum class Hidden {
    Remove,  ///< hidden strokes are left out
    Dash,    ///< pale, thinner and dashed, below the visible ones
    Show,    ///< like the visible ones: the mesh is transparent
  };
  /// What strength does. It is taken relative to the family's threshold: weak strokes just reach
  /// it, at four times the threshold a stroke has its full weight. Families with threshold 0
  /// (contours, creases) always have it.
  enum class Style {
    Plain,  ///< nothing
    Width,  ///< a stroke's width, by its median strength
    Taper,  ///< the width along the stroke, with ends that run to a point: filled outlines
    Fade,   ///< a stroke's colour, by its median strength, pale when weak
  };
  Hidden hidden = Hidden::Remove;
  Style style = Style::Plain;
  double widthPx = 1.5;
  bool colours = false;  ///< a colour for each family (line_style.h), else all in that of text
  Palette palette = Palette::Light;
  bool transparent = false;
  std::array<double, kLineFamilyCount> threshold{};  ///< that the strengths were held against
};

/// The drawing with one group for each family and visibility that has strokes: id
/// "apparent-ridges-visible", classes "lines apparent-ridges visible". One path per stroke, in the
/// order of the drawing; hidden groups lie below. Coordinates are those of the drawing's screen.
Figure drawingFigure(const Drawing& drawing, const DrawingFigureOptions& options);

}  // namespace flatland::ui
