// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core3d/lines/feature_lines.h"
#include "flatland/scene/surface_setting.h"

namespace flatland::ui {

// The views of one surface side by side. View 0 is what a SurfaceSetting says itself, view i its
// panes[i - 1]; what a pane does not say is as in view 0. Lines of all views are found for the
// camera of view 0.

/// One view, as if it were the only one.
struct PaneSetting {
  /// The families of the view are on, and there are no panes. Its camera is that the lines are
  /// found for.
  SurfaceSetting surface;
  RidgeDerivative derivative = RidgeDerivative::ClosedForm;
  bool difference = false;  ///< its lines are compared with those of view 0
  bool ownCamera = false;
  SurfaceCamera camera;  ///< it is looked at from

  bool operator==(const PaneSetting&) const = default;
};

std::size_t paneCount(const SurfaceSetting& setting);  ///< 1 + panes

/// Precondition: pane < paneCount().
PaneSetting paneSetting(const SurfaceSetting& setting, std::size_t pane);

/// From where view `pane` is looked at; that of view 0 where it has none of its own.
const SurfaceCamera& paneCamera(const SurfaceSetting& setting, std::size_t pane);

/// True if a view is looked at from elsewhere than its lines are found for.
bool camerasDiffer(const SurfaceSetting& setting);

/// The setting seen from another camera: that of view 0. Cameras of views of their own are set
/// about it, a quarter turn apart about its upward axis.
SurfaceSetting withCamera(SurfaceSetting setting, const SurfaceCamera& camera);

/// What is to be looked for in a view.
LineOptions lineOptionsOf(const PaneSetting& pane);

/// The setting with a family switched in one view. A view that drew the families of the first has
/// a list of its own from then on.
SurfaceSetting withFamilyOn(SurfaceSetting setting, std::size_t pane, LineFamily family, bool on);

/// The setting with so many views, 1 to 1 + kMostPanes: new ones look like the first.
SurfaceSetting withPaneCount(SurfaceSetting setting, std::size_t count);

/// The names in files.
inline constexpr char kOneRing[] = "one-ring", kClosedForm[] = "closed-form";
inline constexpr char kShowsLines[] = "lines", kShowsDifference[] = "difference";

}  // namespace flatland::ui
