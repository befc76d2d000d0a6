// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "flatland/study/limits.h"

namespace flatland::ui {

/// What a law is of, and what its x is, for people.
QString nameForPeople(LimitQuantity quantity);

QString xNameForPeople(LimitExperiment experiment);

/// What happens on the way to a silhouette, in a few sentences.
QString explanationOf(LimitCase limitCase);

}  // namespace flatland::ui
