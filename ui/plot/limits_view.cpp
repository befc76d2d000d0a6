// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/limits_view.h"

#include <QPainter>

#include "ui/export/figure_qt.h"
#include "ui/model/core_words.h"
#include "ui/model/theme.h"
#include "ui/plot/limits_words.h"

namespace flatland::ui {

LimitsView::LimitsView(const Display& display, QWidget* parent)
    : QWidget(parent), display_(display) {
  setObjectName("limits.view");
  setAccessibleName(tr("Power law at the silhouette"));
  setToolTip(tr("Points: measured. Solid: fitted to the last decade. Dashed: predicted"));
  connect(&display_, &Display::changed, this, qOverload<>(&QWidget::update));
}

void LimitsView::setSeries(std::optional<LimitSeries> series, const QString& why) {
  series_ = std::move(series);
  why_ = why;
  update();
}

void LimitsView::setLaw(std::size_t law) {
  if (law == law_) return;
  law_ = law;
  update();
}

void LimitsView::setMarkedX(std::optional<double> x) {
  if (x == markedX_) return;
  markedX_ = x;
  update();
}

LimitsFigureOptions LimitsView::options() const {
  LimitsFigureOptions options;
  options.width = width() / display_.uiScale();
  options.height = height() / display_.uiScale();
  options.palette = themePalette();
  options.words = wordsOfTheWindow();
  options.law = std::min(law_, series_->laws.size() - 1);
  options.markedX = markedX_;
  options.xName = xNameForPeople(series_->experiment).toStdString();
  options.yName = nameForPeople(series_->laws[options.law].quantity).toStdString();
  return options;
}

Figure LimitsView::figureForFile() const {
  LimitsFigureOptions forFile = options();
  forFile.width = LimitsFigureOptions{}.width;
  forFile.height = LimitsFigureOptions{}.height;
  forFile.palette = Palette::Light;
  return limitsFigure(*series_, forFile);
}

void LimitsView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const SceneColours& colours = sceneColours(themePalette());
  if (!series_) {
    painter.fillRect(rect(), toQColor(colours.background));
    painter.setPen(toQColor(colours.text));
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, why_);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(display_.uiScale(), display_.uiScale());
  paintFigure(painter, limitsFigure(*series_, options()));
}

}  // namespace flatland::ui
