// SPDX-License-Identifier: MIT
#include "core3d/mesh/swept.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "core3d/diff/taylor_2d.h"
#include "core3d/mesh/grid.h"

namespace flatland {

namespace {

std::vector<double> parametersOf(const Curve& curve, int samplesPerPiece) {
  const int count = pieceCount(curve) * samplesPerPiece + (isClosed(curve) ? 0 : 1);
  std::vector<double> parameters;
  for (int i = 0; i < count; ++i) parameters.push_back(static_cast<double>(i) / samplesPerPiece);
  return parameters;
}

// True if the curve's left side is outside: if it is open, or closed and clockwise.
bool leftIsOutside(const Curve& curve) {
  if (!isClosed(curve)) return true;
  // The sign of an area is safe with some samples, even of a curve that crosses itself.
  const std::vector<double> parameters = parametersOf(curve, 16);
  const Vec2 base = pointAt(curve, 0.0);
  double area = 0.0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double next = parameters[(i + 1) % parameters.size()];
    area += cross(pointAt(curve, parameters[i]) - base, pointAt(curve, next) - base);
  }
  return area < 0.0;
}

// x(u) and y(u) of a curve as functions of u alone.
std::array<Taylor2D, 2> taylorOf(const Jet& jet) {
  std::array<Taylor2D, 2> result;
  for (int k = 0; k < 2; ++k) {
    Taylor2D& f = result[static_cast<std::size_t>(k)];
    f.at(0, 0) = jet.p[k];
    f.at(1, 0) = jet.d1[k];
    f.at(2, 0) = jet.d2[k] / 2.0;
    f.at(3, 0) = jet.d3[k] / 6.0;
  }
  return result;
}

// u runs along the curve and v along the sweep, so that u x v is on the curve's right side.
SurfacePoint outwardPoint(const Curve& curve, std::array<Taylor2D, 3> r) {
  if (leftIsOutside(curve)) {
    for (Taylor2D& f : r) {
      // The other way along the curve.
      for (const auto& [i, j] : {std::pair{1, 0}, {1, 1}, {1, 2}, {3, 0}}) f.at(i, j) = -f.at(i, j);
    }
  }
  return surfacePointOf(jetOf(r));
}

}  // namespace

SweptMesh extrude(const Curve& curve, double height, const Sweeping& sweeping) {
  assert(sweeping.samplesPerPiece >= 1 && sweeping.layers >= 1);
  const std::vector<double> parameters = parametersOf(curve, sweeping.samplesPerPiece);
  SweptMesh mesh;
  for (int j = 0; j <= sweeping.layers; ++j) {
    const double z = height * (static_cast<double>(j) / sweeping.layers - 0.5);
    for (const double t : parameters) {
      const Vec2 p = pointAt(curve, t);
      mesh.soup.addVertex(p.x(), p.y(), z);
      mesh.parameters.push_back(t);
    }
  }
  addGrid(mesh.soup, {.columns = static_cast<int>(parameters.size()),
                      .rows = sweeping.layers + 1,
                      .closedColumns = isClosed(curve),
                      .turned = leftIsOutside(curve)});
  return mesh;
}

SweptMesh revolve(const Curve& curve, double axis, const Sweeping& sweeping) {
  assert(sweeping.samplesPerPiece >= 1 && sweeping.layers >= 3);
  const std::vector<double> parameters = parametersOf(curve, sweeping.samplesPerPiece);
  SweptMesh mesh;
  for (int j = 0; j < sweeping.layers; ++j) {
    const double angle = 2.0 * std::numbers::pi * j / sweeping.layers;
    for (const double t : parameters) {
      const Vec2 p = pointAt(curve, t);
      const double radius = p.x() - axis;
      mesh.soup.addVertex(axis + radius * std::cos(angle), p.y(), radius * std::sin(angle));
      mesh.parameters.push_back(t);
    }
  }
  addGrid(mesh.soup, {.columns = static_cast<int>(parameters.size()),
                      .rows = sweeping.layers,
                      .closedColumns = isClosed(curve),
                      .closedRows = true,
                      .turned = leftIsOutside(curve)});
  return mesh;
}

SurfacePoint extrudedPoint(const Curve& curve, double t, double z) {
  const auto [x, y] = taylorOf(jetAt(curve, t));
  return outwardPoint(curve, {x, y, Taylor2D::v(z)});
}

SurfacePoint revolvedPoint(const Curve& curve, double axis, double t, double angleRad) {
  const auto [x, y] = taylorOf(jetAt(curve, t));
  const Taylor2D radius = x - axis, angle = Taylor2D::v(angleRad);
  return outwardPoint(curve, {axis + radius * cos(angle), y, radius * sin(angle)});
}

}  // namespace flatland
