// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/compare_presets.h"

#include <algorithm>

#include "ui/model/surface_look.h"
#include "ui/model/surface_panes.h"

namespace flatland::ui {

namespace {

SurfaceSetting withOnly(SurfaceSetting setting, std::initializer_list<LineFamily> families) {
  for (const LineFamily family : allLineFamilies()) {
    const bool on = std::find(families.begin(), families.end(), family) != families.end();
    if (on != familyOf(setting, family).on) setting = withFamilyOn(setting, 0, family, on);
  }
  return setting;
}

SurfacePane paneOf(std::initializer_list<LineFamily> families) {
  SurfacePane pane;
  pane.families.emplace();
  for (const LineFamily family : families) pane.families->emplace_back(nameOf(family));
  return pane;
}

SurfacePane oneRingPane() {
  SurfacePane pane;
  pane.derivative = kOneRing;
  return pane;
}

/// Which families the first view draws.
std::vector<bool> drawnBy(const SurfaceSetting& setting) {
  std::vector<bool> drawn;
  for (const LineFamily family : allLineFamilies()) drawn.push_back(familyOf(setting, family).on);
  return drawn;
}

SurfaceSetting drawing(SurfaceSetting setting, const std::vector<bool>& drawn) {
  std::size_t i = 0;
  for (const LineFamily family : allLineFamilies()) {
    const bool on = drawn[i++];
    if (on != familyOf(setting, family).on) setting = withFamilyOn(setting, 0, family, on);
  }
  return setting;
}

}  // namespace

SurfaceSetting Comparison::compared(SurfaceSetting setting, ComparePreset preset) {
  const std::vector<bool> now = drawnBy(setting);
  const std::vector<bool> own = now == chosen_ ? before_ : now;
  setting = withPreset(std::move(setting), preset);
  if (preset == ComparePreset::OneView) setting = drawing(std::move(setting), own);
  before_ = own;
  chosen_ = drawnBy(setting);
  return setting;
}

SurfaceSetting withPreset(SurfaceSetting setting, ComparePreset preset) {
  constexpr LineFamily kContours = LineFamily::OccludingContours;
  constexpr LineFamily kRims = LineFamily::Boundaries;
  constexpr LineFamily kApparent = LineFamily::ApparentRidges;
  switch (preset) {
    case ComparePreset::OneView:
      return withPaneCount(std::move(setting), 1);
    case ComparePreset::TwoViews:
      return withPaneCount(std::move(setting), 2);
    case ComparePreset::FourViews:
      return withPaneCount(std::move(setting), 4);
    case ComparePreset::Families:
      setting = withOnly(std::move(setting), {kContours, kRims});
      setting.panes = {paneOf({kContours, kRims, LineFamily::SuggestiveContours}),
                       paneOf({kContours, kRims, LineFamily::Ridges, LineFamily::Valleys}),
                       paneOf({kContours, kRims, kApparent})};
      return setting;
    case ComparePreset::Derivatives:
      setting = withOnly(std::move(setting), {kContours, kRims, kApparent});
      setting.panes = {oneRingPane()};
      return setting;
    case ComparePreset::Difference:
      setting = withOnly(std::move(setting), {kApparent});
      setting.panes = {oneRingPane()};
      setting.panes.front().shows = kShowsDifference;
      return setting;
    case ComparePreset::SecondCamera:
      break;
  }
  setting.panes.resize(1);
  setting.panes.front() = SurfacePane{};
  setting.panes.front().camera = setting.camera;
  const SurfaceCamera first = setting.camera;
  return withCamera(std::move(setting), first);
}

}  // namespace flatland::ui
