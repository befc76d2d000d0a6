// SPDX-License-Identifier: MIT
#include "flatland/curve/jet.h"

#include <cassert>
#include <cmath>

namespace flatland {

Frame frameOf(const Jet& jet, int side) {
  const double s2 = jet.d1.squaredNorm();
  assert(s2 > 0.0);
  const double s = std::sqrt(s2);
  const double c = cross(jet.d1, jet.d2);
  const double cPrime = cross(jet.d1, jet.d3);
  const double h = jet.d1.dot(jet.d2);
  Frame f;
  f.tangent = jet.d1 / s;
  f.normal = side * rotateCcw(f.tangent);
  // The left normal turns with the tangent: dn/du = -(c / s^3) t, hence the minus.
  f.k = -side * c / (s2 * s);
  f.kPrime = -side * (cPrime * s2 - 3.0 * c * h) / (s2 * s2 * s2);
  f.speed = s;
  return f;
}

}  // namespace flatland
