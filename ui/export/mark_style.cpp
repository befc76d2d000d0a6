// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/mark_style.h"

#include <array>
#include <cmath>

namespace flatland::ui {

namespace {

// The colour-blind safe palette of Okabe and Ito, with a darker or lighter relative of a hue where
// text of that colour would not reach a contrast of 4.5 : 1.
constexpr Rgb kOrange{0xE6, 0x9F, 0x00};
constexpr Rgb kSkyBlue{0x56, 0xB4, 0xE9};
constexpr Rgb kGreen{0x00, 0x9E, 0x73};
constexpr Rgb kBlue{0x00, 0x72, 0xB2};
constexpr Rgb kVermilion{0xD5, 0x5E, 0x00};
constexpr Rgb kPurple{0xCC, 0x79, 0xA7};
constexpr Rgb kDarkOrange{0x8A, 0x5F, 0x00};
constexpr Rgb kDarkVermilion{0xB3, 0x4F, 0x00};
constexpr Rgb kDarkPurple{0x99, 0x45, 0x75};
constexpr Rgb kLightVermilion{0xF2, 0x84, 0x3A};
constexpr Rgb kLightPurple{0xE0, 0x9C, 0xC2};

using Styles = std::array<MarkStyle, kMarkKindCount>;

// Projecting lines, each family another: also where colour tells nothing.
const std::vector<double> kSolid{};                                   // apparent ridges
const std::vector<double> kDotted{1.2, 3.0};                          // ridges
const std::vector<double> kDashDot{7.0, 3.5, 1.2, 3.5};               // valleys
const std::vector<double> kLongDashes{8.0, 4.0};                      // silhouettes
const std::vector<double> kShortDashes{3.0, 3.5};                     // inflections
const std::vector<double> kDashDotDot{7.0, 3.5, 1.2, 3.5, 1.2, 3.5};  // corners
const std::vector<double> kSparseDots{1.2, 6.0};                      // flat points
const std::vector<double> kLongShort{8.0, 3.5, 3.0, 3.5};             // apparent minima

// In the order of MarkKind.
const Styles& lightStyles() {
  static const Styles kStyles{{
      {'s',
       {0x6B, 0x6B, 0x6B},
       {0x55, 0x55, 0x55},
       MarkSymbol::Dot,
       kLongDashes,
       1.2,
       "Silhouette",
       "Silhouettes",
       true},
      {'i', kBlue, kBlue, MarkSymbol::Diamond, kShortDashes, 1.2, "Inflection", "Inflections",
       true},
      {'r', kVermilion, kDarkVermilion, MarkSymbol::Triangle, kDotted, 1.2, "Ridge", "Ridges",
       true},
      {'v', kPurple, kDarkPurple, MarkSymbol::TriangleDown, kDashDot, 1.2, "Valley", "Valleys",
       true},
      {'f',
       kGreen,
       {0x00, 0x6B, 0x4E},
       MarkSymbol::OpenSquare,
       kSparseDots,
       1.0,
       "Flat point",
       "Flat points",
       false},
      {'c',
       {0x1A, 0x1A, 0x1A},
       {0x1A, 0x1A, 0x1A},
       MarkSymbol::Square,
       kDashDotDot,
       1.2,
       "Corner",
       "Corners",
       true},
      {'a', kOrange, kDarkOrange, MarkSymbol::Bar, kSolid, 2.0, "Apparent ridge", "Apparent ridges",
       true},
      {'m', kOrange, kDarkOrange, MarkSymbol::OpenBar, kLongShort, 1.2, "Apparent minimum",
       "Apparent minima", false},
  }};
  return kStyles;
}

const Styles& darkStyles() {
  static const Styles kStyles = [] {
    Styles styles = lightStyles();
    const auto recolour = [&styles](MarkKind kind, Rgb colour, Rgb letterColour) {
      MarkStyle& style = styles[static_cast<std::size_t>(kind)];
      style.colour = colour;
      style.letterColour = letterColour;
    };
    recolour(MarkKind::Silhouette, {0xA8, 0xA8, 0xA8}, {0xC0, 0xC0, 0xC0});
    recolour(MarkKind::Inflection, kSkyBlue, kSkyBlue);
    recolour(MarkKind::Ridge, kVermilion, kLightVermilion);
    recolour(MarkKind::Valley, kPurple, kLightPurple);
    recolour(MarkKind::Flat, kGreen, {0x2F, 0xC7, 0x9B});
    recolour(MarkKind::Corner, {0xF0, 0xF0, 0xF0}, {0xF0, 0xF0, 0xF0});
    recolour(MarkKind::ApparentRidge, kOrange, kOrange);
    recolour(MarkKind::ApparentMinimum, kOrange, kOrange);
    return styles;
  }();
  return kStyles;
}

/// Lighter still, for black.
const Styles& highContrastStyles() {
  static const Styles kStyles = [] {
    Styles styles = darkStyles();
    for (MarkStyle& style : styles) {
      style.colour = style.letterColour;
      style.lineWidth *= 1.25;
    }
    return styles;
  }();
  return kStyles;
}

PathData polygon(const Vec2& centre, std::initializer_list<Vec2> corners) {
  PathData path;
  for (const Vec2& corner : corners) {
    if (path.verbs.empty()) {
      path.moveTo(centre + corner);
    } else {
      path.lineTo(centre + corner);
    }
  }
  path.close();
  return path;
}

PathData bar(const Vec2& centre, double length, double thickness, double alongRad) {
  const Vec2 along = 0.5 * length * Vec2(std::cos(alongRad), std::sin(alongRad));
  const Vec2 across = thickness / length * rotateCcw(along);
  return polygon(centre, {along + across, along - across, -along - across, -along + across});
}

}  // namespace

const MarkStyle& styleOf(MarkKind kind, Palette palette) {
  const Styles& styles = palette == Palette::Light  ? lightStyles()
                         : palette == Palette::Dark ? darkStyles()
                                                    : highContrastStyles();
  return styles[static_cast<std::size_t>(kind)];
}

MarkKinds defaultMarkKinds() {
  MarkKinds kinds;
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = lightStyles()[i].shownByDefault;
  return kinds;
}

const std::vector<MarkKind>& markKindsInLegendOrder() {
  static const std::vector<MarkKind> kOrder{
      MarkKind::Silhouette, MarkKind::ApparentRidge, MarkKind::Ridge, MarkKind::Valley,
      MarkKind::Inflection, MarkKind::Corner,        MarkKind::Flat,  MarkKind::ApparentMinimum};
  return kOrder;
}

const SceneColours& sceneColours(Palette palette) {
  static const SceneColours kLight{.background = {0xFF, 0xFF, 0xFF},
                                   .curve = {0x11, 0x11, 0x11},
                                   .controlPolygon = {0xA0, 0xA0, 0xA0},
                                   .screen = kGreen,
                                   .text = {0x22, 0x22, 0x22},
                                   .faint = {0xC8, 0xC8, 0xC8}};
  static const SceneColours kDark{.background = {0x1E, 0x1E, 0x22},
                                  .curve = {0xF4, 0xF4, 0xF4},
                                  .controlPolygon = {0x80, 0x80, 0x88},
                                  .screen = kGreen,
                                  .text = {0xE4, 0xE4, 0xE4},
                                  .faint = {0x50, 0x50, 0x58}};
  static const SceneColours kHighContrast{.background = {0x00, 0x00, 0x00},
                                          .curve = {0xFF, 0xFF, 0xFF},
                                          .controlPolygon = {0xB0, 0xB0, 0xB0},
                                          .screen = {0x2F, 0xC7, 0x9B},
                                          .text = {0xFF, 0xFF, 0xFF},
                                          .faint = {0x80, 0x80, 0x80}};
  return palette == Palette::Light ? kLight : palette == Palette::Dark ? kDark : kHighContrast;
}

Rgb paler(Rgb colour, Rgb background) {
  const auto mix = [](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>((5 * a + 7 * b + 6) / 12);
  };
  return {mix(colour.r, background.r), mix(colour.g, background.g), mix(colour.b, background.b)};
}

SymbolOutline symbolOutline(MarkSymbol symbol, const Vec2& centre, double sizePx, double alongRad) {
  const double r = 0.5 * sizePx;
  switch (symbol) {
    case MarkSymbol::Dot: {
      PathData circle;
      circle.addCircle(centre, 0.9 * r);
      return {circle, true};
    }
    case MarkSymbol::Diamond:
      return {polygon(centre, {{0, -1.15 * r}, {1.15 * r, 0}, {0, 1.15 * r}, {-1.15 * r, 0}}),
              true};
    case MarkSymbol::Triangle:  // its centroid at the centre
      return {polygon(centre, {{0, -1.2 * r}, {1.1 * r, 0.7 * r}, {-1.1 * r, 0.7 * r}}), true};
    case MarkSymbol::TriangleDown:
      return {polygon(centre, {{0, 1.2 * r}, {1.1 * r, -0.7 * r}, {-1.1 * r, -0.7 * r}}), true};
    case MarkSymbol::OpenSquare: {
      const double h = 0.6 * r;
      return {polygon(centre, {{-h, -h}, {h, -h}, {h, h}, {-h, h}}), false};
    }
    case MarkSymbol::Square: {
      const double h = 0.75 * r;
      return {polygon(centre, {{-h, -h}, {h, -h}, {h, h}, {-h, h}}), true};
    }
    case MarkSymbol::Bar:
      return {bar(centre, 2.0 * sizePx, 0.4 * sizePx, alongRad), true};
    case MarkSymbol::OpenBar:
      return {bar(centre, 1.6 * sizePx, 0.4 * sizePx, alongRad), false};
  }
  return {};
}

PathShape markSymbol(MarkKind kind, const Vec2& centre, double sizePx, double alongRad,
                     Palette palette, bool hidden) {
  const MarkStyle& style = styleOf(kind, palette);
  const Rgb background = sceneColours(palette).background;
  const Rgb colour = hidden ? paler(style.colour, background) : style.colour;
  SymbolOutline outline = symbolOutline(style.symbol, centre, sizePx, alongRad);
  // A filled symbol has a thin edge of background that sets it off from what it lies on.
  return outline.filled ? PathShape{std::move(outline.path), colour,
                                    Stroke{.colour = background, .width = 0.8}}
                        : PathShape{std::move(outline.path), background,
                                    Stroke{.colour = colour, .width = 1.4}};
}

}  // namespace flatland::ui
