// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QStringList>

#include "core3d/draw/camera.h"
#include "ui/view3d/surface_models.h"

class QPainter;

namespace flatland::ui {

// What is written and drawn over one of several views, to say what it compares.

/// The factor on the thresholds and the ink that they give; empty if no ink is asked for.
QStringList inkLines(const SurfaceModels& models);

/// The colours of a difference with their shares, and how near counts as the same; empty if the
/// view shows none, or it is not known yet.
QStringList differenceLines(const SurfaceModels& models);

/// The same as a legend with its lower right corner at that of `bounds`. Text in the painter's pen
/// on its background. Its height, px; 0 if there is none.
int paintDifferenceLegend(QPainter& painter, const QRect& bounds, const SurfaceModels& models);

/// Where the first view is looked at from, in a view with a camera of its own: an eye, and an arrow
/// along its line of sight, paler where the surface is in front. Nothing in other views.
void paintFirstCamera(QPainter& painter, const SurfaceModels& models, const Projection& projection);

}  // namespace flatland::ui
