// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/app/docks.h"
#include "ui/flat/canvas_models.h"

class QSettings;

namespace flatland::ui {

class LessonModel;
class MessageBar;
class Plots;
class StatusLine;
struct SurfaceModels;

/// What the panels need beside the models; all of it outlives them.
struct PanelParts {
  StatusLine& status;    ///< says what a panel refuses or has done
  MessageBar& messages;  ///< for files that cannot be written
  Plots& plots;
  LessonModel& lesson;
  const SurfaceModels& surface;
  QSettings* settings;  ///< null: nothing is remembered
};

/// Makes every panel of the window and puts it in its dock.
void addPanels(Docks& docks, const CanvasModels& models, const PanelParts& parts);

}  // namespace flatland::ui
