// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/app/docks.h"
#include "ui/flat/canvas_models.h"

namespace flatland::ui {

class StatusLine;

/// Makes every panel of the window and puts it in its dock. What a panel refuses is said in the
/// status line.
void addPanels(Docks& docks, const CanvasModels& models, StatusLine& status);

}  // namespace flatland::ui
