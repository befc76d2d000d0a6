// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/drawing_figure.h"

#include <algorithm>
#include <cmath>

#include "ui/export/line_style.h"

namespace flatland::ui {

namespace {

using Options = DrawingFigureOptions;

constexpr double kFullStrength = 4.0;     // times the threshold
constexpr double kLeastWeight = 0.3;      // of a stroke that just reaches the threshold
constexpr double kTipLengthWidths = 8.0;  // a tapered end, in stroke widths
constexpr double kTipWidth = 0.15;        // of the stroke's width, where it begins
constexpr double kHiddenWidth = 0.6;      // of a visible stroke's

double median(std::vector<float> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// From kLeastWeight at the threshold to 1 at kFullStrength times it.
double weightOf(double strength, double threshold) {
  if (!(threshold > 0.0)) return 1.0;
  const double along = (strength / threshold - 1.0) / (kFullStrength - 1.0);
  return kLeastWeight + (1.0 - kLeastWeight) * std::clamp(along, 0.0, 1.0);
}

PathData pathOf(const Polyline& line) {
  PathData path;
  for (std::size_t i = 0; i < line.screen.size(); ++i) {
    if (i == 0) {
      path.moveTo(line.screen[i]);
    } else {
      path.lineTo(line.screen[i]);
    }
  }
  if (line.closed) path.close();
  return path;
}

/// Lengths along the stroke to each point.
std::vector<double> lengthsAlong(const std::vector<Vec2>& points) {
  std::vector<double> along{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    along.push_back(along.back() + (points[i] - points[i - 1]).norm());
  }
  return along;
}

/// The outline of a stroke whose full width at point i is widths[i]: down one side and up the
/// other. At bends the sides are moved along the mean of the two normals.
PathData outlineOf(const std::vector<Vec2>& points, const std::vector<double>& widths,
                   bool closed) {
  const std::size_t count = points.size();
  const auto direction = [&](std::size_t from, std::size_t to) -> Vec2 {
    const Vec2 d = points[to] - points[from];
    const double length = d.norm();
    return length > 0.0 ? Vec2(d / length) : Vec2(0.0, 0.0);
  };
  std::vector<Vec2> left, right;
  for (std::size_t i = 0; i < count; ++i) {
    Vec2 tangent(0.0, 0.0);
    if (i > 0 || closed) tangent += direction(i > 0 ? i - 1 : count - 1, i);
    if (i + 1 < count || closed) tangent += direction(i, i + 1 < count ? i + 1 : 0);
    const double length = tangent.norm();
    const Vec2 side =
        length > 0.0 ? Vec2(0.5 * widths[i] / length * rotateCcw(tangent)) : Vec2(0.0, 0.0);
    left.push_back(points[i] + side);
    right.push_back(points[i] - side);
  }
  PathData path;
  const auto add = [&path](const auto& from, const auto& to, bool first) {
    for (auto it = from; it != to; ++it) {
      if (first) {
        path.moveTo(*it);
      } else {
        path.lineTo(*it);
      }
      first = false;
    }
  };
  add(left.begin(), left.end(), true);
  if (closed) path.close();  // the band between two closed lines that run opposite ways
  add(right.rbegin(), right.rend(), closed);
  path.close();
  return path;
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
    // Contours come first in the enumeration and are drawn last, over the others.
    const auto families = allLineFamilies();
    for (const bool visible : {false, true}) {
      if (!visible && options_.hidden == Options::Hidden::Remove) continue;
      for (auto family = families.rbegin(); family != families.rend(); ++family) {
        addGroup(*family, visible);
      }
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
      group.shapes.emplace_back(shapeOf(line));
    }
    if (!group.shapes.empty()) figure_.groups.push_back(std::move(group));
  }

  PathShape shapeOf(const Polyline& line) const {
    const bool asHidden = !line.visible && options_.hidden == Options::Hidden::Dash;
    const double threshold = options_.threshold[static_cast<std::size_t>(line.family)];
    Rgb colour = options_.colours ? lineColour(line.family, options_.palette) : scene_.text;
    if (asHidden) {
      const double width = kHiddenWidth * options_.widthPx;
      return {pathOf(line), std::nullopt,
              Stroke{.colour = paler(colour, scene_.background),
                     .width = width,
                     .dash = {4.0 * width, 3.0 * width},
                     .roundJoins = true}};
    }
    if (options_.style == Options::Style::Taper) return tapered(line, colour, threshold);
    double width = options_.widthPx;
    const double weight = weightOf(median(line.strength), threshold);
    if (options_.style == Options::Style::Width) width *= weight;
    if (options_.style == Options::Style::Fade) colour = mixed(scene_.background, colour, weight);
    return {pathOf(line), std::nullopt,
            Stroke{.colour = colour, .width = width, .roundCaps = true, .roundJoins = true}};
  }

  PathShape tapered(const Polyline& line, Rgb colour, double threshold) const {
    const std::vector<double> along = lengthsAlong(line.screen);
    // A short stroke's tips meet in its middle.
    const double tip = std::min(kTipLengthWidths * options_.widthPx, 0.5 * along.back());
    std::vector<double> widths;
    for (std::size_t i = 0; i < line.screen.size(); ++i) {
      double width = options_.widthPx;
      if (i < line.strength.size()) width *= weightOf(line.strength[i], threshold);
      const double toEnd = std::min(along[i], along.back() - along[i]);
      if (!line.closed && toEnd < tip) width *= kTipWidth + (1.0 - kTipWidth) * toEnd / tip;
      widths.push_back(width);
    }
    return {outlineOf(line.screen, widths, line.closed), colour, std::nullopt};
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
