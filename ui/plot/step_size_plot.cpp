// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/step_size_plot.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "qcustomplot.h"
#include "ui/export/figure_qt.h"
#include "ui/plot/plot_style.h"

namespace flatland::ui {

namespace {

constexpr double kSmallest = 1e-18;  ///< exact agreement is drawn here: a log axis has no zero

constexpr double kDecades = 1e4;  ///< a label every four decades: the plot is small

void makeLogarithmic(QCPAxis& axis) {
  axis.setScaleType(QCPAxis::stLogarithmic);
  const auto ticker = QSharedPointer<QCPAxisTickerLog>::create();
  ticker->setLogBase(kDecades);
  ticker->setSubTickCount(0);
  axis.setTicker(ticker);
  axis.setNumberFormat("eb");
  axis.setNumberPrecision(0);
}

}  // namespace

StepSizePlot::StepSizePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->addWidget(plot_);
  plot_->setObjectName("lesson.step-sizes");
  plot_->setAccessibleName(tr("Difference quotients against their step size"));
  plot_->setToolTip(plot_->accessibleName());
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) makeLogarithmic(*axis);
  plot_->xAxis->setLabel(tr("step h"));
  plot_->yAxis->setLabel(tr("off by"));
  plot_->addGraph();
  plot_->addGraph();
  restyle();
}

void StepSizePlot::restyle() {
  const Palette colours = figurePaletteOf(palette());
  stylePlot(*plot_, colours);
  const QColor corrected = plotColours(colours).line;
  const QColor printed = toQColor(styleOf(MarkKind::ApparentRidge, colours).colour);
  plot_->graph(0)->setPen(QPen(corrected, 1.4));
  plot_->graph(0)->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, corrected, 4.0));
  plot_->graph(1)->setPen(QPen(printed, 1.6, Qt::DashLine));
  plot_->graph(1)->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, printed, 5.0));
}

void StepSizePlot::show(const std::vector<StepDifference>& sweep, const QString& stepName) {
  QVector<double> h, corrected, printed;
  for (const StepDifference& d : sweep) {
    h << d.h;
    corrected << std::max(d.corrected, kSmallest);
    if (d.printed) printed << std::max(*d.printed, kSmallest);
  }
  points_ = static_cast<int>(h.size());
  plot_->graph(0)->setData(h, corrected, false);
  plot_->graph(1)->setData(printed.isEmpty() ? QVector<double>() : h, printed, false);
  if (!h.isEmpty()) {
    const auto [low, high] = std::minmax_element(corrected.cbegin(), corrected.cend());
    double top = *high;
    for (const double p : printed) top = std::max(top, p);
    plot_->xAxis->setRange(0.5 * h.back(), 2.0 * h.front());
    plot_->yAxis->setRange(std::min(1e-14, 0.3 * *low), 10.0 * std::max(top, 1e-3));
  }
  plot_->setToolTip(tr("How far difference quotients are from the right side.\n"
                       "h: %1.\nFilled: corrected. Hollow, dashed: as printed.\n"
                       "Large steps: truncation, slope 2. Small steps: rounding, slope −1.")
                        .arg(stepName));
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StepSizePlot::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  // Labels of large type need room; beside them are those of the other axis.
  constexpr int kLabels = 4;
  const bool fits = width() > kLabels * fontMetrics().horizontalAdvance(QStringLiteral("10-12 "));
  const auto ticker = plot_->xAxis->ticker().dynamicCast<QCPAxisTickerLog>();
  ticker->setLogBase(fits ? kDecades : kDecades * kDecades);
}

void StepSizePlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
    plot_->setFont(font());
    restyle();
    plot_->replot(QCustomPlot::rpQueuedReplot);
  }
  QWidget::changeEvent(event);
}

}  // namespace flatland::ui
