// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

#include "flatland/features/features.h"

namespace flatland::ui {

/// The symbol of a family, as it looks on the curve, in the colours of the person's theme.
QIcon markIcon(MarkKind kind);

}  // namespace flatland::ui
