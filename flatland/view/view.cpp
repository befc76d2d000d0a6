// SPDX-License-Identifier: MIT
#include "flatland/view/view.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace flatland {

double normalizedDeg(double angleDeg) {
  const double a = std::remainder(angleDeg, 360.0);  // exact, in [-180, 180]
  return a == -180.0 ? 180.0 : a;
}

ViewFrame frameOf(const View& view) {
  assert(!view.distance || *view.distance > 0.0);
  // Reduce to the nearest quarter turn first: cos and sin of a multiple of 90 degrees are then the
  // exact 0 and +-1, not 6e-17.
  const double reduced = normalizedDeg(view.angleDeg);
  const int quarter = static_cast<int>(std::lround(reduced / 90.0));
  const double restRad = (reduced - 90.0 * quarter) * (std::numbers::pi / 180.0);
  Vec2 towards(std::cos(restRad), std::sin(restRad));
  for (int i = 0; i < ((quarter % 4) + 4) % 4; ++i) towards = rotateCcw(towards);
  return {.axis = -rotateCcw(towards), .towards = towards, .distance = view.distance};
}

Vec2 towardsViewer(const ViewFrame& frame, const Vec2& point) {
  if (!frame.distance) return frame.towards;
  const Vec2 sight = frame.eye() - point;
  const double length = sight.norm();
  return length > 0.0 ? Vec2(sight / length) : Vec2::Zero();
}

std::optional<double> screenCoordinate(const ViewFrame& frame, const Vec2& point) {
  const double along = point.dot(frame.axis);
  if (!frame.distance) return along;
  const double depth = *frame.distance - point.dot(frame.towards);
  // Beside the viewer the image runs off to infinity; rounding must not bring it back.
  constexpr double kBesideViewer = 0x1p-44;
  if (!(depth > kBesideViewer * *frame.distance)) return std::nullopt;
  return *frame.distance * along / depth;
}

double nearness(const ViewFrame& frame, const Vec2& point) { return point.dot(frame.towards); }

}  // namespace flatland
