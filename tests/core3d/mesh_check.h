// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core3d/mesh/triangle_mesh.h"

namespace flatland::test {

/// Holds a mesh against everything that triangle_mesh.h promises.
inline void expectSound(const TriangleMesh& mesh) {
  const auto vertices = static_cast<std::uint32_t>(mesh.vertexCount());
  const auto corners = static_cast<std::uint32_t>(3 * mesh.triangleCount());
  ASSERT_GT(corners, 0u);
  ASSERT_EQ(mesh.y.size(), vertices);
  ASSERT_EQ(mesh.z.size(), vertices);
  ASSERT_EQ(mesh.fileVertex.size(), vertices);
  ASSERT_EQ(mesh.filePolygon.size(), mesh.triangleCount());
  ASSERT_EQ(mesh.opposite.size(), corners);
  ASSERT_EQ(mesh.cornersAt.size(), corners);
  ASSERT_EQ(mesh.cornerStart.size(), vertices + 1u);
  ASSERT_TRUE(mesh.origin.allFinite());
  ASSERT_GT(mesh.unit, 0.0);
  int bad = 0;
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const Eigen::Vector3f p = mesh.position(v);
    if (!(p.cwiseAbs().maxCoeff() <= 1.0f)) ++bad;
    if (mesh.fileVertex[v] >= mesh.meshVertex.size()) ++bad;
  }
  ASSERT_EQ(bad, 0) << "positions outside [-1, 1] or without a vertex of the file";
  for (const auto& [a, b, c] : mesh.triangles) {
    if (a >= vertices || b >= vertices || c >= vertices || !(a < b && a < c && b != c)) ++bad;
  }
  ASSERT_EQ(bad, 0) << "corners that are no vertex, repeat or do not begin with the smallest";
  for (std::uint32_t h = 0; h < corners; ++h) {
    if (!mesh.hasOpposite(h)) continue;
    const std::uint32_t g = mesh.opposite[h];
    if (g >= corners || mesh.opposite[g] != h || g == h ||
        mesh.vertexOf(g) != mesh.vertexOf(TriangleMesh::nextCorner(h)) ||
        mesh.vertexOf(h) != mesh.vertexOf(TriangleMesh::nextCorner(g))) {
      ++bad;
    }
  }
  ASSERT_EQ(bad, 0) << "half-edges whose opposite is not the other way round";
  for (std::uint32_t v = 0; v < vertices; ++v) {
    const std::uint32_t begin = mesh.cornerStart[v], end = mesh.cornerStart[v + 1];
    ASSERT_LT(begin, end) << "a vertex without a triangle";
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t c = mesh.cornersAt[i];
      const std::uint32_t onward = mesh.opposite[TriangleMesh::previousCorner(c)];
      if (mesh.vertexOf(c) != v) ++bad;
      if (i + 1 < end && onward != mesh.cornersAt[i + 1]) ++bad;
      if (i + 1 == end && !mesh.isAtEdge(v) && onward != mesh.cornersAt[begin]) ++bad;
      if (i + 1 == end && mesh.isAtEdge(v) && onward < TriangleMesh::kCut) ++bad;
    }
  }
  ASSERT_EQ(bad, 0) << "corners at a vertex that are not its one fan in order";
}

/// Six times the volume that the triangles enclose; positive if they face outward.
inline double sixfoldVolume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    volume += mesh.position(a).cast<double>().dot(
        mesh.position(b).cast<double>().cross(mesh.position(c).cast<double>()));
  }
  return volume;
}

/// In the unit of the file.
inline double areaInFile(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = mesh.positionInFile(a);
    area += 0.5 * (mesh.positionInFile(b) - p).cross(mesh.positionInFile(c) - p).norm();
  }
  return area;
}

}  // namespace flatland::test
