// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetrics>
#include <QRect>
#include <QStringList>

#include "ui/view3d/surface_picture.h"

class QPainter;

namespace flatland::ui {

/// Opacity of the ground below words that are written over a surface.
inline constexpr double kBehindText = 0.72;

/// "12.3" of 0.123.
QString percentWords(double share);

/// The colours of a difference with their shares, and how near counts as the same; empty if the
/// view shows none, or it is not known yet.
QStringList differenceLines(const SurfacePicture& picture);

/// What the colours of a scale are, and what kind of scale it is if not linear.
QStringList legendWords(const ColourScale& scale);

/// How high a row is that holds the legend of colours, `scale` times as large as usual, px.
int colourLegendHeight(const QFontMetrics& metrics, double scale);

/// The legend of the colours of a picture: their name, and at the right a bar with numbers below
/// it; nothing if there are none. For a row of colourLegendHeight() below the picture, not over it.
/// Text in the painter's pen. In any thread.
void paintColourLegend(QPainter& painter, const QRect& bounds, const SurfacePicture& picture);

/// The colours of a difference with their lower right corner at that of `bounds`. Text in the
/// painter's pen on its background. How much of the bottom it takes, px; 0 if there is none. In any
/// thread.
int paintDifferenceLegend(QPainter& painter, const QRect& bounds, const SurfacePicture& picture);

}  // namespace flatland::ui
