// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flatland/curve/vec2.h"

namespace flatland {

/// From where flatland is seen. `angleDeg` is the direction from the scene to the viewer,
/// counter-clockwise from +x. Orthographic without a distance; with one, the viewer stands
/// `distance` (length, > 0) away from the origin in that direction.
struct View {
  double angleDeg = 0.0;
  std::optional<double> distance;

  bool operator==(const View&) const = default;
};

/// The view as an orthonormal frame: `towards` points to the viewer (w), `axis` along the screen
/// (towards turned by -90 degrees), so (axis, towards) is right-handed.
struct ViewFrame {
  Vec2 axis;
  Vec2 towards;
  std::optional<double> distance;

  /// Position of the viewer; meaningful only in perspective. Precondition: distance is set.
  Vec2 eye() const { return *distance * towards; }
};

/// Frame of a view. Multiples of 90 degrees are exact, so axis-aligned scenes stay exact.
ViewFrame frameOf(const View& view);

/// Unit vector from the point towards the viewer (w). Zero at the viewer itself.
Vec2 towardsViewer(const ViewFrame& frame, const Vec2& point);

/// Coordinate of the point on the 1D screen, in length units along `axis`. Orthographic:
/// p . axis. Perspective: on the line through the origin, distance (p . axis) / (distance - p . w);
/// nullopt at or behind the viewer.
std::optional<double> screenCoordinate(const ViewFrame& frame, const Vec2& point);

/// How near the point is to the viewer, for "which is in front": larger is nearer. Comparable only
/// along one line of sight.
double nearness(const ViewFrame& frame, const Vec2& point);

/// The angle brought into (-180, 180].
double normalizedDeg(double angleDeg);

}  // namespace flatland
