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
  /// What strength does (stroke_shape.h), between the family's threshold and four times that.
  /// Families with threshold 0 (contours) have their full weight everywhere.
  enum class Style {
    Plain,  ///< nothing
    Width,  ///< the width along a stroke: where it varies, a filled outline
    Taper,  ///< the same, and open ends run out to a point
    Fade,   ///< the colour of a stroke, by its mean: a figure has no gradients
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
/// order of the drawing; groups in the order of painting (line_style.h). Coordinates are those of
/// the drawing's screen.
Figure drawingFigure(const Drawing& drawing, const DrawingFigureOptions& options);

}  // namespace flatland::ui
