// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstdint>
#include <string_view>
#include <vector>

#include "flatland/features/features.h"
#include "ui/export/figure.h"

namespace flatland::ui {

/// Background the colours are meant for: white, dark grey, black.
enum class Palette { Light, Dark, HighContrast };

/// The shape a family of marks has wherever it is drawn; colour is never the only difference.
enum class MarkSymbol { Dot, Diamond, Triangle, TriangleDown, OpenSquare, Square, Bar, OpenBar };

/// How one family of marks looks, the same on curve, screen, plots, table, legend and in files.
struct MarkStyle {
  char letter;       ///< s, i, r, v, f, c, a, m
  Rgb colour;        ///< shapes and lines (Okabe-Ito)
  Rgb letterColour;  ///< text: the same hue, dark or light enough to read (4.5 : 1)
  MarkSymbol symbol;
  std::vector<double> dash;     ///< projecting line: on, off, ... in px; empty: solid
  double lineWidth;             ///< projecting line, px
  std::string_view name;        ///< "Ridge": English; the window translates it
  std::string_view pluralName;  ///< "Ridges"
  bool shownByDefault;
};

const MarkStyle& styleOf(MarkKind kind, Palette palette = Palette::Light);

/// A set of kinds, indexed by static_cast<std::size_t>(kind).
using MarkKinds = std::bitset<kMarkKindCount>;
MarkKinds defaultMarkKinds();
inline bool contains(const MarkKinds& kinds, MarkKind kind) {
  return kinds[static_cast<std::size_t>(kind)];
}

/// All kinds in the order of the legend: what is seen first, then what explains it.
const std::vector<MarkKind>& markKindsInLegendOrder();

/// The colours that belong to no family.
struct SceneColours {
  Rgb background, curve, controlPolygon, screen, text, faint;
};
const SceneColours& sceneColours(Palette palette);

/// `colour` as it looks when hidden: 5 parts of it to 7 of the background, so no format needs
/// transparency.
Rgb paler(Rgb colour, Rgb background);

/// A root of the misprinted (3.13): in the colours of apparent ridges, but a bar across the curve
/// that is hollow, and it and its line dashed. Sizes in px on the canvas.
struct PrintedRootStyle {
  double barWidth = 6.0, barLength = 22.0;
  double outline = 1.6, line = 1.2;
};

/// Diameter of the symbols, px, except Flat (smaller) and the bars (longer across).
inline constexpr double kSymbolSizePx = 9.0;

/// The closed outline of a symbol around `centre` (figure coordinates, y down), and whether it is
/// filled or an outline only. Bars lie along `alongRad` (the direction of their long side, in
/// figure coordinates); the other symbols stay upright.
struct SymbolOutline {
  PathData path;
  bool filled;
};
SymbolOutline symbolOutline(MarkSymbol symbol, const Vec2& centre, double sizePx, double alongRad);

/// The symbol of a family in its colours, paler if hidden.
PathShape markSymbol(MarkKind kind, const Vec2& centre, double sizePx, double alongRad,
                     Palette palette, bool hidden);

}  // namespace flatland::ui
