// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/model/bridges.h"

namespace flatland::ui {

Bridges::Bridges(Document& document, const SurfaceSource& surfaceSource,
                 const SeenSource& seenSource)
    : link(document), source(seenSource), section(document, surfaceSource, seenSource) {
  const auto show = [this] {
    std::optional<CutPlane> plane;
    if (section.isInFlatland()) plane = section.view()->section.plane;
    link.setSectionPlane(plane);
  };
  QObject::connect(&section, &SectionSource::changed, &link, show);
  QObject::connect(&document, &Document::changed, &link, [this, show](const Change& change) {
    if (change.touchesScene() && change.what != Change::What::View) show();
    if (change.what == Change::What::Scene) link.judgeScene();
  });
}

}  // namespace flatland::ui
