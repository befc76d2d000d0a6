// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/flat/crossing_overlay.h"

#include <QEvent>
#include <QPainter>

#include "ui/panels/mark_painting.h"

namespace flatland::ui {

CrossingOverlay::CrossingOverlay(const Bridges& bridges, const Viewport& viewport,
                                 const Display& display, QWidget& canvas)
    : QWidget(&canvas), bridges_(bridges), viewport_(viewport), display_(display) {
  setObjectName("canvas.crossings");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  resize(canvas.size());
  canvas.installEventFilter(this);
  const auto repaint = qOverload<>(&QWidget::update);
  // Hidden without a section: the canvas below is not painted again for an overlay with nothing.
  const auto show = [this] {
    setVisible(bridges_.section.isInFlatland());
    update();
  };
  show();
  connect(&bridges_.section, &SectionSource::changed, this, show);
  connect(&bridges_.section, &SectionSource::chosenChanged, this, repaint);
  connect(&viewport_, &Viewport::changed, this, repaint);
  connect(&display_, &Display::changed, this, repaint);
}

bool CrossingOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(static_cast<QWidget*>(watched)->size());
  return false;
}

std::vector<QPointF> CrossingOverlay::crossings() const {
  std::vector<QPointF> places;
  if (!bridges_.section.isInFlatland()) return places;
  const SectionView& section = *bridges_.section.view();
  for (const SectionPair& pair : section.pairs) {
    if (!pair.ridge) break;  // those come last
    places.push_back(viewport_.toWidget(section.marks.ridges[*pair.ridge].inPlane));
  }
  return places;
}

std::vector<QPointF> CrossingOverlay::chosen() const {
  std::vector<QPointF> places;
  if (!bridges_.section.isInFlatland() || !bridges_.section.chosen()) return places;
  const SectionView& section = *bridges_.section.view();
  const SectionPair& pair = section.pairs.at(*bridges_.section.chosen());
  if (pair.ridge) places.push_back(viewport_.toWidget(section.marks.ridges[*pair.ridge].inPlane));
  if (pair.mark) places.push_back(viewport_.toWidget(section.marks.marks[*pair.mark].mark.point));
  return places;
}

void CrossingOverlay::paintEvent(QPaintEvent*) {
  if (!bridges_.section.isInFlatland()) return;
  const std::vector<QPointF> places = crossings();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const SectionView& section = *bridges_.section.view();
  for (std::size_t i = 0; i < places.size(); ++i) {
    paintCrossing(painter, places[i], static_cast<int>(i) + 1, display_.uiScale(),
                  !section.seenRidges[*section.pairs[i].ridge]);
  }
  for (const QPointF& at : chosen()) paintChosen(painter, at, display_.uiScale());
}

}  // namespace flatland::ui
