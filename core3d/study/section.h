// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core3d/diff/surface_fields.h"
#include "core3d/lines/feature_lines.h"
#include "core3d/lines/surface_view.h"
#include "core3d/mesh/slice.h"
#include "flatland/features/features.h"
#include "flatland/scene/scene.h"

namespace flatland {

/// A section of a mesh as a scene of flatland. Curve i of the scene is line `lineOf[i]` of the
/// slice; it is seen from 90 degrees, up the plane, unless setView says otherwise, and its normal
/// points to the outside of the surface.
struct Section {
  CutPlane plane;
  Slice slice;
  Scene scene;
  std::vector<std::size_t> lineOf;
  double maxDeviation = 0.0;  ///< of the curves from the points of the slice; unit of the file
  std::size_t corners = 0;
};

/// Cuts and fits (curve/fit.h). Precondition: tolerance > 0, in the unit of the file.
Section sectionOf(const TriangleMesh& mesh, const CutPlane& plane, double tolerance);

/// Looks at the section from elsewhere. Its normals still point to the outside.
void setView(Section& section, const View& view);

/// The plane through the vertex nearest to p (unit of the file) along w and t_A there: the section
/// in which flatland's lambda is the surface's. nullopt where there is no t_A: n.w or K is 0.
std::optional<CutPlane> planeAlongRidge(const TriangleMesh& mesh, const SurfaceFields& fields,
                                        const SurfaceView& view, const Eigen::Vector3d& p);

/// Why a section differs from its surface: the angle between t_A and the plane, degrees in [0, 90],
/// on a triangle; t_A is the mean of that at its corners by their signs. 0: the plane holds t_A,
/// and flatland's equation is the surface's as long as it stays so. nullopt without a t_A.
std::optional<double> offPlaneDeg(const TriangleMesh& mesh, const SurfaceFields& fields,
                                  const SurfaceView& view, const CutPlane& plane,
                                  std::uint32_t triangle);

/// A mark of the section's curves, on the surface.
struct SectionMark {
  Mark mark;
  Eigen::Vector3d at;  ///< unit of the file
  std::optional<double> offPlaneDeg;
};

/// A place where an apparent ridge of the surface goes through the plane.
struct CrossedRidge {
  Eigen::Vector3d at;
  Vec2 inPlane;
  std::optional<double> offPlaneDeg;
  std::optional<double> toMark;  ///< distance to the section's nearest apparent ridge, if any
  double strength;               ///< LineEnd::strength there
};

struct SectionMarks {
  std::vector<SectionMark> marks;  ///< all kinds, as findFeatures lists them
  std::vector<CrossedRidge> ridges;
  bool complete = true;  ///< FeatureSet::complete
};

/// Marks of the section beside the ridges of the surface; `ridges` are segments found in this view.
SectionMarks compareSection(const Section& section, const TriangleMesh& mesh,
                            const SurfaceFields& fields, const SurfaceView& view,
                            const std::vector<LineSegment>& ridges);

}  // namespace flatland
