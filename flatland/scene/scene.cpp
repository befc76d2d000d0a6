// SPDX-License-Identifier: MIT
#include "flatland/scene/scene.h"

namespace flatland {

Bounds boundsOf(const Scene& scene) {
  Bounds bounds{Vec2::Zero(), Vec2::Zero()};
  bool first = true;
  for (const SceneCurve& curve : scene.curves) {
    const Bounds box = boundsOf(curve.shape);
    bounds.low = first ? box.low : bounds.low.cwiseMin(box.low);
    bounds.high = first ? box.high : bounds.high.cwiseMax(box.high);
    first = false;
  }
  return bounds;
}

}  // namespace flatland
