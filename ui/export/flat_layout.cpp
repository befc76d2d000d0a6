// SPDX-License-Identifier: GPL-3.0-or-later
// Where things stand in the picture of a scene: the screen, and the scale that fits it all.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/export/flat_figure.h"
#include "ui/export/flat_parts.h"

namespace flatland::ui {

namespace {

// All relative to the size of the curves.
constexpr double kScreenGap = 0.22;        // between the curves and the screen
constexpr double kControlPointGap = 0.06;  // between control points and the screen
constexpr double kViewerGap = 0.2;         // between the screen and a viewer
constexpr double kScreenOverhang = 0.06;   // of the screen beyond the image, at each end
constexpr double kShortestScreen = 0.3;
constexpr double kFarthestImage = 0.35;  // of the image beyond the curves, in perspective
constexpr double kFarthestViewer = 3.0;  // beyond the screen, to be part of the picture

double sizeOf(const std::vector<Vec2>& points) {
  if (points.empty()) return 1.0;
  Vec2 low = points.front();
  Vec2 high = points.front();
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).norm();
  return size > 0.0 ? size : 1.0;
}

/// A world point and how much room it needs around it, px: left, top, right, bottom.
struct Padded {
  Vec2 world;
  Vec2 before, after;
};

struct Span {
  Vec2 low, high;
};

/// The box, px, all points fill at a scale, relative to the world's origin.
Span spanAt(const std::vector<Padded>& items, double scale) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Span span{Vec2::Constant(kInfinity), Vec2::Constant(-kInfinity)};
  for (const Padded& item : items) {
    const Vec2 at(scale * item.world.x(), -scale * item.world.y());
    span.low = span.low.cwiseMin(at - item.before);
    span.high = span.high.cwiseMax(at + item.after);
  }
  return span;
}

}  // namespace

FlatFigureOptions atUnitScale(FlatFigureOptions options) {
  const double scale = options.scale;
  options.scale = 1.0;
  options.width /= scale;
  options.height /= scale;
  options.margin /= scale;
  if (options.transform) {
    options.transform->scale /= scale;
    options.transform->origin /= scale;
  }
  if (options.eye) *options.eye /= scale;
  return options;
}

std::vector<Vec2> sampledPoints(const SceneCurve& curve) {
  constexpr int kPerPiece = 32;
  return sampledPoints(curve.shape, kPerPiece);
}

std::vector<Vec2> sampledPoints(const Scene& scene) {
  std::vector<Vec2> points;
  for (const SceneCurve& curve : scene.curves) {
    const std::vector<Vec2> more = sampledPoints(curve);
    points.insert(points.end(), more.begin(), more.end());
  }
  return points;
}

ScreenLine screenLine(const Scene& scene, bool controlPoints, const std::optional<double>& offset) {
  const ViewFrame frame = frameOf(scene.view);
  const std::vector<Vec2> points = sampledPoints(scene);
  const double size = sizeOf(points);
  const double limit = frame.distance.value_or(std::numeric_limits<double>::infinity());

  double nearest = points.empty() ? 0.0 : -std::numeric_limits<double>::infinity();
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Vec2& p : points) {
    const double along = p.dot(frame.towards);
    if (along < limit) nearest = std::max(nearest, along);
    low = std::min(low, p.dot(frame.axis));
    high = std::max(high, p.dot(frame.axis));
  }
  if (points.empty()) low = high = 0.0;

  ScreenLine screen;
  screen.offset = nearest + kScreenGap * size;
  if (controlPoints) {
    for (const SceneCurve& curve : scene.curves) {
      for (const Vec2& p : flatland::controlPoints(curve.shape)) {
        screen.offset = std::max(screen.offset, p.dot(frame.towards) + kControlPointGap * size);
      }
    }
  }
  screen.offset = std::min(screen.offset, limit - kViewerGap * size);
  if (offset) screen.offset = *offset;
  if (!std::isfinite(screen.offset)) screen.offset = 0.0;  // every point is behind the viewer

  screen.low = low;
  screen.high = high;
  if (frame.distance) {
    const double far = kFarthestImage * size;
    double imageLow = std::numeric_limits<double>::infinity();
    double imageHigh = -imageLow;
    for (const Vec2& p : points) {
      if (const std::optional<Vec2> seen = pointOnScreen(frame, screen, p)) {
        const double s = seen->dot(frame.axis);
        imageLow = std::min(imageLow, std::clamp(s, low - far, high + far));
        imageHigh = std::max(imageHigh, std::clamp(s, low - far, high + far));
      }
    }
    if (imageLow <= imageHigh) {
      screen.low = imageLow;
      screen.high = imageHigh;
    }
  }
  const double length = std::max(screen.high - screen.low, kShortestScreen * size);
  const double middle = 0.5 * (screen.low + screen.high);
  screen.low = middle - 0.5 * length - kScreenOverhang * size;
  screen.high = middle + 0.5 * length + kScreenOverhang * size;
  return screen;
}

