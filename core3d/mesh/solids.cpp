// SPDX-License-Identifier: MIT
#include "core3d/mesh/solids.h"

#include <Eigen/Geometry>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core3d/diff/taylor_2d.h"
#include "core3d/mesh/grid.h"

namespace flatland {

namespace {

constexpr double kPi = std::numbers::pi;

enum class Shape { Sheet, Tube, Ring, Globe };

Shape shapeOf(SolidKind kind) {
  switch (kind) {
    case SolidKind::Cylinder:
      return Shape::Tube;
    case SolidKind::Torus:
      return Shape::Ring;
    case SolidKind::Saddle:
    case SolidKind::SineSheet:
    case SolidKind::GaussianBump:
      return Shape::Sheet;
    default:
      return Shape::Globe;
  }
}

// The formulas. x, y, z: a place as in solids.h.
template <typename T>
std::array<T, 3> coordinates(const Solid& s, const T& x, const T& y, const T& z) {
  using std::cos;
  using std::exp;
  using std::pow;
  using std::sin;
  const T a = s.a, b = s.b, c = s.c;
  switch (s.kind) {
    case SolidKind::Sphere:
      return {a * x, a * y, a * z};
    case SolidKind::Ellipsoid:
      return {a * x, b * y, c * z};
    case SolidKind::Cylinder:
      return {a * cos(x), a * sin(x), y};
    case SolidKind::Torus: {
      const T radius = a + b * cos(y);
      return {radius * cos(x), radius * sin(x), b * sin(y)};
    }
    case SolidKind::Saddle:
      return {x, y, T(0.5) * a * (x * x - y * y)};
    case SolidKind::SineSheet:
      return {x, y, a * sin(b * x)};
    case SolidKind::GaussianBump:
      return {x, y, a * exp(T(-0.5) * (x * x + y * y))};
    case SolidKind::RoundedCube: {
      const T radius = a * pow(x * x * x * x + y * y * y * y + z * z * z * z, -0.25);
      return {radius * x, radius * y, radius * z};
    }
    case SolidKind::BumpySphere: {
      const T radius = a * (T(1.0) + b * sin(c * x) * sin(c * y) * sin(c * z));
      return {radius * x, radius * y, radius * z};
    }
  }
  return {};
}

Eigen::Vector3d positionAt(const Solid& solid, const Eigen::Vector3d& place) {
  const auto [x, y, z] = coordinates<double>(solid, place.x(), place.y(), place.z());
  return {x, y, z};
}

// Half a side of the square under a sheet.
double halfSide(const Solid& s) { return s.kind == SolidKind::SineSheet ? s.c : s.b; }

// A number in [-1/4, 1/4) that depends on nothing but its arguments (splitmix64).
double quarterMove(std::uint64_t seed, std::uint64_t i, std::uint64_t j, std::uint64_t k) {
  std::uint64_t h = seed;
  for (const std::uint64_t part : {i, j, k}) {
    h += 0x9e3779b97f4a7c15ull + part;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
    h ^= h >> 31;
  }
  return static_cast<double>(h >> 11) * 0x1p-54 - 0.25;
}

void addVertex(SolidMesh& mesh, const Solid& solid, const Eigen::Vector3d& place) {
  const Eigen::Vector3d p = positionAt(solid, place);
  mesh.soup.addVertex(p.x(), p.y(), p.z());
  mesh.places.push_back(place);
}

SolidMesh rectangular(const Solid& solid, const Meshing& meshing) {
  const Shape shape = shapeOf(solid.kind);
  const bool closedX = shape != Shape::Sheet, closedY = shape == Shape::Ring;
  const double halfX = closedX ? kPi : halfSide(solid);
  const double halfY = closedY ? kPi : (shape == Shape::Tube ? 0.5 * solid.b : halfSide(solid));
  const int n = meshing.cells;
  const int columns = closedX ? n : n + 1, rows = closedY ? n : n + 1;
  SolidMesh mesh;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      double x = i, y = j;
      const bool inner = (closedX || (i > 0 && i < n)) && (closedY || (j > 0 && j < n));
      if (meshing.irregular && inner) {
        const auto ui = static_cast<std::uint64_t>(i), uj = static_cast<std::uint64_t>(j);
        x += quarterMove(meshing.seed, ui, uj, 0);
        y += quarterMove(meshing.seed, ui, uj, 1);
      }
      addVertex(mesh, solid, {halfX * (2.0 * x / n - 1.0), halfY * (2.0 * y / n - 1.0), 0.0});
    }
  }
  addGrid(mesh.soup,
          {.columns = columns, .rows = rows, .closedColumns = closedX, .closedRows = closedY});
  return mesh;
}

