// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/display.h"
#include "ui/model/document.h"
#include "ui/model/probe.h"
#include "ui/model/selection.h"
#include "ui/model/stage.h"
#include "ui/model/viewport.h"

namespace flatland::ui {

/// The models a canvas shows and edits; all of them outlive it.
struct CanvasModels {
  Document& document;
  Selection& selection;
  Viewport& viewport;
  Display& display;
  Stage& stage;
  Probe& probe;
};

}  // namespace flatland::ui
