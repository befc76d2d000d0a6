// SPDX-License-Identifier: MIT
#include "flatland/features/orientation.h"

namespace flatland {

int normalSide(const SceneCurve& curve, const ViewFrame& frame) {
  const BezierChain& chain = curve.chain;
  const Vec2 chord = chain.points().back() - chain.points().front();
  // n.w of the left normal is the screen component of the tangent, so its integral is the chord's.
  const double facing = chain.closed() ? 0.0 : chord.dot(frame.axis);
  int side;
  if (facing != 0.0) {
    side = facing > 0.0 ? 1 : -1;
  } else {
    // Walked counter-clockwise, outside lies to the right.
    side = twiceSignedArea(chain) >= 0.0 ? -1 : 1;
  }
  return curve.flipNormal ? -side : side;
}

}  // namespace flatland
