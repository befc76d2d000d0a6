// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/mark_groups.h"

#include "ui/panels/mark_painting.h"
#include "ui/view3d/bridge_marks.h"
#include "ui/view3d/plane_marks.h"

namespace flatland::ui {

namespace {

void addSpots(std::vector<FigureGroup>& groups, const SurfacePicture& picture,
              const Projection& projection, double scale) {
  const SectionView& section = *picture.section;
  const std::vector<bool> seen =
      picture.pane.ownCamera ? seenSpots(section, projection.view()) : seenSpots(section);
  FigureGroup parts[] = {{"section-marks-hidden", "marks section hidden", {}},
                         {"section-marks", "marks section visible", {}},
                         {"section-crossings-hidden", "crossings section hidden", {}},
                         {"section-crossings", "crossings section visible", {}}};
  for (const SectionSpot& spot : sectionSpots(section, seen, projection, picture.setting,
                                              picture.markKinds, picture.palette, scale)) {
    // A symbol at the edge would be cut into pieces where there are several views.
    if (spot.at.x() < 0.0 || spot.at.y() < 0.0 || spot.at.x() > projection.width ||
        spot.at.y() > projection.height) {
      continue;
    }
    std::vector<Shape>& to = parts[2 * (spot.crossing > 0) + !spot.hidden].shapes;
    if (spot.crossing == 0) {
      to.emplace_back(spot.symbol);
      continue;
    }
    for (Shape& shape :
         crossingShapes(spot.at, spot.crossing, scale, spot.hidden, picture.palette)) {
      to.push_back(std::move(shape));
    }
  }
  for (FigureGroup& part : parts) {
    if (!part.shapes.empty()) groups.push_back(std::move(part));
  }
}

}  // namespace

std::vector<FigureGroup> markGroups(const SurfacePicture& picture, const Projection& projection,
                                    double scale) {
  std::vector<FigureGroup> groups;
  if (!picture.surface) return groups;
  if (picture.bridge && !picture.pane.ownCamera) {
    FigureGroup ticks{"predicted-ticks", "ticks predicted", {}};
    for (PathShape& shape : tickShapes(*picture.bridge, projection, picture.palette, scale)) {
      ticks.shapes.emplace_back(std::move(shape));
    }
    if (!ticks.shapes.empty()) groups.push_back(std::move(ticks));
  }
  if (picture.section) addSpots(groups, picture, projection, scale);
  return groups;
}

}  // namespace flatland::ui
