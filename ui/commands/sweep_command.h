// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/model/document.h"
#include "ui/model/swept_surface.h"

namespace flatland::ui {

/// Makes a curve the surface of the scene (sweptSetting), seen as usual: one step for undo. A
/// revolution is seen along its axis, so the flat view turns there with it. Precondition: there is
/// such a curve.
void sweepCurve(Document& document, std::size_t curve, SweptSurface::Kind kind);

}  // namespace flatland::ui
