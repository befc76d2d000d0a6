// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPainterPath>
#include <string>

#include "ui/export/figure.h"

class QPainter;

namespace flatland::ui {

QColor toQColor(Rgb colour);
QPainterPath toPainterPath(const PathData& path);

/// Paints the figure in its own coordinates (1 px = 1 unit of the painter), antialiased, background
/// included. The painter's state is as before afterwards.
void paintFigure(QPainter& painter, const Figure& figure);

/// The figure as a PDF file of its size (1 px = 1/96 inch), shapes as vectors and text as text.
/// Needs a QGuiApplication.
std::string figureToPdf(const Figure& figure, const FigureSource& source);

/// The figure as a PNG file, `dpi` / 96 pixels per px, rounded to whole pixels; transparent where
/// the figure has no background. Needs a QGuiApplication. Throws InputError if it does not fit into
/// memory (above 32,768 pixels a side).
std::string figureToPng(const Figure& figure, const FigureSource& source, double dpi = 96.0);

}  // namespace flatland::ui
