// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

namespace flatland {

/// Where the normals of two triangles differ by so much, the surface is creased: what is flatter is
/// not called an edge even where it stands alone. The default of the family of creases too.
inline constexpr double kCreaseDeg = 30.0;

/// A smooth surface bends by less than that from facet to facet, however coarse its mesh; the rim
/// of a bore or of a box by more.
inline constexpr double kFoldDeg = 70.0;

/// The cosine of an angle in degrees, to compare with n.m of unit normals.
inline double cosineOfDeg(double angleDeg) { return std::cos(angleDeg * std::numbers::pi / 180.0); }

}  // namespace flatland
