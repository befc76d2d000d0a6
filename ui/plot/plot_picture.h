// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <string>

class QCustomPlot;

namespace flatland::ui {

enum class PictureFormat { Svg, Pdf, Png };

/// "svg", "pdf", "png"
QString suffixOf(PictureFormat format);

/// The plot as a file of `size` (px of 1/96 inch); SVG and PDF as vectors with text as text, PNG
/// with `dpi` / 96 pixels per px. The plot is laid out anew for it, so use one that no one
/// looks at. Throws InputError if a PNG does not fit into memory.
std::string pictureOf(QCustomPlot& plot, PictureFormat format, const QSize& size, double dpi,
                      const QString& title);

}  // namespace flatland::ui
