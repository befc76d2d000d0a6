// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "flatland/scene/scene.h"

namespace flatland {

/// Limits, beyond which a file is refused with the reason (see also kMostSvgSegments).
inline constexpr std::size_t kLargestSvgBytes = 16U * 1024U * 1024U;
inline constexpr int kMostSvgElements =
    200'000;  ///< drawn ones; each `use` counts its target again
inline constexpr int kDeepestSvgNesting = 200;
inline constexpr int kDeepestSvgUse = 16;  ///< `use` of `use` of ...; a circle of them ends here

/// A scene made from something else, and what a person should know of it.
struct ImportedScene {
  Scene scene;
  std::string done;     ///< one clause: how many curves, how they were turned and scaled
  std::string leftOut;  ///< one clause: what was left out or changed; empty if nothing was

  /// Both as one sentence.
  std::string note() const;
};

struct SvgOptions {
  /// Scale by a power of two and move so that the drawing is 2 to 4 units across and centred at the
  /// origin; else lengths are pixels of 1/96 inch with the origin at the bottom left of the page.
  bool comfortable = true;
};

/// The outlines of an SVG drawing: paths and basic shapes in the order of the file, with all
/// transforms, `use`, nested groups, symbols and view boxes; y turned up. What is drawn within
/// (text, images) or how (gradients, clips, style sheets) is left out and counted. Shapes that are
/// hidden or have neither fill nor stroke are left out too. The view is the default one. Throws
/// InputError with line and reason for what is no SVG, has an error, is beyond a limit, or has
/// nothing to draw; see docs/decisions/0011-svg-import.md.
ImportedScene sceneFromSvg(const std::string& text, const std::string& source,
                           const SvgOptions& options = {});

/// Reads a file. Throws InputError, also when the file cannot be read.
ImportedScene loadSvg(const std::filesystem::path& file, const SvgOptions& options = {});

/// True if the name ends in .svg, in upper or lower case.
bool isSvgName(const std::string& name);

}  // namespace flatland
