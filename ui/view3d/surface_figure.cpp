// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_figure.h"

#include "core3d/draw/draughtsman.h"
#include "ui/export/drawing_figure.h"
#include "ui/export/figure_cells.h"
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

/// The groups of one part of a drawing, by another name.
std::vector<FigureGroup> groupsOf(const Drawing& drawing, const DrawingFigureOptions& options,
                                  const std::optional<Rgb>& colour, const std::string& name = {}) {
  std::vector<FigureGroup> groups = drawingFigure(drawing, options).groups;
  if (colour) recolour(groups, *colour);
  if (name.empty()) return groups;
  for (FigureGroup& group : groups) {
    const bool hidden = group.id.ends_with("hidden");
    group.id = name + (hidden ? "-hidden" : "-visible");
    group.classes = "lines " + name + (hidden ? " hidden" : " visible");
  }
  return groups;
}

/// Draws the views of one surface, which share what is prepared for it.
class Views {
 public:
  Views(const SurfacePicture& any, std::stop_token stop)
      : surface_(*any.surface),
        draughtsman_(*surface_.mesh, *surface_.fields),
        stop_(std::move(stop)) {}

  Figure figure(const SurfacePicture& picture, double width, double height) {
    const SurfaceSetting& setting = picture.setting;
    Figure figure;
    figure.width = width;
    figure.height = height;
    figure.background = sceneColours(picture.palette).background;
    DrawingFigureOptions options;
    options.hidden = figureHidden(hiddenOf(setting));
    options.colours = true;
    options.palette = picture.palette;
    const Projection looking = projection(picture.pane.camera, width, height);
    figure.groups = picture.pane.difference ? differenceGroups(picture, looking, options)
                                            : familyGroups(picture, looking, options);
    return figure;
  }

 private:
  Projection projection(const SurfaceCamera& camera, double width, double height) const {
    return orbitProjection(camera, surface_.ballRadius, width, height);
  }

  StrokeOptions strokesOf(const SurfacePicture& picture) const {
    StrokeOptions strokes;
    strokes.hidden = hiddenOf(picture.setting) != HiddenLines::Off;
    strokes.stop = stop_;
    return strokes;
  }

  std::vector<FigureGroup> familyGroups(const SurfacePicture& picture, const Projection& looking,
                                        DrawingFigureOptions options) {
    const PaneSetting& pane = picture.pane;
    const SurfaceView found = projection(pane.surface.camera, looking.width, looking.height).view();
    StrokeOptions strokes = strokesOf(picture);
    LineOptions lines = lineOptionsOf(pane);
    if (pane.ownCamera) {
      // The ink is that of the first camera's picture.
      lines.threshold = lineOptionsOf(picture.setting).threshold;
    } else {
      strokes.ink = pane.surface.ink;
    }
    const Drawing drawing = draughtsman_.draw(looking, found, lines, strokes);
    options.threshold = drawing.weak;
    std::vector<FigureGroup> all;
    for (const LineFamily family : allLineFamilies()) {
      const SurfaceFamily look = familyOf(picture.setting, family);
      options.widthPx = look.widthPx;
      const bool fades = look.fade && !picture.setting.unfiltered;
      options.style =
          fades ? DrawingFigureOptions::Style::Fade : DrawingFigureOptions::Style::Plain;
      for (FigureGroup& group : groupsOf(onlyOf(drawing, family), options, rgbOf(look.colour))) {
        all.push_back(std::move(group));
      }
    }
    return all;
  }

  std::vector<FigureGroup> differenceGroups(const SurfacePicture& picture,
                                            const Projection& looking,
                                            DrawingFigureOptions options) {
    // Each part stands for a family without a threshold, so that no piece is filtered.
    constexpr LineFamily kAny = LineFamily::Topographic;
    const char* const names[] = {"difference-common", "difference-added", "difference-missing"};
    LineOptions lines;
    lines[kAny] = true;
    lines.unfiltered = true;
    options.widthPx = SurfaceFamily{}.widthPx;
    std::vector<FigureGroup> all;
    for (std::size_t part = 0; part < SeenDifference::kParts; ++part) {
      FeatureLines found;
      found.of(kAny) = picture.seen->difference->pieces[part];
      const Drawing drawing = draughtsman_.draw(looking, found, lines, strokesOf(picture));
      const Rgb colour = differenceColour(part, picture.palette);
      for (FigureGroup& group : groupsOf(drawing, options, colour, names[part])) {
        all.push_back(std::move(group));
      }
    }
    return all;
  }

  const LoadedSurface& surface_;
  Draughtsman draughtsman_;
  std::stop_token stop_;
};

}  // namespace

Figure surfaceFigure(const std::vector<SurfacePicture>& pictures, const QSize& size,
                     std::stop_token stop) {
  Views views(pictures.front(), std::move(stop));
  std::vector<FigureCell> cells;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const CellPlace place = cellPlace(i, pictures.size(), size.width(), size.height());
    cells.push_back({views.figure(pictures[i], place.width, place.height), pictures[i].title});
  }
  return sideBySide(std::move(cells), size.width(), size.height(),
                    sceneColours(pictures.front().palette).text);
}

}  // namespace flatland::ui
