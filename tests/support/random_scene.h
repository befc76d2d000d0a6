// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "flatland/io/scene_json.h"
#include "tests/support/seed.h"

namespace flatland::test {

/// Any length a scene may hold: every exponent up to that of 1e50, subnormals and both zeros
/// included.
inline double anyLength(Random& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::abs(value) <= kLargestLength) return value;  // no NaN passes
  }
}

/// A scene of 0 to 4 curves, open and closed, of degree 1 to 9, with any coordinates.
inline Scene anyScene(Random& random) {
  Scene scene;
  const int curves = uniformInt(random, 0, 4);
  for (int i = 0; i < curves; ++i) {
    const int degree = uniformInt(random, 1, 9);
    const bool closed = uniformInt(random, 0, 1) == 1;
    const int pieces = uniformInt(random, closed && degree == 1 ? 2 : 1, 4);
    std::vector<Vec2> points;
    for (int j = 0; j < degree * pieces + (closed ? 0 : 1); ++j) {
      points.emplace_back(anyLength(random),
                          uniformInt(random, 0, 4) == 0 ? -0.0 : anyLength(random));
    }
    // Now and then a closed chain whose last point is its first.
    if (closed && points.size() > 2 && uniformInt(random, 0, 3) == 0)
      points.back() = points.front();
    scene.curves.push_back(
        {BezierChain(degree, closed, std::move(points)), uniformInt(random, 0, 1) == 1});
  }
  scene.view.angleDeg = uniform(random, -720.0, 720.0);
  if (uniformInt(random, 0, 1) == 1) scene.view.distance = std::abs(anyLength(random)) + 1e-300;
  return scene;
}

}  // namespace flatland::test
