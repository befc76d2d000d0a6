// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "core3d/diff/surface_jet.h"
#include "core3d/mesh/polygon_soup.h"

namespace flatland {

enum class SolidKind {
  Sphere,        ///< radius a
  Cylinder,      ///< about z: radius a, height b; open ends
  Torus,         ///< about z: radius a of the circle of centres, radius b of the tube, b < a
  Ellipsoid,     ///< half axes a, b, c along x, y, z
  Saddle,        ///< z = a (x^2 - y^2) / 2 over [-b, b]^2
  SineSheet,     ///< z = a sin(b x) over [-c, c]^2
  GaussianBump,  ///< z = a exp(-(x^2 + y^2) / 2) over [-b, b]^2
  RoundedCube,   ///< x^4 + y^4 + z^4 = a^4
  BumpySphere,   ///< direction d at a (1 + b sin(c dx) sin(c dy) sin(c dz))
};

/// A surface given by a formula, whose normal and curvatures are known exactly: the truth that
/// estimators and lines are held against. Normals point outward, or up (+z) on a sheet.
struct Solid {
  SolidKind kind;
  double a = 1.0, b = 1.0, c = 1.0;  ///< as SolidKind says; lengths > 0

  std::string name() const;
};

/// One of each kind with the sizes that the documents use (sheet and bump as in the thesis's
/// pictures: sin(2x)/2 over [-3, 3]^2, 2 exp(-r^2/2) over [-4, 4]^2).
std::vector<Solid> standardSolids();

/// The exact point at a place. Places: (x, y, 0) on the sheets; (angle about z, z, 0) on the
/// cylinder; (angle about z, angle about the tube, 0) on the torus, 0 outermost; a unit vector, in
/// whose direction the surface is looked for or (ellipsoid) that is stretched, on the others.
SurfacePoint pointAt(const Solid& solid, const Eigen::Vector3d& place);

/// A mesh of a solid.
struct SolidMesh {
  PolygonSoup soup;
  std::vector<Eigen::Vector3d> places;  ///< of the vertices of the soup, for pointAt
};

/// How a solid is meshed.
struct Meshing {
  int cells = 50;  ///< n: n x n cells of two triangles, on closed solids for each of 6 sides
  bool irregular = false;  ///< moves inner vertices by up to a quarter of a cell along both sides
  std::uint64_t seed = 1;  ///< of these moves
};

/// Vertices lie on the solid exactly. On the solids that are known by directions the six sides are
/// those of a cube and vertices along its edges stand twice, bit for bit equal; buildMesh welds
/// them.
SolidMesh meshOf(const Solid& solid, const Meshing& meshing);

}  // namespace flatland