std::optional<Vec2> pointOnScreen(const ViewFrame& frame, const ScreenLine& screen,
                                  const Vec2& point) {
  double s = point.dot(frame.axis);
  if (frame.distance) {
    const double depth = *frame.distance - point.dot(frame.towards);
    if (!(depth > 0.0)) return std::nullopt;
    s *= (*frame.distance - screen.offset) / depth;
  }
  return s * frame.axis + screen.offset * frame.towards;
}

bool showsViewer(const Scene& scene, const ScreenLine& screen) {
  const ViewFrame frame = frameOf(scene.view);
  if (!frame.distance) return false;
  return *frame.distance - screen.offset <= kFarthestViewer * sizeOf(sampledPoints(scene));
}

FigureTransform fittedTransform(const Scene& scene, const FlatFigureOptions& options) {
  if (options.scale != 1.0) {
    const FigureTransform small = fittedTransform(scene, atUnitScale(options));
    return {small.scale * options.scale, small.origin * options.scale};
  }
  const ViewFrame frame = frameOf(scene.view);
  const ScreenLine screen = screenLine(scene, options.controlPolygon, options.screenOffset);

  std::vector<Padded> items;
  const Vec2 letterRoom = Vec2::Constant(options.letters ? 20.0 : 8.0);
  for (const Vec2& p : sampledPoints(scene)) items.push_back({p, letterRoom, letterRoom});
  if (options.controlPolygon) {
    for (const SceneCurve& curve : scene.curves) {
      for (const Vec2& p : flatland::controlPoints(curve.shape)) {
        items.push_back({p, Vec2::Constant(5.0), Vec2::Constant(5.0)});
      }
    }
  }
  const Vec2 beyond = kLetterColumnPx * Vec2(frame.towards.x(), -frame.towards.y());
  const Vec2 letterHalf = Vec2::Constant(8.0);
  for (const double s : {screen.low, screen.high}) {
    const Vec2 end = s * frame.axis + screen.offset * frame.towards;
    items.push_back({end, letterHalf + (-beyond).cwiseMax(0.0), letterHalf + beyond.cwiseMax(0.0)});
  }
  if (showsViewer(scene, screen)) {
    items.push_back({frame.eye(), Vec2::Constant(20.0), Vec2::Constant(20.0)});
  }

  // The box grows with the scale, so bisection finds the largest that fits, below the one at which
  // the bare points fill the room.
  const Vec2 room(
      std::max(options.width - 2.0 * options.margin, 1.0),
      std::max(options.height - 2.0 * options.margin - legendHeight(scene, options), 1.0));
  Vec2 bareLow = items.front().world;
  Vec2 bareHigh = bareLow;
  for (const Padded& item : items) {
    bareLow = bareLow.cwiseMin(item.world);
    bareHigh = bareHigh.cwiseMax(item.world);
  }
  double low = 0.0;
  double high = room.maxCoeff() / (bareHigh - bareLow).maxCoeff();  // the screen has some length
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const Span span = spanAt(items, middle);
    ((span.high - span.low - room).maxCoeff() <= 0.0 ? low : high) = middle;
  }
  // A figure too small for its letters still shows something.
  const double scale = low > 0.0 ? low : high;
  const Span span = spanAt(items, scale);
  const Vec2 middle = Vec2::Constant(options.margin) + 0.5 * room;
  return {scale, middle - 0.5 * (span.low + span.high)};
}

}  // namespace flatland::ui
