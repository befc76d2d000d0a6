// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "flatland/view/apparent_curvature.h"

namespace flatland {

/// A point of a parametrised surface with its partial derivatives by u and v up to order 3.
struct SurfaceJet {
  Eigen::Vector3d p;
  Eigen::Vector3d u, v;
  Eigen::Vector3d uu, uv, vv;
  Eigen::Vector3d uuu, uuv, uvv, vvv;
};

/// A point of an oriented surface with all that a view needs of it. K(a) = D_a n, so a sphere of
/// radius R has K = 1/R with its normal outward; C(a, b, c) = (D_c K)(a, b) is the covariant
/// derivative and totally symmetric (Codazzi).
struct SurfacePoint {
  Eigen::Vector3d p;
  Eigen::Vector3d n;                  ///< unit normal
  Eigen::Matrix<double, 3, 2> frame;  ///< columns e1, e2: orthonormal, e1 x e2 = n
  Eigen::Matrix2d K;                  ///< in that frame, symmetric, 1/length
  SymmetricCubic<2> C;                ///< in that frame, 1/length^2
};

/// The point with the normal along u x v, exact up to rounding. e1 is along u. Precondition: u and
/// v are not parallel.
SurfacePoint surfacePointOf(const SurfaceJet& jet);

/// The same point with its normal to the other side: n, K and C change sign, e2 too.
SurfacePoint turnedRound(const SurfacePoint& point);

/// The point as a viewer sees it who is far away along the unit vector w, or at the distance.
SeenPoint<2> seenFrom(const SurfacePoint& point, const Eigen::Vector3d& w,
                      std::optional<double> distance = std::nullopt);

}  // namespace flatland
