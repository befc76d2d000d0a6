// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "flatland/io/svg_file.h"

namespace flatland::ui {

/// A letter of a font.
struct GlyphName {
  QString family;
  char32_t character = U'a';

  /// "glyph:DejaVu Sans:a"
  std::string argument() const;
};

/// Reads "glyph:FAMILY:CHARACTER"; the character may also be written "U+0061". Throws InputError.
GlyphName glyphNamed(const std::string& argument);

/// The outline of a glyph as a scene: one closed curve for each contour, from the font's own
/// unhinted outline in units of its em, quadratic where the font's is (TrueType), else cubic
/// (PostScript). Scaled and centred as drawings are (flatland/io/svg_file.h). Needs a
/// QGuiApplication. Throws InputError for a family or glyph that is not there, naming the nearest
/// that are, and for a glyph without an outline.
ImportedScene glyphScene(const GlyphName& name);

}  // namespace flatland::ui
