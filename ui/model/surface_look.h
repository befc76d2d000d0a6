// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core3d/lines/feature_lines.h"
#include "flatland/scene/surface_setting.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

// What the names and numbers of a SurfaceSetting mean.

/// What is seen of the surface below its lines.
enum class SurfaceStyle { Paper, Flat, Lambert, Toon, Gooch, Normals, Colours };
inline constexpr int kSurfaceStyleCount = 7;

/// What the style Colours shows.
enum class SurfaceQuantity { K1, K2, Lambda, Feature, Offset, OffsetShare };
inline constexpr int kSurfaceQuantityCount = 6;

enum class HiddenLines { Off, Dashed, Shown };
inline constexpr int kHiddenLinesCount = 3;

/// The names in files, "lambert", "k1", "dashed".
std::string_view nameOf(SurfaceStyle style);
std::string_view nameOf(SurfaceQuantity quantity);
std::string_view nameOf(HiddenLines hidden);

/// What the setting says; the usual one for a name that is none.
SurfaceStyle styleOf(const SurfaceSetting& setting);
SurfaceQuantity quantityOf(const SurfaceSetting& setting);
HiddenLines hiddenOf(const SurfaceSetting& setting);

/// How a family is drawn: as the setting says, or as usual where it says nothing. Both have a
/// threshold.
SurfaceFamily familyOf(const SurfaceSetting& setting, LineFamily family);
SurfaceFamily usualFamily(LineFamily family);

/// The setting with another family.
SurfaceSetting withFamily(SurfaceSetting setting, const SurfaceFamily& family);

Rgb colourOf(const SurfaceFamily& family, Palette palette);
std::optional<Rgb> rgbOf(const std::string& hex);  ///< of "#rrggbb"

/// The axis of the mesh that points upward, unit.
Eigen::Vector3d upAxisOf(const SurfaceSetting& setting);

/// What is to be looked for.
LineOptions lineOptionsOf(const SurfaceSetting& setting);

/// Opacity of a line: 1 at twice the threshold, kWeakestInk at the threshold and below.
float inkOf(float strength, double threshold);
inline constexpr float kWeakestInk = 0.25f;

}  // namespace flatland::ui
