// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core3d/study/surface_derivation.h"
#include "core3d/study/triangle_lesson.h"
#include "flatland/io/derivation_text.h"

namespace flatland {

/// Chapter 4 at a vertex of a mesh, for a file or a terminal.
struct SurfaceDerivation {
  std::uint32_t fileVertex = 0;  ///< its number in the file, from 0
  Eigen::Vector3d inFile;        ///< its place there
  double size = 1.0;             ///< of the surface, in the unit of the file: the unit of lengths
  std::optional<SurfacePlace> place;  ///< empty where the normal is unknown
  std::vector<DerivationRow> rows;    ///< all steps, in order
};
SurfaceDerivation surfaceDerivationAt(const TriangleMesh& mesh, const SurfaceFields& fields,
                                      const SurfaceView& view, const Eigen::Vector3d& right,
                                      std::uint32_t vertex);

/// The matrices, then the steps as derivationToText.
std::string surfaceDerivationToText(const SurfaceDerivation& derivation);

/// Chapter 5 on a triangle: corners, crossings, pieces with their tests, and the verdict. Places
/// are those of the file.
std::string triangleLessonToJson(const TriangleMesh& mesh, const TriangleLesson& lesson);
std::string triangleLessonToText(const TriangleMesh& mesh, const TriangleLesson& lesson);

}  // namespace flatland
