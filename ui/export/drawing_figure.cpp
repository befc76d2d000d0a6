// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/drawing_figure.h"

#include <cmath>
#include <utility>

#include "core3d/draw/stroke_shape.h"
#include "ui/export/line_style.h"

namespace flatland::ui {

namespace {

using Options = DrawingFigureOptions;

constexpr double kFullStrength = 4.0;  // times the threshold
constexpr double kWeakest = 0.3;       // width or darkness of what just reaches the threshold
constexpr double kTaperWidths = 10.0;  // length of a pointed end
constexpr double kHiddenWidth = 0.6;   // of a visible stroke's

StrokeStyle strokeStyle(const Options& options) {
  StrokeStyle style{.widthPx = options.widthPx};
  if (options.style == Options::Style::Fade) {
    style.leastDarkness = kWeakest;
  } else if (options.style != Options::Style::Plain) {
    style.leastWidth = kWeakest;
  }
  if (options.style == Options::Style::Taper) style.taperPx = kTaperWidths * options.widthPx;
  return style;
}

/// Along the stroke, each point alike.
double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 1.0 : sum / static_cast<double>(values.size());
}

void addPolygon(PathData& path, const std::vector<Vec2>& points, bool closed) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0) {
      path.moveTo(points[i]);
    } else {
      path.lineTo(points[i]);
    }
  }
  if (closed) path.close();
}

class Builder {
 public:
  Builder(const Drawing& drawing, const Options& options)
      : drawing_(drawing), options_(options), scene_(sceneColours(options.palette)) {
    figure_.width = drawing.projection.width;
    figure_.height = drawing.projection.height;
    if (!options.transparent) figure_.background = scene_.background;
  }

  Figure build() {
    for (const bool visible : {false, true}) {
      if (!visible && options_.hidden == Options::Hidden::Remove) continue;
      for (const LineFamily family : paintingOrder()) addGroup(family, visible);
    }
    return std::move(figure_);
  }

 private:
  void addGroup(LineFamily family, bool visible) {
    FigureGroup group;
    const std::string name(nameOf(family)), seen = visible ? "visible" : "hidden";
    group.id = name + "-" + seen;
    group.classes = "lines " + name + " " + seen;
    for (const Polyline& line : drawing_.polylines) {
      if (line.family != family || line.visible != visible || line.screen.size() < 2) continue;
      group.shapes.emplace_back(drawn(line));
    }
    if (!group.shapes.empty()) figure_.groups.push_back(std::move(group));
  }

  PathShape drawn(const Polyline& line) const {
    Rgb colour = options_.colours ? lineColour(line.family, options_.palette) : scene_.text;
    PathData path;
    if (!line.visible && options_.hidden == Options::Hidden::Dash) {
      const double width = kHiddenWidth * options_.widthPx;
      addPolygon(path, line.screen, line.closed);
      return {std::move(path), std::nullopt,
              Stroke{.colour = paler(colour, scene_.background),
                     .width = width,
                     .dash = {4.0 * width, 3.0 * width},
                     .roundJoins = true}};
    }
    const double threshold = options_.threshold[static_cast<std::size_t>(line.family)];
    const StrokeShape shape =
        shapeOf(line, strokeStyle(options_), threshold, kFullStrength * threshold);
    const bool outlined =
        options_.style == Options::Style::Width || options_.style == Options::Style::Taper;
    if (!shape.uniform && outlined) {
      for (const auto& polygon : outlineOf(shape)) addPolygon(path, polygon, true);
      return {std::move(path), colour, std::nullopt};
    }
    colour = mixed(scene_.background, colour, mean(shape.darkness));
    addPolygon(path, line.screen, line.closed);
    return {
        std::move(path), std::nullopt,
        Stroke{.colour = colour, .width = options_.widthPx, .roundCaps = true, .roundJoins = true}};
  }

  static Rgb mixed(Rgb from, Rgb to, double share) {
    const auto channel = [share](std::uint8_t a, std::uint8_t b) {
      return static_cast<std::uint8_t>(std::lround(a + share * (b - a)));
    };
    return {channel(from.r, to.r), channel(from.g, to.g), channel(from.b, to.b)};
  }

  const Drawing& drawing_;
  const Options& options_;
  const SceneColours& scene_;
  Figure figure_;
};

}  // namespace

Figure drawingFigure(const Drawing& drawing, const DrawingFigureOptions& options) {
  return Builder(drawing, options).build();
}

}  // namespace flatland::ui
