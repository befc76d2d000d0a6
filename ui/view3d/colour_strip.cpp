// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/colour_strip.h"

#include <QPainter>

#include "ui/export/figure_qt.h"
#include "ui/view3d/picture_legend.h"

namespace flatland::ui {

ColourStrip::ColourStrip(const SurfaceModels& models, QWidget* parent)
    : QWidget(parent), models_(models) {
  setObjectName("surface.colours");
  setAccessibleName(tr("Legend of the colours"));
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(&models_.seen, &SeenSource::changed, this, &ColourStrip::follow);
  connect(&models_.display, &Display::changed, this, [this] {
    updateGeometry();
    update();
  });
}

QSize ColourStrip::sizeHint() const {
  return {320, colourLegendHeight(fontMetrics(), models_.display.uiScale())};
}

void ColourStrip::follow() {
  const auto& seen = models_.seen.seen();
  // Of what there may be no room for.
  const QString words =
      seen && seen->colours ? legendWords(seen->colours->scale).join(", ") : QString();
  setToolTip(words);
  setAccessibleDescription(words);
  update();
}

void ColourStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const SurfacePicture picture = pictureOf(models_);
  const SceneColours& colours = sceneColours(picture.palette);
  painter.fillRect(rect(), toQColor(colours.background));
  painter.setPen(toQColor(colours.text));
  paintColourLegend(painter, rect(), picture);
}

}  // namespace flatland::ui
