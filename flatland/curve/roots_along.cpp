// SPDX-License-Identifier: MIT
#include "flatland/curve/roots_along.h"

namespace flatland {

std::vector<ProxyRoots> rootsAlong(const Curve& curve, const CurveFunction& f) {
  std::vector<ProxyRoots> found;
  for (int i = 0; i < pieceCount(curve); ++i) {
    found.push_back(proxyRoots([&](double t) { return f(derivativesAt(curve, i, t)); }));
  }
  return found;
}

}  // namespace flatland
