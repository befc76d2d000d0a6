// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/line_style.h"

#include <array>

namespace flatland::ui {

std::array<LineFamily, kLineFamilyCount> paintingOrder() {
  using enum LineFamily;
  return {Isophotes,
          Topographic,
          SuggestiveContours,
          SuggestiveHighlights,
          ApparentRidges,
          PrincipalHighlights,
          Ridges,
          Valleys,
          Parabolic,
          ZeroMeanCurvature,
          Creases,
          SelfIntersections,
          OccludingContours,
          Boundaries,
          ExteriorSilhouette};
}

Rgb lineColour(LineFamily family, Palette palette) {
  const SceneColours& scene = sceneColours(palette);
  const auto mark = [palette](MarkKind kind) { return styleOf(kind, palette).colour; };
  const bool dark = palette != Palette::Light;
  switch (family) {
    case LineFamily::ExteriorSilhouette:
      // On black one white is like the other, and the ways to darken it are taken.
      return palette == Palette::HighContrast ? Rgb{0xFF, 0xF0, 0x70} : scene.text;
    case LineFamily::OccludingContours:
      return scene.text;
    case LineFamily::SuggestiveContours:
      return mark(MarkKind::Inflection);
    case LineFamily::SuggestiveHighlights:
      return dark ? Rgb{0xC4, 0xE6, 0xFF} : Rgb{0x56, 0xB4, 0xE9};
    case LineFamily::ApparentRidges:
      return mark(MarkKind::ApparentRidge);
    case LineFamily::PrincipalHighlights:
      return dark ? Rgb{0x66, 0xD9, 0xC8} : Rgb{0x00, 0x7A, 0x87};
    case LineFamily::Ridges:
      return mark(MarkKind::Ridge);
    case LineFamily::Valleys:
      return mark(MarkKind::Valley);
    case LineFamily::Parabolic:
      return mark(MarkKind::Flat);
    case LineFamily::ZeroMeanCurvature:
      return dark ? Rgb{0xC8, 0xD8, 0x50} : Rgb{0x6B, 0x7A, 0x00};
    case LineFamily::Creases:
      return dark ? Rgb{0xC9, 0xA5, 0x86} : Rgb{0x7A, 0x4A, 0x20};
    case LineFamily::Boundaries:
      return dark ? Rgb{0xA0, 0xA0, 0xA0} : Rgb{0x5A, 0x5A, 0x5A};
    case LineFamily::SelfIntersections:
      return dark ? Rgb{0xFF, 0x6E, 0x8A} : Rgb{0xB0, 0x10, 0x40};
    case LineFamily::Isophotes:
      return dark ? Rgb{0x84, 0x88, 0x90} : Rgb{0x8A, 0x8C, 0x90};
    case LineFamily::Topographic:
      break;
  }
  return dark ? Rgb{0xA8, 0x98, 0x78} : Rgb{0x93, 0x80, 0x5E};  // as on maps
}

Rgb predictedColour(MarkKind kind, Palette palette) {
  const bool light = palette == Palette::Light;
  if (kind == MarkKind::Silhouette) return light ? Rgb{0x4E, 0x86, 0xB8} : Rgb{0x8F, 0xC4, 0xF0};
  return light ? Rgb{0x5A, 0x32, 0xC8} : Rgb{0xB9, 0x9C, 0xFF};
}

std::string_view lineTitle(LineFamily family) {
  constexpr std::array<std::string_view, kLineFamilyCount> kTitles = {
      "Exterior silhouette",
      "Occluding contours",
      "Suggestive contours",
      "Suggestive highlights",
      "Apparent ridges",
      "Principal highlights",
      "Isophotes",
      "Ridges",
      "Valleys",
      "Parabolic lines",
      "Zero mean curvature",
      "Creases",
      "Boundaries",
      "Self-intersections",
      "Topographic lines",
  };
  return kTitles[static_cast<std::size_t>(family)];
}

}  // namespace flatland::ui
