// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core3d/draw/camera.h"
#include "ui/export/mark_style.h"
#include "ui/view3d/surface_models.h"

class QPainter;

namespace flatland::ui {

/// What is drawn at a place of a section.
struct SectionSpot {
  PathShape symbol;  ///< of a mark; empty for a crossing
  int crossing = 0;  ///< its number, from 1; 0 for a mark
  Vec2 at;           ///< px
  bool hidden;
};

/// The marks of a section of the kinds that are shown, and where apparent ridges of the surface go
/// through its plane. `seen` says what can be seen: marks first, then ridges. What cannot is left
/// out where the setting leaves hidden lines out.
std::vector<SectionSpot> sectionSpots(const SectionView& section, const std::vector<bool>& seen,
                                      const Projection& projection, const SurfaceSetting& setting,
                                      MarkKinds kinds, Palette palette, double scale);

/// `seen` of sectionSpots() as the first view sees it, and as another one does: by a ray for each.
std::vector<bool> seenSpots(const SectionView& section);
std::vector<bool> seenSpots(const SectionView& section, const SurfaceView& view);

/// Where the chosen pair is in the picture, px: on the surface, on its section, or both.
std::vector<Eigen::Vector2d> chosenSpots(const SectionSource& source, const Projection& projection);

/// Paints the handles of the cutting plane over the picture of the surface, the marks of the
/// section, and with numbers where apparent ridges of the surface go through the plane. Hidden
/// marks are paler.
void paintPlane(QPainter& painter, const SurfaceModels& models, const Projection& projection);

}  // namespace flatland::ui
