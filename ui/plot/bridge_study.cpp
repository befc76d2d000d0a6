// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/bridge_study.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "core3d/io/bridge_text.h"
#include "ui/export/convergence_figure.h"
#include "ui/export/figure_qt.h"
#include "ui/export/scene_record.h"
#include "ui/model/core_words.h"
#include "ui/model/theme.h"
#include "ui/plot/figure_files.h"

namespace flatland::ui {

namespace {

const std::vector<int> kCells = {16, 32, 64, 128, 256};  ///< along the curve

Figure figureOf(const BridgeStudyData& data, ConvergenceFigureOptions options) {
  std::vector<ConvergenceSeries> all;
  for (const BridgeSeries& series : data.series) all.push_back(convergenceOf(series));
  options.words = wordsOfTheWindow();
  return convergenceFigure(all, "Bridge", options);
}

}  // namespace

/// Shows the study there is.
class BridgeStudy::Diagram : public QWidget {
 public:
  Diagram(BridgeStudy& study, const Display& display)
      : QWidget(&study), study_(study), display_(display) {
    setObjectName("bridge.study.diagram");
    setAccessibleName(BridgeStudy::tr("Distance over resolution"));
    setToolTip(
        BridgeStudy::tr("Median distance of extracted to predicted ridges, for meshes of 16 to 256 "
                        "cells along the curve"));
    connect(&display_, &Display::changed, this, qOverload<>(&QWidget::update));
  }
  QSize sizeHint() const override { return {360, 300}; }
  QSize minimumSizeHint() const override { return {200, 240}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = display_.uiScale();
    painter.scale(scale, scale);
    ConvergenceFigureOptions options;
    options.width = width() / scale;
    options.height = height() / scale;
    options.palette = themePalette();
    paintFigure(painter, figureOf(*study_.data(), options));
  }

 private:
  const BridgeStudy& study_;
  const Display& display_;
};

BridgeStudy::BridgeStudy(const Document& document, const BridgeSource& bridge,
                         const Display& display, QWidget* parent)
    : QWidget(parent), document_(document), bridge_(bridge) {
  setObjectName("bridge.study");
  run_ = new QPushButton(this);
  run_->setObjectName("bridge.study.run");
  connect(run_, &QPushButton::clicked, this, [this] {
    if (isRunning()) {
      job_.cancel();
    } else {
      start();
    }
  });
  export_ = new QPushButton(tr("&Export…"), this);
  export_->setObjectName("bridge.study.export");
  export_->setToolTip(tr("Write the diagram as a picture, or all values as CSV"));
  connect(export_, &QPushButton::clicked, this, &BridgeStudy::exportDiagram);
  progress_ = new QProgressBar(this);
  progress_->setObjectName("bridge.study.progress");
  progress_->setAccessibleName(tr("Progress"));
  progress_->setRange(0, 100);
  old_ = new QLabel(tr("Of the curve and the view as they were."), this);
  old_->setObjectName("bridge.study.old");
  old_->setWordWrap(true);
  diagram_ = new Diagram(*this, display);
  auto* row = new QHBoxLayout;
  row->addWidget(run_);
  row->addWidget(export_);
  row->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins({});
  layout->addLayout(row);
  layout->addWidget(progress_);
  layout->addWidget(old_);
  layout->addWidget(diagram_, 1);
  connect(&bridge_, &BridgeSource::changed, this, &BridgeStudy::showState);
  connect(&job_, &Job::runningChanged, this, &BridgeStudy::showState);
  connect(&job_, &Job::failed, this, &BridgeStudy::said);
  connect(&job_, &Job::progressed, this,
          [this](double share) { progress_->setValue(qRound(100.0 * share)); });
  showState();
}

void BridgeStudy::start() {
  const auto& view = bridge_.view();
  if (!view || !view->prediction.flat().view) return;
  progress_->setValue(0);
  using Data = std::shared_ptr<const BridgeStudyData>;
  job_.start<Data>(
      [prediction = view->prediction,
       scene = document_.scene()](const JobControl& control) -> std::optional<Data> {
        BridgeOptions options;
        options.cells = kCells;
        std::stop_source stop;
        options.stop = stop.get_token();
        options.progress = [&](double share) {
          control.setProgress(share);
          if (control.isCancelled()) stop.request_stop();
        };
        auto series = measureBridge(prediction, options);
        if (series.empty() || control.isCancelled()) return std::nullopt;
        return std::make_shared<const BridgeStudyData>(BridgeStudyData{scene, std::move(series)});
      },
      [this](const Data& data) {
        data_ = data;
        showState();
        diagram_->update();
      });
}

bool BridgeStudy::isOfThisSweep() const {
  const auto& surface = document_.scene().surface;
  return data_ && surface && surface->swept && data_->scene.surface->swept == surface->swept;
}

void BridgeStudy::showState() {
  const auto& view = bridge_.view();
  run_->setText(isRunning() ? tr("Cancel") : tr("&Study resolutions"));
  run_->setToolTip(isRunning() ? tr("Give up the study")
                               : tr("Measure the distance on meshes of 16 to 256 cells, for both "
                                    "estimators of curvature and both ways to the derivative"));
  run_->setEnabled(isRunning() || (view && view->prediction.flat().view));
  // Of an extrusion it says nothing about a revolution; of another curve something to compare with.
  const Scene& now = document_.scene();
  const bool shown = isOfThisSweep();
  export_->setEnabled(shown);
  progress_->setVisible(isRunning());
  old_->setVisible(shown && !(data_->scene.curves == now.curves && data_->scene.view == now.view));
  diagram_->setVisible(shown);
}

void BridgeStudy::exportDiagram() {
  if (!isOfThisSweep()) return;
  // A study that ends while the dialog is open does not change what is written.
  const QString text =
      exportFigureFile(this, {.suggestedName = tr("bridge"),
                              .title = "Flatland, bridge: distance over resolution",
                              .sceneJson = sceneRecord(data_->scene),
                              .figure = [data = data_] { return figureOf(*data, {}); },
                              .table = [data = data_] { return bridgeCsv(data->series); }});
  if (!text.isEmpty()) emit said(text);
}

}  // namespace flatland::ui
