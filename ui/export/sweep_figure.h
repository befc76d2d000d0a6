// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flatland/screen/sweep.h"
#include "ui/export/figure.h"
#include "ui/export/mark_style.h"

namespace flatland::ui {

struct SweepFigureOptions {
  double width = 960.0, height = 600.0;  ///< px
  MarkKinds kinds = defaultMarkKinds();
  std::optional<double> viewAngleDeg;  ///< drawn as a line if given
  Palette palette = Palette::Light;
};

/// The diagram of a sweep: view direction from -180 to 180 degrees against arc length, curves of a
/// scene above each other. Marks that do not move are level lines, silhouettes and apparent ridges
/// curves; births and merges are ringed. Colours and dashes are those of the marks elsewhere.
Figure sweepFigure(const Sweep& sweep, const std::vector<double>& curveLengths,
                   const SweepFigureOptions& options);

}  // namespace flatland::ui
