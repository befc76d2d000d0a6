// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ui/export/figure.h"
#include "ui/export/figure_words.h"
#include "ui/export/mark_style.h"

// What the diagrams share; not for others.
namespace flatland::ui {

/// Puts a diagram together: groups in the order of drawing, lines and words in its colours.
class FigureBuilder {
 protected:
  FigureBuilder(double width, double height, Palette palette, double textPx, FigureWords words = {})
      : colours_(sceneColours(palette)), textPx_(textPx), words_(std::move(words)) {
    figure_.width = width;
    figure_.height = height;
    figure_.background = colours_.background;
  }

  /// Stays valid until the next group.
  FigureGroup& group(const std::string& id, const std::string& classes) {
    return figure_.groups.emplace_back(FigureGroup{id, classes, {}});
  }

  static void addLine(FigureGroup& to, const Vec2& a, const Vec2& b, const Stroke& stroke) {
    PathData path;
    path.moveTo(a);
    path.lineTo(b);
    to.shapes.emplace_back(PathShape{std::move(path), std::nullopt, stroke});
  }

  void addText(FigureGroup& to, const Vec2& at, const std::string& text,
               TextShape::Anchor anchor) const {
    to.shapes.emplace_back(TextShape{at, text, textPx_, colours_.text, anchor, false});
  }

  /// The English in the reader's language (inWords).
  std::string say(const std::string& english, const std::vector<std::string>& values = {}) const {
    return inWords(words_, english, values);
  }

  Stroke gridStroke() const {
    return {.colour = paler(colours_.faint, colours_.background), .width = 0.7};
  }
  Stroke frameStroke() const { return {.colour = colours_.text, .width = 1.0}; }

  const SceneColours& colours_;
  double textPx_;
  FigureWords words_;
  Figure figure_;
};

}  // namespace flatland::ui
