// SPDX-License-Identifier: MIT
#include "core3d/diff/surface_jet.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace flatland {

SurfacePoint surfacePointOf(const SurfaceJet& jet) {
  SurfacePoint point;
  point.p = jet.p;
  point.n = jet.u.cross(jet.v).normalized();
  point.frame.col(0) = jet.u.normalized();
  point.frame.col(1) = point.n.cross(point.frame.col(0));

  // In coordinates of the parameters first: metric g, second form h = -n.r_ij = n_i.r_j.
  const Eigen::Vector3d* const first[2] = {&jet.u, &jet.v};
  const Eigen::Vector3d* const second[3] = {&jet.uu, &jet.uv, &jet.vv};
  const Eigen::Vector3d* const third[4] = {&jet.uuu, &jet.uuv, &jet.uvv, &jet.vvv};
  Eigen::Matrix2d g, h;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      g(i, j) = first[i]->dot(*first[j]);
      h(i, j) = -point.n.dot(*second[i + j]);
    }
  }
  const Eigen::Matrix2d inverse = g.inverse();
  // Weingarten: n_k = h_k^l r_l.
  const Eigen::Matrix2d shape = h * inverse;
  // Christoffel symbols G^l_ij, by i + j.
  Eigen::Vector2d christoffel[3];
  for (int s = 0; s < 3; ++s) {
    christoffel[s] = inverse * Eigen::Vector2d(second[s]->dot(jet.u), second[s]->dot(jet.v));
  }
  // C_ijk = d_k h_ij - G^l_ki h_lj - G^l_kj h_il, which is symmetric: one entry for each i + j + k.
  SymmetricCubic<2> inParameters;
  constexpr int kIndices[4][3] = {{0, 0, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}};
  for (std::size_t s = 0; s < 4; ++s) {
    const auto [i, j, k] = kIndices[s];
    const Eigen::Vector3d normalByK = shape(k, 0) * jet.u + shape(k, 1) * jet.v;
    const double derivative = -normalByK.dot(*second[i + j]) - point.n.dot(*third[i + j + k]);
    inParameters.coefficients[s] =
        derivative - christoffel[k + i].dot(h.row(j)) - christoffel[k + j].dot(h.row(i));
  }

  // Columns: e1 and e2 in coordinates of the parameters.
  const Eigen::Matrix2d toParameters =
      (point.frame.transpose() * (Eigen::Matrix<double, 3, 2>() << jet.u, jet.v).finished())
          .inverse();
  point.K = toParameters.transpose() * h * toParameters;
  point.K(1, 0) = point.K(0, 1) = 0.5 * (point.K(0, 1) + point.K(1, 0));
  const Eigen::Vector2d e[2] = {toParameters.col(0), toParameters.col(1)};
  for (std::size_t s = 0; s < 4; ++s) {
    const auto [i, j, k] = kIndices[s];
    point.C.coefficients[s] = inParameters(e[i], e[j], e[k]);
  }
  return point;
}

SurfacePoint turnedRound(const SurfacePoint& point) {
  SurfacePoint turned = point;
  turned.n = -point.n;
  turned.frame.col(1) = -point.frame.col(1);
  // The sign of n, times one for every index 2.
  turned.K.diagonal() = -point.K.diagonal();
  const auto [c111, c112, c122, c222] = point.C.coefficients;
  turned.C.coefficients = {-c111, c112, -c122, c222};
  return turned;
}

SeenPoint<2> seenFrom(const SurfacePoint& point, const Eigen::Vector3d& w,
                      std::optional<double> distance) {
  return {point.K, point.C, point.frame.transpose() * w, point.n.dot(w), distance};
}

}  // namespace flatland
