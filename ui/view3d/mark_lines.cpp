// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/mark_lines.h"

#include "ui/export/line_style.h"

namespace flatland::ui {

std::vector<MarkLines> predictedLines(Bridges& bridges, Palette palette) {
  std::vector<MarkLines> all;
  const std::shared_ptr<const BridgeView>& bridge = bridges.source.view();
  const std::vector<LineEnds>& dashes = bridges.dashes.of(bridge);
  for (std::size_t i = 0; i < dashes.size(); ++i) {
    const float ink = bridge->limits[i] == BridgeLimit::None ? 1.0f : kLimitedInk;
    const MarkKind kind = bridge->prediction.lines()[i].kind;
    all.push_back({dashes[i], predictedColour(kind, palette), kPredictedWidthPx, ink});
  }
  return all;
}

Rgb sectionColour(Palette palette) {
  return palette == Palette::Light ? Rgb{0x00, 0x7A, 0x5A} : Rgb{0x2E, 0xD9, 0xA3};
}

MarkLines sectionLine(const std::shared_ptr<const SectionView>& section, Palette palette) {
  return {LineEnds(section, &section->lines), sectionColour(palette), kSectionWidthPx, 1.0f};
}

}  // namespace flatland::ui
