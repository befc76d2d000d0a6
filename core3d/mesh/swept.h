// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core3d/diff/surface_jet.h"
#include "core3d/mesh/polygon_soup.h"
#include "flatland/curve/curve.h"

namespace flatland {

/// Surfaces swept by a plane curve: the bridges from flatland to the world of surfaces. What is
/// known of the curve's marks is known of these surfaces' lines too.
///
/// The curve lies in the plane z = 0. Outside is the outer side of a closed curve, and the left
/// side of an open one (above a graph that runs to the right).
struct SweptMesh {
  PolygonSoup soup;
  std::vector<double> parameters;  ///< t of the curve, for each vertex of the soup
};

/// How finely a curve is swept. At least one sample for each piece, one layer, three for a turn.
struct Sweeping {
  int samplesPerPiece = 32;  ///< of the curve, evenly in its parameter
  int layers = 16;           ///< along the sweep
};

/// The curve moved along z from -height / 2 to height / 2; without lids.
SweptMesh extrude(const Curve& curve, double height, const Sweeping& sweeping);

/// The curve turned about the line x = axis, which is parallel to y: t and angle to
/// (axis + (x - axis) cos(angle), y, (x - axis) sin(angle)). Where the curve meets the axis the
/// surface has a pole; a curve that crosses it gives a surface that crosses itself.
SweptMesh revolve(const Curve& curve, double axis, const Sweeping& sweeping);

/// Exact points of these surfaces. Precondition: no cusp of the curve at t; not on the axis.
SurfacePoint extrudedPoint(const Curve& curve, double t, double z);
SurfacePoint revolvedPoint(const Curve& curve, double axis, double t, double angleRad);

}  // namespace flatland
