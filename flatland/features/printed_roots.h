// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "flatland/features/features.h"
#include "flatland/roots/isolate.h"

namespace flatland {

/// A root of (3.13) as printed in the thesis, -(n.j) k k' - k^3 (t.j) = 0, that is no inflection:
/// (n.j) k' + k^2 (t.j) = 0. Nothing is special about such a point; it is shown so that it can be
/// seen to miss (docs/math/derivation.md; bibliography: judd2007thesis).
struct PrintedRoot {
  int curve;  ///< index in Scene::curves
  double t;   ///< as Mark::t
  double u;   ///< as Mark::u
  Vec2 point;
  std::optional<double> screen;  ///< empty at or behind the viewer
  /// True if lambda has a maximum there after all: the root is an apparent ridge to 1e-9 of t.
  /// Possible only where (t.j) = 0 and k' = 0 too: a ridge seen head-on.
  bool isMaximum;
  /// Screen distance, length, to the nearest apparent ridge of the same curve; empty if there is
  /// none.
  std::optional<double> toApparentRidge;
  /// Arc length along the curve to the nearest apparent ridge, on a closed curve the shorter way
  /// round, and the share of the whole curve that this is; both empty if there is none.
  std::optional<double> alongToApparentRidge;
  std::optional<double> shareToApparentRidge;
};

struct PrintedRoots {
  std::vector<PrintedRoot> roots;  ///< by curve, then t
  int unresolved = 0;              ///< intervals whose roots could not be counted

  int maxima() const;
  /// The root nearest to an apparent ridge along its curve, and the farthest; null if no root has
  /// one. By share of the curve, so that curves of different size compare.
  const PrintedRoot* nearest() const;
  const PrintedRoot* farthest() const;
};

/// The printed roots of all curves. Inflections, roots of both forms by their factor k, are left
/// out. On Bezier pieces the roots are isolated with certified signs as those of marks are, on
/// other curves by proxies (roots/chebyshev.h). `features` must be those of `scene`.
PrintedRoots findPrintedRoots(const Scene& scene, const FeatureSet& features);

/// The roots on one piece of a curve of any kind by proxies, in the piece's parameter.
Roots printedRootsByProxy(const Curve& curve, int piece, const ViewFrame& frame);

}  // namespace flatland
