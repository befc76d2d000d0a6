// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/surface_figure.h"

#include <algorithm>

#include "core3d/draw/draughtsman.h"
#include "core3d/study/drawn_segments.h"
#include "ui/export/drawing_figure.h"
#include "ui/export/figure_cells.h"
#include "ui/export/line_style.h"
#include "ui/model/orbit.h"
#include "ui/view3d/mark_groups.h"

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

bool isHidden(const FigureGroup& group) { return group.id.ends_with("-hidden"); }

/// The groups of one part of a drawing, by another name.
std::vector<FigureGroup> groupsOf(const Drawing& drawing, const DrawingFigureOptions& options,
                                  const std::optional<Rgb>& colour, const std::string& name = {}) {
  std::vector<FigureGroup> groups = drawingFigure(drawing, options).groups;
  if (colour) recolour(groups, *colour);
  if (name.empty()) return groups;
  for (FigureGroup& group : groups) {
    const bool hidden = isHidden(group);
    group.id = name + (hidden ? "-hidden" : "-visible");
    group.classes = "lines " + name + (hidden ? " hidden" : " visible");
  }
  return groups;
}

/// The strokes of lines that are no family, under a name of their own: "predicted-contours" gives
/// groups "predicted-contours-visible" and "-hidden".
struct NamedLines {
  std::string name, classes;
  Rgb colour;
  double widthPx;
  std::vector<double> dash = {};  ///< in widths, of what is visible
};

std::vector<FigureGroup> groupsOf(const Drawing& drawing, DrawingFigureOptions options,
                                  const NamedLines& lines) {
  options.widthPx = lines.widthPx;
  options.style = DrawingFigureOptions::Style::Plain;
  std::vector<FigureGroup> groups = drawingFigure(drawing, options).groups;
  for (FigureGroup& group : groups) {
    const bool hidden = isHidden(group);
    const std::string seen = hidden ? "hidden" : "visible";
    group.id = lines.name + "-" + seen;
    group.classes = "lines " + lines.classes + " " + seen;
    const bool pale = hidden && options.hidden == DrawingFigureOptions::Hidden::Dash;
    for (Shape& shape : group.shapes) {
      auto* path = std::get_if<PathShape>(&shape);
      if (!path || !path->stroke) continue;
      path->stroke->colour =
          pale ? paler(lines.colour, sceneColours(options.palette).background) : lines.colour;
      if (pale || lines.dash.empty()) continue;
      path->stroke->roundCaps = false;  // they would close the gaps
      for (const double part : lines.dash) path->stroke->dash.push_back(part * lines.widthPx);
    }
  }
  return groups;
}

/// The polylines of some levels, as a drawing of its own.
template <class Wanted>
Drawing onlyOfLevels(const Drawing& drawing, const Wanted& wanted) {
  Drawing part;
  part.projection = drawing.projection;
  for (const Polyline& line : drawing.polylines) {
    if (wanted(line.level)) part.polylines.push_back(line);
  }
  return part;
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
    // As in the window: lines that are no family below the others, hidden ones below all that is
    // visible, marks above all.
    const auto add = [&figure](std::vector<FigureGroup> groups) {
      for (FigureGroup& group : groups) figure.groups.push_back(std::move(group));
    };
    add(predictedGroups(picture, looking, options));
    add(sectionGroups(picture, looking, options));
    add(picture.pane.difference ? differenceGroups(picture, looking, options)
                                : familyGroups(picture, looking, options));
    std::stable_partition(figure.groups.begin(), figure.groups.end(),
                          [](const FigureGroup& group) { return isHidden(group); });
    add(markGroups(picture, looking, 1.0));
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
    for (const LineFamily family : paintingOrder()) {
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

  /// Lines that stand for a family without a threshold, so that no piece is filtered.
  Drawing drawn(const SurfacePicture& picture, const Projection& looking, LineFamily family,
                std::vector<LineSegment> segments) {
    LineOptions lines;
    lines[family] = true;
    lines.unfiltered = true;
    FeatureLines found;
    found.of(family) = std::move(segments);
    return draughtsman_.draw(looking, found, lines, strokesOf(picture));
  }

  std::vector<FigureGroup> predictedGroups(const SurfacePicture& picture, const Projection& looking,
                                           const DrawingFigureOptions& options) {
    // While a curve is dragged, prediction and mesh may be of two curves.
    if (!picture.bridge || picture.bridge->seen->surface->mesh != surface_.mesh) return {};
    const BridgeView& bridge = *picture.bridge;
    const std::vector<PredictedLine>& lines = bridge.prediction.lines();
    std::vector<FigureGroup> all;
    const struct {
      MarkKind kind;
      LineFamily family;  ///< whose visibility it has: both lie on the smooth surface
      const char* name;
    } kinds[] = {{MarkKind::ApparentRidge, LineFamily::Isophotes, "apparent-ridges"},
                 {MarkKind::Silhouette, LineFamily::OccludingContours, "contours"}};
    for (const auto& [kind, family, name] : kinds) {
      std::vector<LineSegment> segments;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].kind != kind) continue;
        for (const LineSegment& segment : segmentsOf(lines[i], surface_.swept->mesh, *surface_.mesh,
                                                     static_cast<std::uint32_t>(i))) {
          segments.push_back(segment);
        }
      }
      const Drawing drawing = drawn(picture, looking, family, std::move(segments));
      for (const bool limited : {true, false}) {
        Rgb colour = predictedColour(kind, picture.palette);
        if (limited) colour = paler(colour, sceneColours(picture.palette).background);
        const std::string classes = std::string("predicted ") + name + (limited ? " limited" : "");
        const NamedLines named{std::string("predicted-") + name + (limited ? "-limited" : ""),
                               classes,
                               colour,
                               kPredictedWidthPx,
                               {kPredictedDash.begin(), kPredictedDash.end()}};
        const Drawing part = onlyOfLevels(drawing, [&](std::uint32_t level) {
          return (bridge.limits[level] != BridgeLimit::None) == limited;
        });
        for (FigureGroup& group : groupsOf(part, options, named)) all.push_back(std::move(group));
      }
    }
    return all;
  }

  std::vector<FigureGroup> sectionGroups(const SurfacePicture& picture, const Projection& looking,
                                         const DrawingFigureOptions& options) {
    if (!picture.section) return {};
    const Drawing drawing = drawn(picture, looking, LineFamily::Topographic,
                                  segmentsOf(picture.section->section.slice, *surface_.mesh));
    return groupsOf(drawing, options,
                    {"section", "section", sectionColour(picture.palette), kSectionWidthPx});
  }

  std::vector<FigureGroup> differenceGroups(const SurfacePicture& picture,
                                            const Projection& looking,
                                            DrawingFigureOptions options) {
    const char* const names[] = {"difference-common", "difference-added", "difference-missing"};
    options.widthPx = SurfaceFamily{}.widthPx;
    std::vector<FigureGroup> all;
    for (std::size_t part = 0; part < SeenDifference::kParts; ++part) {
      const Drawing drawing =
          drawn(picture, looking, LineFamily::Topographic, picture.seen->difference->pieces[part]);
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
