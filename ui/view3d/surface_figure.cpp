// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_figure.h"

#include "core3d/draw/draughtsman.h"
#include "ui/export/drawing_figure.h"
#include "ui/model/orbit.h"

namespace flatland::ui {

namespace {

DrawingFigureOptions::Hidden figureHidden(HiddenLines hidden) {
  switch (hidden) {
    case HiddenLines::Off:
      return DrawingFigureOptions::Hidden::Remove;
    case HiddenLines::Dashed:
      return DrawingFigureOptions::Hidden::Dash;
    case HiddenLines::Shown:
      break;
  }
  return DrawingFigureOptions::Hidden::Show;
}

/// The polylines of one family, as a drawing of its own.
Drawing onlyOf(const Drawing& drawing, LineFamily family) {
  Drawing part;
  part.projection = drawing.projection;
  for (const Polyline& line : drawing.polylines) {
    if (line.family == family) part.polylines.push_back(line);
  }
  return part;
}

/// What a family of the window looks like that has a colour of its own.
void recolour(std::vector<FigureGroup>& groups, Rgb colour) {
  for (FigureGroup& group : groups) {
    for (Shape& shape : group.shapes) {
      auto* path = std::get_if<PathShape>(&shape);
      if (path && path->stroke) path->stroke->colour = colour;
    }
  }
}

}  // namespace

Figure surfaceFigure(const SurfacePicture& picture, const QSize& size, std::stop_token stop) {
  const LoadedSurface& surface = *picture.surface;
  const SurfaceSetting& setting = picture.setting;
  const Projection projection =
      orbitProjection(setting.camera, surface.ballRadius, size.width(), size.height());
  StrokeOptions strokes;
  strokes.hidden = hiddenOf(setting) != HiddenLines::Off;
  strokes.stop = std::move(stop);
  const LineOptions lines = lineOptionsOf(setting);
  const Drawing drawing =
      Draughtsman(*surface.mesh, *surface.fields).draw(projection, lines, strokes);

  DrawingFigureOptions options;
  options.hidden = figureHidden(hiddenOf(setting));
  options.colours = true;
  options.palette = picture.palette;
  options.threshold = lines.threshold;
  Figure figure = drawingFigure(onlyOf(drawing, LineFamily::ExteriorSilhouette), options);
  figure.width = size.width();
  figure.height = size.height();
  figure.groups.clear();
  for (const LineFamily family : allLineFamilies()) {
    const SurfaceFamily look = familyOf(setting, family);
    options.widthPx = look.widthPx;
    const bool fades = look.fade && !setting.unfiltered;
    options.style = fades ? DrawingFigureOptions::Style::Fade : DrawingFigureOptions::Style::Plain;
    std::vector<FigureGroup> groups = drawingFigure(onlyOf(drawing, family), options).groups;
    if (const std::optional<Rgb> own = rgbOf(look.colour)) recolour(groups, *own);
    for (FigureGroup& group : groups) figure.groups.push_back(std::move(group));
  }
  return figure;
}

}  // namespace flatland::ui
