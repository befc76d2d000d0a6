// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/flat_layers.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace flatland::ui {

namespace {

std::string_view layerName(FlatLayer layer) {
  switch (layer) {
    case FlatLayer::ControlPolygon:
      return "control-polygon";
    case FlatLayer::Rays:
      return "rays";
    case FlatLayer::Sight:
      return "sight";
    case FlatLayer::Curve:
      return "curve";
    case FlatLayer::Screen:
      return "screen";
    case FlatLayer::Image:
      return "image";
    case FlatLayer::Marks:
      return "marks";
    case FlatLayer::Letters:
      return "letters";
    case FlatLayer::Viewer:
      return "viewer";
  }
  return "";
}

/// Wide lines below, what is small and exact on top.
int drawingOrder(MarkKind kind) {
  constexpr std::array<MarkKind, kMarkKindCount> kOrder{
      MarkKind::ApparentRidge, MarkKind::ApparentMinimum, MarkKind::Flat,   MarkKind::Silhouette,
      MarkKind::Ridge,         MarkKind::Valley,          MarkKind::Corner, MarkKind::Inflection};
  return static_cast<int>(std::find(kOrder.begin(), kOrder.end(), kind) - kOrder.begin());
}

}  // namespace

FigureGroup& FlatLayers::group(FlatLayer layer, bool visible) {
  FigureGroup& found = groups_[{layer, visible, -1}];
  if (found.id.empty()) {
    found.id = std::string(layerName(layer)) + (visible ? "" : "-hidden");
    found.classes = std::string(layerName(layer)) + (visible ? "" : " hidden");
  }
  return found;
}

FigureGroup& FlatLayers::group(FlatLayer layer, const Mark& mark) {
  FigureGroup& found = groups_[{layer, mark.visible, drawingOrder(mark.kind)}];
  if (found.id.empty()) {
    const std::string kind(nameOf(mark.kind));
    found.id = std::string(layerName(layer)) + "-" + kind + (mark.visible ? "" : "-hidden");
    found.classes = std::string(layerName(layer)) + " " + kind + (mark.visible ? "" : " hidden");
  }
  return found;
}

std::vector<FigureGroup> FlatLayers::taken() {
  std::vector<FigureGroup> taken;
  for (auto& [key, group] : groups_) {
    if (!group.shapes.empty()) taken.push_back(std::move(group));
  }
  groups_.clear();
  return taken;
}

}  // namespace flatland::ui
