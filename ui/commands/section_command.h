// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/model/section_source.h"

namespace flatland::ui {

/// Why a section cannot be opened as curves, for a person; empty if it can.
QString whyNotOpened(const SectionView* section);

/// Replaces the scene's curves and view by those of the section, beside the same surface: one step
/// for undo. A swept surface goes with the curve that it is made of, and comes back with it.
/// Precondition: whyNotOpened() is empty.
void openSection(Document& document, const SectionView& section);

}  // namespace flatland::ui
