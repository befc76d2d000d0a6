// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/bridges.h"
#include "ui/model/display.h"
#include "ui/model/document.h"
#include "ui/model/orbit.h"
#include "ui/model/surface_pick.h"
#include "ui/model/surface_source.h"
#include "ui/model/surface_study.h"
#include "ui/model/surface_views.h"

namespace flatland::ui {

/// What one view of the surface looks at and acts on; all of it outlives the view.
struct SurfaceModels {
  Document& document;
  SurfaceSource& source;
  SeenSource& seen;  ///< of this view
  Display& display;
  SurfacePick& pick;
  SurfaceStudy& study;  ///< of what is picked
  SurfaceViews& views;
  Bridges& bridges;
  std::size_t pane = 0;  ///< which of the views it is

  /// The same for another of the views.
  SurfaceModels of(std::size_t other) const {
    return {document, source, views.seen(other), display, pick, study, views, bridges, other};
  }

  /// True if the document has a surface, and so many views of it.
  bool there() const { return document.scene().surface && pane < views.count(); }

  /// How this view is drawn, and from where it is looked at. Precondition: there().
  PaneSetting setting() const { return views.setting(pane); }
  const SurfaceCamera& camera() const { return paneCamera(*document.scene().surface, pane); }
  /// The view that lines are found for, which is that of view 0 in every view: what is said of a
  /// place is said of it. Preconditions: there(), and a surface that has been read.
  SurfaceView foundView() const {
    return orbitView(document.scene().surface->camera, source.surface()->ballRadius);
  }
  /// Moves the camera of this view, which may be that of others too. Precondition: there().
  void setCamera(const SurfaceCamera& camera) const { document.setCamera(camera, pane); }
};

}  // namespace flatland::ui
