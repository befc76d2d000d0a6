// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

namespace flatland {

/// A totally symmetric trilinear form on D-vectors. `coefficients[i + j + k]` is C(e_i, e_j, e_k):
/// {C111} for D = 1, {C111, C112, C122, C222} for D = 2.
template <int D>
struct SymmetricCubic {
  static_assert(D == 1 || D == 2, "index sums name the coefficients only up to D = 2");
  using Vector = Eigen::Matrix<double, D, 1>;

  std::array<double, D == 1 ? 1 : 4> coefficients{};

  double operator()(const Vector& a, const Vector& b, const Vector& c) const {
    double sum = 0.0;
    for (int i = 0; i < D; ++i) {
      for (int j = 0; j < D; ++j) {
        for (int k = 0; k < D; ++k) {
          sum += coefficients[static_cast<std::size_t>(i + j + k)] * (a(i) * b(j) * c(k));
        }
      }
    }
    return sum;
  }
};

/// A point of a hypersurface in R^(D+1) as seen by a viewer: D = 1 a curve seen on a line, D = 2 a
/// surface seen on a plane. Vectors and forms are in one orthonormal frame of the tangent space; n
/// is the unit normal, w the unit vector towards the viewer.
template <int D>
struct SeenPoint {
  using Vector = Eigen::Matrix<double, D, 1>;
  using Matrix = Eigen::Matrix<double, D, D>;

  Matrix K;                        ///< shape operator K a = D_a n, symmetric, 1/length
  SymmetricCubic<D> C;             ///< its covariant derivative, 1/length^2
  Vector wT;                       ///< tangential part of w
  double nw;                       ///< n.w; |wT|^2 + nw^2 = 1
  std::optional<double> distance;  ///< to the viewer, length > 0; empty when orthographic
};

/// What a step on the screen is measured in. Orthographic views know only PerLength.
enum class LambdaMeasure {
  PerLength,     ///< length across the line of sight: lambda in 1/length^2
  PerViewAngle,  ///< radians as seen from the viewer: r grows by d and lambda by d^2, so that far
                 ///< things bend more per angle. Needs a distance
};

/// View-dependent curvature and the terms of the apparent-ridge equation,
///   feature + offset + perspective = 1/2 D_tA lambda,
/// the derivative taken along r, that is per unit step on the screen along the direction of largest
/// lambda.
///
/// Sign: r and v go together, v with its larger component positive (v = 1 for D = 1). Turning both
/// round (as v and r are directions without a sign) turns the signs of all three terms.
template <int D>
struct ApparentCurvature {
  using Vector = Eigen::Matrix<double, D, 1>;

  double lambda;  ///< largest squared turn of n per screen step: largest eigenvalue of K G K
  Vector v;       ///< its unit eigenvector
  Vector
      r;  ///< tangent vector that projects to the unit screen direction t_A; K r = sqrt(lambda) v
  double feature;      ///< C(r, r, K r)
  double offset;       ///< -K(r, r) K(K r, w_T) / n.w
  double perspective;  ///< -(w_T.r) lambda / d, twice that per view angle; 0 when orthographic
  double relativeGap;  ///< (lambda - other eigenvalue) / lambda in [0, 1]; 1 for D = 1

