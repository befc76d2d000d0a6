// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "flatland/scene/scene.h"

namespace flatland {

/// Answers whether points of a scene can be seen, each from a direction of its own: what Visibility
/// does for one view, for many views. Orthographic; the scene's own view does not matter.
///
/// Only the pieces whose hull meets the line of sight are looked at. On a curve with a Bezier form
/// they are cut at certified folds, as in Visibility. On other curves folds are looked for at 16
/// places of each stretch that is nearly a cubic (or of each rational piece): two folds between
/// neighbouring places are missed, which takes a swing of less than about 1/1000 of the curve's
/// size.
class SightRays {
 public:
  explicit SightRays(const Scene& scene);
  ~SightRays();
  SightRays(SightRays&&) noexcept;
  SightRays& operator=(SightRays&&) noexcept;

  /// As Visibility::isVisible() in that view. Cost: a few microseconds for each piece that lies
  /// before the point; const and thread safe.
  bool isVisible(int curve, double t, double angleDeg) const;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace flatland
