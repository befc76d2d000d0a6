// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/limits_view.h"

#include <QCoreApplication>
#include <QPainter>

#include "ui/export/figure_qt.h"
#include "ui/model/theme.h"

namespace flatland::ui {

namespace {

struct LimitsWords {
  Q_DECLARE_TR_FUNCTIONS(LimitsWords)
};

}  // namespace

QString nameForPeople(LimitQuantity quantity) {
  switch (quantity) {
    case LimitQuantity::Lambda:
      return LimitsWords::tr("λ");
    case LimitQuantity::Feature:
      return LimitsWords::tr("|feature|");
    case LimitQuantity::Offset:
      return LimitsWords::tr("|offset|");
    case LimitQuantity::Ratio:
      return LimitsWords::tr("|offset| / |feature|");
    case LimitQuantity::RidgeDistance:
      return LimitsWords::tr("apparent ridge to the merging");
    case LimitQuantity::SilhouetteDistance:
      break;
  }
  return LimitsWords::tr("silhouette to the merging");
}

QString xNameForPeople(LimitExperiment experiment) {
  switch (experiment) {
    case LimitExperiment::Turn:
      return LimitsWords::tr("|n·w|");
    case LimitExperiment::Walk:
      return LimitsWords::tr("arc length to the silhouette");
    case LimitExperiment::Slide:
      break;
  }
  return LimitsWords::tr("angle to the merging, radians");
}

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
