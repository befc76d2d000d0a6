// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core3d/draw/camera.h"
#include "ui/model/bridge_source.h"

namespace flatland::ui {

/// Where a mark of the curve is seen at the edge of the picture: the picture's edge is flatland's
/// screen, and the line from the mark goes there along the rulings, or, of a revolution, along the
/// picture of the axis across the plane of the curve.
struct EdgeTick {
  Eigen::Vector2d at;      ///< px, on the edge of the picture
  Eigen::Vector2d inward;  ///< unit
  std::size_t line;        ///< index into the prediction's lines
};

/// On the lower edge as far as the picture is upright; none where the direction is seen end-on, or
/// the mark is out of the picture.
std::vector<EdgeTick> edgeTicks(const BridgeView& bridge, const Projection& projection);

/// The predicted line nearest to a pixel, if one is within a reach in px.
std::optional<std::size_t> predictedLineAt(const BridgeView& bridge, const Projection& projection,
                                           const Eigen::Vector2d& px, double reachPx);

}  // namespace flatland::ui
