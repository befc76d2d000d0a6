// SPDX-License-Identifier: GPL-3.0-or-later
// The rows that name the symbols, and from where the scene is seen.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "ui/export/flat_parts.h"

namespace flatland::ui {

namespace {

constexpr double kTextPx = 11.0;
constexpr double kRowPx = 18.0;
constexpr double kGapPx = 16.0;       // between entries
constexpr double kLetterAtPx = 13.0;  // from the symbol's middle to the letter's
constexpr double kNameAtPx = 21.0;    // from the symbol's middle to the name

struct Entry {
  std::optional<MarkKind> kind;  // none: a line of text
  std::string text;
  double x, y;  // of the symbol's middle, or of the text's start; y from the legend's top
};

std::string formatted(const char* format, double value) {
  char number[32];
  std::snprintf(number, sizeof number, format, value);
  return number;
}

std::string viewText(const View& view, const FlatFigureOptions& options) {
  std::string text =
      inWords(options.words, "seen from %1", {formatted("%.6g\u00b0", view.angleDeg)});
  if (view.distance) {
    text += ", " + inWords(options.words, "at distance %1", {formatted("%.6g", *view.distance)});
  }
  return text;
}

struct Rows {
  std::vector<Entry> entries;
  double height = 0.0;
};

Rows rowsOf(const Scene& scene, const FlatFigureOptions& options) {
  Rows rows;
  const double left = options.margin;
  const double right = options.width - options.margin;
  double x = left;
  double y = 0.5 * kRowPx;
  const auto add = [&](std::optional<MarkKind> kind, const std::string& text) {
    const double textAt = kind ? 0.5 * kSymbolSizePx + kNameAtPx : 0.0;
    const double width = textAt + estimatedWidth(text, kTextPx);
    if (x > left && x + width > right) {
      x = left;
      y += kRowPx;
    }
    rows.entries.push_back({kind, text, kind ? x + 0.5 * kSymbolSizePx : x, y});
    x += width + kGapPx;
  };
  for (const MarkKind kind : markKindsInLegendOrder()) {
    if (contains(options.kinds, kind)) {
      add(kind, inWords(options.words, std::string(styleOf(kind).name)));
    }
  }
  if (options.hidden == FlatFigureOptions::Hidden::Pale) {
    add(std::nullopt, inWords(options.words, "paler: hidden"));
  }
  add(std::nullopt, viewText(scene.view, options));
  rows.height = y + 0.5 * kRowPx;
  return rows;
}

}  // namespace

double legendHeight(const Scene& scene, const FlatFigureOptions& options) {
  return options.legend ? rowsOf(scene, options).height : 0.0;
}

FigureGroup legend(const Scene& scene, const FlatFigureOptions& options) {
  FigureGroup group{"legend", "legend", {}};
  if (!options.legend) return group;
  const SceneColours& colours = sceneColours(options.palette);
  const Rows rows = rowsOf(scene, options);
  const double top = options.height - options.margin - rows.height;
  for (const Entry& entry : rows.entries) {
    const Vec2 at(entry.x, top + entry.y);
    TextShape text{.position = at,
                   .text = entry.text,
                   .size = kTextPx,
                   .colour = colours.text,
                   .anchor = TextShape::Anchor::Start};
    if (entry.kind) {
      const MarkStyle& style = styleOf(*entry.kind, options.palette);
      // Bars stand upright here, as they do on a curve seen from the right.
      group.shapes.emplace_back(markSymbol(*entry.kind, at, 0.8 * kSymbolSizePx,
                                           std::numbers::pi / 2.0, options.palette, false));
      group.shapes.emplace_back(TextShape{.position = at + Vec2(kLetterAtPx, 0.0),
                                          .text = std::string(1, style.letter),
                                          .size = kTextPx,
                                          .colour = style.letterColour,
                                          .bold = true});
      text.position.x() += kNameAtPx;
    }
    group.shapes.emplace_back(std::move(text));
  }
  return group;
}

}  // namespace flatland::ui
