// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/mark_style.h"
#include "ui/model/theme.h"

class QPainter;
class QPointF;

namespace flatland::ui {

/// Paints a filled or outlined shape of a figure, such as markSymbol().
void paintShape(QPainter& painter, const PathShape& shape);

/// A cross with its number, for a ridge of the surface that goes through the plane: the same on
/// the surface and in flatland.
void paintCrossing(QPainter& painter, const QPointF& at, int number, double scale, bool hidden,
                   Palette palette = themePalette());
/// A ring about a place that is talked about, in the same two pictures.
void paintChosen(QPainter& painter, const QPointF& at, double scale);
/// The crossing for files, without the halo of the number.
std::vector<Shape> crossingShapes(const Vec2& at, int number, double scale, bool hidden,
                                  Palette palette);

}  // namespace flatland::ui
