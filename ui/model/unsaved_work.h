// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "flatland/scene/scene.h"

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

/// What of `now` is otherwise than in `saved`. Cost: a comparison of the points.
UnsavedWork unsavedWork(const Scene& now, const Scene& saved);

/// "the curves, the cameras you kept" in the person's language; where there is no work, how the
/// scene is shown.
QString unsavedWorkForPeople(const Scene& now, const Scene& saved);

}  // namespace flatland::ui
