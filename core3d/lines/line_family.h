// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace flatland {

/// The kinds of lines that are found on a surface. "View" says that they move with the viewer.
enum class LineFamily : std::uint8_t {
  ExteriorSilhouette,    ///< view: contours against the background. LineFinder gives all contours
                         ///< for it; drawing keeps those with nothing behind (rays are cast there)
  OccludingContours,     ///< view: n.w = 0, the exterior silhouette included
  SuggestiveContours,    ///< view: radial curvature 0, growing towards the viewer
  SuggestiveHighlights,  ///< view: radial curvature 0, falling towards the viewer
  ApparentRidges,        ///< view: maxima of view-dependent curvature
  PrincipalHighlights,   ///< view: w_T along a principal direction, where that is a highlight
  Isophotes,             ///< view: n.w = a level
  Ridges,                ///< maxima of k1 along e1, k1 > |k2|
  Valleys,               ///< minima of k2 along e2, -k2 > |k1|
  Parabolic,             ///< K = k1 k2 = 0
  ZeroMeanCurvature,     ///< H = (k1 + k2) / 2 = 0
  Creases,               ///< edges with a sharp dihedral angle
  Boundaries,            ///< edges with one triangle
  SelfIntersections,     ///< where the surface passes through itself
  Topographic,           ///< a coordinate = a level
};
inline constexpr std::size_t kLineFamilyCount = 15;
inline constexpr std::size_t kViewFamilies = 7;  ///< the first ones, which depend on the view

/// All families, in the order of the enumeration.
std::array<LineFamily, kLineFamilyCount> allLineFamilies();

/// The name in files and on the command line: "apparent-ridges".
std::string_view nameOf(LineFamily family);
/// The family of a name; nullopt if there is none.
std::optional<LineFamily> lineFamilyNamed(std::string_view name);

/// True if the lines depend on the viewer, so that they have to be found for each view.
bool dependsOnView(LineFamily family);

}  // namespace flatland
