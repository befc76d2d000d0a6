// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "flatland/features/features.h"

namespace flatland::ui {

/// The kind in the person's language: "Apparent ridge".
QString nameForPeople(MarkKind kind);
/// "Apparent ridges"
QString pluralForPeople(MarkKind kind);
/// One sentence on what the kind is, for tooltips.
QString explanation(MarkKind kind);

}  // namespace flatland::ui