  /// 1/2 D_tA lambda.
  double sum() const { return feature + offset + perspective; }
};

namespace detail {

/// Largest eigenvalue, its unit vector and the distance to the other eigenvalue of
/// M = K K + p p^T / nw^2 with p = K w_T. For D = 2 the traceless part, which decides the
/// direction, is built from products and not as a difference of entries of M, so it keeps its
/// digits when M is nearly isotropic.
template <int D>
struct LargestEigen {
  double value;
  Eigen::Matrix<double, D, 1> vector;
  double gap;
};

inline LargestEigen<1> largestEigen(const Eigen::Matrix<double, 1, 1>& K,
                                    const Eigen::Matrix<double, 1, 1>& p, double inverseNw) {
  const double seen = p(0) * inverseNw;
  const double value = K(0) * K(0) + seen * seen;
  return {value, Eigen::Matrix<double, 1, 1>::Constant(1.0), value};
}

inline LargestEigen<2> largestEigen(const Eigen::Matrix2d& K, const Eigen::Vector2d& p,
                                    double inverseNw) {
  const double px = p(0) * inverseNw, py = p(1) * inverseNw;
  const double mean =
      0.5 * (K(0, 0) * K(0, 0) + 2.0 * K(0, 1) * K(0, 1) + K(1, 1) * K(1, 1) + px * px + py * py);
  // K K - (K : K / 2) I = tr K (K - tr K / 2 I), by Cayley and Hamilton.
  const double trace = K(0, 0) + K(1, 1);
  const double half = 0.5 * (trace * (K(0, 0) - K(1, 1)) + (px - py) * (px + py));
  const double mixed = trace * K(0, 1) + px * py;
  const double radius = std::sqrt(half * half + mixed * mixed);
  // Of the two proportional eigenvectors the longer one; both are zero for an isotropic M.
  const double main = radius + std::abs(half);
  const double length = std::sqrt(main * main + mixed * mixed);
  const double scale = length > 0.0 ? 1.0 / length : 0.0;
  const double large = length > 0.0 ? main * scale : 1.0;
  const double small = mixed * scale;
  const bool first = half >= 0.0;
  return {mean + radius, {first ? large : small, first ? small : large}, 2.0 * radius};
}

}  // namespace detail

/// View-dependent curvature at a point (docs/math/view_dependent_curvature.md), with the offset
/// term in closed form (bibliography: judd2007).
///
/// Degenerate answers. Silhouette, nw = 0: nullopt, for lambda has no finite value. K = 0: lambda,
/// r and all terms 0, v = (1, 0), relativeGap 0 (1 for D = 1). Equal eigenvalues: every direction
/// is one of largest lambda, v = (1, 0) or whatever rounding makes of it, and r and the terms
/// follow v; relativeGap says how near that is: v is accurate to about 1e-15 / relativeGap.
///
/// K and K / nw between 1e-70 and 1e70 in size, so that no square leaves the range of double.
/// Precondition: PerViewAngle only with a distance. No allocation; about 60 operations for D = 2.
template <int D>
std::optional<ApparentCurvature<D>> apparentCurvature(
    const SeenPoint<D>& at, LambdaMeasure measure = LambdaMeasure::PerLength) {
  static_assert(D == 1 || D == 2, "the eigenvector is found in closed form");
  using Vector = typename SeenPoint<D>::Vector;
  assert(at.distance || measure == LambdaMeasure::PerLength);
  if (at.nw == 0.0) return std::nullopt;

  const double inverseNw = 1.0 / at.nw;
  const auto eigen = detail::largestEigen(at.K, Vector(at.K * at.wT), inverseNw);
  ApparentCurvature<D> seen{};
  seen.v = eigen.vector;
  seen.r = Vector::Zero();
  if (!(eigen.value > 0.0)) {
    if (D == 1) seen.relativeGap = 1.0;
    return seen;
  }

  // Screen steps per length: 1 across the line of sight, or the angle they span at the viewer.
  const bool perAngle = measure == LambdaMeasure::PerViewAngle;
  const double root = std::sqrt(eigen.value);
  const double step = perAngle ? *at.distance : 1.0;
  const Vector Kv = at.K * seen.v;
  // r = G K v / sqrt(lambda) with G = I + w_T w_T^T / nw^2.
  const Vector GKv = Kv + at.wT * (at.wT.dot(Kv) * inverseNw * inverseNw);
  seen.lambda = eigen.value * (step * step);
  seen.r = GKv * (step / root);
  seen.relativeGap = eigen.gap / eigen.value;

  const Vector Kr = at.K * seen.r;
  seen.feature = at.C(seen.r, seen.r, Kr);
  seen.offset = -seen.r.dot(Kr) * Kr.dot(at.K * at.wT) * inverseNw;
  if (at.distance) {
    const double turns = perAngle ? 2.0 : 1.0;
    seen.perspective = -turns * at.wT.dot(seen.r) * seen.lambda / *at.distance;
  }
  return seen;
}

}  // namespace flatland
