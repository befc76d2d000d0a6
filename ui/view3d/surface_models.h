// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/display.h"
#include "ui/model/document.h"
#include "ui/model/seen_surface.h"
#include "ui/model/surface_pick.h"
#include "ui/model/surface_source.h"

namespace flatland::ui {

/// What a view of the surface looks at and acts on; all of it outlives the view.
struct SurfaceModels {
  Document& document;
  SurfaceSource& source;
  SeenSource& seen;
  Display& display;
  SurfacePick& pick;
};

}  // namespace flatland::ui
