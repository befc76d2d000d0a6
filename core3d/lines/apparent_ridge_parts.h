// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core3d/lines/families.h"

namespace flatland {

// What a triangle of the walk for apparent ridges is judged by. Part of LineFinder; shared with
// study/triangle_lesson.h, which shows the same to people.

/// The triangle with its directions, lambda growing along them. `placing`: slopes that put the line
/// where it is drawn; else 1/2 D_tA lambda itself, as SeenVertices::slope.
OrientedFace apparentRidgeFace(const SeenMesh& sight, std::uint32_t triangle, bool placing);

/// sqrt(lambda) between two vertices, dimensionless: what the threshold is compared with.
float apparentRidgeStrength(const SeenMesh& sight, std::uint32_t a, std::uint32_t b, float t);

/// The derivative of sqrt(lambda) per length on the surface at the corners, and its mean.
struct RidgeFall {
  float derivative[3];
  float curvature;
};
RidgeFall apparentRidgeFall(const SeenMesh& sight, std::uint32_t triangle);

/// True if the curvature falls on both sides of a piece that ends there (contrast.h).
bool apparentRidgeStandsOut(const SeenMesh& sight, std::uint32_t triangle, const Eigen::Vector3f& a,
                            const Eigen::Vector3f& b);

/// The difference quotient of the thesis (Fig. 5-1 a): lambda at the points where the plane of r
/// and the normal at v leaves the triangles round it, less lambda at v, by distance; along r
/// counted positive.
struct RingDifference {
  int sides = 0;            ///< of them; 2 inside a mesh, fewer at its edge
  Eigen::Vector3f at[2];    ///< the first two points, w and w' of the figure
  float lambda[2] = {};     ///< there, linear between the vertices
  float derivative = 0.0f;  ///< 1/2 D lambda by length on the surface; 0 without sides
};
template <typename Lambda>
RingDifference ringDifference(const TriangleMesh& mesh, const Eigen::Vector3f& normal,
                              const Eigen::Vector3f& r, const Lambda& lambdaAt, std::uint32_t v) {
  RingDifference ring;
  const Eigen::Vector3f p = mesh.position(v), across = normal.cross(r).normalized();
  float sum = 0.0f;
  for (std::uint32_t i = mesh.cornerStart[v]; i < mesh.cornerStart[v + 1]; ++i) {
    const std::uint32_t next = TriangleMesh::nextCorner(mesh.cornersAt[i]);
    const std::uint32_t a = mesh.vertexOf(next), b = mesh.vertexOf(TriangleMesh::nextCorner(next));
    const float sa = across.dot(mesh.position(a) - p), sb = across.dot(mesh.position(b) - p);
    if ((sa > 0.0f) == (sb > 0.0f)) continue;
    const float t = sa / (sa - sb);
    const Eigen::Vector3f way = mesh.position(a) + t * (mesh.position(b) - mesh.position(a)) - p;
    const float distance = way.norm();
    if (!(distance > 0.0f)) continue;
    const float lambda = lambdaAt(a) + t * (lambdaAt(b) - lambdaAt(a));
    const float difference = lambda - lambdaAt(v);
    sum += (way.dot(r) > 0.0f ? difference : -difference) / distance;
    if (ring.sides < 2) {
      ring.at[ring.sides] = p + way;
      ring.lambda[ring.sides] = lambda;
    }
    ++ring.sides;
  }
  if (ring.sides > 0) ring.derivative = 0.5f * sum / static_cast<float>(ring.sides);
  return ring;
}

}  // namespace flatland
