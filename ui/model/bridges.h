// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/bridge_source.h"
#include "ui/model/plane_grip.h"
#include "ui/model/predicted_dashes.h"
#include "ui/model/section_source.h"
#include "ui/model/view_link.h"

namespace flatland::ui {

/// What joins flatland and the surface beside it.
struct Bridges {
  Bridges(Document& document, const SurfaceSource& surfaceSource, const SeenSource& seenSource);

  ViewLink link;
  BridgeSource source;     ///< curves as surfaces
  PredictedDashes dashes;  ///< of source.view(), to be drawn
  SectionSource section;   ///< surfaces as curves
  PlaneGrip grip;

  bool isStale() const { return source.isStale() || section.isStale(); }
};

}  // namespace flatland::ui