// The cube's sides, with cells that are nearly equal on the sphere.
SolidMesh globe(const Solid& solid, const Meshing& meshing) {
  const int n = meshing.cells;
  SolidMesh mesh;
  const auto warped = [n](double i) { return std::tan(kPi / 4.0 * (2.0 * i / n - 1.0)); };
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2, up = (axis + 1) % 3, across = (axis + 2) % 3;
    const bool positive = side % 2 == 1;
    const int first = static_cast<int>(mesh.soup.vertexCount());
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        // A corner of the lattice on the cube: the same numbers from every side it lies on.
        Eigen::Vector3i corner;
        corner[axis] = positive ? n : 0;
        corner[up] = positive ? i : j;
        corner[across] = positive ? j : i;
        Eigen::Vector3d place(warped(corner[0]), warped(corner[1]), warped(corner[2]));
        place.normalize();
        if (meshing.irregular) {
          const double edge = kPi / 2.0 / n;
          const auto move = [&](std::uint64_t k) {
            const auto key = (static_cast<std::uint64_t>(corner[0]) << 42) |
                             (static_cast<std::uint64_t>(corner[1]) << 21) |
                             static_cast<std::uint64_t>(corner[2]);
            return edge * quarterMove(meshing.seed, key, k, 2);
          };
          const Eigen::Vector3d e1 = place.unitOrthogonal(), e2 = place.cross(e1);
          place = (place + move(0) * e1 + move(1) * e2).normalized();
        }
        addVertex(mesh, solid, place);
      }
    }
    addGrid(mesh.soup, {.first = first, .columns = n + 1, .rows = n + 1});
  }
  return mesh;
}

}  // namespace

std::string Solid::name() const {
  constexpr const char* kNames[] = {"sphere",        "cylinder",     "torus",
                                    "ellipsoid",     "saddle",       "sine sheet",
                                    "Gaussian bump", "rounded cube", "bumpy sphere"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<Solid> standardSolids() {
  return {{SolidKind::Sphere, 1.0},
          {SolidKind::Cylinder, 1.0, 2.0},
          {SolidKind::Torus, 1.0, 0.4},
          {SolidKind::Ellipsoid, 1.0, 0.8, 0.6},
          {SolidKind::Saddle, 1.0, 1.0},
          {SolidKind::SineSheet, 0.5, 2.0, 3.0},
          {SolidKind::GaussianBump, 2.0, 4.0},
          {SolidKind::RoundedCube, 1.0},
          {SolidKind::BumpySphere, 1.0, 0.1, 5.0}};
}

SurfacePoint pointAt(const Solid& solid, const Eigen::Vector3d& place) {
  if (shapeOf(solid.kind) != Shape::Globe) {
    return surfacePointOf(
        jetOf(coordinates<Taylor2D>(solid, Taylor2D::u(place.x()), Taylor2D::v(place.y()), 0.0)));
  }
  // Directions near the place: the unit vectors along place + u e1 + v e2.
  const Eigen::Vector3d d = place.normalized(), e1 = d.unitOrthogonal(), e2 = d.cross(e1);
  const Taylor2D u = Taylor2D::u(0.0), v = Taylor2D::v(0.0);
  const Taylor2D shrink = pow(Taylor2D(1.0) + u * u + v * v, -0.5);
  std::array<Taylor2D, 3> near;
  for (int k = 0; k < 3; ++k) {
    near[static_cast<std::size_t>(k)] = (Taylor2D(d[k]) + u * e1[k] + v * e2[k]) * shrink;
  }
  return surfacePointOf(jetOf(coordinates<Taylor2D>(solid, near[0], near[1], near[2])));
}

SolidMesh meshOf(const Solid& solid, const Meshing& meshing) {
  assert(meshing.cells >= 3);
  return shapeOf(solid.kind) == Shape::Globe ? globe(solid, meshing) : rectangular(solid, meshing);
}

}  // namespace flatland
