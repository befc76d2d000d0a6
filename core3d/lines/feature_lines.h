// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/line_family.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/triangle_mesh.h"

namespace flatland {

/// Where a line crosses an edge of the mesh or passes a vertex: pieces of the same family and level
/// that end in the same node belong together.
using LineNode = std::uint64_t;
/// The node on an edge; either half-edge of the edge gives the same one.
LineNode edgeNode(const TriangleMesh& mesh, std::uint32_t halfEdge);
LineNode vertexNode(std::uint32_t vertex);
/// A node inside a triangle, by any number below 2^62 that is given to it alone.
LineNode freeNode(std::uint64_t number);

struct LineEnd {
  Eigen::Vector3f at;  ///< coordinates of the mesh
  float strength;      ///< dimensionless, what the family's threshold is compared with
  LineNode node;
};

/// A straight piece of a line inside one triangle (or along one of its edges).
struct LineSegment {
  LineEnd a, b;
  std::uint32_t triangle;   ///< it lies in
  std::uint32_t level = 0;  ///< of isophotes and topographic lines, from 0
  bool standsOut = true;    ///< see LineOptions::flatToo
  /// The second triangle that it lies in, if it runs along an edge that is no border or where two
  /// sheets cross. kNone: it lies in one alone, or was interpolated between two sides of an edge.
  std::uint32_t other = TriangleMesh::kNone;
};

/// How the derivative of lambda along t_A is found.
enum class RidgeDerivative : std::uint8_t {
  ClosedForm,  ///< feature + offset + perspective from K and C
  OneRing,  ///< difference quotients to the neighbours, as the thesis practised it; for comparison
};
std::string_view nameOf(RidgeDerivative derivative);  ///< "closed-form", "one-ring"

/// What is looked for, and how strong it must be. Thresholds are dimensionless: curvatures are
/// multiplied with SurfaceFields::size. They are compared with LineEnd::strength; a segment stays
/// if either end reaches the threshold. Strokes are filtered later, as wholes (draw/strokes.h).
struct LineOptions {
  std::array<bool, kLineFamilyCount> on{};
  std::array<double, kLineFamilyCount> threshold = defaultThresholds();
  /// Every crossing of the defining equation, also where it is no maximum, on the side turned away,
  /// or weak: to see what the filters do.
  bool unfiltered = false;
  /// Maxima whose curvature hardly falls on one side are given too, with LineSegment::standsOut =
  /// false: for whoever joins segments and judges the stroke. Noise makes single segments of a
  /// clear line fail.
  bool flatToo = false;
  RidgeDerivative derivative = RidgeDerivative::ClosedForm;
  int isophoteLevels = 10;                                   ///< of n.w between 0 and 1, >= 1
  int topographicLevels = 20;                                ///< between lowest and highest, >= 1
  Eigen::Vector3d topographicUp = Eigen::Vector3d::UnitY();  ///< levels are planes across it

  bool& operator[](LineFamily family) { return on[static_cast<std::size_t>(family)]; }
  bool operator[](LineFamily family) const { return on[static_cast<std::size_t>(family)]; }
  double thresholdOf(LineFamily family) const {
    return threshold[static_cast<std::size_t>(family)];
  }

  static std::array<double, kLineFamilyCount> defaultThresholds();
};

/// The lines of one view, unordered segments per family.
struct FeatureLines {
  std::array<std::vector<LineSegment>, kLineFamilyCount> segments;

  const std::vector<LineSegment>& of(LineFamily family) const {
    return segments[static_cast<std::size_t>(family)];
  }
  std::vector<LineSegment>& of(LineFamily family) {
    return segments[static_cast<std::size_t>(family)];
  }
};

}  // namespace flatland
