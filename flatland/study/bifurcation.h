// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "flatland/curve/families.h"

namespace flatland {

/// A value of a family's parameter at which the number of apparent ridges changes in a view that
/// the curve is symmetric to.
struct Bifurcation {
  std::size_t parameter;  ///< place in FamilyCurve::parameters
  double value;           ///< in that parameter's unit
};

/// Ellipse, seen along y: the half axis b = sqrt(3/2) a. Above it the tip that faces the viewer is
/// an apparent ridge, below it lambda has a minimum there. nullopt for the other families.
std::optional<Bifurcation> bifurcationOf(const FamilyCurve& curve);

}  // namespace flatland
