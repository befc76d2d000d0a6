// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// A point of the edge from corner `corner` of a triangle to the next one.
struct EdgePoint {
  int corner;
  float t;  ///< 0 at that corner, 1 at the next

  template <typename T>
  T between(const T& a, const T& b) const {
    return a + t * (b - a);
  }
};

/// Where lines leave a triangle. 0: no line. 2: a piece from one to the other. 3: three pieces that
/// meet in the middle of the triangle.
struct Crossings {
  int count = 0;
  EdgePoint points[3];
};

/// Where a function with these values at the corners, linear between them, is zero. A corner with
/// the value 0 counts as negative, so neighbours agree. No infinities for finite values.
inline Crossings zeroCrossings(const float (&f)[3]) {
  Crossings found;
  for (int i = 0; i < 3; ++i) {
    const float a = f[i], b = f[(i + 1) % 3];
    // From the lower index alone t would depend on the side; a / (a - b) is the same up to
    // rounding.
    if ((a > 0.0f) != (b > 0.0f)) found.points[found.count++] = {i, a / (a - b)};
  }
  return found;
}

/// Three corners with directions in which a quantity grows, by how much it grows along them.
struct OrientedFace {
  Eigen::Vector3f p[3];  ///< places
  Eigen::Vector3f r[3];  ///< directions, of any length; 0: unknown
  float slope[3];        ///< derivative along them, times a smooth positive factor, >= 0
};

/// Zero crossings of a derivative along a field of directions without sign (thesis, chapter 5;
/// bibliography: judd2007): on edges whose ends point against each other, placed by linear
/// interpolation. Every corner is treated alike, so winding and order do not matter. If the
/// directions cannot be made to agree all round, then three edges are crossed, or one: the line
/// ends there in a singular point of the field and one piece alone is not drawn.
inline Crossings orientedCrossings(const OrientedFace& face) {
  Crossings found;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (face.r[i].dot(face.r[j]) < 0.0f) {
      const float sum = face.slope[i] + face.slope[j];
      found.points[found.count++] = {i, sum > 0.0f ? face.slope[i] / sum : 0.5f};
    }
  }
  if (found.count == 1) found.count = 0;
  return found;
}

/// True if the direction at a corner points towards the line through a and b: it makes an acute
/// angle with the perpendicular dropped on it. A corner that lies on the line says nothing and
/// passes.
inline bool pointsTowards(const Eigen::Vector3f& p, const Eigen::Vector3f& r,
                          const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  // Nearer than this share of the triangle's size, which side it is on is rounding.
  constexpr float kOnLineSq = 1e-8f;
  const Eigen::Vector3f along = b - a, from = a - p;
  const float lengthSq = along.squaredNorm();
  if (!(lengthSq > 0.0f)) return true;
  const Eigen::Vector3f perpendicular = from - along * (from.dot(along) / lengthSq);
  if (perpendicular.squaredNorm() <= kOnLineSq * (from.squaredNorm() + lengthSq)) return true;
  return r.dot(perpendicular) > 0.0f;
}

/// True if the piece of a line from a to b is one of maxima: all directions point towards it.
inline bool isMaximum(const OrientedFace& face, const Eigen::Vector3f& a,
                      const Eigen::Vector3f& b) {
  for (int i = 0; i < 3; ++i) {
    if (!pointsTowards(face.p[i], face.r[i], a, b)) return false;
  }
  return true;
}

/// True if the directions at the corners are the same but for their sign, roughly: where they turn
/// by more than 70 degrees within one triangle (two curvatures change places there) a derivative
/// along them says nothing.
inline bool directionsAgree(const OrientedFace& face) {
  constexpr float kCosineSq = 0.12f;
  for (int i = 0; i < 3; ++i) {
    const auto &a = face.r[i], &b = face.r[(i + 1) % 3];
    const float product = a.dot(b);
    if (product * product < kCosineSq * a.squaredNorm() * b.squaredNorm()) return false;
  }
  return true;
}

/// How fast the derivative along the directions falls across the piece from a to b: its values at
/// the corners over their distances from the line along the directions. With derivatives per length
/// of a curvature this is minus its second derivative.
inline float fallOfDerivative(const OrientedFace& face, const float (&derivative)[3],
                              const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const Eigen::Vector3f along = b - a;
  const float lengthSq = along.squaredNorm();
  if (!(lengthSq > 0.0f)) return 0.0f;
  float sum = 0.0f, distances = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f from = a - face.p[i];
    const Eigen::Vector3f perpendicular = from - along * (from.dot(along) / lengthSq);
    const float way = face.r[i].dot(perpendicular);
    if (!(way > 0.0f)) continue;
    sum += derivative[i];
    distances += perpendicular.squaredNorm() * face.r[i].norm() / way;
  }
  return distances > 0.0f ? sum / distances : 0.0f;
}

}  // namespace flatland
