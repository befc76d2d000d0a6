// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// The bar of a colour map, or the colours of a difference, as a legend with its lower right corner
/// at that of `bounds`. Text in the painter's pen on its background. How much of the bottom it
/// takes, px; 0 if there is none. In any thread.
int paintLegend(QPainter& painter, const QRect& bounds, const SurfacePicture& picture);

}  // namespace flatland::ui
