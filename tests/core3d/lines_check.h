// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core3d/diff/exact_fields.h"
#include "core3d/lines/line_finder.h"
#include "core3d/mesh/build_mesh.h"

namespace flatland::test {

/// A mesh of a solid with its exact fields.
struct SolidModel {
  TriangleMesh mesh;
  SurfaceFields fields;
};

inline SolidModel modelOf(const Solid& solid, const Meshing& meshing) {
  const SolidMesh made = meshOf(solid, meshing);
  SolidModel model{buildMesh(made.soup).mesh, {}};
  model.fields = exactFields(solid, made.places, model.mesh);
  return model;
}

inline LineOptions only(std::initializer_list<LineFamily> families) {
  LineOptions options;
  for (const LineFamily family : families) options[family] = true;
  return options;
}

/// The middle of a piece, in the unit of the file.
inline Eigen::Vector3d middleInFile(const TriangleMesh& mesh, const LineSegment& segment) {
  return mesh.origin + mesh.unit * (0.5f * (segment.a.at + segment.b.at)).cast<double>();
}

inline double lengthInFile(const TriangleMesh& mesh, const LineSegment& segment) {
  return mesh.unit * static_cast<double>((segment.b.at - segment.a.at).norm());
}

inline double totalLength(const TriangleMesh& mesh, const std::vector<LineSegment>& segments) {
  double sum = 0.0;
  for (const LineSegment& segment : segments) sum += lengthInFile(mesh, segment);
  return sum;
}

/// Distances of the ends of all pieces from where `distance` (of a point in the unit of the file)
/// says the line is, ascending.
template <typename Distance>
std::vector<double> distancesOf(const TriangleMesh& mesh, const std::vector<LineSegment>& segments,
                                const Distance& distance) {
  std::vector<double> all;
  for (const LineSegment& segment : segments) {
    for (const LineEnd* end : {&segment.a, &segment.b})
      all.push_back(distance(Eigen::Vector3d(mesh.origin + mesh.unit * end->at.cast<double>())));
  }
  std::sort(all.begin(), all.end());
  return all;
}

inline double median(const std::vector<double>& sorted) {
  return sorted.empty() ? std::numeric_limits<double>::infinity() : sorted[sorted.size() / 2];
}

/// All numbers of all pieces are finite.
inline void expectFinite(const FeatureLines& lines) {
  for (const auto& segments : lines.segments) {
    for (const LineSegment& segment : segments) {
      ASSERT_TRUE(segment.a.at.allFinite() && segment.b.at.allFinite());
      ASSERT_TRUE(std::isfinite(segment.a.strength) && std::isfinite(segment.b.strength));
    }
  }
}

}  // namespace flatland::test
