// SPDX-License-Identifier: MIT
#include "core3d/diff/surface_fields.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace flatland {

void SurfaceFields::resize(std::size_t vertices) {
  for (auto* values : {&nx, &ny, &nz, &e1x, &e1y, &e1z, &k1, &k2, &c111, &c112, &c122, &c222})
    values->resize(vertices);
}

void SurfaceFields::set(std::uint32_t v, const SurfacePoint& point) {
  // The angle from the first axis to the direction of the larger eigenvalue; 0 where they are
  // equal.
  const double angle = 0.5 * std::atan2(2.0 * point.K(0, 1), point.K(0, 0) - point.K(1, 1));
  const Eigen::Vector2d a(std::cos(angle), std::sin(angle)), b(-a.y(), a.x());
  const Eigen::Vector3d e = point.frame * a;
  const auto store = [v](std::vector<float>& values, double value) {
    values[v] = static_cast<float>(value);
  };
  store(nx, point.n.x());
  store(ny, point.n.y());
  store(nz, point.n.z());
  store(e1x, e.x());
  store(e1y, e.y());
  store(e1z, e.z());
  // On a fan of edges of 1e-20, say, C goes beyond the range of float: curvature is unknown there.
  const double curvature[] = {a.dot(point.K * a), b.dot(point.K * b), point.C(a, a, a),
                              point.C(a, a, b),   point.C(a, b, b),   point.C(b, b, b)};
  const bool fits = std::all_of(std::begin(curvature), std::end(curvature), [](double value) {
    return std::abs(value) <= std::numeric_limits<float>::max();
  });
  std::size_t i = 0;
  for (auto* values : {&k1, &k2, &c111, &c112, &c122, &c222})
    store(*values, fits ? curvature[i++] : 0.0);
}

SurfacePoint SurfaceFields::at(const TriangleMesh& mesh, std::uint32_t v) const {
  SurfacePoint point;
  point.p = mesh.position(v).cast<double>();
  point.n = normal(v).cast<double>();
  point.frame.col(0) = e1(v).cast<double>();
  point.frame.col(1) = point.n.cross(Eigen::Vector3d(point.frame.col(0)));
  point.K << k1[v], 0.0, 0.0, k2[v];
  point.C.coefficients = {c111[v], c112[v], c122[v], c222[v]};
  return point;
}

double surfaceSize(const TriangleMesh& mesh) {
  const auto corner = [&mesh](const std::array<std::uint32_t, 3>& triangle, std::size_t k) {
    return Eigen::Vector3d(mesh.position(triangle[k]).cast<double>());
  };
  const auto areaOf = [&](const std::array<std::uint32_t, 3>& t) {
    return 0.5 * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
  };
  double area = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (const auto& t : mesh.triangles) {
    const double a = areaOf(t);
    area += a;
    moment += a / 3.0 * (corner(t, 0) + corner(t, 1) + corner(t, 2));
  }
  if (!(area > 0.0)) return 1.0;
  const Eigen::Vector3d centre = moment / area;
  double squares = 0.0;
  for (const auto& t : mesh.triangles) {
    // Exact over a triangle: the mean of |p|^2 is (|a|^2 + |b|^2 + |c|^2 + |a + b + c|^2) / 12.
    const Eigen::Vector3d a = corner(t, 0) - centre, b = corner(t, 1) - centre,
                          c = corner(t, 2) - centre;
    squares += areaOf(t) *
               (a.squaredNorm() + b.squaredNorm() + c.squaredNorm() + (a + b + c).squaredNorm()) /
               12.0;
  }
  return std::sqrt(squares / area);
}

}  // namespace flatland
