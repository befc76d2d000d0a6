// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/sweep_axes.h"
#include "ui/plot/sweep_source.h"

namespace flatland::ui {

/// The ring (a birth or merge) of the diagram nearest to `px`, if one is within `reachPx`.
const SweepEvent* foldNear(const SweepData& data, const SweepAxes& axes, const Vec2& px,
                           double reachPx);

/// The place a click at `px` means: the ring, or the line or branch at the click's angle that is
/// nearest above or below it, if within `reachPx`; else the position itself. The angle is rounded
/// to less than a tenth of a pixel. nullopt without curves.
std::optional<SweepAxes::Place> snappedPlace(const SweepData& data, const SweepAxes& axes,
                                             const Vec2& px, double reachPx);

/// The angle, nearest to `nearDeg`, of the next event of a sweep in the direction of `step` (1 or
/// -1); nullopt if there is none. Events hold modulo 180 degrees.
std::optional<double> nextEventDeg(const Sweep& sweep, double nearDeg, int step);

}  // namespace flatland::ui
