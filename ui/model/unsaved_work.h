// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "flatland/scene/scene.h"

class QUndoStack;

namespace flatland::ui {

/// What a person has made of a scene and would miss. Looking at it is no work: which mesh stands
/// beside the curves, which families are on, views side by side, shading, ink, plane and camera
/// (docs/decisions/0029-looking-is-no-work.md).
struct UnsavedWork {
  bool curves = false;
  bool view = false;     ///< from where the curves are seen
  bool swept = false;    ///< a surface made of a curve
  bool lines = false;    ///< thresholds, colours, widths or fading of families
  bool cameras = false;  ///< those that are kept

  bool any() const { return curves || view || swept || lines || cameras; }
};

/// What of `now` is otherwise than in `saved`. What is not there any more is none of it. Cost: a
/// comparison of the points.
UnsavedWork unsavedWork(const Scene& now, const Scene& saved);

/// Work on surfaces that went when they were closed or another took their place, and that neither
/// `now`, the scene at `undoIndex`, nor `saved` has: only undoing brings it back. Steps since the
/// clean one count; those of a lesson do not, nor what another scene has taken the place of as a
/// whole. Cost: linear in the steps.
UnsavedWork workTakenOut(const QUndoStack& stack, int undoIndex, const Scene& now,
                         const Scene& saved);

/// "the curves as you changed them, the cameras you kept" in the person's language. Lines are those
/// of the mesh of `scene`, if it has one. Precondition: there is any.
QString workForPeople(const UnsavedWork& work, const Scene& scene = {});

/// The same for a scene with a file, where it also counts which surface there is and which plane
/// cuts it; if nothing of that changed, how it is shown.
QString changesForPeople(const Scene& now, const Scene& saved);

}  // namespace flatland::ui
