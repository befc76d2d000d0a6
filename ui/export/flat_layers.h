// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "flatland/features/features.h"
#include "ui/export/figure.h"

namespace flatland::ui {

/// What lies above what in the flat figure, from the bottom to the top.
enum class FlatLayer { ControlPolygon, Rays, Sight, Curve, Screen, Image, Marks, Letters, Viewer };

/// The groups of a flat figure. They may be asked for in any order: they come sorted by layer,
/// hidden before seen, and within a layer by family, wide lines below, what is small on top. Ids
/// and classes say layer, family and "hidden".
class FlatLayers {
 public:
  /// The group of a layer as a whole.
  FigureGroup& group(FlatLayer layer, bool visible = true);
  /// The group of a mark's family in a layer.
  FigureGroup& group(FlatLayer layer, const Mark& mark);

  /// Those that have shapes; none are left.
  std::vector<FigureGroup> taken();

 private:
  std::map<std::tuple<FlatLayer, bool, int>, FigureGroup> groups_;  // the bool: not hidden
};

}  // namespace flatland::ui
