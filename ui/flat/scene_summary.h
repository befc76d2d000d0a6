// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/model/document.h"

namespace flatland::ui {

/// The scene in two or three sentences, for who cannot see the canvas: how many curves and points,
/// from where it is seen, and how many marks there are of each kind.
QString sceneSummary(const Document& document);

}  // namespace flatland::ui
