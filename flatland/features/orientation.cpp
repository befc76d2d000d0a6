// SPDX-License-Identifier: MIT
#include "flatland/features/orientation.h"

#include <cmath>

namespace flatland {

int normalSide(const SceneCurve& curve, const ViewFrame& frame) {
  // Ties are judged relative to the size, so that rounding does not decide them.
  constexpr double kTie = 1e-12;
  const double size = boundsOf(curve.shape).diagonal();
  const bool closed = isClosed(curve.shape);
  const Vec2 chord = pointAt(curve.shape, pieceCount(curve.shape)) - pointAt(curve.shape, 0.0);
  // n.w of the left normal is the screen component of the tangent, so its integral is the chord's.
  const double facing = closed ? 0.0 : chord.dot(frame.axis);
  int side;
  if (std::abs(facing) > kTie * size) {
    side = facing > 0.0 ? 1 : -1;
  } else {
    // Walked counter-clockwise, outside lies to the right.
    side = twiceSignedArea(curve.shape) >= -kTie * size * size ? -1 : 1;
  }
  return curve.flipNormal ? -side : side;
}

std::vector<int> normalSides(const Scene& scene) {
  const ViewFrame frame = frameOf(scene.view);
  std::vector<int> sides;
  for (const SceneCurve& curve : scene.curves) sides.push_back(normalSide(curve, frame));
  return sides;
}

}  // namespace flatland
