// SPDX-License-Identifier: MIT
#pragma once

namespace flatland {

/// The vertical fields of view that are taken from people, from files and the command line alike.
/// Nearer to 180 degrees the picture is of nothing but its own rim, nearer to 0 the viewer so far
/// away that single precision cannot tell the view from an orthographic one.
inline constexpr double kLeastPerspectiveDeg = 0.1, kMostPerspectiveDeg = 179.0;

/// Takes no value that is not a number.
constexpr bool isPerspective(double angleDeg) {
  return angleDeg >= kLeastPerspectiveDeg && angleDeg <= kMostPerspectiveDeg;
}

}  // namespace flatland
