// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/view3d/surface_models.h"

class QMenu;

namespace flatland::ui {

/// What a view shows, in the person's language: the names of its families, that it is a difference,
/// has a camera of its own. Precondition: models.there().
QString paneWords(const SurfaceModels& models);

/// Fills a menu, anew each time, with what can be changed in one view: its families, the derivative
/// of its apparent ridges, lines or difference, a camera of its own. Every choice is an undo step.
void fillPaneMenu(QMenu& menu, const SurfaceModels& models);

}  // namespace flatland::ui
