// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "flatland/study/derivation.h"

namespace flatland::ui {

/// Both sides, how far they are apart and the residual, as rich text of three lines; or why there
/// are none.
QString valuesForPeople(DerivationStep step, const std::optional<StepReading>& reading,
                        bool printed);

}  // namespace flatland::ui
