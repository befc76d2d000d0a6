// SPDX-License-Identifier: MIT
#include "flatland/scene/scene.h"

namespace flatland {

Bounds boundsOf(const Scene& scene) {
  Bounds bounds{Vec2::Zero(), Vec2::Zero()};
  bool first = true;
  for (const SceneCurve& curve : scene.curves) {
    for (const Vec2& p : curve.chain().points()) {
      bounds.low = first ? p : bounds.low.cwiseMin(p);
      bounds.high = first ? p : bounds.high.cwiseMax(p);
      first = false;
    }
  }
  return bounds;
}

}  // namespace flatland
