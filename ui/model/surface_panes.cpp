// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/surface_panes.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "ui/model/orbit.h"
#include "ui/model/surface_look.h"

namespace flatland::ui {

namespace {

std::vector<std::string> familiesOn(const SurfaceSetting& setting) {
  std::vector<std::string> names;
  for (const LineFamily family : allLineFamilies()) {
    if (familyOf(setting, family).on) names.emplace_back(nameOf(family));
  }
  return names;
}

}  // namespace

std::size_t paneCount(const SurfaceSetting& setting) { return 1 + setting.panes.size(); }

const SurfaceCamera& paneCamera(const SurfaceSetting& setting, std::size_t pane) {
  if (pane == 0 || !setting.panes[pane - 1].camera) return setting.camera;
  return *setting.panes[pane - 1].camera;
}

bool camerasDiffer(const SurfaceSetting& setting) {
  return std::any_of(setting.panes.begin(), setting.panes.end(),
                     [](const SurfacePane& pane) { return pane.camera.has_value(); });
}

SurfaceSetting withCamera(SurfaceSetting setting, const SurfaceCamera& camera) {
  setting.camera = camera;
  double turn = 0.0;
  for (SurfacePane& pane : setting.panes) {
    turn += std::numbers::pi / 2.0;
    if (pane.camera) pane.camera = spun(camera, turn);
  }
  return setting;
}

PaneSetting paneSetting(const SurfaceSetting& setting, std::size_t pane) {
  PaneSetting view;
  view.surface = setting;
  view.surface.panes.clear();
  view.camera = paneCamera(setting, pane);
  if (pane == 0) return view;
  const SurfacePane& own = setting.panes[pane - 1];
  view.ownCamera = own.camera.has_value();
  view.difference = own.shows == kShowsDifference;
  if (own.derivative == kOneRing) view.derivative = RidgeDerivative::OneRing;
  if (!own.families) return view;
  for (const LineFamily family : allLineFamilies()) {
    SurfaceFamily look = familyOf(setting, family);
    look.on =
        std::find(own.families->begin(), own.families->end(), look.name) != own.families->end();
    view.surface = withFamily(std::move(view.surface), look);
  }
  return view;
}

LineOptions lineOptionsOf(const PaneSetting& pane) {
  LineOptions options = lineOptionsOf(pane.surface);
  options.derivative = pane.derivative;
  return options;
}

SurfaceSetting withFamilyOn(SurfaceSetting setting, std::size_t pane, LineFamily family, bool on) {
  if (pane == 0) {
    SurfaceFamily look = familyOf(setting, family);
    look.on = on;
    return withFamily(std::move(setting), look);
  }
  std::optional<std::vector<std::string>>& own = setting.panes[pane - 1].families;
  if (!own) own = familiesOn(setting);
  const std::string name(nameOf(family));
  std::erase(*own, name);
  if (on) own->push_back(name);
  return setting;
}

SurfaceSetting withPaneCount(SurfaceSetting setting, std::size_t count) {
  setting.panes.resize(std::clamp<std::size_t>(count, 1, 1 + kMostPanes) - 1);
  return setting;
}

}  // namespace flatland::ui
