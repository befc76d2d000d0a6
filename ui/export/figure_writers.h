// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "ui/export/figure.h"

namespace flatland::ui {

/// The figure as SVG 1.1: one <g> with id and class per group, text as text, and a <metadata> that
/// holds program, command and scene.
std::string figureToSvg(const Figure& figure, const FigureSource& source);

/// The figure as TikZ: a file that compiles alone with pdflatex, xelatex or lualatex (class
/// standalone) and, through the package of that name, can be \input into a document as a
/// tikzpicture. Colours are defined by name, so a document can change them.
std::string figureToTikz(const Figure& figure, const FigureSource& source);

}  // namespace flatland::ui
