// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plots_panel.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/plot/profile_words.h"

namespace flatland::ui {

namespace {

constexpr PlotKind kKinds[kPlotKindCount] = {PlotKind::Curvature, PlotKind::Lambda, PlotKind::Terms,
                                             PlotKind::Ratio};
constexpr const char* kIds[kPlotKindCount] = {"curvature", "lambda", "terms", "ratio"};

}  // namespace

PlotsPanel::PlotsPanel(Plots& plots, Display& display, QSettings* settings, QWidget* parent)
    : QWidget(parent),
      plots_(plots),
      display_(display),
      exporter_(new PlotExporter(plots, settings, this)),
      against_(new QComboBox(this)),
      curve_(new QComboBox(this)) {
  auto* stack = new QWidget;
  auto* column = new QVBoxLayout(stack);
  column->setContentsMargins({});
  column->setSpacing(0);
  for (std::size_t i = 0; i < kPlotKindCount; ++i) {
    auto* plot = new ProfilePlot(plots, kKinds[i], stack);
    plot->setObjectName(QStringLiteral("plots.plot.%1").arg(kIds[i]));
    plot->surface().setObjectName(QStringLiteral("plots.surface.%1").arg(kIds[i]));
    connect(plot, &ProfilePlot::menuWanted, this,
            [this, kind = kKinds[i]](const QPoint& at) { showMenu(kind, at); });
    plotWidgets_[i] = plot;
    column->addWidget(plot, 1);
  }
  auto* scroll = new QScrollArea(this);
  scroll->setObjectName("plots.scroll");
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(stack);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 4, 2, 0);
  layout->setSpacing(2);
  layout->addLayout(buildTools());
  layout->addWidget(scroll, 1);
  connect(exporter_, &PlotExporter::said, this, &PlotsPanel::said);
  connect(exporter_, &PlotExporter::failed, this, &PlotsPanel::failed);
  connect(&plots_, &Plots::changed, this, &PlotsPanel::showChoices);
  showChoices();
}

QLayout* PlotsPanel::buildTools() {
  against_->setObjectName("plots.against");
  against_->addItem(tr("against arc length"), static_cast<int>(Abscissa::ArcLength));
  against_->addItem(tr("against screen"), static_cast<int>(Abscissa::Screen));
  against_->setToolTip(
      tr("What the plots are drawn against: length along the curve, or place on the screen"));
  against_->setAccessibleName(tr("Drawn against"));
  connect(against_, &QComboBox::activated, this, [this] {
    display_.setPlotAbscissa(static_cast<Abscissa>(against_->currentData().toInt()));
  });
  curve_->setObjectName("plots.curve");
  curve_->setToolTip(tr("The curve that is plotted: that of the probe"));
  curve_->setAccessibleName(tr("Plotted curve"));
  connect(curve_, &QComboBox::activated, this,
          [this](int index) { plots_.setCurve(static_cast<std::size_t>(index)); });
  auto* all = new QToolButton(this);
  all->setObjectName("plots.all");
  all->setText(tr("All"));
  all->setToolTip(tr("Show the whole curve (0, or a double-click on a plot)"));
  all->setAccessibleName(all->toolTip());
  all->setAutoRaise(true);
  connect(all, &QToolButton::clicked, &plots_, &Plots::resetRange);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(against_);
  row->addWidget(curve_);
  row->addStretch(1);
  row->addWidget(all);
  row->addWidget(buildChooser());
  return row;
}

QToolButton* PlotsPanel::buildChooser() {
  auto* chooser = new QToolButton(this);
  chooser->setObjectName("plots.choose");
  chooser->setText(tr("Plots"));
  chooser->setToolTip(tr("Which plots are shown, and how to copy or export them"));
  chooser->setAccessibleName(chooser->toolTip());
  chooser->setAutoRaise(true);
  chooser->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(chooser);
  menu->setToolTipsVisible(true);
  for (std::size_t i = 0; i < kPlotKindCount; ++i) {
    QAction* action = menu->addAction(titleOf(kKinds[i]));
    action->setObjectName(QStringLiteral("plots.show.%1").arg(kIds[i]));
    action->setToolTip(explanation(kKinds[i]));
    action->setCheckable(true);
    connect(action, &QAction::triggered, this,
            [this, kind = kKinds[i]](bool on) { display_.setShows(kind, on); });
    shown_[i] = action;
  }
  menu->addSeparator();
  for (std::size_t i = 0; i < kPlotKindCount; ++i) {
    QAction* action = menu->addAction(tr("Export %1…").arg(titleOf(kKinds[i])));
    action->setObjectName(QStringLiteral("plots.export.%1").arg(kIds[i]));
    action->setToolTip(tr("Write the plot as SVG, PDF, PNG or CSV"));
    connect(action, &QAction::triggered, this,
            [this, kind = kKinds[i]] { exporter_->exportPlot(kind); });
  }
  chooser->setMenu(menu);
  return chooser;
}

void PlotsPanel::showChoices() {
  const QSignalBlocker silent(curve_);
  against_->setCurrentIndex(against_->findData(static_cast<int>(plots_.abscissa())));
  const int curves = static_cast<int>(plots_.curveCount());
  while (curve_->count() > curves) curve_->removeItem(curve_->count() - 1);
  while (curve_->count() < curves) curve_->addItem(tr("Curve %1").arg(curve_->count()));
  curve_->setVisible(curves > 1);
  if (plots_.curve()) curve_->setCurrentIndex(static_cast<int>(*plots_.curve()));
  ProfilePlot* last = nullptr;
  for (std::size_t i = 0; i < kPlotKindCount; ++i) {
    const bool on = display_.shows(kKinds[i]);
    shown_[i]->setChecked(on);
    plotWidgets_[i]->setVisible(on);
    if (on) last = plotWidgets_[i];
  }
  for (ProfilePlot* plot : plotWidgets_) plot->setNumbersBelow(plot == last);
  setFocusProxy(last ? plotWidgets_[static_cast<std::size_t>(
                           std::find_if(plotWidgets_.begin(), plotWidgets_.end(),
                                        [](const ProfilePlot* p) { return !p->isHidden(); }) -
                           plotWidgets_.begin())]
                     : nullptr);
}

void PlotsPanel::showMenu(PlotKind kind, const QPoint& globalPos) {
  QMenu menu(this);
  menu.setObjectName("plots.menu");
  menu.setToolTipsVisible(true);
  const auto add = [&menu](const char* id, const QString& text, const QString& tip, auto act) {
    QAction* action = menu.addAction(text);
    action->setObjectName(id);
    action->setToolTip(tip);
    connect(action, &QAction::triggered, &menu, act);
  };
  add("plots.copy-picture", tr("&Copy Picture"), tr("Copy the plot to the clipboard"),
      [this, kind] { exporter_->copyPicture(kind); });
  add("plots.copy-table", tr("Copy &Numbers"), tr("Copy what is plotted as CSV"),
      [this, kind] { exporter_->copyTable(kind); });
  add("plots.export", tr("&Export…"), tr("Write the plot as SVG, PDF, PNG or CSV"),
      [this, kind] { exporter_->exportPlot(kind); });
  menu.addSeparator();
  add("plots.reset", tr("Show &All"), tr("Show the whole curve"), [this] { plots_.resetRange(); });
  add("plots.hide", tr("&Hide This Plot"), tr("The button Plots brings it back"),
      [this, kind] { display_.setShows(kind, false); });
  menu.exec(globalPos);
}

}  // namespace flatland::ui
