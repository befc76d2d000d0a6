// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace flatland::ui {

/// The kinds of commands that may merge (QUndoCommand::id); only equal ones are tried.
enum CommandId {
  kCurvesCommandId = 1,
  kViewCommandId = 2,
  kLessonCommandId = 3,
  kSurfaceCommandId = 4
};

}  // namespace flatland::ui
