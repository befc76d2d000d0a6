// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "core3d/draw/camera.h"
#include "ui/view3d/surface_models.h"

class QPainter;

namespace flatland::ui {

// What is written and drawn over one of several views, to say what it compares.

/// Which view terms and t_A are those of, where there are others: the first one, whose lines all
/// views show. Empty where all views have one camera.
QString seenByWords(const std::optional<SurfaceSetting>& setting);

/// The factor on the thresholds and the ink that they give; empty if no ink is asked for.
QStringList inkLines(const SurfaceModels& models);

/// Where the first view is looked at from, in a view with a camera of its own: an eye, and an arrow
/// along its line of sight, paler where the surface is in front. Nothing in other views.
void paintFirstCamera(QPainter& painter, const SurfaceModels& models, const Projection& projection);

}  // namespace flatland::ui
