// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "ui/model/plots.h"

namespace flatland::ui {

/// The words of the plots along the curve.
struct ProfileWords {
  Q_DECLARE_TR_FUNCTIONS(ProfilePlot)
};

/// "Curvature k", "|offset| / |feature|": the plot's title in the person's language.
QString titleOf(PlotKind kind);
/// What is plotted and on which axis, for tooltips.
QString explanation(PlotKind kind);
/// "k", "feature": the quantity in short.
QString nameForPeople(ProfileQuantity quantity);

}  // namespace flatland::ui
