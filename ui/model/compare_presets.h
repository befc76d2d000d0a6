// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "flatland/scene/surface_setting.h"

namespace flatland::ui {

/// Arrangements of views that show one thing against another.
enum class ComparePreset {
  OneView,
  TwoViews,
  FourViews,
  Families,      ///< contours; suggestive contours; ridges and valleys; apparent ridges
  Derivatives,   ///< apparent ridges by the closed form, and from neighbours as the thesis did
  Difference,    ///< the two of them in one view
  SecondCamera,  ///< the lines of the first view seen from its side
};

/// The setting with that arrangement; thresholds, colours and the camera of the first view stay.
/// Views that are there already are kept by the first three, as many as there is room for.
SurfaceSetting withPreset(SurfaceSetting setting, ComparePreset preset);

/// Comparing one surface in several ways, one after the other. The families that were drawn before
/// come back with one view, unless somebody has chosen others meanwhile.
class Comparison {
 public:
  /// withPreset(), with that.
  SurfaceSetting compared(SurfaceSetting setting, ComparePreset preset);

 private:
  // By family, in the order of allLineFamilies().
  std::vector<bool> before_;
  std::vector<bool> chosen_;  ///< by the last arrangement
};

}  // namespace flatland::ui
