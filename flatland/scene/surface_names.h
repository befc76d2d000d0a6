// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace flatland {

// The words that a scene's surface is written with, in files and on the command line. What they
// stand for is known to the rooms above, whose enumerations are in the same order.

/// Families of lines, core3d/lines/line_family.h.
inline constexpr std::string_view kLineFamilyNames[] = {
    "exterior-silhouette",
    "contours",
    "suggestive-contours",
    "suggestive-highlights",
    "apparent-ridges",
    "principal-highlights",
    "isophotes",
    "ridges",
    "valleys",
    "parabolic",
    "zero-mean-curvature",
    "creases",
    "boundaries",
    "self-intersections",
    "topographic",
};

/// SurfaceSetting::style, what is below the lines.
inline constexpr std::string_view kSurfaceStyleNames[] = {"paper", "flat",    "lambert", "toon",
                                                          "gooch", "normals", "colours"};
/// SurfaceSetting::quantity, what the style "colours" shows.
inline constexpr std::string_view kSurfaceQuantityNames[] = {"k1",      "k2",     "lambda",
                                                             "feature", "offset", "offset-share"};
/// SurfaceSetting::hidden.
inline constexpr std::string_view kHiddenLineNames[] = {"off", "dashed", "shown"};
/// SurfacePane::derivative.
inline constexpr std::string_view kDerivativeNames[] = {"closed-form", "one-ring"};
/// SurfacePane::shows.
inline constexpr std::string_view kPaneShowsNames[] = {"lines", "difference"};
/// SweptSetting::kind.
inline constexpr std::string_view kSweptKindNames[] = {"extrusion", "revolution"};

}  // namespace flatland
