// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "flatland/features/printed_roots.h"
#include "flatland/study/derivation.h"

namespace flatland::ui {

/// A number of so many digits, with a true minus sign and a point: as formulas have it.
QString numberForPeople(double value, int digits = 4);

/// Both sides and their difference, as rich text of three rows; or why there are none. The
/// difference is that of the digits shown, with its share of |left| + |right|: 100 % where one side
/// is the other with the wrong sign. Where it is below 1e-12 of the products both are sums of, it
/// is rounding, told as the exact one.
QString valuesForPeople(const DerivationStepText& text, const std::optional<StepReading>& reading,
                        bool printed);

/// In one line: how many printed roots lie at a maximum of lambda, and how far along the curve the
/// nearest apparent ridge is, at best and at worst.
QString missesForPeople(const PrintedRoots& printed);

/// The same for each root, a line each; as many as a tip can hold.
QString eachMissForPeople(const PrintedRoots& printed);

}  // namespace flatland::ui
