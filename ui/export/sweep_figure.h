// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flatland/screen/sweep_visibility.h"
#include "ui/export/figure.h"
#include "ui/export/figure_words.h"
#include "ui/export/mark_style.h"
#include "ui/export/sweep_axes.h"

namespace flatland::ui {

struct SweepFigureOptions {
  double width = 960.0, height = 600.0;  ///< px
  double textPx = 12.0;
  MarkKinds kinds = defaultMarkKinds();
  std::optional<double> viewAngleDeg;  ///< drawn as a line if given
  Palette palette = Palette::Light;
  bool legend = true;
  FigureWords words;
  std::optional<SweepWindow> window;            ///< none: the whole diagram
  const SweepVisibility* visibility = nullptr;  ///< of this sweep; none: nothing is paler
};

/// The diagram of a sweep: view direction from -180 to 180 degrees against arc length, curves of a
/// scene above each other. Marks that do not move are level lines, silhouettes and apparent ridges
/// curves, paler where hidden; births and merges are ringed. Colours, symbols and letters are those
/// of the marks elsewhere.
Figure sweepFigure(const Sweep& sweep, const std::vector<double>& curveLengths,
                   const SweepFigureOptions& options);

/// The axes that sweepFigure uses.
SweepAxes sweepAxes(const Sweep& sweep, const std::vector<double>& curveLengths,
                    const SweepFigureOptions& options);

/// Arc lengths of the scene's curves, far more accurate than a pixel.
std::vector<double> curveLengths(const Scene& scene);

/// Radius of the ring around a birth or merge, px.
inline constexpr double kEventRingPx = 5.0;

}  // namespace flatland::ui
